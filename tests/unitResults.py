"""Turns what a GoogleTest program left into lines `PASS|FAIL|SKIP program.suite.test [reason]`.

    unitResults.py PROGRAM STATUS RESULTS.json LOG

The results file is written at the end of a run: when there is none, the program died, and its log
tells what passed before and which test it was in. A program that ends badly without a failed test
(in a destructor, say) has failed as well.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import re
import sys


def fromJson(results):
    for suite in results["testsuites"]:
        for test in suite["testsuite"]:
            name = f"{suite['name']}.{test['name']}"
            if test.get("failures"):
                yield "FAIL", name, test["failures"][0]["failure"].strip().splitlines()[0]
            elif test.get("status") == "NOTRUN" or test.get("result") in ("SKIPPED", "SUPPRESSED"):
                yield "SKIP", name, ""
            else:
                yield "PASS", name, ""


def fromLog(text):
    ended = re.compile(r"\[ +(OK|FAILED|SKIPPED) +\] (\S+?),?(?: where .*)? \(\d+ ms\)$", re.M)
    words = {"OK": "PASS", "FAILED": "FAIL", "SKIPPED": "SKIP"}
    done = [(words[word], name, "") for word, name in ended.findall(text)]
    yield from done
    for name in re.findall(r"^\[ RUN +\] (\S+)", text, re.M):
        if name not in {row[1] for row in done}:
            yield "FAIL", name, "the program died in it"


def main(program, status, results, log):
    try:
        with open(results) as file:
            rows = list(fromJson(json.load(file)))
    except (OSError, ValueError):
        with open(log, errors="replace") as file:
            rows = list(fromLog(file.read()))
    if int(status) and not any(row[0] == "FAIL" for row in rows):
        rows.append(("FAIL", "end", f"exit status {status}"))
    for word, name, reason in rows:
        print(f"{word} {program}.{name} {reason}".rstrip())


if __name__ == "__main__":
    main(*sys.argv[1:])

# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/sceneNeeds.md: what a step of a scene takes, and with one thing less; whose each kernel and
field is"""
import csv
import fnmatch
import os
import re

here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
rowsFile = os.path.join(here, 'results', 'sceneNeeds.csv')
ownersFile = os.path.join(here, 'sceneOwners.csv')
solvers = ['sphDem', 'picDem', 'dem']
itemOf = {'sphDem': 'fluid particle', 'picDem': 'cell', 'dem': 'particle'}
ofSolids = ('solids.', 'contacts.', 'bonds.', 'clumps.', 'walls.')


def readRows(text):
    """Rows of sceneCounts, with kernels and fields as {name: number}"""
    rows = list(csv.DictReader(text.splitlines()))
    for row in rows:
        row['has'] = set(row['has'].split(';'))
        for column in ('kernelList', 'fieldList'):
            row[column] = {name: float(value) for name, value in (
                part.rsplit('=', 1) for part in row[column].split(';'))}
    return rows


def owners():
    with open(ownersFile) as f:
        return list(csv.DictReader(line for line in f if not line.startswith('#')))


def partsOf(table, solver, kind, name):
    """What needs a kernel or field: alternatives, each a set of parts; None: nobody knows"""
    prefix = ''
    if solver != 'dem' and (name.startswith('solids: ')
                            or kind == 'field' and name.startswith(ofSolids)):
        solver, prefix, name = 'dem', 'solids/', name[8:] if kind == 'kernel' else name
    mine = [row for row in table if row['solver'] == solver and row['kind'] == kind]
    found = ([row for row in mine if row['name'] == name]
             or [row for row in mine if fnmatch.fnmatchcase(name, row['name'])])
    if not found:
        return None
    return [{prefix + part for part in alternative.split('+')} for row in found
            for alternative in row['needs'].split(';')]


def unneeded(row, table):
    """Kernels that a scene runs and fields that it holds for a part that it does not have, or that
    no line of the table explains"""
    wrong = []
    for kind, column in (('kernel', 'kernelList'), ('field', 'fieldList')):
        for name in row[column]:
            parts = partsOf(table, row['solver'], kind, name)
            if parts is None:
                wrong.append(f'{kind} {name} has no owner')
            elif not any(alternative <= row['has'] for alternative in parts):
                wrong.append(
                    f'{kind} {name} is for {" or ".join("+".join(sorted(p)) for p in parts)}')
    return wrong


def number(value, digits=3):
    return f'{float(value):.{digits}g}' if float(value) < 10**digits else f'{float(value):.0f}'


def saved(row, whole):
    """Of the whole scene's time"""
    ratio = float(row['timeRatio'])
    return '-' if ratio == 0 else f'{100*(ratio - 1):+.0f} %'


def table(rows, solver):
    lines = [f'| without | kernels a step | fields | bytes a {itemOf[solver]} | time of a step |',
             '| --- | --- | --- | --- | --- |']
    whole = None
    for row in rows:
        if row['solver'] != solver:
            continue
        if not row['without']:
            whole = row
            time = f"{number(row['time'])} µs" if float(row['time']) > 0 else '-'
            lines.append(f"| **{row['scene']}** ({row['items']}) | {number(row['kernels'])} | "
                         f"{row['fields']} | {number(row['bytes'])} | {time} |")
            continue
        kernels, fields = (len(set(whole[c]) - set(row[c])) for c in ('kernelList', 'fieldList'))
        gone = [f'{n} gone' if n else '' for n in (kernels, fields)]
        lines.append('| ' + ' | '.join([
            row['without'],
            f"{number(row['kernels'])}" + (f' ({gone[0]})' if gone[0] else ''),
            row['fields'] + (f' ({gone[1]})' if gone[1] else ''),
            number(row['bytes']),
            saved(row, whole)]) + ' |')
    return '\n'.join(lines)


def summary(rows, known):
    kernels = {(r['solver'], k) for r in rows for k in r['kernelList']}
    fields = {(r['solver'], f) for r in rows for f in r['fieldList']}
    wrong = sum(len(unneeded(r, known)) for r in rows)
    return (f'{len(rows)} scenes run {len(kernels)} kernels and hold {len(fields)} fields. '
            f'Kernels and fields of parts that a scene does not have: **{wrong}**.')


def fill(text, rows):
    """The page with its generated parts made anew"""
    parts = {solver: table(rows, solver) for solver in solvers}
    parts['summary'] = summary(rows, owners())
    found = set(re.findall(r'<!-- generated (\w+)', text))
    if found != set(parts):
        raise ValueError(
            f'docs/sceneNeeds.md: generated parts are {sorted(found)}, wanted {sorted(parts)}')
    return re.sub(r'(<!-- generated (\w+)[^>]*-->).*?<!-- end -->',
                  lambda m: f'{m.group(1)}\n\n{parts[m.group(2)]}\n\n<!-- end -->', text,
                  flags=re.S)

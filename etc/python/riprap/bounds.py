# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities, the tolerance table and the printed verdict

tests/regression/tolerances.csv has one line a bound: scene, level (full | quick | finding), run (a
pattern), quantity, low, high, reason. A bound applies to the quantity's error if it has one, else
to its computed value; an empty low or high is open. A quantity without a bound is printed as
information.
A finding is a bound of full that models shown beside the case's own need not meet: what misses it
is printed as such and counted by itself. The first line that fits decides.
"""
import csv
import fnmatch
import os
from dataclasses import dataclass
from typing import Optional


@dataclass
class Quantity:
    name: str
    computed: Optional[float] = None
    reference: Optional[float] = None
    error: Optional[float] = None

    @property
    def checked(self):
        return self.computed if self.error is None else self.error

    @property
    def kind(self):
        """What `checked` is: relative, error (in the unit of the name), or value"""
        if self.error is None:
            return 'value'
        if self.computed is None or not self.reference:
            return 'error'
        return ('relative' if abs(abs(self.error) - abs(self.computed/self.reference - 1)) < 1e-6
                else 'error')


class Bounds:
    def __init__(self, scene, level):
        path = os.path.join(root(), 'tests', 'regression', 'tolerances.csv')
        with open(path, newline='') as f:
            lines = [line for line in f if line.strip() and not line.startswith('#')]
        self.rows = [r for r in csv.DictReader(lines, skipinitialspace=True)
                     if r['scene'] == scene
                     and r['level'] in ((level, 'finding') if level == 'full' else (level,))]
        self.used = set()

    def find(self, run, quantity):
        """Limits, and whether they are those of a finding"""
        for i, r in enumerate(self.rows):
            if r['quantity'] == quantity and fnmatch.fnmatch(run, r['run']):
                self.used.add(i)
                return (float(r['low']) if r['low'] else None,
                        float(r['high']) if r['high'] else None), r['level'] == 'finding'
        return None, False

    def unused(self):
        """Bounds that nothing was checked against: a check that silently vanished is a failure"""
        return [r for i, r in enumerate(self.rows) if i not in self.used]


def root():
    """Top of the repository"""
    here = os.path.dirname(os.path.abspath(__file__))
    return os.environ.get('RIPRAP_DIR') or os.path.abspath(os.path.join(here, '..', '..', '..'))


def check(bounds, results):
    """Table rows of {run: [Quantity]}, the number of quantities out of bounds and that of findings
    that miss theirs"""
    rows, failures, findings = [], 0, 0
    for run, quantities in results.items():
        for q in quantities:
            limits, finding = bounds.find(run, q.name)
            verdict = ''
            if limits:
                low, high = limits
                good = q.checked is not None and q.checked == q.checked \
                    and (low is None or q.checked >= low) and (high is None or q.checked <= high)
                verdict = 'ok' if good else ('misses: a finding' if finding else 'OUT OF BOUNDS')
                findings += finding and not good
                failures += not finding and not good
            rows.append((run, q.name, _show(q.reference), _show(q.computed), _show(q.error),
                         _limits(limits), verdict))
    return rows, failures, findings


def printTable(rows, header=('run', 'quantity', 'reference', 'computed', 'error', 'bound', '')):
    widths = [max(len(str(r[i])) for r in [header, *rows]) for i in range(len(header))]
    for r in [header, tuple('-'*w for w in widths), *rows]:
        print('  '.join(str(c).ljust(w) for c, w in zip(r, widths)).rstrip())


def _show(value):
    return '' if value is None else f'{value:.4g}'


def _limits(limits):
    if not limits:
        return 'none'
    low, high = limits
    if low is None:
        return f'<= {high:g}'
    return f'>= {low:g}' if high is None else f'{low:g} .. {high:g}'

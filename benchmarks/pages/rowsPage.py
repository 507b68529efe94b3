# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/charts/rows.html: all rows in one page that needs neither a server nor a network

rowsPage.html beside this file is the page, rowsPage.js its script; the rows take the place of the
word DATA in it, strings by their number in a table.
"""
import json
import os

from riprap import rows

here = os.path.dirname(os.path.abspath(__file__))
columns = ['scene', 'solver', 'run', 'settings', 'spacing', 'particles', 'precision', 'device',
           'card', 'quantity', 'yardstick', 'error', 'kept', 'cost', 'steps', 'date', 'version',
           'left']
strings = {'scene', 'solver', 'run', 'settings', 'precision', 'device', 'card', 'quantity',
           'yardstick', 'date', 'version', 'left'}


def page(loaded, judged, peers):
    kept, why = {}, {}
    for scene, (mine, reason) in judged.items():
        for s in mine:
            for p in s.points:
                for r in p.rows:
                    why[id(r)] = reason or ('one spacing of these settings'
                                            if s.verdict == 'one spacing' else '')
                    if s.verdict != 'one spacing' and not reason:
                        kept[id(r)] = p.kept
    table, numbers = [], {}

    def number(text):
        if text not in numbers:
            numbers[text] = len(table)
            table.append(text)
        return numbers[text]

    data = []
    for r in [*loaded, *peers]:
        values = {'scene': r.scene, 'solver': r.solver, 'run': r.run, 'settings': r.settings,
                  'spacing': r.spacing, 'particles': r.particles, 'precision': r.precision,
                  'device': r.place, 'card': r.processor, 'quantity': r.quantity,
                  'yardstick': r.yardstick, 'error': r.error, 'kept': kept.get(id(r)),
                  'cost': r.cost, 'steps': r.steps, 'date': r.date, 'version': r.version,
                  'left': r.left or why.get(id(r), '')}
        data.append([number(values[c]) if c in strings else _short(values[c]) for c in columns])
    embedded = json.dumps({'columns': columns, 'strings': sorted(strings), 'table': table,
                           'rows': data}, separators=(',', ':'),
                          ensure_ascii=True).replace('</', '<\\/')
    texts = {}
    for name in ('rowsPage.html', 'rowsPage.js'):
        with open(os.path.join(here, name)) as f:
            texts[name] = f.read()
    return texts['rowsPage.html'].replace('SCRIPT',
                                          texts['rowsPage.js'].replace('"DATA"', embedded))


def _short(value):
    return None if value is None else float(f'{value:.4g}')


__all__ = ['page', 'rows']

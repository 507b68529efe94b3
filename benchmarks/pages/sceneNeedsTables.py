# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/sceneNeeds.md: what a step of a scene takes, and with one thing less; whose each kernel and
field is"""
import csv
import fnmatch
import os
import re

here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
rowsFile = os.path.join(here, 'results', 'sceneNeeds.csv')
cutRowsFile = os.path.join(here, 'results', 'sceneCuts.csv')
cutColumns = ['solver', 'without', 'byEntry', 'program']
ownersFile = os.path.join(here, 'sceneOwners.csv')
solvers = ['sphDem', 'picDem', 'dem']
itemOf = {'sphDem': 'fluid particle', 'picDem': 'cell', 'dem': 'particle'}
# The scene of each solver from which all is left out that can be
barest = {'sphDem': 'all of these but walls', 'picDem': 'all of these', 'dem': 'all of these'}
# Scenes that lack what another has without a part of a step for it: both are the same program
sameProgram = {'sphDem': ['the dry part of the box'],
               'picDem': [],            # water that is let go has another pressure to solve for
               'dem': ['the empty part of the box', 'the sleeping block']}
bound = 1.05
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


def key(row):
    return row['solver'], row['scene'], row['without']


def nameOf(row):
    return ', '.join(part for part in (row['solver'], row['scene'],
                                       row['without'] and 'without ' + row['without']) if part)


def readCutRows(text):
    return list(csv.DictReader(text.splitlines()))


def keepCutRow(row):
    """In place of the one there is, or behind those of its solver"""
    with open(cutRowsFile) as f:
        rows = readCutRows(f.read())
    same = [k for k, old in enumerate(rows)
            if (old['solver'], old['without']) == (row['solver'], row['without'])]
    if same:
        rows[same[0]] = row
    else:
        rows.append(row)
    rows.sort(key=lambda r: solvers.index(r['solver']))
    with open(cutRowsFile, 'w', newline='') as f:
        out = csv.DictWriter(f, cutColumns, lineterminator='\n')
        out.writeheader()
        out.writerows(rows)


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


def change(ratio):
    return f'{100*(ratio - 1):+.0f} %'


def measured(row, whole):
    """Instructions an item, and what has changed of the step; time where it was measured"""
    if not row['instructions']:
        return ['-'] + (['-'] if float(whole['time']) > 0 else [])
    cells = []
    each = number(float(row['instructions'])/float(row['items']), 4)
    if row is whole:
        cells.append(each)
    else:
        cells.append(f"{each} ({change(float(row['instructions'])/float(whole['instructions']))})")
    if float(whole['time']) > 0:
        cells.append(f"{number(row['time'])} µs" if row is whole
                     else change(float(row['timeRatio'])))
    return cells


def table(rows, solver):
    rows = [row for row in rows if row['solver'] == solver]
    head = ['without', 'kernels a step', 'fields', f'bytes a {itemOf[solver]}',
            f'instructions a {itemOf[solver]} and step']
    head += ['time of a step'] if float(rows[0]['time']) > 0 else []
    lines = ['| ' + ' | '.join(head) + ' |', '| ' + ' | '.join('---' for _ in head) + ' |']
    whole = None
    for row in rows:
        if not row['without']:
            whole = row
        kernels, fields = (len(set(whole[c]) - set(row[c])) for c in ('kernelList', 'fieldList'))
        gone = [f' ({n} gone)' if n else '' for n in (kernels, fields)]
        lines.append('| ' + ' | '.join([
            row['without'] or f"**{row['scene']}** ({row['items']})",
            number(row['kernels']) + gone[0],
            row['fields'] + gone[1],
            number(row['bytes'])] + measured(row, whole)) + ' |')
    return '\n'.join(lines)


def comparisons(rows, cutRows):
    """(solver, without, instructions with it absent by entry, of a program without it)"""
    known = {key(row): row for row in rows}
    found = [(r['solver'], r['without'], float(r['byEntry']), float(r['program']))
             for r in cutRows]
    for row in rows:
        if row['without'] in sameProgram[row['solver']] and row['instructions']:
            whole = known[row['solver'], row['scene'], '']
            found.append((row['solver'], row['without'], float(whole['instructions']),
                          float(row['instructions'])))
    return sorted(found, key=lambda f: solvers.index(f[0]))


def cutTable(rows, cutRows):
    lines = ['| solver | what the scene lacks | instructions a step | of a program without it | '
             'ratio |', '| --- | --- | --- | --- | --- |']
    for solver, without, by, program in comparisons(rows, cutRows):
        ratio = f'{by/program:.3f}'
        lines.append(f'| {solver} | {without} | {by:.0f} | {program:.0f} | '
                     + (f'**{ratio}**' if by > bound*program else ratio) + ' |')
    return '\n'.join(lines)


def cutSummary(rows, cutRows):
    ratios = [by/program for _, _, by, program in comparisons(rows, cutRows)]
    return (f'Of {len(ratios)} comparisons {sum(r <= bound for r in ratios)} are within 5 %; '
            f'the largest ratio is {max(ratios):.3f}.')


def summary(rows, known):
    kernels = {(r['solver'], k) for r in rows for k in r['kernelList']}
    fields = {(r['solver'], f) for r in rows for f in r['fieldList']}
    wrong = sum(len(unneeded(r, known)) for r in rows)
    return (f'{len(rows)} scenes run {len(kernels)} kernels and hold {len(fields)} fields. '
            f'Kernels and fields of parts that a scene does not have: **{wrong}**.')


def fill(text, rows, cutRows):
    """The page with its generated parts made anew"""
    parts = {solver: table(rows, solver) for solver in solvers}
    parts['summary'] = summary(rows, owners())
    parts['cuts'] = cutTable(rows, cutRows)
    parts['cutSummary'] = cutSummary(rows, cutRows)
    found = set(re.findall(r'<!-- generated (\w+)', text))
    if found != set(parts):
        raise ValueError(
            f'docs/sceneNeeds.md: generated parts are {sorted(found)}, wanted {sorted(parts)}')
    return re.sub(r'(<!-- generated (\w+)[^>]*-->).*?<!-- end -->',
                  lambda m: f'{m.group(1)}\n\n{parts[m.group(2)]}\n\n<!-- end -->', text,
                  flags=re.S)

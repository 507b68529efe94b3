#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Loader of rows, observed order, Richardson's limit, fronts, the page with all rows; whole runs of
applications"""
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

root = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path.insert(0, os.path.join(root, 'etc', 'python'))
sys.path.insert(0, os.path.join(root, 'benchmarks'))

from riprap import convergence, records, rows  # noqa: E402  (after the path)
from pages import rowsPage, workPrecisionTables  # noqa: E402

stick = {'scene': 'pool', 'file': 'pool', 'runs': '.*', 'chance': r'chance\d', 'quantity': 'level',
         'dimensions': '2', 'length': '1', 'lengthIs': 'depth', 'kind': 'waves',
         'yardstick': 'exact', 'of': 'the level', 'use': 'yes', 'reason': ''}


def row(run, spacing, error, wall, **more):
    r = dict.fromkeys(records.columns, '')
    r.update(date='2026-01-01', scene='pool', run=run, model='picDem', settings='transfer=flip',
             spacing=str(spacing), particles='1000', precision='mixed',
             device='AMD EPYC, 1 threads', quantity='level', error=str(error), wallTime=str(wall),
             steps='100', particleSteps='1e5', machine='AMD EPYC (2 threads)', simulated='2',
             kind='relative')
    r.update(more)
    return r


def loaded(found, sticks=(stick,)):
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, 'pool.csv'), 'w', newline='') as f:
            writer = csv.DictWriter(f, records.columns)
            writer.writeheader()
            writer.writerows(found)
        return rows.load(folder, list(sticks))


class Convergence(unittest.TestCase):
    def testOrder(self):
        h = [0.1, 0.05, 0.02]
        found = convergence.order(h, [3*x**1.7 for x in h])
        self.assertAlmostEqual(found.order, 1.7, places=10)
        self.assertAlmostEqual(found.deviation, 0, places=10)
        self.assertIsNone(convergence.order([0.1, 0.1], [1, 2]))
        self.assertIsNone(convergence.order([0.1, 0.05], [1, 0]))
        self.assertIsNone(convergence.order([0.1, 0.05], [1, 2]).deviation)
        # with 5 % of scatter the slope lies within two standard errors
        noisy = convergence.order([0.1, 0.05, 0.02, 0.01], [
            3*x**1.7*f for x, f in zip([0.1, 0.05, 0.02, 0.01], (1.05, 0.95, 1.05, 0.95))])
        self.assertLess(abs(noisy.order - 1.7), 2*noisy.deviation)
        self.assertGreater(noisy.deviation, 0.01)

    def testLimit(self):
        for p in (0.7, 1.0, 2.0, 3.3):
            for h in ([0.4, 0.2, 0.1], [0.3, 0.25, 0.1], [0.8, 0.4, 0.2, 0.1]):
                found = convergence.richardson(h, [5 + 2*x**p for x in h])
                self.assertEqual(found.kind, 'monotone')
                self.assertAlmostEqual(found.value, 5, places=6)
                self.assertAlmostEqual(found.order, p, places=5)
        # Of second order the uncertainty is 1.25 times the distance from the limit
        found = convergence.richardson([0.4, 0.2, 0.1], [5 + 2*x**2 for x in (0.4, 0.2, 0.1)])
        self.assertAlmostEqual(found.uncertainty, 1.25*0.02, places=8)
        # away from it the factor is 3, and the limit is within
        found = convergence.richardson([0.4, 0.2, 0.1], [5 + 2*x for x in (0.4, 0.2, 0.1)])
        self.assertAlmostEqual(found.uncertainty, 0.6, places=8)

    def testWhereThereIsNone(self):
        self.assertEqual(convergence.richardson([0.4, 0.2, 0.1], [1, 2, 1.5]).kind, 'oscillating')
        self.assertEqual(convergence.richardson([0.4, 0.2, 0.1], [1, 1.1, 1.4]).kind, 'diverging')
        self.assertIsNone(convergence.richardson([0.4, 0.2, 0.2], [1, 2, 3]))
        self.assertEqual(convergence.richardson([0.4, 0.2, 0.1], [1, 1, 1]).uncertainty, 0)


class Rows(unittest.TestCase):
    def testLuckEarnsNothing(self):
        mine = rows.series(loaded([row('n10', 0.1, 0.001, 1), row('n20', 0.05, 0.04, 8),
                                   row('n40', 0.025, 0.01, 64)]))[0]
        self.assertEqual([p.kept for p in mine.points], [0.04, 0.04, 0.01])
        self.assertEqual(mine.verdict, 'falls')
        rising = rows.series(loaded([row('n10', 0.1, 0.001, 1), row('n20', 0.05, 0.02, 8),
                                     row('n40', 0.025, 0.03, 64)]))[0]
        self.assertEqual(rising.verdict, 'does not fall')
        self.assertEqual({p.kept for p in rising.points}, {0.03})

    def testScenesWithoutFallAreLeftOut(self):
        judged = rows.scenes(rows.series(loaded([row('n10', 0.1, 0.1, 1), row('n20', 0.05, 0.09, 8),
                                                 row('n40', 0.025, 0.1, 64)])))
        self.assertEqual(judged['pool'][1], 'no series falls with its spacing')

    def testNewestCountsWithTheShortestTimeOfItsSteps(self):
        found = loaded([row('n10', 0.1, 0.2, 1, steps='50'), row('n10', 0.1, 0.1, 4),
                        row('n10', 0.1, 0.1, 6)])
        used = [r for r in found if not r.left]
        self.assertEqual([(r.error, r.cost) for r in used], [(0.1, 2.0)])
        self.assertEqual([r.left for r in found[:2]], ['a newer row of the same settings']*2)

    def testChanceMakesABand(self):
        point = rows.series(loaded([row('n10', 0.1, 0.1, 1), row('n10-chance1', 0.1, 0.14, 1),
                                    row('n10-chance2', 0.1, 0.11, 1)]))[0].points[0]
        self.assertEqual((point.low, point.error, point.high), (0.1, 0.11, 0.14))

    def testWhatIsLeftOut(self):
        def reason(**more):
            return loaded([dict(row('n10', 0.1, 0.1, 1), **more)])[0].left
        self.assertEqual(reason(), '')
        self.assertIn('quick', loaded([row('n10-quick', 0.1, 0.1, 1)])[0].left)
        self.assertEqual(reason(error=''), 'it stopped')
        self.assertEqual(reason(kind='value'), 'a value, no error')
        self.assertEqual(reason(spacing=''), 'no spacing')
        self.assertEqual(reason(wallTime=''), 'no cost recorded')
        self.assertEqual(reason(quantity='another'), 'no yardstick named')
        self.assertEqual(loaded([row('n10', 0.1, 0.1, 1)],
                                [dict(stick, use='no', reason='a gate')])[0].left, 'a gate')

    def testPlaces(self):
        self.assertEqual(loaded([row('n10', 0.1, 0.1, 1)])[0].place, 'CPU, one thread')
        self.assertEqual(
            loaded([row('n10', 0.1, 0.1, 1, device='Intel', machine='Xeon (16 threads)')])[0].place,
            'CPU, several threads')
        self.assertEqual(loaded([row('n10', 0.1, 0.1, 1, device='NVIDIA H200')])[0].place, 'GPU')

    def testNames(self):
        for name, variant in {'n50-apic': 'apic', 'tank2D-coarse': 'tank2D',
                              'dp1.25-freeSlip': 'freeSlip', 'n40-half': 'half',
                              'column-half-cpu': '',
                              'square16': 'square', 'hexagonal4-counted': 'hexagonal-counted',
                              '2d-0.001-a5-edges': '2d-0.001-edges', 'wide-dp5': 'wide'}.items():
            self.assertEqual(rows.variantOf(name), variant)
        self.assertEqual(rows.variantOf('heave-0.25', r'-0(\.\d+)?'), 'heave')

    def testFronts(self):
        found = loaded([row('n10', 0.1, 0.1, 1), row('n20', 0.05, 0.02, 8),
                        row('n10-apic', 0.1, 0.09, 4, settings='transfer=apic'),
                        row('n20-apic', 0.05, 0.01, 6, settings='transfer=apic'),
                        row('n20-pic', 0.05, 1e-3, 1, settings='transfer=pic')])
        mine, why = rows.scenes(rows.series(found))['pool']
        self.assertEqual(why, '')
        front = rows.fronts(mine)['picDem', 'CPU, one thread']
        # one spacing of pic makes none
        self.assertEqual([(c[0], c[1]) for c in front], [(0.5, 0.1), (2.0, 0.09), (3.0, 0.01)])
        self.assertEqual(rows.cheapest(front, 0.05)[0], 3.0)
        self.assertIsNone(rows.cheapest(front, 0.001))


class Repository(unittest.TestCase):
    """The rows that there are"""

    @classmethod
    def setUpClass(cls):
        cls.loaded = rows.load()
        cls.judged = rows.scenes(rows.series(cls.loaded))

    def testEveryRowIsReadAndJudged(self):
        count = 0
        for name in os.listdir(os.path.join(root, 'benchmarks', 'results')):
            with open(os.path.join(root, 'benchmarks', 'results', name), newline='') as f:
                found = list(csv.DictReader(f))
            count += len(found) if 'run' in found[0] and 'error' in found[0] else 0
        self.assertEqual(len(self.loaded), count)
        self.assertEqual([r.run for r in self.loaded if r.left == 'no yardstick named'], [])
        for r in self.loaded:
            self.assertTrue(r.left or (r.error is not None and r.cost and r.spacing), r)

    def testTheGateIsNoYardstick(self):
        self.assertNotIn('damBreak', self.judged)
        own = [v for v in workPrecisionTables.ownSeries(self.loaded)
               if v[:2] == ('damBreak', 'picDem')]
        limit = convergence.richardson(own[0][4], own[0][5])
        self.assertLess(abs(limit.value - 0.115), 0.005)

    def testKnownOrders(self):
        """What the pages of verification say of orders"""
        orders = {(scene, s.solver, s.variant, s.settings.count('ratio=2.5')): s.order.order
                  for scene, (mine, _) in self.judged.items() for s in mine if s.order}
        self.assertAlmostEqual(orders['standingWave', 'sphDem', '', 1], 2.0, delta=0.1)
        self.assertAlmostEqual(orders['poiseuille', 'picDem', '', 0], 2.1, delta=0.1)
        # h of two spacings: the lattice, docs/theory.md
        self.assertLess(orders['standingWave', 'sphDem', '', 0], 0)

    def testPage(self):
        text = rowsPage.page(self.loaded, self.judged, rows.peers())
        self.assertNotRegex(
            text,
            r'(src|href)\s*=|https?://(?!www\.w3\.org/2000/svg)|@import|fetch\(|XMLHttpRequest')
        data = json.loads(re.search(r'const data = (\{.*?\});\n', text,
                                    re.S).group(1).replace('<\\/', '</'))
        self.assertEqual(len(data['rows']), len(self.loaded) + len(rows.peers()))
        left = data['columns'].index('left')
        reasons = {data['table'][r[left]] for r in data['rows']}
        self.assertIn('the gate of the experiment is not modelled: finer runs are farther off',
                      reasons)
        self.assertIn('', reasons)

    def testPageRuns(self):
        """Its script, with a page made of nothing: it draws, filters and sorts"""
        try:
            subprocess.run(['node', '--version'], check=True, capture_output=True)
        except (OSError, subprocess.CalledProcessError):
            self.skipTest('no node')
        script = re.search(r'<script>\n(.*)</script>',
                           rowsPage.page(self.loaded, self.judged, rows.peers()), re.S).group(1)
        with open(os.path.join(root, 'tests', 'python', 'pageOfNothing.js')) as f:
            nothing = f.read()
        done = subprocess.run(['node', '-'], input=nothing.replace('SCRIPT', script),
                              capture_output=True, text=True)
        self.assertEqual((done.stdout.strip(), done.returncode), ('ok', 0), done.stderr)

    def testYardsticksAreChecked(self):
        with tempfile.NamedTemporaryFile('w', suffix='.csv') as f:
            f.write(','.join(stick) + '\n' + 'a,a,.*,,q,2,,,waves,exact,it,no,\n')
            f.flush()
            with self.assertRaisesRegex(ValueError, 'scene a'):
                rows.yardsticks(f.name)


class Applications(unittest.TestCase):
    columns = ('name,version,device,particles,steps,wall,start,solver,fields,functionObjects,'
               'writing,other,solverShare,bound,note,endTime,waiting,stateBytes').split(',')

    def rows(self, *lines):
        return [dict(zip(self.columns, line.split(','))) for line in lines]

    def testChart(self):
        try:
            from charts import applications
        except ModuleNotFoundError:
            self.skipTest('no matplotlib')
        old, other, new, half, state, slow = self.rows(
            'dem,a,gpu,1000,1,9,1,7,0,0,1,0,78,80,NVIDIA A100,1.5,,',
            'dem,b,gpu,1000,1,9,1,7,0,0,1,0,78,80,NVIDIA H200; busy,1.5,,',
            'dem,c,gpu,1000,1,8,1,6,0,0,1,0,75,80,NVIDIA H200,1.5,0.25,',
            'dem,c,gpu,1000,1,4,1,2,0,0,1,0,50,80,NVIDIA H200,0.5,,',
            'restart-dem,c,gpu,1000,1,4,1,2,0,0,1,0,,,NVIDIA H200,0.02,0,9000',
            'sphDem,c,cpu,10,1,4,1,2,0,0,1,0,50,,two cores,0.4,,')
        self.assertEqual(applications.chosen([old, slow, other, new, half, state]),
                         [half, new, slow])
        seconds = applications.secondsOf(new)
        self.assertEqual((seconds['writing'], seconds['waiting for writing']), (0.75, 0.25))
        seconds = applications.secondsOf(half)
        self.assertNotIn('writing', seconds)
        self.assertEqual(seconds[applications.both], 1)
        self.assertTrue(set(seconds) <= set(applications.paint))

    def testRecorded(self):
        with open(os.path.join(root, 'benchmarks', 'results', 'applications.csv'),
                  newline='') as f:
            found = list(csv.DictReader(f))
        self.assertEqual(list(found[0]), self.columns)
        for r in found:
            self.assertNotIn(None, r.values(), r['name'])
            if r['solverShare']:
                self.assertAlmostEqual(100*float(r['solver'])/float(r['wall']),
                                       float(r['solverShare']), delta=0.1)

    def testRuns(self):
        """What is run is there, spheres for two spans of time"""
        for level in ('gpu', 'cpu', 'quick'):
            said = subprocess.run([os.path.join(root, 'benchmarks', 'runApplications'), level,
                                   '-dry'], capture_output=True, text=True, check=True).stdout
            runs = [line.split() for line in said.splitlines()]
            for name, case, *_ in runs:
                self.assertTrue(os.access(os.path.join(root, case), os.X_OK), name)
            names = [r[0] for r in runs]
            self.assertEqual(names.count('dem'), 2 if level == 'gpu' else 1)
            for name in ('elasticGate', 'setParticles-rocks', 'restart-dem', 'restart-picDem'):
                self.assertIn(name, names)


if __name__ == '__main__':
    unittest.main()

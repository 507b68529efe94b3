#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""riprapAdvise: what is foretold from made rows, that held-out scenes are not looked at, the score
on the repository's rows, what a wrong word is told"""
import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest

root = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path.insert(0, os.path.join(root, 'etc', 'python'))

from riprap import advice, advise  # noqa: E402  (after the path)

log = """    space            2D: x y; periodic: none
    device           AMD EPYC, 1 threads (asked for)
    threads          1 of the CPU (OMP_NUM_THREADS)
    precision        mixed

Particles
    fluid: 1600

Memory on the device
    fluid: 100 kB
    all: 160 kB, 100 B a particle

Particle steps to time 2: 4000 with this step, about 5000 at maxVelocity

Expected wall time [s], as the log will end
    start                              1.00     4.8 %
    solver                            20.00    95.2 %  400 times
    all                               21.00   100.0 %
"""


def series(scene, solver, flow, order, at40, dimensions=2, across=(20, 40, 80), settings='',
           steps=100):
    """Errors at40 (n/40)^-order, costs n^(D + 1)"""
    spent = [advice.Spent(n, 1e-3*n**(dimensions + 1), steps*n, float(n**dimensions), 10.0)
             for n in across]
    return advice.Known(scene, flow, dimensions, solver, settings, 'mixed', 'exact',
                        [(n, at40*(n/40)**-order) for n in across], {'CPU, one thread': spent})


class Case(unittest.TestCase):
    """A directory of a case whose dry run has been made"""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = folder.name
        for name in ('system', 'constant/polyMesh'):
            os.makedirs(os.path.join(self.case, name))
        self.write('system/controlDict', 'solver sphDem; startTime 0; endTime 2;')
        self.write('constant/g', 'value (0 -9.81 0);')
        self.write('constant/polyMesh/points',
                   'FoamFile { format ascii; }\n8\n((0 0 0)\n(1 0 0)\n(1 1 0)\n(0 1 0)\n(0 0 0.1)\n'
                   '(1 0 0.1)\n(1 1 0.1)\n(0 1 0.1))')
        self.write('system/setParticlesDict', 'spacing 0.01; regions ( column { set fluid; '
                                              'source box; box (0 0 0) (0.4 0.8 0.1); } );')
        self.write('constant/sphProperties', '')
        self.write('log', log)

    def write(self, name, text):
        with open(os.path.join(self.case, name), 'w') as f:
            f.write(text)

    def read(self, **more):
        return advise.read(self.case, more.get('length'), more.get('flow'),
                           os.path.join(self.case, 'log'), more.get('measured'))

    def said(self, *words):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = advise.main([*words, '-case', self.case, '-log',
                                  os.path.join(self.case, 'log')])
        return status, out.getvalue(), err.getvalue()


class Foretold(Case):
    def testAcross(self):
        known = [series('a', 'picDem', 'waves', 2, 0.01), series('b', 'picDem', 'waves', 2, 0.04)]
        pool = advice.weighed(known, 'picDem', 'waves')
        # the geometric mean is 0.02 at 40
        self.assertAlmostEqual(advice.acrossFor(pool, 0.005), 80, places=6)
        self.assertAlmostEqual(advice.foretoldError(pool, 160), 0.02/16, places=8)
        self.assertIsNone(advice.acrossFor(pool, 0.02/16/2))            # beyond twice the finest
        # no coarser than the scenes are
        self.assertEqual(advice.acrossFor(pool, 0.9), 20)
        other = advice.weighed([*known, series('c', 'picDem', 'rest', 2, 20.0)], 'picDem', 'waves')
        self.assertAlmostEqual(advice.foretoldError(other, 40), 0.02*1000**(0.1/2.1), places=6)

    def testHeldOutScenesAreNotLookedAt(self):
        known = [series(s, 'picDem', 'waves', 2, e)
                 for s, e in (('a', 0.01), ('b', 0.02), ('c', 0.03))]
        before = [h for h in advice.leaveOneOut(known) if h.scene == 'c']
        worse = [*known[:2], series('c', 'picDem', 'waves', 2, 0.3)]
        after = [h for h in advice.leaveOneOut(worse) if h.scene == 'c']
        # c's own errors are a tenth of what is foretold there: what is reached with the spacings of
        # a and b is as much more
        foretold = advice.weighed(known, 'picDem', 'waves', 'c')
        self.assertEqual([k.scene for k, _ in foretold], ['a', 'b'])
        for b, a in zip(before, after):
            self.assertAlmostEqual(b.reached/advice._between(
                known[2].errors, advice.acrossFor(foretold, b.asked), -2), 1, places=6)
            self.assertAlmostEqual(a.reached/advice._between(
                worse[2].errors, advice.acrossFor(foretold, a.asked), -2), 1, places=6)

    def testTheSameIn3DIsNoOtherScene(self):
        known = [series('a', 'picDem', 'waves', 2, 0.01),
                 series('a3D', 'picDem', 'waves', 2, 0.01, 3),
                 series('b', 'picDem', 'waves', 2, 0.01)]
        self.assertEqual([k.scene for k, _ in advice.weighed(known, 'picDem', 'waves', 'a')], ['b'])

    def testExactAtRestSaysNothingOfWaves(self):
        known = [series('a', 'picDem', 'waves', 2, 0.01),
                 series('pool', 'picDem', 'rest', 0, 1e-10)]
        self.assertEqual([k.scene for k, _ in advice.weighed(known, 'picDem', 'waves')], ['a'])
        self.assertEqual({k.scene for k, _ in advice.weighed(known, 'picDem', 'rest')},
                         {'a', 'pool'})

    def testCost(self):
        self.assertEqual(advice.costRatio(2, 'CPU, one thread', 1000, 2), 8)
        self.assertEqual(advice.costRatio(3, 'CPU, one thread', 1000, 2), 16)
        # steps alone, while the GPU is not full
        self.assertEqual(advice.costRatio(2, 'GPU', 1000, 2), 2)
        self.assertEqual(advice.costRatio(2, 'GPU', 1e5, 2), 8)
        known = [series('a', 'picDem', 'waves', 2, 0.01, steps=1),
                 series('a', 'sphDem', 'waves', 2, 0.01, steps=60)]
        self.assertAlmostEqual(advice.stepsRatio(known, 'picDem', 'sphDem', 2), 60)

    def testScore(self):
        found = advice.score([1, 1.9, 0.51, 2.1, 0.4])
        self.assertEqual((found.told, found.within), (5, 3))
        self.assertAlmostEqual(found.factor, 2.1)

    def testMeasuredOfTheAskedErrorIsTheCaseItself(self):
        known = [series('a', 'sphDem', 'dam break', 1, 0.02),
                 series('b', 'sphDem', 'dam break', 1, 0.02)]
        proposals, unknown = advise.propose(self.read(), known, 0.02, 0.02)
        self.assertEqual((len(proposals), unknown), (1, []))
        p = proposals[0]
        self.assertAlmostEqual(p.spacing, 0.01)
        self.assertAlmostEqual(p.cost, 10)          # 20 s for 2 s, as the dry run says
        # first order: half the spacing, 8 times the cost
        half = advise.propose(self.read(), known, 0.01, 0.02)[0][0]
        self.assertAlmostEqual(half.spacing, 0.005)
        self.assertAlmostEqual(half.cost, 80)
        self.assertAlmostEqual(half.memory, 4*160e3)

    def testCheapestFirst(self):
        known = [series(s, solver, 'dam break', 2, 0.01, steps=n) for s in ('a', 'b')
                 for solver, n in (('sphDem', 60), ('picDem', 1))]
        proposals, _ = advise.propose(self.read(), known, 0.01, None)
        self.assertEqual([p.solver for p in proposals], ['picDem', 'sphDem'])
        self.assertAlmostEqual(proposals[0].across, 40, places=5)


class OfACase(Case):
    def testRead(self):
        c = self.read()
        self.assertEqual((c.solver, c.dimensions, c.particles, c.steps, c.cost, c.place),
                         ('sphDem', 2, 1600, 2500, 10, 'CPU, one thread'))
        self.assertEqual((c.flow, c.length, c.memory), ('dam break', 0.4, 160e3))

    def testPicTellsItsSpacingByCells(self):
        self.write('system/controlDict', 'solver picDem; startTime 0; endTime 2;')
        self.write('log', log.replace('space            2D: x y; periodic: none',
                                      'grid             2D: 50 x 40 cells of 0.02 m along x y; '
                                      'periodic: none'))
        c = self.read()
        self.assertEqual((c.spacing, c.flow), (0.01, 'dam break'))
        self.write('constant/picProperties', 'seeds { perDirection 1; }')
        self.assertEqual(self.read().spacing, 0.02)
        self.write('log', log.replace('space            2D: x y; periodic: none',
                                      'grid             2D: 20 x 40 cells of 0.02 m along x y; '
                                      'periodic: none'))
        self.assertEqual(self.read().flow, 'rest')          # as wide as the water

    def testFlows(self):
        def flow():
            return self.read(length=1).flow
        self.write('system/setParticlesDict', 'spacing 0.01; regions ( pool { set fluid; '
                                              'source box; box (0 0 0) (1 0.5 0.1); } );')
        self.assertEqual(flow(), 'rest')
        self.assertEqual(self.read().length, 0.5)
        self.write('system/setParticlesDict',
                   'spacing 0.01; regions ( pool { set fluid; source box; box (0 0 0) (1 0.5 0.1); '
                   'velocity (0 1 0); } );')
        self.assertEqual(flow(), 'waves')
        self.write('constant/sphProperties', 'walls { motion { lid { patches (top); } } }')
        self.assertEqual(flow(), 'waves')
        self.write('constant/solidProperties', 'materials { }')
        self.assertEqual(flow(), 'bodies in water')
        with self.assertRaisesRegex(advise.Wrong, 'the diameter of the smallest body by -length'):
            self.read()
        self.assertIsNone(self.read(measured=0.02).length)
        self.write('system/setParticlesDict', 'spacing 0.01; bonds { }')
        self.assertEqual(flow(), 'elastic')

    def testWhereItDoesNotKnow(self):
        self.write('log', log.replace('periodic: none', 'periodic: x'))
        status, out, err = self.said('2%')
        self.assertEqual((status, out), (1, ''))
        self.assertIn('the dictionaries do not tell the kind of flow; give it by -flow: dam break, '
                      'waves', err)
        self.write('log', log)
        status, out, err = self.said('0.0001%', '-flow', 'waves', '-length', '1')
        self.assertEqual((status, err), (3, ''))
        self.assertIn('Not known: sphDem: 0.0001 % lies beyond what its scenes tell of', out)
        self.assertNotIn('Proposed', out)

    def testSaysWhatItRestsOn(self):
        status, out, err = self.said('1%')
        self.assertEqual((status, err), (0, ''))
        self.assertRegex(out, r'Taken for: dam break \(gravity, '
                              r'and water that does not reach from wall to wall\)')
        self.assertRegex(out, r'Length that matters: 0\.4 m, 40 spacings')
        self.assertRegex(
            out, r'Proposed: solver picDem, spacing [\d.]+ mm .*, precision mixed, device auto')
        self.assertRegex(out, r'expected error [\d.]+ %, from [\d.]+ to [\d.]+ %')
        self.assertRegex(out, r'rests on damBreak;')
        self.assertRegex(out, r'Not known: sphDem: no scene of this kind')
        self.assertRegex(out, r'\d+ of \d+ errors and \d+ of \d+ costs are within a factor of 2')

    def testWrongWords(self):
        for words, message in (
                (['2'], "the error '2' is no share"), (['-1%'], 'required|unrecognized|share'),
                (['0'], 'no share'), (['x%'], 'no share'),
                (['100%'], 'no share'), (['2%', '-measured', '2'], "the error '2' is no share"),
                (['2%', '-length', '0'], "-length '0' is no length"),
                (['2%', '-length', 'x'], 'is no length'),
                (['2%', '-flow', 'lava'], "-flow 'lava' is not known; there are dam break, waves"),
                (['2%', '-speed'], 'unrecognized'), ([], 'required')):
            status, out, err = self.said(*words)
            self.assertEqual((status, out, err.count('\n')), (1, '', 1), words)
            self.assertRegex(err, '^riprapAdvise: .*(' + message + ')', words)

    def testWrongCases(self):
        for name, text, message in (('system/controlDict', 'solver lava;',
                                     "solver of .* is 'lava'; sphDem, picDem, dem are known"),
                                    ('system/setParticlesDict', 'regions ( );', 'has no spacing'),
                                    ('log', 'nothing', 'does not say how many dimensions')):
            with open(os.path.join(self.case, name)) as f:
                kept = f.read()
            self.write(name, text)
            status, _, err = self.said('2%')
            self.assertEqual((status, err.count('\n')), (1, 1))
            self.assertRegex(err, message)
            self.write(name, kept)
        done = subprocess.run([os.path.join(root, 'bin', 'riprapAdvise'), '2%', '-case',
                               '/nowhere'], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr),
                         (1, 'riprapAdvise: there is no case /nowhere\n'))


class Score(unittest.TestCase):
    """Every scene of etc/advice.csv foretold from the others. The goal, 8 of 10 within a factor of
    2 of both, is not reached: bounds are below what is"""

    def testByOtherScenes(self):
        errors, costs, both, unknown = advice.scores(advice.read())
        print(f'by other scenes: {errors.within} of {errors.told} errors, {costs.within} '
              f'of {costs.told} costs, {both} of both within a factor of 2; {unknown} not known; '
              f'two thirds within {errors.factor:.2f} and {costs.factor:.2f}')
        self.assertGreaterEqual(errors.told, 30)
        self.assertGreaterEqual(errors.within, 0.45*errors.told)
        self.assertGreaterEqual(costs.within, 0.7*costs.told)
        self.assertLess(errors.factor, 4)

    def testByTheCasesOwnError(self):
        errors, costs, both, unknown = advice.scores(advice.read(), 'error')
        print(f'by the own error at the coarsest spacing: {errors.within} of {errors.told} errors, '
              f'{costs.within} of {costs.told} costs, {both} of both; {unknown} not known; '
              f'two thirds within {errors.factor:.2f} and {costs.factor:.2f}')
        self.assertGreaterEqual(errors.told, 35)
        self.assertGreaterEqual(errors.within, 0.7*errors.told)
        self.assertGreaterEqual(costs.within, 0.7*costs.told)
        self.assertLess(errors.factor, 2)

    def testByTheDifferenceOfTwoRuns(self):
        errors, costs, both, unknown = advice.scores(advice.read(), 'difference')
        print(f'by the difference of the two coarsest runs: {errors.within} of {errors.told} '
              f'errors, {costs.within} of {costs.told} costs, {both} of both; {unknown} not known')
        self.assertGreaterEqual(errors.told, 15)
        self.assertGreaterEqual(errors.within, 0.55*errors.told)

    def testADifferenceIsLookedAtAlone(self):
        """Of second order the difference of spacings of 1 and 2 is three times the finer's error:
        what follows is exact"""
        known = [series(s, 'picDem', 'waves', 2, e) for s, e in (('a', 0.01), ('b', 0.02))]
        for held in advice.leaveOneOut(known, 'difference'):
            self.assertAlmostEqual(held.reached/held.asked, 1, places=6)


if __name__ == '__main__':
    unittest.main()

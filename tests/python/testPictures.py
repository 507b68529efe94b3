# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of etc/python/riprap that draw: run by tests/regression/pictures.sh"""
import os
import sys
import tempfile
import unittest

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(here, '..', '..', 'etc', 'python'), here]

import madeCase                                          # noqa: E402
from riprap import clouds, plotting                      # noqa: E402
from riprap.dictionaries import readDictionary           # noqa: E402
from riprap.pictures import (PictureError, camera,       # noqa: E402
                             foamFiles, motions, options, panels, scene, shapes, sheet, style,
                             surface)
from riprap.pictures.points import within                # noqa: E402


class Surface(unittest.TestCase):
    def test_level_of_a_block_is_its_edge(self):
        x = madeCase.block((0, 0, 0), (1, 0.5, 0.02), 0.02)[:, :2]
        grid = surface.blend(x, 0.02, box=(np.zeros(2), np.array([2.0, 1.0])), refine=4)
        at = np.array([[0.5, y] for y in np.linspace(0.4, 0.6, 2001)])
        edge = at[np.argmin(np.abs(grid.at(at) - surface.level)), 1]
        self.assertAlmostEqual(edge, 0.5, delta=0.2*0.02)

    def test_full_up_to_walls(self):
        x = madeCase.block((0, 0, 0), (1, 0.5, 0.02), 0.02)[:, :2]
        grid = surface.blend(x, 0.02, box=(np.zeros(2), np.array([1.0, 1.0])), refine=4)
        walls = grid.at(np.array([[0, 0.2], [1, 0.2], [0.5, 0], [0, 0]]))
        self.assertLess(np.abs(walls - 1).max(), 0.1)
        self.assertGreater(grid.at(np.array([[0.5, 0.25]]))[0], 0.98)

    def test_volume_and_values(self):
        x = madeCase.block((0, 0, 0), (1, 0.5, 0.2), 0.05)
        grid = surface.blend(x, 0.05, value=x[:, 0])
        self.assertAlmostEqual(grid.f.sum()*np.prod(grid.cell), 0.1, delta=1e-3)
        middle = grid.value[tuple(
            np.round((np.array([0.5, 0.25, 0.1]) - grid.low)/grid.cell).astype(int))]
        self.assertAlmostEqual(middle, 0.5, delta=0.03)

    def test_single_drop_is_below_the_level(self):
        grid = surface.blend(np.array([[0.0, 0, 0]]), 0.1)
        self.assertLess(grid.f.max(), surface.level)

    def test_cells(self):
        counts, place = (4, 2, 1), np.array([(i, j, 0) for j in range(2) for i in range(4)])
        grid = surface.ofCells(counts, place, np.zeros(3), np.array([4.0, 2, 1]),
                               np.array([1.0, 1, 0, 0]*2), axes=(0, 1))
        self.assertEqual(grid.f.shape, (9, 5))
        self.assertGreater(grid.at(np.array([[1.0, 1.0]]))[0], 0.75)
        self.assertAlmostEqual(grid.at(np.array([[2.0, 1.0]]))[0], 0.5, delta=0.01)


class Shapes(unittest.TestCase):
    def test_closed_and_outwards(self):
        for points, triangles, volume in ((*shapes.box((0, 0, 0), (1, 2, 3)), 6),
                                          (*shapes.cylinder((0, 0, 0), (0, 0, 2), 0.5), np.pi/2),
                                          (*shapes.sphere((1, 1, 1), 0.5), np.pi/6),
                                          (*shapes.rotatedBox(np.zeros(3), (1, 2, 3), np.array([
                                                  1.0, 1, 0]), np.array([0, 0, 1.0])), 6)):
            got, centre, _ = shapes.massProperties(points, triangles)
            self.assertAlmostEqual(got, volume, delta=0.01*volume)
            edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]],
                                            triangles[:, [2, 0]]]), axis=1)
            self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all())

    def test_inertia_and_axes_of_a_turned_box(self):
        points, triangles = shapes.box((-0.5, -1, -1.5), (0.5, 1, 1.5))
        R, _ = motions.turned((1, 2, 3), 0.7, np.zeros(3))
        _, _, J = shapes.massProperties(points @ R.T + 5, triangles)
        axes = shapes.principalAxes(J)
        moments = np.diag(axes.T @ J @ axes)
        np.testing.assert_allclose(np.sort(moments),
                                   np.sort([6/12*(4 + 9), 6/12*(1 + 9), 6/12*(1 + 4)]), rtol=1e-6)
        self.assertAlmostEqual(np.linalg.det(axes), 1, places=9)

    def test_section_is_a_closed_line(self):
        lines = shapes.chains(shapes.section(*shapes.sphere((0, 0, 0.1), 1), 2, 0.1)[:, :, :2],
                              1e-7)
        self.assertEqual(len(lines), 1)
        np.testing.assert_allclose(lines[0][0], lines[0][-1], atol=1e-9)
        np.testing.assert_allclose(np.linalg.norm(lines[0], axis=1), 1, atol=0.01)

    def test_rigid_fit(self):
        R, _ = motions.turned((0, 1, 1), 1.1, np.zeros(3))
        x = np.random.default_rng(1).normal(size=(5, 3))
        got, shift = shapes.rigidFit(x, x @ R.T + (1, 2, 3))
        np.testing.assert_allclose(got, R, atol=1e-9)
        np.testing.assert_allclose(got @ x[0] + shift, R @ x[0] + (1, 2, 3), atol=1e-9)


class Motions(unittest.TestCase):
    def test_functions(self):
        R, s = motions.transformation({'solidBodyMotionFunction': 'linearMotion',
                                       'linearMotionCoeffs': {'velocity': '(1 0 2)'}}, 2, '')
        np.testing.assert_allclose(s, (2, 0, 4))
        R, s = motions.transformation({'solidBodyMotionFunction': 'rotatingMotion',
                                       'origin': '(1 0 0)', 'axis': '(0 0 1)', 'omega': '1'},
                                      np.pi/2, '')
        np.testing.assert_allclose(R @ (2, 0, 0) + s, (1, 1, 0), atol=1e-12)
        R, s = motions.transformation({'solidBodyMotionFunction': 'oscillatingLinearMotion',
                                       'amplitude': '(0.1 0 0)', 'omega': '2'}, np.pi/4, '')
        np.testing.assert_allclose(s, (0.1, 0, 0))
        self.assertIsNone(motions.transformation({'solidBodyMotionFunction': 'SDA'}, 1, ''))

    def test_table(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, 'motion'), 'w') as f:
                f.write('2\n(\n(0 ((0 0 0) (0 0 0)))\n(2 ((2 0 0) (0 0 90)))\n)\n')
            entries = {'solidBodyMotionFunction': 'tabulated6DoFMotion', 'CofG': '(0 0 0)',
                       'timeDataFileName': '"$FOAM_CASE/motion"'}
            R, s = motions.transformation(entries, 2, folder)
            np.testing.assert_allclose(R @ (1, 0, 0) + s, (2, 1, 0), atol=1e-12)
            np.testing.assert_allclose(motions.transformation(entries, 1, folder)[1], (1, 0, 0))


class Views(unittest.TestCase):
    def test_up_is_against_gravity(self):
        for gravity, flat in (((0, -9.81, 0), 2), ((0, 0, -9.81), 1), ((9.81, 0, 0), 2),
                              ((1, -9, 0), 2), ((0, 0, -9.81), None), ((0, -9.81, 0), None),
                              ((-9.81, 0, 0), None)):
            for view in ((None, 'front', 'back') if flat is not None
                         else (None, 'front', 'left', 'top', '200,-30')):
                c = camera.choose(gravity, flat, (1.0, 0.6, 0.3), view)
                frame = np.array([c.right, c.up, c.toEye])
                np.testing.assert_allclose(frame @ frame.T, np.eye(3), atol=1e-9)
                self.assertAlmostEqual(np.linalg.det(frame), 1, places=9)
                self.assertGreater(np.dot(c.up, -np.array(gravity)), 0)
                self.assertAlmostEqual(np.dot(c.right, gravity), 0, places=9)

    def test_front_of_xz(self):
        c = camera.choose((0, 0, -9.81), 1, (1, 1, 1))
        np.testing.assert_allclose(c.right, (1, 0, 0))

    def test_everything_fits(self):
        for view in ('oblique', 'top', 'left', '130,40'):
            c = camera.choose((0, 0, -9.81), None, (2.0, 1, 1), view)
            corners = camera.corners((5, 5, 5), (7, 6, 6))
            for shape in (None, 0.7, 3.0):
                c.fit(corners, shape)
                places, _ = c.project(corners)
                self.assertLess(np.abs(places).max(), 1)
                self.assertGreater(np.abs(places).max(), 0.85)

    def test_wrong_views(self):
        for view, flat in (('side', None), ('top', 2), ('3,95', None)):
            with self.assertRaises(PictureError):
                camera.choose((0, -9.81, 0), flat, (1, 1, 1), view)

    def test_a_far_sky_is_left_out(self):
        low, high = camera.shown(((0, 0, 0), (1, 10, 1)), [(np.zeros(3), np.array([1.0, 0.5, 1]))],
                                 np.array([0.0, 1, 0]))
        self.assertLess(high[1], 1)
        self.assertEqual((high[0], high[2]), (1, 1))


class Files(unittest.TestCase):
    def test_mesh_and_fields(self):
        with tempfile.TemporaryDirectory() as folder:
            madeCase.mesh(folder, (0, 0, 0), (3, 2, 1), (3, 2, 1),
                          {'zLow': 'empty', 'zHigh': 'empty'})
            mesh = foamFiles.Mesh(folder)
            self.assertEqual(mesh.emptyAxis, 2)
            self.assertEqual([len(p.faces) for p in mesh.patches], [2, 2, 3, 3, 6, 6])
            counts, place = mesh.lattice()
            self.assertEqual(list(counts), [3, 2, 1])
            self.assertEqual([tuple(p) for p in place[:4]],
                             [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0)])

    def test_binary_faces(self):
        starts, corners = np.array([0, 4, 8, 11], dtype='<i4'), np.arange(11, dtype='<i4')
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, 'faces'), 'wb') as f:
                f.write(madeCase.header('faceCompactList', 'faces', 'binary').encode() + b'4\n('
                        + starts.tobytes() + b')\n\n11\n(' + corners.tobytes() + b')\n')
            faces = foamFiles.boundaryFaces(os.path.join(folder, 'faces'), 1)
        self.assertEqual([list(f) for f in faces], [[4, 5, 6, 7], [8, 9, 10]])

    def test_binary_cloud_and_field(self):
        with tempfile.TemporaryDirectory() as folder:
            x = np.arange(6.0).reshape(2, 3)
            body = b'2\n(\n' + b''.join(b'(' + row.tobytes() + np.int32(0).tobytes() + b')\n'
                                        for row in x) + b')\n'
            with open(os.path.join(folder, 'positions'), 'wb') as f:
                f.write(madeCase.header('Cloud', 'positions', 'binary').encode() + body)
            np.testing.assert_array_equal(clouds.readPositions(os.path.join(folder, 'positions')),
                                          x)
            with open(os.path.join(folder, 'alpha.water'), 'wb') as f:
                f.write(madeCase.header('volScalarField', 'alpha.water', 'binary').encode()
                        + b'internalField nonuniform List<scalar> 3(' +
                        np.array([0.0, 0.5, 1]).tobytes() + b');\nboundaryField {}\n')
            np.testing.assert_array_equal(foamFiles.volumeField(os.path.join(folder, 'alpha.water'),
                                                                3), [0, 0.5, 1])

    def test_cloud_without_particles(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, 'positions'), 'w') as f:
                f.write(madeCase.header('Cloud', 'positions', 'ascii') + '0\n(\n)\n')
            self.assertEqual(clouds.readPositions(os.path.join(folder, 'positions')).shape, (0, 3))

    def test_stl(self):
        points, triangles = shapes.box((0, 0, 0), (1, 1, 1))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'a.stl')
            with open(path, 'w') as f:
                f.write('solid a\n' + ''.join('facet normal 0 0 0\nouter loop\n' + ''.join(
                    'vertex %g %g %g\n' % tuple(points[i]) for i in t) + 'endloop\nendfacet\n'
                                              for t in triangles) + 'endsolid\n')
            got, faces = foamFiles.readSurface(path, 2.0)
            self.assertEqual((len(got), len(faces)), (8, 12))
            self.assertAlmostEqual(shapes.massProperties(got, faces)[0], 8)
            with open(path, 'w') as f:
                f.write('nothing')
            with self.assertRaises(PictureError):
                foamFiles.readSurface(path)

    def test_dictionary_that_is_taken_in(self):
        got = readDictionary('', text='a { type box; n 3; } b { $a; n 4; }')
        self.assertEqual(got['b'], {'type': 'box', 'n': '4'})


class Scenes(unittest.TestCase):
    def test_length_before_a_list_is_no_point(self):
        for text in ('((0 1 2) (3 4 5))', '2((0 1 2) (3 4 5))', '2 ( ( 0 1 2 ) ( 3 4 5 ) )'):
            np.testing.assert_array_equal(scene.pointsOf(text), np.arange(6.0).reshape(2, 3))

    def test_shape_of_a_body_is_where_its_pose_says(self):
        with tempfile.TemporaryDirectory() as folder:
            madeCase.mesh(folder, (0, 0, 0), (2, 2, 2))
            madeCase.gravity(folder, (0, 0, -9.81))
            x = np.array([[0.5, 0.5, 0.5], [0.7, 0.5, 0.5], [0.5, 0.8, 0.5], [0.5, 0.5, 0.6]])
            R, _ = motions.turned((0, 0, 1), np.pi/2, np.zeros(3))
            centre = x.mean(axis=0)
            y = (x - centre) @ R.T + (1.2, 1.1, 1.0)
            for time, places in (('0', x), ('1', y)):
                madeCase.cloud(folder, time, 'solids', places, radius=np.full(4, 0.1),
                               group=np.zeros(4, dtype=int), clump=np.zeros(4, dtype=int),
                               origId=np.arange(4))
            madeCase.put(os.path.join(folder, '0', 'uniform', 'lagrangian', 'solids'),
                         'cloudProperties',
                         madeCase.header('dictionary', 'cloudProperties')
                         + 'surfaces { crate { body 0; source box; box (0.4 0.4 0.4) '
                           '(0.8 0.9 0.7); } }\n')
            clumps = os.path.join(folder, '0', 'uniform', 'lagrangian', 'solids', 'clumps')
            for name, kind, values in (('position', 'vectorField', [centre]),
                                       ('orientationReal', 'scalarField', [1.0]),
                                       ('orientationImaginary', 'vectorField', [[0, 0, 0]]),
                                       ('startPosition', 'vectorField', [centre]),
                                       ('startOrientationReal', 'scalarField', [1.0]),
                                       ('startOrientationImaginary', 'vectorField', [[0, 0, 0]]),
                                       ('group', 'labelField', [0])):
                madeCase.put(clumps, name,
                             madeCase.header(kind, name) + madeCase.listOf(np.array(values)))
            case = scene.Case(folder)
            bodies = [i for i in case.frame('0', None).items if i.kind == 'body']
            self.assertEqual(len(bodies), 1)
            np.testing.assert_allclose(bodies[0].points.max(axis=0), (0.8, 0.9, 0.7), atol=1e-9)
            # a picture without poses: from its particles
            moved = [i for i in case.frame('1', None).items if i.kind == 'body'][0]
            np.testing.assert_allclose(moved.points, (bodies[0].points
                                                      - centre) @ R.T + (1.2, 1.1, 1.0), atol=1e-7)
            self.assertFalse(case.frame('1', None).balls)

    def test_choices(self):
        with tempfile.TemporaryDirectory() as folder:
            case = scene.Case(madeCase.damBreak(folder))
            self.assertEqual(case.choices(), ['none', 'U', 'p'])
            o = options.Options(['-case', folder, '-strip', '2'])
            self.assertEqual(o.chosenTimes(case), ['0.2', '0.4'])
            self.assertEqual(options.Options(['-times', '0.11,last']).chosenTimes(case),
                             ['0.1', '0.4'])
            with self.assertRaises(PictureError):
                options.Options(['-field', 'T']).chosenField(case)

    def test_hidden_groups_and_walls(self):
        with tempfile.TemporaryDirectory() as folder:
            case = madeCase.damBreak(folder)
            for time in ('0', '0.1'):
                madeCase.cloud(case, time, 'solids', [(0.8, 0.1, 0.01), (0.85, 0.1, 0.01),
                                                      (2, 0.1, 0.01)], radius=np.full(3, 0.02),
                               group=np.array([0, 1, 1]), origId=np.arange(3))
            madeCase.put(os.path.join(case, '0', 'uniform', 'lagrangian', 'solids'),
                         'cloudProperties',
                         madeCase.header('dictionary',
                                         'cloudProperties') + 'groups 2 ( stone far );\n')
            made = scene.Case(case)
            whole = made.frame('0.1', None)
            self.assertEqual(made.names(), {'patches': ['xLow', 'xHigh', 'yLow', 'yHigh'],
                                            'surfaces': [], 'groups': ['stone', 'far']})
            made.hide(['f.*', 'xHigh'])
            frame = made.frame('0.1', None)
            self.assertEqual([len(b[0]) for b in frame.balls], [1])
            self.assertEqual([len(whole.items) - len(frame.items), len(frame.unseen)], [1, 1])
            # what is hidden holds no place on the picture, but the tank is as large
            self.assertLess(max(high[0] for _, high in frame.boxes), 1.1)
            self.assertEqual(sheet.Picture(made, ['0.1'], None).window[1][0], 1)
            with self.assertRaisesRegex(PictureError, 'groups stone, far'):
                made.hide(['fur'])

    def test_obstacles_end_at_the_mesh(self):
        with tempfile.TemporaryDirectory() as folder:
            # no wall but the floor: more than the mesh is looked at
            case = madeCase.damBreak(folder, 2, None, spacing=0.05)
            madeCase.mesh(case, (0, 0, 0), (1, 0.3, 0.42),
                          kinds={s: 'patch' for s in madeCase.sides if s != 'zLow'})
            madeCase.put(os.path.join(case, 'constant'), 'geometry',
                         madeCase.header('dictionary', 'geometry') +
                         'column { type searchableCylinder; point1 (0.7 0.15 -0.2); '
                         'point2 (0.7 0.15 1); radius 0.05; }\n')
            made = scene.Case(case)
            picture = sheet.Picture(made, ['0'], None)
            frame, window = picture.frames[0], picture.window
            self.assertGreater(window[1][2], 0.43)
            sides = panels.contents(made, frame, picture.camera, None, window)['bounds']
            self.assertAlmostEqual(sides[5][0][2], 0.42, delta=1e-3)
            self.assertAlmostEqual(sides[4][0][2], 0, delta=1e-3)
            column = [i for i in frame.items if i.kind == 'obstacle'][0]
            cut = within(column.points[column.triangles], camera.common(window, frame.bounds), 0.1)
            np.testing.assert_allclose((cut[:, :, 2].min(), cut[:, :, 2].max()), (0, 0.42),
                                       atol=1e-9)

    def test_limits(self):
        self.assertEqual(style.limits([np.array([0.0, 1, 2])], 'U')[0], 0)
        low, high = style.limits([np.linspace(-1, 3, 100)], 'p')
        self.assertEqual(low, -high)


class Sheets(unittest.TestCase):
    def test_layout(self):
        for count, shape, size, columns in ((6, 1.1, (1200, None), 3), (4, 0.3, (1400, None), 2),
                                            (3, 0.5, (1400, None), 3), (1, 3.0, (1400, None), 1),
                                            (2, 1.0, (900, 500), 2)):
            made = sheet.Layout(count, shape, size, True, True)
            self.assertEqual(made.columns, columns, (count, shape))
            self.assertLessEqual(made.size[1], size[1] or 0.8*size[0] + 1)
            self.assertAlmostEqual(made.high/made.wide, shape, places=6)
            for x, y, w, h in made.places + [made.barPlace]:
                self.assertTrue(x >= 0 and y >= 0 and x + w <= 1 and y + h <= 1)
            boxes = [(x, x + w, y, y + h) for x, y, w, h in made.places]
            self.assertFalse(any(a[0] < b[1] and b[0] < a[1] and a[2] < b[3] and b[2] < a[3]
                                 for i, a in enumerate(boxes) for b in boxes[:i]))

    def test_decimals_of_times(self):
        self.assertEqual([sheet.timeDigits(t)
                          for t in ([0.1, 0.4], [0.15, 0.3], [0.002, 0.004], [1, 2])], [1, 2, 3, 1])


class Charts(unittest.TestCase):
    def test_pareto(self):
        self.assertEqual(plotting.pareto([(3, 1), (1, 5), (2, 2), (2.5, 3), (4, 1.5)]),
                         [(1, 5), (2, 2), (3, 1)])

    def test_names_do_not_overlap(self):
        at = plotting.spread(np.array([0.5, 0.5, 0.52, 0.9]), np.full(4, 0.1), 0, 1)
        self.assertTrue((np.diff(at) >= 0.1 - 1e-3).all())

    def test_plain_numbers(self):
        self.assertEqual([plotting.plain(v) for v in (0.02, 5, 300, 20000, 1e-6)],
                         ['0.02', '5', '300', '20 000', '$10^{-6}$'])

    def test_names_stand_beside_curves(self):
        fig, (axis,) = plotting.figure(1)
        axis.semilogy([0, 1], [1, 10], label='one')
        axis.semilogy([0, 1], [1, 3], label='other')
        plotting.named(axis)
        with tempfile.TemporaryDirectory() as folder:
            plotting.save(fig, os.path.join(folder, 'a.png'))
        self.assertEqual(sorted(t.get_text() for t in axis.texts), ['one', 'other'])
        self.assertIsNone(axis.get_legend())


if __name__ == '__main__':
    unittest.main()

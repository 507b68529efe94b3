# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tests share: histories of spheres, reference points"""
import csv
import math
import os

import numpy as np

from riprap.dictionaries import numberOf

here = os.path.dirname(os.path.abspath(__file__))


class Sphere:
    """A sphere's line of constant/particles.csv and its history"""

    def __init__(self, run, index, line, table):
        self.radius, self.material = float(line['radius']), line['material']
        self.t = table['Time']

        def of(name):
            return np.column_stack([table[f'{index}{name}{axis}'] for axis in 'xyz'])

        self.x = np.column_stack([table[f'{index}{axis}'] for axis in 'XYZ'])
        self.U, self.W, self.F = of('U'), of('W'), of('F')
        m = run.solid['materials'][self.material]
        if 'rho' in m:
            self.E, self.nu, self.rho = (numberOf(m[k]) for k in ('E', 'nu', 'rho'))
            self.mass = self.rho*4/3*math.pi*self.radius**3


def spheres(run):
    table = run.table('bodies')
    with open(os.path.join(run.path, 'constant', 'particles.csv')) as f:
        return [Sphere(run, i, line, table) for i, line in enumerate(csv.DictReader(f))]


def testOf(run):
    return run.dictionary('system/test')['name']


def points(name):
    """A table of numbers of reference/"""
    return np.loadtxt(os.path.join(here, 'reference', name + '.csv'), delimiter=',', skiprows=1)


def records(name):
    """A table of reference/ as columns by name, numbers where they are"""
    with open(os.path.join(here, 'reference', name + '.csv')) as f:
        rows = list(csv.DictReader(f))

    def column(key):
        values = [r[key] for r in rows]
        try:
            return np.array([float(v) for v in values])
        except ValueError:
            return np.array(values)
    return {key: column(key) for key in rows[0]}


def rms(differences):
    return float(np.sqrt(np.mean(np.square(differences))))

# SPDX-License-Identifier: GPL-3.0-or-later
"""What interFoam and interIsoFoam give, in the quantities of riprap's tutorials: (name, computed,
error)"""
import glob
import os
import re

import numpy as np

from riprap import fronts, measures
from riprap.bounds import root
from riprap.waves import Wave, exactPeriod

from .cases import gauges, scenes


def reference(scene, name):
    return os.path.join(root(), 'tutorials', 'sphDem', scene, 'reference', name + '.csv')


def lastOf(case, pattern):
    return sorted(glob.glob(os.path.join(case, 'postProcessing', pattern)))[-1]


def pressures(case, cell):
    """As tutorials/sphDem/dambreakPressure/analysis.py"""
    table = np.loadtxt(lastOf(case, 'wallProbes/*/p'))
    T, p = table[:, 0]*np.sqrt(9.81/0.3), table[:, 1:]/(1000*9.81*0.3)
    band = np.loadtxt(reference('dambreakPressure', 'lobovsky2014_sensor2_percentiles'),
                      delimiter=',', skiprows=1)
    plateau = (T >= 3.6) & (T <= 5)
    arrival = [measures.crossing(t, q, 0.5) for t, q in ((T, p[:, 1]), (band[:, 0], band[:, 2]))]
    yield 'arrival at sensor 2, t sqrt(g/H)', arrival[0], abs(arrival[0]/arrival[1] - 1)
    yield ('peak at sensor 2 [rho g H]', measures.movingAverage(T, p[:, 1], 0.05)[T < 3.2].max(),
           None)
    measured = band[(band[:, 0] >= 3.6) & (band[:, 0] <= 5), 2].mean()
    mean = np.trapezoid if hasattr(np, 'trapezoid') else np.trapz
    for i, name in enumerate(['3 mm', 'sensor 2', '30 mm', '80 mm']):
        value = mean(p[plateau, i], T[plateau])/np.ptp(T[plateau])
        yield f'plateau at {name}', value, abs(value/measured - 1) if name == 'sensor 2' else None
    np.savetxt(os.path.join(case, 'sensor2.csv'), np.column_stack([
        np.linspace(2, 5.4, 341), np.interp(np.linspace(2, 5.4, 341), T, p[:, 1])]), delimiter=',',
               header='t sqrt(g/H),p/(rho g H)', comments='', fmt='%.5g')


def frontOfBox(case, cell):
    """Time of the first kilopascal at the lowest sensor; means of all from 0.45 to 0.9 s, as in
    tutorials/sphDem/damBreakBox"""
    table = np.loadtxt(lastOf(case, 'wallProbes/*/p'))
    t, p = table[:, 0], table[:, 1:]
    yield 'arrival at P1 [s]', measures.crossing(t, p[:, 0], 1000), None
    times = np.linspace(0.45, 0.9, 2001)
    for k in range(p.shape[1]):
        yield (f'mean at P{k + 1}, 0.45 to 0.9 s [Pa]', float(np.interp(times, t, p[:, k]).mean()),
               None)


def folders(case, name):
    """Of a set's times, in order: time, folder"""
    found = glob.glob(os.path.join(case, 'postProcessing', name, '*'))
    return sorted((float(os.path.basename(f)), f) for f in found)


def sampled(case):
    """Small tables of what the solver has sampled: floor.txt (t, alpha along the lowest row),
    heights.txt (t, sum of alpha over each column); made once"""
    for name, file, of in (('floor', 'row', lambda a: a),
                           ('heights', 'column*', lambda a: [a.sum()])):
        path = os.path.join(case, name + '.txt')
        if os.path.exists(path):
            continue
        rows = []
        for time, folder in folders(case, name):
            files = sorted(glob.glob(f'{folder}/{file}_alpha.water.xy'),
                           key=lambda f: int(re.sub(r'\D', '', os.path.basename(f)) or 0))
            rows.append([time, *(v for f in files for v in of(np.loadtxt(f)[:, 1]))])
        if rows:
            np.savetxt(path, rows, fmt='%.9g')


def levels(case, cell):
    """t and the water over each point [m], (times, points)"""
    sampled(case)
    table = np.loadtxt(os.path.join(case, 'heights.txt'))
    return table[:, 0], table[:, 1:]*cell


def frontHistory(case, cell):
    """t and where the lowest row of cells is half full"""
    sampled(case)
    table, front = np.loadtxt(os.path.join(case, 'floor.txt')), []
    for alpha in table[:, 1:]:
        last = np.flatnonzero(alpha >= 0.5)[-1]
        part = 0 if last == len(alpha) - 1 else (alpha[last] - 0.5)/(alpha[last] - alpha[last + 1])
        front.append((last + 0.5 + part)*cell)
    return table[:, 0], np.array(front)


def collapse(case, cell):
    """As tutorials/sphDem/damBreak/analysis.py; the height is the water in the column of cells at
    the wall"""
    a, W = 0.146, 0.584
    t, front = frontHistory(case, cell)
    tH, height = levels(case, cell)
    rate = np.sqrt(9.81/a)
    hit = measures.crossing(t, front, W - 2*cell)
    for name, file in (('Koshizuka & Oka', 'koshizukaOka1996_front'),
                       ('Martin & Moyce n2=2', 'martinMoyce1952_n2_2_front')):
        early = t <= hit
        shift, rms = fronts.fitShift(t[early]*rate*2**0.5, front[early]/a,
                                     fronts.readReference(reference('damBreak', file)))
        yield f'front rms [a], {name}', None, rms
        yield f'shift in T of the gate, {name}', shift, None
    for name, file, factor in (('Koshizuka & Oka', 'koshizukaOka1996_height', 2**0.5),
                               ('Martin & Moyce n2=2', 'martinMoyce1952_n2_2_height', 1)):
        data = fronts.readReference(reference('damBreak', file))
        when = data[:, 0]/(rate*factor)
        keep = when <= 0.5
        yield (f'height rms [a], {name}', None,
               measures.rms(np.interp(when[keep], tH, height[:, 0]/a) - 2*data[keep, 1]))
    yield 'far wall hit [s]', hit, None
    log = open(os.path.join(case, 'log.run')).read()
    part = [float(v) for v in re.findall(r'Phase-1 volume fraction = (\S+)', log)]
    yield 'water lost by the end', 1 - part[-1]/part[0], None


class VofWave(Wave):
    """The fit of the tutorial, of the water's height at its gauges"""

    def __init__(self, case, cell):
        self.L, self.H = scenes['standingWave'].width, scenes['standingWave'].water[1]
        self.k = 2*np.pi/self.L
        self.omega = np.sqrt(9.81*self.k*np.tanh(self.k*self.H))
        self.period = 2*np.pi/self.omega
        self.decay = 2*1e-6*self.k**2
        x = np.array(gauges(cell))
        self.t, heights = levels(case, cell)
        self.mode = 2*np.mean(heights*np.cos(self.k*x), axis=1)


def wave(case, cell):
    w = VofWave(case, cell)
    omega, decay, amplitude = w.fit()
    period = 2*np.pi/omega
    yield 'period [s]', period, abs(period/exactPeriod() - 1)
    yield 'change of the amplitude a period', np.exp(-(decay - w.decay)*period) - 1, None
    yield 'amplitude [m]', amplitude, None


def readField(path):
    with open(path) as f:
        text = f.read()
    start = text.index('internalField')
    if text[start:].split()[1] == 'uniform':
        return np.array([float(re.search(r'uniform (\S+);', text[start:]).group(1))])
    body = text[text.index('(', text.index('\n', start)) + 1:text.index('\n)', start)]
    values = np.array(body.replace('(', ' ').replace(')', ' ').split(), float)
    return values.reshape(-1, 3) if 'List<vector>' in text[start:start + 100] else values


def pool(case, cell):
    """Largest speed in the water over all written times; pressure in it at the end"""
    speed, scene = 0, scenes['hydrostatic']
    times = sorted((d for d in os.listdir(case) if re.fullmatch(r'[\d.]+', d) and float(d) > 0),
                   key=float)
    for t in times:
        U, alpha = readField(f'{case}/{t}/U'), readField(f'{case}/{t}/alpha.water')
        if len(U) == len(alpha):
            speed = max(speed, np.linalg.norm(U[alpha > 0.99], axis=1).max())
    yield 'largest speed [m/s]', speed, None
    nx = round(scene.width/cell)
    p, y = readField(f'{case}/{times[-1]}/p'), (np.arange(len(alpha))//nx + 0.5)*cell
    deep = y < scene.water[1] - cell
    yield 'pressure L2', None, measures.relativeL2(p[deep], 1000*9.81*(scene.water[1] - y[deep]))


of = {'damBreak': collapse, 'damBreakBox': frontOfBox, 'dambreakPressure': pressures,
      'standingWave': wave, 'hydrostatic': pool}

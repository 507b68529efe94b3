# SPDX-License-Identifier: GPL-3.0-or-later
"""Rocks are dumped into water: do they come down, does anything overlap, is the water kept?"""
import itertools
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def tank(run, entry):
    return numberOf(run.dictionary('system/tank')[entry])


def members(run, name):
    """Balls, those of clumps and in stones too; which body each belongs to"""
    cloud = clouds.readCloud(run.path, name, ('radius', 'U'), 'solids')
    ofClump = os.path.join(run.path, name, 'lagrangian', 'solids', 'clump')
    body = clouds.readField(ofClump) if os.path.exists(ofClump) else np.arange(len(cloud['radius']))
    return cloud['positions'], cloud['radius'], cloud['U'], body


def centres(run, name):
    """Of the bodies' balls"""
    x, r, u, body = members(run, name)
    return np.array([x[body == b].mean(axis=0) for b in np.unique(body)])


def closestBalls(run, name):
    """Smallest distance of two surfaces that are not of one body; the lowest"""
    x, r, u, body = members(run, name)
    d = np.sqrt(((x[:, None] - x[None])**2).sum(axis=2)) - r[:, None] - r[None]
    return d[body[:, None] != body[None]].min(), (x[:, 1] - r).min()


def facets(path):
    """Triangles of an STL file, (n, 3, 3)"""
    with open(path) as f:
        return np.array([[float(v) for v in line.split()[1:]] for line in f
                         if line.split()[:1] == ['vertex']]).reshape(-1, 3, 3)


def middleAndAxes(t):
    """Of what the triangles enclose: its centre, the axes of its inertia as columns"""
    volume = np.linalg.det(t)/6
    middle = (volume[:, None]*t.sum(axis=1)/4).sum(axis=0)/volume.sum()
    t = t - middle
    volume, s = np.linalg.det(t)/6, t.sum(axis=1)
    second = np.einsum('f,fi,fj->ij', volume/20, s, s) + np.einsum('f,fvi,fvj->ij', volume/20, t, t)
    return middle, np.linalg.eigh(np.trace(second)*np.eye(3) - second)[1]


def turns(run, name):
    """Rotations from the axes of each clump to space"""
    folder = os.path.join(run.path, name, 'uniform', 'lagrangian', 'solids', 'clumps')
    w, v = (clouds.readField(os.path.join(folder, part))
            for part in ('orientationReal', 'orientationImaginary'))
    cross = np.zeros((len(w), 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        cross[:, k, j], cross[:, j, k] = v[:, i], -v[:, i]
    R = np.eye(3) + 2*w[:, None, None]*cross + 2*cross @ cross
    return clouds.readField(os.path.join(folder, 'position')), R


def depth(points, t):
    """Of points in a convex surface; negative outside, there at least as far away"""
    n = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
    n /= np.linalg.norm(n, axis=1)[:, None]
    return -(points @ n.T - (n*t[:, 0]).sum(axis=1)).max(axis=1)


def stones(run, name):
    """Surfaces of the stones at a time, (n, triangles, 3, 3). Their clumps turn with the axes of
    inertia; which way these point tells the balls, which are inside"""
    given = facets(os.path.join(run.path, 'constant', 'triSurface', 'stone.stl'))
    x, r, u, body = members(run, name)
    at, R = turns(run, name)
    shapes = run.dictionary(name + '/uniform/lagrangian/solids/cloudProperties')['shapes']
    scales = [numberOf(shape['scale']) for shape in shapes.values()]
    kind = clouds.readField(os.path.join(run.path, name, 'uniform', 'lagrangian', 'solids',
                                         'clumps', 'shape')).astype(int)
    middle, axes = middleAndAxes(given)
    result = []
    for b in range(len(at)):
        inside = x[body == b], r[body == b]
        candidates = []
        for order in itertools.permutations(range(3)):
            for signs in itertools.product((1, -1), repeat=3):
                turned = axes[:, order]*signs
                if np.linalg.det(turned) > 0:
                    t = at[b] + scales[kind[b]]*(given - middle) @ turned @ R[b].T
                    candidates.append(((depth(inside[0], t) - inside[1]).min(), t))
        out, t = max(candidates, key=lambda c: c[0])
        assert out > -1e-3*inside[1].max(), (b, out)
        result.append(t)
    return np.array(result)


def dense(t, n=8):
    """Points on triangles"""
    weights = [(i/n, j/n, 1 - (i + j)/n) for i in range(n + 1) for j in range(n + 1 - i)]
    return np.einsum('wv,fvd->fwd', np.array(weights), t).reshape(-1, 3)


def closestStones(run, name):
    """As closestBalls, by points on one surface and the planes of another, which are convex: right
    where they overlap, else no more than their distance"""
    all = stones(run, name)
    middle, reach = (all.mean(axis=(1, 2)),
                     np.linalg.norm(all - all.mean(axis=(1, 2), keepdims=True), axis=3).max())
    near = [-depth(dense(a), b).max() for i, a in enumerate(all) for j, b in enumerate(all)
            if i != j and np.linalg.norm(middle[i] - middle[j]) < 2.5*reach]
    return min(near, default=np.inf), all[..., 1].min()


def closest(run, name):
    return (closestStones if shape(run) == 'stones' else closestBalls)(run, name)


def shape(run):
    return run.dictionary('system/shape')['shape']


def water(run, name):
    """Particles"""
    return len(clouds.readCloud(run.path, name, ())['positions'])


def analyse(run):
    names = clouds.times(run.path)
    x = centres(run, names[-1])
    lost = 1 - water(run, names[-1])/water(run, names[1])
    apart = [closest(run, n) for n in names]
    return [Quantity('end [s]', computed=float(names[-1])),
            Quantity('smallest distance of two surfaces [m]',
                     computed=float(min(a[0] for a in apart))),
            Quantity('lowest rock above the floor [m]', computed=float(min(a[1] for a in apart))),
            Quantity('mean height of the rocks [m]', computed=float(x[:, 1].mean())),
            Quantity('fastest rock [m/s]',
                     computed=float(np.sqrt((members(run, names[-1])[2]**2).sum(axis=1)).max())),
            Quantity('rocks', computed=len(x)),
            Quantity('water lost', computed=lost)]


def plot(runs, path):
    fig, axes = plotting.figure(len(runs))
    for run, axis in zip(runs, np.atleast_1d(axes)):
        for name in clouds.times(run.path):
            x = centres(run, name)
            axis.plot(float(name) + 0*x[:, 1], x[:, 1], '.', color='C0', markersize=3)
        axis.axhline(tank(run, 'waterHeight'), color='C1', linewidth=0.8)
        axis.set(xlabel='t [s]', ylabel='heights of the rocks [m]', title=run.name)
    plotting.save(fig, path)


coarse = 'system/tank:nx 48; system/tank:ny 72; system/tank:nz 24; system/tank:spacing 0.005'
Study(
    scene='picRockDumping',
    variants=[Variant('rocks')] + [Variant(kind, [
        '-endTime', '0.5', '-set', f'system/shape:shape {kind}']) for kind in ('clumps', 'stones')],
    quick=[Variant('rocks-quick', ['-endTime', '0.12', '-set', coarse])],
    analyse=analyse,
    plot=plot,
    headline='water lost',
).main(here)

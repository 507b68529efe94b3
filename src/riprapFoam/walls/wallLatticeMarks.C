// SPDX-License-Identifier: GPL-3.0-or-later
/*  Which cells of the lattice are wall: behind faces, convex edges and convex corners */

#include "wallLattice.H"

namespace Foam
{

void wallLattice::markFaces()
{
    const triSurface& surface = wall_.surface;
    forAll(axis_, f)
    {
        const labelledTri& t = surface.localFaces()[f];
        const label a = axis_[f], b = (a + 1) % 3, c = (a + 2) % 3;
        const point &p = at_[t[0]], &q = at_[t[1]], &r = at_[t[2]];
        const label from = planeNode(a, (p[a] + q[a] + r[a])/3);

        label b0, b1, c0, c1;
        range(b, min(min(p[b], q[b]), r[b]), max(max(p[b], q[b]), r[b]), b0, b1);
        range(c, min(min(p[c], q[c]), r[c]), max(max(p[c], q[c]), r[c]), c0, c1);

        // Twice the areas that a point makes with each side; one sign inside
        auto side = [&](const point& u, const point& v, scalar y, scalar z)
        {
            return (v[b] - u[b])*(z - u[c]) - (v[c] - u[c])*(y - u[b]);
        };
        const scalar sense = side(p, q, r[b], r[c]) < 0 ? -1 : 1;
        const scalar slack = -1e-6*s_*s_;

        for (label j = b0; j < b1; ++j)
        {
            for (label k = c0; k < c1; ++k)
            {
                const scalar y = centre_[b][j], z = centre_[c][k];
                if
                (
                    sense*side(p, q, y, z) < slack
                 || sense*side(q, r, y, z) < slack
                 || sense*side(r, p, y, z) < slack
                )
                {
                    continue;
                }
                point foot;
                foot[a] = nodes_[a][from];
                foot[b] = y;
                foot[c] = z;
                for (label l = 0; l < wall_.layers; ++l)
                {
                    Key key;
                    key[a] = behind(from, solid_[f], l);
                    key[b] = j;
                    key[c] = k;
                    if (key[a] < 0 || key[a] >= nodes_[a].size() - 1) break;
                    mark(key, l, t.region(), foot);
                }
            }
        }
    }
}


void wallLattice::markEdges()
{
    const triSurface& surface = wall_.surface;
    forAll(kinds_, e)
    {
        if (kinds_[e] != wallSurface::edgeKind::convex) continue;

        const label f = surface.edgeFaces()[e][0], g = surface.edgeFaces()[e][1];
        const label a = axis_[f], b = axis_[g];
        if (a == b) continue;           // two sides of one plane
        const label c = 3 - a - b;
        const point &p = at_[surface.edges()[e][0]], &q = at_[surface.edges()[e][1]];
        const label fromA = planeNode(a, p[a]), fromB = planeNode(b, p[b]);
        const label source = min(
            surface.localFaces()[f].region(), surface.localFaces()[g].region());

        label c0, c1;
        range(c, min(p[c], q[c]), max(p[c], q[c]), c0, c1);
        for (label k = c0; k < c1; ++k)
        {
            point foot;
            foot[a] = nodes_[a][fromA];
            foot[b] = nodes_[b][fromB];
            foot[c] = centre_[c][k];
            for (label i = 0; i < wall_.layers; ++i)
            {
                for (label j = 0; j < wall_.layers; ++j)
                {
                    Key key;
                    key[a] = behind(fromA, solid_[f], i);
                    key[b] = behind(fromB, solid_[g], j);
                    key[c] = k;
                    mark(key, max(i, j), source, foot);
                }
            }
        }
    }
}


void wallLattice::markCorners()
{
    const triSurface& surface = wall_.surface;
    forAll(surface.pointEdges(), p)
    {
        label nSharp = 0;
        bool closed = true;
        for (const label e : surface.pointEdges()[p])
        {
            nSharp += kinds_[e] == wallSurface::edgeKind::convex;
            closed = closed
                && kinds_[e] != wallSurface::edgeKind::open
                && kinds_[e] != wallSurface::edgeKind::concave;
        }
        if (nSharp != 3 || !closed) continue;

        label from[3], solid[3] = {0, 0, 0}, source = labelMax;
        for (const label f : surface.pointFaces()[p])
        {
            from[axis_[f]] = planeNode(axis_[f], at_[p][axis_[f]]);
            solid[axis_[f]] = solid_[f];
            source = min(source, surface.localFaces()[f].region());
        }
        if (!solid[0] || !solid[1] || !solid[2]) continue;

        const label n = wall_.layers;
        for (label l = 0; l < n*n*n; ++l)
        {
            const label d[3] = {l % n, (l/n) % n, l/(n*n)};
            Key key;
            for (label a = 0; a < 3; ++a) key[a] = behind(from[a], solid[a], d[a]);
            mark(key, max(d[0], max(d[1], d[2])), source, at_[p]);
        }
    }
}

} // namespace Foam

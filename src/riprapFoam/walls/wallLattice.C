// SPDX-License-Identifier: GPL-3.0-or-later
/*  The lattice of rectilinear walls: frame, planes and cells. Marks: wallLatticeMarks.C */

#include "wallLattice.H"
#include "StringStream.H"

namespace Foam
{


// Are all normals along the frame's axes (half a degree)?
bool wallLattice::alongFrame()
{
    const vectorField& normals = wall_.surface.faceNormals();
    axis_.setSize(normals.size());
    solid_.setSize(normals.size());
    forAll(normals, f)
    {
        const vector n(frame_ & normals[f]);
        label a = 0;
        for (label c = 1; c < 3; ++c) if (mag(n[c]) > mag(n[a])) a = c;
        if (mag(n[a]) < 0.99996) return false;
        axis_[f] = a;
        solid_[f] = n[a] > 0 ? -1 : 1;
    }
    return true;
}


bool wallLattice::findFrame()
{
    const triSurface& surface = wall_.surface;
    if (!alongFrame())
    {
        // First axis: the largest triangle's normal; second: in its plane, the longest side of it
        // that is an edge of the wall
        const scalarField area(mag(surface.faceAreas()));
        const label largest = findMax(area);
        const vector n(surface.faceNormals()[largest]);
        vector side(Zero);
        forAll(kinds_, e)
        {
            if (kinds_[e] == wallSurface::edgeKind::smooth) continue;
            const vector along(surface.edges()[e].vec(surface.localPoints()));
            if (mag(along & n) < 0.005*mag(along) && mag(along) > mag(side)) side = along;
        }
        if (mag(side) < SMALL) return false;
        const vector t(normalised(side - (side & n)*n));
        frame_ = tensor(n, t, n ^ t);
        if (!alongFrame()) return false;
    }
    at_ = frame_ & surface.localPoints();
    return true;
}


// Planes of walls, then those of edges where walls end if they are half a spacing from any other
bool wallLattice::findPlanes()
{
    const triSurface& surface = wall_.surface;
    DynamicList<scalar> hard[3], soft[3];
    forAll(axis_, f)
    {
        const label a = axis_[f];
        const labelledTri& t = surface.localFaces()[f];
        hard[a].append((at_[t[0]][a] + at_[t[1]][a] + at_[t[2]][a])/3);
    }
    forAll(kinds_, e)
    {
        if (kinds_[e] != wallSurface::edgeKind::open) continue;
        const edge& ends = surface.edges()[e];
        const vector along(normalised(at_[ends[1]] - at_[ends[0]]));
        for (label a = 0; a < 3; ++a)
        {
            if (mag(along[a]) < 1e-3) soft[a].append(at_[ends[0]][a]);
        }
    }

    for (label a = 0; a < 3; ++a)
    {
        Foam::sort(hard[a]);
        Foam::sort(soft[a]);
        DynamicList<scalar> all;
        for (const scalar x : hard[a])
        {
            if (all.empty() || x > all.last() + 0.05*s_) all.append(x);
        }
        for (const scalar x : soft[a])
        {
            bool far = true;
            for (const scalar y : all) far = far && mag(x - y) > 0.5*s_;
            if (far) all.append(x);
        }
        Foam::sort(all);
        planes_[a] = scalarField(all);
        if (planes_[a].empty()) return false;
    }
    return true;
}


bool wallLattice::divide(label a, DynamicList<string>& notes)
{
    DynamicList<scalar> nodes;
    const scalarField& planes = planes_[a];
    node_[a].setSize(planes.size());
    scalar least = s_, most = s_;

    for (label l = wall_.layers; l > 0; --l) nodes.append(planes.first() - l*s_);
    forAll(planes, i)
    {
        node_[a][i] = nodes.size();
        nodes.append(planes[i]);
        if (i == planes.size() - 1) break;

        const scalar length = planes[i + 1] - planes[i];
        label n = max(label(1), label(length/s_));
        if (mag(length/(n + 1) - s_) < mag(length/n - s_)) ++n;
        const scalar d = length/n;
        if (mag(d - s_) > 0.36*s_) return false;

        least = min(least, d);
        most = max(most, d);
        for (label j = 1; j < n; ++j) nodes.append(planes[i] + (length*j)/n);
    }
    for (label l = 1; l <= wall_.layers; ++l) nodes.append(planes.last() + l*s_);
    nodes_[a] = scalarField(nodes);
    centre_[a].setSize(nodes.size() - 1);
    forAll(centre_[a], i) centre_[a][i] = 0.5*(nodes[i] + nodes[i + 1]);

    if (most - least > 1e-6*s_)
    {
        vector e(frame_.T() & vector(a == 0, a == 1, a == 2));
        for (direction c = 0; c < vector::nComponents; ++c) if (mag(e[c]) < 1e-6) e[c] = 0;
        OStringStream text;
        text.precision(5);
        text<< "wall spacing along " << e << " from " << least << " to " << most
            << " m, to divide the distances between walls";
        notes.append(text.str());
    }
    return true;
}


void wallLattice::collect(wallCandidates& out) const
{
    for (label depth = 0; depth < wall_.layers; ++depth)
    {
        for (const auto& cell : marks_)
        {
            const Mark& m = cell.second;
            if (m.depth != depth) continue;
            point x;
            for (label a = 0; a < 3; ++a) x[a] = centre_[a][cell.first[a]];
            const vector n(normalised(m.foot - x));
            point global(frame_.T() & x);
            if (space_.planar) global[space_.empty] = space_.middle;
            out.add(global, frame_.T() & n, m.source, (depth + 0.5)*s_);
        }
    }
}

} // namespace Foam


bool Foam::layLattice
(
    const wallSpace& space,
    const wallSurface& wall,
    wallCandidates& out,
    DynamicList<string>& notes
)
{
    if (mag(space.firstOffset - 0.5*space.spacing) > 1e-6*space.spacing) return false;

    DynamicList<string> mine;
    wallLattice lattice(space, wall);
    if (!lattice.build(mine)) return false;
    lattice.collect(out);
    notes.append(mine);
    return true;
}

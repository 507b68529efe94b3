// SPDX-License-Identifier: GPL-3.0-or-later
/*  2D walls of any shape: each smooth curve between two corners is moved into the solid, layer by
    layer, and divided evenly along its moved length. A corner at which the layers part (convex as
    seen from the fluid, turn phi) is filled along the mitre: the layer at depth d runs on by d
    tan(phi/2) past the corner on both sides, and is divided evenly there. Where layers meet, the
    nearer wall's stay (see generateWallPoints).
*/

#include "wallSurface.H"
#include "polylines.H"

namespace Foam
{

class wallCurves
{
    const wallSpace& space_;
    const wallSurface& wall_;
    wallCandidates& out_;

    scalar depth(label layer) const { return space_.firstOffset + layer*space_.spacing; }

    vector tangent(label segment) const { return wall_.segments[segment].unitVec(wall_.points); }

    vector normal(label segment) const { return space_.left(tangent(segment)); }

    label source(label segment) const { return wall_.surface[2*segment].region(); }

    //- Displacement of a vertex for unit depth, against the normal; at a cyclic patch along it
    vector mitre(const vector& n1, const vector& n2) const { return (n1 + n2)/(1 + (n1 & n2)); }

    vector endMitre(label p, const vector& n) const
    {
        const vector& c = wall_.seam[p];
        const vector m(n - (n & c)*c);
        return (m & n) > 0.3 ? m/(m & n) : n;
    }

    void layPiece(const UList<label>& points, const UList<label>& segments, bool closed);
    void fillCorner(label p, label from, label to);

public:

    wallCurves(const wallSpace& space, const wallSurface& wall, wallCandidates& out)
    :
        space_(space), wall_(wall), out_(out)
    {}

    void lay();
};


void wallCurves::layPiece(const UList<label>& points, const UList<label>& segments, bool closed)
{
    const label n = segments.size();
    vectorField shift(n + 1);
    for (label i = 1; i < n; ++i) shift[i] = mitre(normal(segments[i - 1]), normal(segments[i]));
    if (closed)
    {
        shift[0] = shift[n] = mitre(normal(segments[n - 1]), normal(segments[0]));
    }
    else
    {
        shift[0] = endMitre(points[0], normal(segments[0]));
        shift[n] = endMitre(points[n], normal(segments[n - 1]));
    }

    for (label layer = 0; layer < wall_.layers; ++layer)
    {
        const scalar d = depth(layer);
        pointField moved(n + 1);
        forAll(moved, i) moved[i] = wall_.points[points[i]] - d*shift[i];

        scalarField lengths(n);
        forAll(lengths, i)
        {
            lengths[i] = max(scalar(0), (moved[i + 1] - moved[i]) & tangent(segments[i]));
        }
        for (const auto& at : divideEvenly(lengths, space_.spacing))
        {
            const label i = at.first();
            const scalar w = at.second();
            out_.add
            (
                (1 - w)*moved[i] + w*moved[i + 1],
                normalised((1 - w)*shift[i] + w*shift[i + 1]),
                source(segments[i]),
                d
            );
        }
    }
}


void wallCurves::fillCorner(label p, label from, label to)
{
    const vector t1(tangent(from)), t2(tangent(to)), n1(normal(from)), n2(normal(to));
    if ((n1 & t2) < 0) return;                  // turns away from the fluid: layers meet

    const point& corner = wall_.points[p];
    const scalar half = Foam::tan(0.5*Foam::acos(min(max(n1 & n2, scalar(-0.999)), scalar(1))));
    const scalar reach = 1.5*depth(wall_.layers);

    for (label layer = 0; layer < wall_.layers; ++layer)
    {
        const scalar d = depth(layer), side = d*half;
        for (const auto& at : divideEvenly(scalarField(2, side), space_.spacing))
        {
            const bool first = at.first() == 0;
            const point x
            (
                first
              ? corner - d*n1 + at.second()*side*t1
              : corner - d*n2 - (1 - at.second())*side*t2
            );
            if (mag(x - corner) < reach)
            {
                out_.add(x, normalised(corner - x), source(first ? from : to), d);
            }
        }
    }
}


void wallCurves::lay()
{
    auto isCorner = [&](label, label e, label f)
    {
        return (normal(e) & normal(f)) < space_.cosFeature;
    };

    // Pieces end at corners; oriented as their segments are
    for (polyline& piece : linkEdges(wall_.segments, isCorner))
    {
        if (wall_.segments[piece.edges[0]].start() != piece.points[0])
        {
            Foam::reverse(piece.points);
            Foam::reverse(piece.edges);
        }
        layPiece(piece.points, piece.edges, piece.closed);
    }

    labelListList segmentsAt(wall_.points.size());
    forAll(wall_.segments, i)
    {
        segmentsAt[wall_.segments[i].start()].append(i);
        segmentsAt[wall_.segments[i].end()].append(i);
    }
    forAll(segmentsAt, p)
    {
        if (segmentsAt[p].size() != 2) continue;
        label from = segmentsAt[p][0], to = segmentsAt[p][1];
        if (wall_.segments[from].start() == p) std::swap(from, to);
        if (isCorner(p, from, to)) fillCorner(p, from, to);
    }
}

} // namespace Foam


void Foam::layCurves(const wallSpace& space, const wallSurface& wall, wallCandidates& out)
{
    wallCurves(space, wall, out).lay();
}

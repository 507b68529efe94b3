// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidPacking.H"

#include <cmath>

namespace Foam
{

const Enum<solidPackingKind> solidPackingNames
({
    {solidPackingKind::square, "square"},
    {solidPackingKind::hexagonal, "hexagonal"},
    {solidPackingKind::layers, "layers"},
    {solidPackingKind::random, "random"},
    {solidPackingKind::fitted, "fitted"}
});


// Steps along a row, from row to row, from layer to layer, in spacings
static vector steps(solidPackingKind kind, bool planar)
{
    const scalar row = std::sqrt(scalar(3))/2;
    if (kind == solidPackingKind::square) return vector(1, 1, 1);
    if (planar) return vector(1, row, 1);
    if (kind == solidPackingKind::layers) return vector(1, 1, std::sqrt(scalar(0.5)));
    return vector(1, row, std::sqrt(scalar(2)/3));
}


// What row j of layer k is moved by, in spacings
static vector shift(solidPackingKind kind, bool planar, label j, label k)
{
    if (kind == solidPackingKind::square) return Zero;
    if (planar) return vector(j % 2 ? 0.5 : 0, 0, 0);
    if (kind == solidPackingKind::layers) return k % 2 ? vector(0.5, 0.5, 0) : vector(Zero);
    return vector((j + k) % 2 ? 0.5 : 0, k % 2 ? std::sqrt(scalar(3))/6 : 0, 0);
}

} // namespace Foam


Foam::scalar Foam::solidLattice::cell(bool planar) const
{
    const vector s(steps(kind, planar));
    return planar ? sqr(spacing)*s.x()*s.y() : pow3(spacing)*s.x()*s.y()*s.z();
}


Foam::pointField Foam::solidLattice::fill(const boundBox& box, const particlePacking& frame) const
{
    const bool planar = frame.planar();
    const vector step(spacing*steps(kind, planar));
    const label dimensions = planar ? 2 : 3;
    const scalar slack = 1e-6*spacing;

    // As many as fit side by side
    label n[3] = {1, 1, 1};
    for (label d = 0; d < dimensions; ++d)
    {
        const scalar room = box.span()[frame.axis(d)] - 2*radius + slack;
        if (room < 0) return pointField();
        n[d] = label(std::floor(room/step[d])) + 1;
    }

    DynamicList<point> centres;
    for (label k = 0; k < n[2]; ++k)
    {
        for (label j = 0; j < n[1]; ++j)
        {
            const vector moved(spacing*shift(kind, planar, j, k));
            for (label i = 0; i < n[0]; ++i)
            {
                const label index[3] = {i, j, k};
                point x(Zero);
                bool in = true;
                for (label d = 0; d < dimensions; ++d)
                {
                    const direction axis = frame.axis(d);
                    x[axis] = box.min()[axis] + radius + index[d]*step[d] + moved[d];
                    in = in && x[axis] + radius <= box.max()[axis] + slack;
                    // One less where a row is shifted, even if there were room
                    if (kind == solidPackingKind::layers && moved[d] > 0 && index[d] == n[d] - 1)
                        in = false;
                }
                if (in) centres.append(frame.inPlane(x));
            }
        }
    }
    return pointField(std::move(centres));
}

// SPDX-License-Identifier: GPL-3.0-or-later

#include "particlePacking.H"

#include <cmath>

const Foam::Enum<Foam::particlePacking::kind> Foam::particlePacking::names
({
    {kind::square, "square"},
    {kind::hexagonal, "hexagonal"}
});


Foam::particlePacking::particlePacking
(
    const polyMesh& mesh,
    kind packing,
    scalar spacing,
    const vector& gravity
)
:
    kind_(packing),
    spacing_(spacing),
    planar_(mesh.nGeometricD() == 2),
    axes_{0, 1, 2},
    middle_(0)
{
    DynamicList<direction> solved;
    direction empty = 2;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (mesh.geometricD()[d] > 0) solved.append(d); else empty = d;
    }
    if (solved.size() < 2)
    {
        FatalErrorInFunction << "the mesh has " << solved.size()
                            << " directions that are not empty: particles need 2 or 3"
                            << exit(FatalError);
    }

    // The axis nearest to gravity is stacked last
    direction up = solved.last();
    for (const direction d : solved)
    {
        if (mag(gravity[d]) > mag(gravity[up]) + SMALL) up = d;
    }
    label n = 0;
    for (const direction d : solved) if (d != up) axes_[n++] = d;
    axes_[n++] = up;
    if (planar_)
    {
        axes_[2] = empty;
        middle_ = mesh.bounds().midpoint()[empty];
    }
}


Foam::scalar Foam::particlePacking::estimate(const boundBox& box, const boundBox& limits) const
{
    scalar n = 1, longest = 0;
    for (label i = 0; i < (planar_ ? 2 : 3); ++i)
    {
        const direction axis = axes_[i];
        const scalar low = max(box.min()[axis], limits.min()[axis]),
                     high = min(box.max()[axis], limits.max()[axis]);
        n *= max(high - low, scalar(0))/spacing_;
        // Counted from the box's corner, which may be far outside the limits
        longest = max(longest, (high - box.min()[axis])/spacing_);
    }
    return max(n, longest);
}


Foam::vector Foam::particlePacking::steps() const
{
    const bool hexagonal = kind_ == kind::hexagonal;
    const scalar a =
        !hexagonal ? spacing_
      : planar_ ? spacing_*std::sqrt(2/std::sqrt(scalar(3)))
      : spacing_*std::pow(scalar(2), scalar(1)/6);
    return vector
    (
        a,
        hexagonal ? a*std::sqrt(scalar(3))/2 : a,
        planar_ ? 1 : hexagonal ? a*std::sqrt(scalar(2)/3) : a
    );
}


Foam::scalar Foam::particlePacking::latticeCoordinate(label d, label i, label j, label k) const
{
    const bool hexagonal = kind_ == kind::hexagonal;
    scalar x = (d == 0 ? i : d == 1 ? j : k) + 0.5;
    if (hexagonal && d == 0) x += ((j + k) % 2) ? 0.25 : -0.25;
    if (hexagonal && d == 1 && !planar_) x += (k % 2) ? scalar(1)/6 : -scalar(1)/6;
    return x;
}


void Foam::particlePacking::indexRanges
(
    const boundBox& box,
    const boundBox& limits,
    const vector& step,
    labelVector& begin,
    labelVector& end
) const
{
    for (label d = 0; d < (planar_ ? 2 : 3); ++d)
    {
        const scalar low = box.min()[axes_[d]];
        const scalar high = min(box.max()[axes_[d]], limits.max()[axes_[d]]);
        begin[d] = label(std::floor(max(scalar(0), (limits.min()[axes_[d]] - low)/step[d] - 1)));
        end[d] = label(std::floor((high - low)/step[d])) + 2;
    }
}


Foam::pointField Foam::particlePacking::fill(const boundBox& box, const boundBox& limits) const
{
    if
    (
        planar_
     && (middle_ < box.min()[axes_[2]] - SMALL || middle_ > box.max()[axes_[2]] + SMALL)
    )
    {
        return pointField();
    }

    const vector step(steps());
    labelVector begin(0, 0, 0), end(1, 1, 1);
    indexRanges(box, limits, step, begin, end);

    const scalar slack = 1e-6*spacing_;
    DynamicList<point> points;
    for (label k = begin[2]; k < end[2]; ++k)
    {
        for (label j = begin[1]; j < end[1]; ++j)
        {
            for (label i = begin[0]; i < end[0]; ++i)
            {
                point p(Zero);
                bool in = true;
                for (label d = 0; d < (planar_ ? 2 : 3); ++d)
                {
                    const direction axis = axes_[d];
                    p[axis] = box.min()[axis] + latticeCoordinate(d, i, j, k)*step[d];
                    // Half-open, so that boxes side by side share no particle
                    in = in && p[axis] < box.max()[axis] - slack
                        && p[axis] > limits.min()[axis] && p[axis] < limits.max()[axis];
                }
                if (in) points.append(inPlane(p));
            }
        }
    }
    return pointField(std::move(points));
}

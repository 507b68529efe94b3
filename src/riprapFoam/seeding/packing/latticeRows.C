// SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeRows.H"

#include <cmath>

Foam::latticeRows::latticeRows
(
    const particlePacking& packing,
    const boundBox& box,
    const boundBox& limits
)
:
    packing_(packing),
    box_(box),
    limits_(limits),
    hexagonal_(!packing.square()),
    dimensions_(packing.planar() ? 2 : 3),
    begin_(0, 0, 0),
    end_(1, 1, 1)
{
    const bool planar = packing.planar();
    const scalar spacing = packing.spacing();
    const scalar a =
        !hexagonal_ ? spacing
      : planar ? spacing*std::sqrt(2/std::sqrt(scalar(3)))
      : spacing*std::pow(scalar(2), scalar(1)/6);
    step_ = vector
    (
        a,
        hexagonal_ ? a*std::sqrt(scalar(3))/2 : a,
        planar ? 1 : hexagonal_ ? a*std::sqrt(scalar(2)/3) : a
    );

    const direction across = packing.axis(2);
    const scalar middle = packing.inPlane(Zero)[across];
    if (planar && (middle < box.min()[across] - SMALL || middle > box.max()[across] + SMALL))
        end_ = labelVector(0, 0, 0);
    else
        indexRanges(limits, begin_, end_);
}


void Foam::latticeRows::indexRanges(
    const boundBox& limits, labelVector& begin, labelVector& end) const
{
    begin = labelVector(0, 0, 0);
    end = labelVector(1, 1, 1);
    for (label d = 0; d < dimensions_; ++d)
    {
        const direction axis = packing_.axis(d);
        const scalar low = box_.min()[axis];
        const scalar high = min(box_.max()[axis], limits.max()[axis]);
        begin[d] = label(std::floor(max(scalar(0), (limits.min()[axis] - low)/step_[d] - 1)));
        end[d] = label(std::floor((high - low)/step_[d])) + 2;
    }
}


Foam::scalar Foam::latticeRows::latticeCoordinate(label d, label i, label j, label k) const
{
    scalar x = (d == 0 ? i : d == 1 ? j : k) + 0.5;
    if (hexagonal_ && d == 0) x += ((j + k) % 2) ? 0.25 : -0.25;
    if (hexagonal_ && d == 1 && dimensions_ == 3) x += (k % 2) ? scalar(1)/6 : -scalar(1)/6;
    return x;
}


bool Foam::latticeRows::at(label i, label j, label k, point& p) const
{
    const scalar slack = 1e-6*packing_.spacing();
    p = Zero;
    for (label d = 0; d < dimensions_; ++d)
    {
        const direction axis = packing_.axis(d);
        p[axis] = box_.min()[axis] + latticeCoordinate(d, i, j, k)*step_[d];
        // Half-open, so that boxes side by side share no particle
        if (!(p[axis] < box_.max()[axis] - slack
            && p[axis] > limits_.min()[axis] && p[axis] < limits_.max()[axis]))
            return false;
    }
    p = packing_.inPlane(p);
    return true;
}


std::int64_t Foam::latticeRows::numbers() const
{
    std::int64_t n = 1;
    for (label d = 0; d < 3; ++d) n *= max(end_[d] - begin_[d], label(0));
    return n;
}


Foam::pointField Foam::latticeRows::points() const
{
    DynamicList<point> all;
    for (label k = begin_[2]; k < end_[2]; ++k)
    {
        for (label j = begin_[1]; j < end_[1]; ++j)
        {
            for (label i = begin_[0]; i < end_[0]; ++i)
            {
                point p;
                if (at(i, j, k, p)) all.append(p);
            }
        }
    }
    return pointField(std::move(all));
}

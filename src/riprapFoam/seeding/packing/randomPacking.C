// SPDX-License-Identifier: GPL-3.0-or-later

#include "randomPacking.H"
#include "bodyGrading.H"
#include "pointGrid.H"
#include "uniformNumbers.H"

namespace Foam
{

// Move each of a pair by half their overlap; the largest overlap, relative to the radius
static scalar pushApart
(
    const scalarField& radii,
    scalar scale,
    const std::function<bool(label, const vector&)>& move,
    pointField& x
)
{
    const pointGrid grid(2*scale*max(radii), x);
    scalar largest = 0;
    forAll(x, i)
    {
        vector way(Zero);
        grid.near
        (
            x[i],
            [&](label j, const vector& apart, scalar distance)
            {
                const scalar overlap = scale*(radii[i] + radii[j]) - distance;
                if (j == i || overlap <= 0) return;
                largest = max(largest, overlap/radii[i]);
                // Two at one place part along x, each its own way
                const vector n(distance > VSMALL ? apart/distance : vector(i < j ? -1 : 1, 0, 0));
                // A little more than half, so that the end is reached
                way += (0.5 + 1e-3)*overlap*n;
            }
        );
        if (magSqr(way) > 0) move(i, way);
    }
    return largest;
}

} // namespace Foam


Foam::scalarField Foam::randomPacking::radii(scalar volume, bool planar) const
{
    uniformNumbers uniform(seed);

    DynamicList<scalar> all;
    scalar left = solidFraction*volume;
    for (;;)
    {
        const scalar radius = smallest + uniform()*(largest - smallest);
        const scalar v = ballVolume(radius, planar);
        if (left < 0.5*v) break;
        left -= v;
        all.append(radius);
    }
    return scalarField(std::move(all));
}


bool Foam::randomPacking::throwIn
(
    const boundBox& box,
    const fits& fit,
    const particlePacking& frame,
    const scalarField& radii,
    pointField& x
) const
{
    uniformNumbers uniform(seed + 1);
    x.setSize(radii.size());
    forAll(x, i)
    {
        label tries = 0;
        do
        {
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                x[i][d] = box.min()[d] + uniform()*box.span()[d];
            }
            x[i] = frame.inPlane(x[i]);
            if (++tries > 100000) return false;
        }
        while (!fit(x[i], radii[i]));
    }
    return true;
}


bool Foam::randomPacking::place
(
    const boundBox& box,
    const fits& fit,
    const particlePacking& frame,
    const scalarField& radii,
    pointField& x
) const
{
    if (!throwIn(box, fit, frame, radii, x)) return false;

    // A move out of the volume is tried again along each axis alone
    auto move = [&](label i, const vector& way)
    {
        const point moved(frame.inPlane(x[i] + way));
        if (fit(moved, radii[i]))
        {
            x[i] = moved;
            return true;
        }
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            point alone(x[i]);
            alone[d] += way[d];
            alone = frame.inPlane(alone);
            if (fit(alone, radii[i])) x[i] = alone;
        }
        return false;
    };

    const label growth = 40, most = 20000;
    for (label step = 1; step <= growth; ++step)
    {
        const scalar scale = 0.5 + 0.5*step/growth;
        const scalar enough = step < growth ? 1e-2 : 1e-7;
        label sweeps = 0;
        while (pushApart(radii, scale, move, x) > enough)
        {
            if (++sweeps > (step < growth ? 200 : most)) break;
        }
        if (step == growth && sweeps > most) return false;
    }
    return true;
}

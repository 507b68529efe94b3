// SPDX-License-Identifier: GPL-3.0-or-later
/*  source cylinder;  p1 (0 0 0);  p2 (0 0 1);  radius 0.1;
    source sphere;    centre (0 0 0);  radius 0.1;
*/

#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "particleSource.H"

namespace Foam
{

// A polygon of the same area as the circle about a point of the mid-plane, a part of 1e-4 of the
// radius off it
static dictionary circleOutline(const point& centre, scalar radius, const particlePacking& frame)
{
    using constant::mathematical::twoPi;

    const label sides = 256;
    const scalar reach = radius*Foam::sqrt(twoPi/sides/Foam::sin(twoPi/sides));
    pointField corners(sides, frame.inPlane(centre));
    forAll(corners, i)
    {
        corners[i][frame.axis(0)] += reach*Foam::cos(twoPi*i/sides);
        corners[i][frame.axis(1)] += reach*Foam::sin(twoPi*i/sides);
    }
    dictionary entries;
    entries.add("outline", corners);
    return entries;
}


class cylinderSource
:
    public volumeSource
{
    point p1_, p2_;
    scalar radius_;
    dictionary where_;          // for messages

public:

    TypeName("cylinder");

    cylinderSource(checkedDictionary& dict, const Time&)
    :
        radius_(dict.positive("radius")),
        where_(dict.dict())
    {
        dict.found("p1");
        dict.found("p2");
        p1_ = dict.dict().get<point>("p1");
        p2_ = dict.dict().get<point>("p2");
        if (mag(p2_ - p1_) < SMALL)
        {
            FatalIOErrorInFunction(dict.dict())
                << "Entries p1 and p2 are the same point " << p1_ << ": the cylinder has no length"
                << exit(FatalIOError);
        }
    }

    // Discs of radius r about a unit axis n reach r sqrt(1 - n_d^2) along d
    boundBox bounds() const override
    {
        const vector n(normalised(p2_ - p1_));
        vector reach;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            reach[d] = radius_*Foam::sqrt(max(scalar(0), 1 - sqr(n[d])));
        }
        return boundBox(min(p1_, p2_) - reach, max(p1_, p2_) + reach);
    }

    boolList inside(const pointField& points) const override
    {
        const vector axis(p2_ - p1_);
        boolList in(points.size());
        forAll(in, i)
        {
            const vector x(points[i] - p1_);
            const scalar along = (x & axis)/magSqr(axis);
            in[i] = along >= 0 && along <= 1 && magSqr(x - along*axis) <= sqr(radius_);
        }
        return in;
    }

    clumpShape shape(const particlePacking& frame) const override
    {
        return cylinderShape(p1_, p2_, radius_, frame, where_);
    }

    // In 2D a circle, or a rectangle
    dictionary surfaceEntries(const particlePacking& frame) const override
    {
        if (!frame.planar()) return shapeEntries(where_, {"source", "p1", "p2", "radius"});
        const vector n(normalised(p2_ - p1_));
        vector empty(Zero);
        empty[frame.axis(2)] = 1;
        if (mag(n & empty) > 1 - 1e-9) return circleOutline(0.5*(p1_ + p2_), radius_, frame);
        const vector across(empty ^ n);
        const scalar off = mag(frame.inPlane(p1_) - p1_),
                     half = Foam::sqrt(max(sqr(radius_) - sqr(off), scalar(0)));
        const point a(frame.inPlane(p1_)), b(frame.inPlane(p2_));
        dictionary entries;
        if (half > 0)
            entries.add("outline",
                pointField(List<point>{
                    a - half*across, b - half*across, b + half*across, a + half*across}));
        return entries;
    }
};

defineTypeNameAndDebug(cylinderSource, 0);
addToRunTimeSelectionTable(particleSource, cylinderSource, dictionary);


class sphereSource
:
    public volumeSource
{
    point centre_;
    scalar radius_;
    dictionary where_;

public:

    TypeName("sphere");

    sphereSource(checkedDictionary& dict, const Time&)
    :
        radius_(dict.positive("radius"))
    {
        dict.found("centre");
        centre_ = dict.dict().get<point>("centre");
        where_ = dict.dict();
    }

    boundBox bounds() const override
    {
        return boundBox(centre_ - radius_*vector::one, centre_ + radius_*vector::one);
    }

    boolList inside(const pointField& points) const override
    {
        boolList in(points.size());
        forAll(in, i) in[i] = magSqr(points[i] - centre_) <= sqr(radius_);
        return in;
    }

    clumpShape shape(const particlePacking& frame) const override
    {
        return sphereShape(centre_, radius_, frame);
    }

    dictionary surfaceEntries(const particlePacking& frame) const override
    {
        if (!frame.planar()) return shapeEntries(where_, {"source", "centre", "radius"});
        const scalar off = mag(frame.inPlane(centre_) - centre_);
        return off < radius_ ? circleOutline(centre_, Foam::sqrt(sqr(radius_) - sqr(off)), frame)
                             : dictionary();
    }
};

defineTypeNameAndDebug(sphereSource, 0);
addToRunTimeSelectionTable(particleSource, sphereSource, dictionary);

} // namespace Foam

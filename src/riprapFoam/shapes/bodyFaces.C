// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyFaces.H"
#include "clumpShape.H"
#include "closedSurface.H"
#include "exactShapes.H"
#include "mathematicalConstants.H"
#include "quaternion.H"

#include <set>

namespace Foam
{

using constant::mathematical::twoPi;

//- A closed surface: triangles, or in 2D segments (the third vertex is -1) with the body on their
//  left
struct closedFaces
{
    const riprap::SphConfig& config;
    DynamicList<point> points;
    DynamicList<FixedList<label, 3>> elements;

    bool planar() const { return config.dimensions == 2; }

    vector axis(label k) const
    {
        vector a(Zero);
        a[config.axes[k]] = 1;
        return a;
    }

    void add(label a, label b, label c) { elements.append(FixedList<label, 3>{a, b, c}); }

    //- Lines and polygons may be given either way round: planar bodies are put so that their area
    //  is positive
    void polygon(const pointField& corners)
    {
        const label n = corners.size(), first = points.size();
        scalar area = 0;
        forAll(corners, i)
        {
            const point& a = corners[i];
            const point& b = corners[(i + 1) % n];
            area += (a & axis(0))*(b & axis(1)) - (a & axis(1))*(b & axis(0));
        }
        points.append(corners);
        for (label i = 0; i < n; ++i)
        {
            const label next = (i + 1) % n;
            if (area > 0) add(first + i, first + next, -1);
            else add(first + next, first + i, -1);
        }
    }

    void triangles(const triSurface& surface)
    {
        const label first = points.size();
        points.append(surface.points());
        for (const labelledTri& t : surface) add(first + t[0], first + t[1], first + t[2]);
    }

    scalar middle() const
    {
        return 0.5*(config.domainMin[config.axes[2]] + config.domainMax[config.axes[2]]);
    }

    //- In 2D: where it cuts the mid-plane. Points at that height are taken to be above it, so that
    //  each line is cut once
    void section(const triSurface& surface)
    {
        const pointField& p = surface.points();
        for (const labelledTri& t : surface)
        {
            point cut[2];
            label cuts = 0;
            for (label e = 0; e < 3; ++e)
            {
                const point& a = p[t[e]];
                const point& b = p[t[(e + 1) % 3]];
                const scalar from = (a & axis(2)) - middle(), to = (b & axis(2)) - middle();
                if ((from >= 0) != (to >= 0)) cut[cuts++] = a + from/(from - to)*(b - a);
            }
            if (cuts < 2 || mag(cut[1] - cut[0]) < VSMALL) continue;
            const label first = points.size();
            points.append(cut[0]);
            points.append(cut[1]);
            add(first, first + 1, -1);
            if ((normal(elements.last()) & ((p[t[1]] - p[t[0]]) ^ (p[t[2]] - p[t[0]]))) < 0)
                std::swap(elements.last()[0], elements.last()[1]);
        }
    }

    //- A quadrilateral that is seen counter-clockwise from outside
    void quad(label a, label b, label c, label d) { add(a, b, c); add(a, c, d); }

    void box(const point& low, const point& high)
    {
        if (planar())
        {
            pointField corners(4, low);
            corners[1][config.axes[0]] = corners[2][config.axes[0]] = high[config.axes[0]];
            corners[2][config.axes[1]] = corners[3][config.axes[1]] = high[config.axes[1]];
            return polygon(corners);
        }
        points.append(boundBox(low, high).points());        // as of a hexahedral cell
        quad(0, 3, 2, 1);
        quad(4, 5, 6, 7);
        quad(0, 1, 5, 4);
        quad(1, 2, 6, 5);
        quad(2, 3, 7, 6);
        quad(3, 0, 4, 7);
    }

    pointField circle(
        const point& centre, const vector& a, const vector& b, scalar radius, label sides) const
    {
        pointField corners(sides);
        forAll(corners, i)
            corners[i] = centre
                + radius*(Foam::cos(twoPi*i/sides)*a + Foam::sin(twoPi*i/sides)*b);
        return corners;
    }

    //- Corners so near to each other that a chord is a hundredth of a spacing off the arc
    label sides(scalar radius) const
    {
        const scalar off = min(0.01*config.spacing/radius, scalar(0.1));
        return max(label(16), label(twoPi/(2*Foam::acos(1 - off))) + 1);
    }

    void cylinder(const point& p1, const point& p2, scalar radius)
    {
        const scalar length = mag(p2 - p1);
        const vector n((p2 - p1)/length);
        const label around = sides(radius);
        if (planar())
        {
            if (mag(n & axis(2)) > 0.5)
                return polygon(circle(p1, axis(0), axis(1), radius, around));
            const vector across(axis(2) ^ n);
            const scalar half = Foam::sqrt(
                max(sqr(radius) - sqr((p1 & axis(2)) - middle()), scalar(0)));
            return polygon(pointField(List<point>{
                p1 - half*across, p2 - half*across, p2 + half*across, p1 + half*across}));
        }
        const vector a(normalised(mag(n.x()) < 0.9 ? vector(1, 0, 0) ^ n : vector(0, 1, 0) ^ n)),
            b(n ^ a);
        const label first = points.size();
        points.append(circle(p1, a, b, radius, around));
        points.append(circle(p2, a, b, radius, around));
        points.append(p1);
        points.append(p2);
        for (label i = 0; i < around; ++i)
        {
            const label j = (i + 1) % around, low = first + 2*around;
            quad(first + i, first + j, first + around + j, first + around + i);
            add(low, first + j, first + i);
            add(low + 1, first + around + i, first + around + j);
        }
    }

    //- Parallels and meridians
    void sphere(const point& centre, scalar radius)
    {
        if (planar())
        {
            const scalar reach = Foam::sqrt(
                max(sqr(radius) - sqr((centre & axis(2)) - middle()), scalar(0)));
            return polygon(circle(centre, axis(0), axis(1), reach, sides(reach)));
        }
        const label around = sides(radius), rows = around/2, first = points.size();
        for (label r = 0; r <= rows; ++r)
        {
            const scalar height = radius*Foam::cos(0.5*twoPi*r/rows),
                         reach = radius*Foam::sin(0.5*twoPi*r/rows);
            if (r == 0 || r == rows) points.append(centre + vector(0, 0, height));
            else
                points.append(circle(centre + vector(0, 0, height), vector(1, 0, 0),
                    vector(0, 1, 0), reach, around));
        }
        const auto at = [&](label r, label i)
        { return r == 0 ? first : first + 1 + (r - 1)*around + (r == rows ? 0 : i % around); };
        for (label r = 0; r < rows; ++r)
            for (label i = 0; i < around; ++i)
            {
                if (r > 0) add(at(r, i), at(r + 1, i), at(r, i + 1));
                if (r < rows - 1) add(at(r, i + 1), at(r + 1, i), at(r + 1, i + 1));
            }
    }

    vector normal(const FixedList<label, 3>& e) const
    {
        const point& a = points[e[0]];
        const point& b = points[e[1]];
        if (planar()) return (b - a) ^ axis(2)*((axis(0) ^ axis(1)) & axis(2));
        return (b - a) ^ (points[e[2]] - a);
    }

    //- As body `k`, from where its frame is: centre, and principal axes as columns
    void addTo(riprap::WallFaceInput& all, label k, const point& centre, const tensor& frame) const
    {
        const label first = all.point.size()/3;
        for (const point& p : points)
        {
            const vector y(frame.T() & (p - centre));
            for (direction d = 0; d < vector::nComponents; ++d) all.point.push_back(y[d]);
        }
        for (const auto& e : elements)
        {
            const vector n(normal(e));
            if (mag(n) < VSMALL) continue;
            const vector y(frame.T() & (n/mag(n)));
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                all.normal.push_back(y[d]);
                all.vertex.push_back(e[d] < 0 ? -1 : first + e[d]);
            }
            all.body.push_back(k);
            all.part.push_back(0);
            all.halfThickness.push_back(0);
        }
    }
};


//- By the entries that bodySurface left. false: there is none, as of a ball beside the mid-plane
static bool read(const dictionary& entries, const Time& time, closedFaces& faces)
{
    const word source(entries.get<word>("source"));
    if (source == "box")
    {
        checkedDictionary dict(entries);
        const boundBox box(boxOf(dict));
        faces.box(box.min(), box.max());
    }
    else if (source == "cylinder")
        faces.cylinder(
            entries.get<point>("p1"), entries.get<point>("p2"), entries.get<scalar>("radius"));
    else if (source == "sphere")
        faces.sphere(entries.get<point>("centre"), entries.get<scalar>("radius"));
    else
    {
        checkedDictionary dict(entries);
        const autoPtr<triSurface> surface(readClosedSurface(dict, time));
        if (faces.planar()) faces.section(surface());
        else faces.triangles(surface());
    }
    return faces.elements.size();
}


static tensor axesOf(const std::array<double, 4>& q)
{
    return quaternion(q[0], vector(q[1], q[2], q[3])).R();
}

} // namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::bodySurface(const dictionary& region)
{
    return shapeEntries(region, {"source", "box", "p1", "p2", "centre", "radius", "file", "scale"});
}


riprap::WallFaceInput Foam::bodyFaces
(
    const dictionary& properties,
    const Time& time,
    const riprap::SphConfig& config,
    const std::vector<riprap::DemClump>& clumps
)
{
    riprap::WallFaceInput all;
    std::vector<bool> done(clumps.size(), false);
    for (const entry& e : properties.subOrEmptyDict("surfaces"))
    {
        const label k = e.dict().get<label>("body");
        closedFaces faces{config, {}, {}};
        if (k < 0 || std::size_t(k) >= clumps.size() || !read(e.dict(), time, faces)) continue;
        const riprap::DemClump& body = clumps[k];
        const riprap::DemPose start = body.moved ? body.start
                                                 : riprap::DemPose{body.position, body.orientation};
        faces.addTo(all, k, point(start.position[0], start.position[1], start.position[2]),
            axesOf(start.orientation));
        done[k] = true;
    }
    label shape = 0;
    for (const entry& e : properties.subOrEmptyDict("shapes"))
    {
        const clumpShape own(keptShape(e.dict(), time, config.dimensions, config.axes));
        closedFaces faces{config, {}, {}};
        if (faces.planar()) faces.polygon(e.dict().get<pointField>("outline"));
        else if (e.dict().found("source")) read(e.dict(), time, faces);
        else
        {
            checkedDictionary again(e.dict());
            faces.triangles(readClosedSurface(again, time)());
        }
        for (std::size_t k = 0; k < clumps.size(); ++k)
        {
            if (clumps[k].shape == shape && !done[k]) faces.addTo(all, k, own.middle, own.axes);
        }
        ++shape;
    }
    return all;
}


Foam::label Foam::bodiesWithFaces(const riprap::WallFaceInput& faces)
{
    return std::set<std::int32_t>(faces.body.begin(), faces.body.end()).size();
}


// ************************************************************************* //

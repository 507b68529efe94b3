// SPDX-License-Identifier: GPL-3.0-or-later
/*  Entry surface of a rigid body whose particles come from a list: the volume that it is, by the
    entries of a region of that volume

        source csv;  file "hull.csv";  radius 0.005;  rigid yes;
        surface { source surface; file "hull.stl"; }            // or box, cylinder, sphere

    With it the body has mass, inertia and faces of that volume, whatever its particles hold, as
    regions of such a volume have.
*/

#include "bodyFaces.H"
#include "particleSource.H"
#include "pointGrid.H"
#include "quaternion.H"
#include "solidRegions.H"

namespace Foam
{

static autoPtr<particleSource> readVolume(checkedDictionary& dict, const Time& time)
{
    dict.found("source");
    const word source(dict.dict().get<word>("source"));
    DynamicList<word> valid;
    for (const word& name : particleSource::dictionaryConstructorTablePtr_->sortedToc())
    {
        if (name != "csv") valid.append(name);
    }
    if (!valid.found(source)) dict.unknownWord("source", source, wordList(valid));
    autoPtr<particleSource> volume(particleSource::New(dict, time));
    dict.end();
    return volume;
}


// A volume has one mass: what a list says of each particle's would be lost
static void requireOneMass(
    const rigidEntries& given, const demSettings& settings, const solidRegion& region)
{
    if (region.mass.size())
    {
        FatalIOErrorInFunction(region.dict) << "Region " << region.name
                                            << " has the mass of its entry surface, and its list "
                                               "has a column mass: leave it out, or say the"
                                            << " body's mass or density" << exit(FatalIOError);
    }
    if (given.mass > 0 || given.density > 0) return;
    for (const label m : region.material)
    {
        if (settings.materials[m].density == settings.materials[region.material[0]].density)
            continue;
        FatalIOErrorInFunction(region.dict) << "Region " << region.name
                                            << " has the mass of its entry surface, and its list "
                                               "has materials of different density: say the"
                                            << " body's mass or density" << exit(FatalIOError);
    }
}


static void requireInside(const solidRegion& region)
{
    const scalarField distance(region.exact->distance(region.position));
    label out = 0, farthest = 0;
    forAll(distance, i)
    {
        out += distance[i] > 0;
        if (distance[i] > distance[farthest]) farthest = i;
    }
    if (!out) return;
    FatalIOErrorInFunction(region.dict)
        << "Entry surface does not hold the particles of region " << region.name
        << ": the centres of " << out << " of " << region.size() << " are outside of it, that at "
        << region.position[farthest] << " by " << distance[farthest] << " m" << exit(FatalIOError);
}


// The corners of the body's faces in space, an element after the other
static pointField cornersOf(
    const riprap::WallFaceInput& faces, const riprap::DemClump& body, label corners)
{
    const auto& q = body.orientation;
    const tensor axes(quaternion(q[0], vector(q[1], q[2], q[3])).R());
    const point centre(body.position[0], body.position[1], body.position[2]);
    pointField all(corners*faces.size());
    forAll(all, k)
    {
        const double* p = &faces.point[3*std::size_t(faces.vertex[3*(k/corners) + k % corners])];
        all[k] = centre + (axes & vector(p[0], p[1], p[2]));
    }
    return all;
}


// Points of a triangle, or of a line from a to b = c, no farther than a length apart
static void addPoints(
    const point& a, const point& b, const point& c, scalar length, DynamicList<point>& points)
{
    const label n = label(max(mag(b - a), max(mag(c - a), mag(c - b)))/length) + 1;
    for (label i = 0; i <= n; ++i)
        for (label j = 0; j <= (b == c ? 0 : n - i); ++j)
            points.append(a + scalar(i)/n*(b - a) + scalar(j)/n*(c - a));
}

} // namespace Foam


void Foam::readRigidSurface(checkedDictionary& dict, const rigidEntries& given,
    const solidSpace& space, solidRegion& region)
{
    const dictionary& entries = dict.subDict("surface");
    if (!dict.dict().found("surface", keyType::LITERAL) || region.size() == 0) return;

    checkedDictionary own(entries);
    const auto source = readVolume(own, space.mesh.time());
    const auto& volume = dynamic_cast<const volumeSource&>(source());
    const auto& g = space.settings.config.gravity;
    const particlePacking frame(
        space.mesh, particlePacking::kind::square, 1, vector(g[0], g[1], g[2]));
    region.exact = std::make_shared<const clumpShape>(volume.shape(frame));
    region.shape = volume.surfaceEntries(frame);
    region.surface = bodySurface(entries);
    requireOneMass(given, space.settings, region);
    requireInside(region);
}


void Foam::requireCovered(
    const solidRegion& region, const Time& time, const riprap::SphConfig& config)
{
    if (!region.dict.isDict("surface") || region.clumps.size() != 1) return;

    dictionary surface(region.surface), surfaces, properties;
    surface.add("body", 0);
    surfaces.add(region.name, surface);
    properties.add("surfaces", surfaces);
    const label corners = config.dimensions;
    const pointField corner(cornersOf(
        bodyFaces(properties, time, config, {region.clumps[0]}), region.clumps[0], corners));

    // How the scene finds the faces near a particle (sph/boundary/bodyContact.hpp)
    const scalar reach = max(region.radius) + config.spacing;
    const pointGrid centres(2*reach, region.position);
    DynamicList<point> points;
    for (label k = 0; k < corner.size(); k += corners)
    {
        addPoints(corner[k], corner[k + 1], corner[k + corners - 1], 0.25*reach, points);
    }
    for (point& x : points)
    {
        if (corners == 2) x[config.axes[2]] = region.position[0][config.axes[2]];
        const scalar distance = centres.nearest(x, -1);
        if (distance <= reach) continue;
        FatalIOErrorInFunction(region.dict)
            << "Region " << region.name << ": no particle of the list is within " << reach
            << " m of its entry surface at " << x
            << ", where water would get in: faces are sought within a particle's radius and the "
               "water's spacing. Let particles follow the surface"
            << exit(FatalIOError);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  rigid yes;  all particles of a region are one rigid body. A region of a box, cylinder, sphere or
                surface has the mass, centre and inertia of its exact volume
    at its material's density; of a list without the entry surface they are those of its particles
    together, each with its own inertia (2/5 m R^2 of a sphere, m R^2/2 of a disk). What
    rigidEntries.H has comes before both. Particles share the body's mass and volume.
*/

#include "principalAxes.H"
#include "boundBox.H"
#include "quaternion.H"
#include "rigidEntries.H"
#include "solidRegions.H"

namespace Foam
{

struct rigidBody
{
    scalar mass = 0, volume = 0;
    point centre = Zero;
    tensor inertia = Zero;              // in 2D its moment is at zz
    tensor axes = tensor::I;            // principal, where they are known
    bool uniform = false;               // centre and axes are those of the shape
};


static rigidBody ofParticles(const solidSpace& space, const solidRegion& region)
{
    const riprap::DemConfig& config = space.settings.config;
    const bool planar = config.dimensions == 2;
    rigidBody body;
    forAll(region.mass, i)
    {
        body.mass += region.mass[i];
        body.volume += region.mass[i]/space.settings.materials[region.material[i]].density;
        body.centre += region.mass[i]*region.position[i];
    }
    body.centre /= body.mass;

    tensor J(Zero);
    forAll(region.mass, i)
    {
        vector arm(region.position[i] - body.centre);
        if (planar) arm[config.axes[2]] = 0;
        const scalar own = region.mass[i]*sqr(region.radius[i])*(planar ? 0.5 : 0.4);
        J += (region.mass[i]*magSqr(arm) + own)*tensor::I - region.mass[i]*arm*arm;
    }
    body.inertia = J;
    if (planar) body.inertia.zz() = J[4*config.axes[2]];
    return body;
}


static rigidBody ofShape(const clumpShape& shape, scalar density)
{
    rigidBody body;
    body.mass = density*shape.volume;
    body.volume = shape.volume;
    body.centre = shape.middle;
    body.inertia = density*inertiaOf(shape);
    body.axes = shape.axes;
    body.uniform = true;
    return body;
}


static void change(const rigidEntries& given, bool planar, direction empty, rigidBody& body)
{
    const scalar before = body.mass, height = body.centre[empty];
    body.uniform = body.uniform && !given.centred && !given.turned;
    if (given.density > 0) body.mass = given.density*body.volume;
    if (given.mass > 0) body.mass = given.mass;
    body.inertia *= body.mass/before;
    if (given.centred) body.centre = given.centre;
    if (planar) body.centre[empty] = height;
    if (given.turned && planar) body.inertia.zz() = given.planarInertia;
    else if (given.turned) body.inertia = given.inertia;
}


static riprap::DemClump clumpOf(
    const rigidBody& body, bool planar, const vector& velocity, const vector& spin)
{
    vector moments(0, 0, body.inertia.zz());
    quaternion turn(quaternion::I);
    if (!planar)
    {
        // Those of the shape to the bit: it is seen in its own axes
        const tensor own(body.axes.T() & body.inertia & body.axes);
        moments = vector(own.xx(), own.yy(), own.zz());
        tensor axes(body.axes);
        if (!body.uniform) moments = principalMoments(body.inertia, axes);
        turn = quaternion(axes);
    }
    riprap::DemClump clump;
    clump.mass = body.mass;
    clump.volume = body.volume;
    clump.orientation[0] = turn.w();
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        clump.position[d] = body.centre[d];
        clump.velocity[d] = velocity[d];
        clump.spin[d] = spin[d];
        clump.inertia[d] = moments[d];
        clump.orientation[d + 1] = turn.v()[d];
    }
    return clump;
}

//- Coordinates of the mesh were meant, not the way from the middle. emptyAxis: in 2D
static void warnOfCentre(const solidRegion& region, const point& centre, const label emptyAxis)
{
    boundBox box(region.position, false);
    const scalar most = max(region.radius);
    box.min() -= most*vector::one;
    box.max() += most*vector::one;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (d == emptyAxis || (centre[d] >= box.min()[d] && centre[d] <= box.max()[d])) continue;
        WarningInFunction << "Entry centreOfMass " << centre << " of region " << region.name
                          << " is outside of its particles, which are within " << box.min()
                          << " and " << box.max() << " m. Coordinates are those of the mesh"
                          << endl;
        return;
    }
}

} // namespace Foam


void Foam::makeRigid
(
    const solidSpace& space,
    label group,
    const vector& velocity,
    const vector& spin,
    const rigidEntries& given,
    solidRegion& region
)
{
    const riprap::DemConfig& config = space.settings.config;
    const bool planar = config.dimensions == 2;
    rigidBody body(region.exact
            ? ofShape(*region.exact, space.settings.materials[region.material[0]].density)
            : ofParticles(space, region));
    change(given, planar, config.axes[2], body);
    if (given.centred) warnOfCentre(region, body.centre, planar ? config.axes[2] : -1);
    riprap::DemClump clump(clumpOf(body, planar, velocity, spin));
    if (!body.uniform && region.shape.size())
    {
        const auto& q = clump.orientation;
        region.shape.add("centreOfMass", body.centre);
        if (!planar) region.shape.add("axes", quaternion(q[0], vector(q[1], q[2], q[3])).R());
    }
    clump.group = group;
    region.mass *= body.mass/sum(region.mass);
    region.clumps.append(clump);
    region.clump = labelField(region.size(), 0);

    const char* metre = planar ? " per metre" : "";
    Info<< "    " << region.name << ": one rigid body, mass " << body.mass << " kg" << metre
        << ", centre " << body.centre << ", principal moments of inertia "
        << vector(clump.inertia[0], clump.inertia[1], clump.inertia[2]) << " kg m2" << metre
        << ", volume " << body.volume << " m3" << metre;
    if (region.cells > 0)
        Info<< "; the cells of its particles are " << region.cells/body.volume << " of it";
    Info<< nl;
}

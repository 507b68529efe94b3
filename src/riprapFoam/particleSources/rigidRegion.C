// SPDX-License-Identifier: GPL-3.0-or-later
/*  rigid yes;  all bodies of a region are one rigid body: mass, centre and inertia are theirs together, each with its own
    (2/5 m R^2 of a sphere, m R^2/2 of a disk) about its centre.
*/

#include "principalAxes.H"
#include "quaternion.H"
#include "solidRegions.H"

void Foam::makeRigid(const solidSpace& space, label group, const vector& velocity, const vector& spin, solidRegion& region)
{
    const riprap::DemConfig& config = space.settings.config;
    const bool planar = config.dimensions == 2;

    riprap::DemClump body;
    body.group = group;
    point middle(Zero);
    forAll(region.mass, i)
    {
        body.mass += region.mass[i];
        middle += region.mass[i]*region.position[i];
    }
    middle /= body.mass;

    tensor J(Zero);
    forAll(region.mass, i)
    {
        vector arm(region.position[i] - middle);
        if (planar) arm[config.axes[2]] = 0;
        const scalar own = region.mass[i]*sqr(region.radius[i])*(planar ? 0.5 : 0.4);
        J += (region.mass[i]*magSqr(arm) + own)*tensor::I - region.mass[i]*arm*arm;
    }

    vector moments(Zero);
    quaternion turn(quaternion::I);
    if (planar) moments[2] = J[4*config.axes[2]];
    else
    {
        tensor axes;
        moments = principalMoments(J, axes);
        turn = quaternion(axes);
    }
    body.orientation[0] = turn.w();
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        body.position[d] = middle[d];
        body.velocity[d] = velocity[d];
        body.spin[d] = spin[d];
        body.inertia[d] = moments[d];
        body.orientation[d + 1] = turn.v()[d];
    }
    region.clumps.append(body);
    region.clump = labelField(region.size(), 0);
    Info<< "    " << region.name << ": one rigid body, mass " << body.mass << " kg, centre " << middle << ", principal moments of inertia "
        << moments << " kg m2" << nl;
}

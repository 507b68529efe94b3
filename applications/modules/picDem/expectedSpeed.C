/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "expectedSpeed.H"
#include "pic/grid/speed.hpp"
#include "pic/openings/kinds.hpp"
#include "SubField.H"
#include "sphDictionaries.H"
#include "sweptDomain.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static vector gravityOf(const riprap::PicConfig& config)
{
    const riprap::Vector3& g = config.gravity;
    return vector(g[0], g[1], g[2]);
}


//- Of surfaces that are moved, and of groups of solids
static scalar movedSpeed(const expectedSpeed::sources& of)
{
    const Time& time = of.mesh.time();
    scalar fastest = of.solids ? of.solids->movedSpeed() : 0;
    forAll(of.bodyOfObstacle, i)
    {
        const label body = of.bodyOfObstacle[i];
        if (body < 0) continue;
        const boundBox bounds((*of.obstacles)[i].bounds());
        fastest = max(
            fastest, of.bodies.largestSpeed(body, bounds, time.value(), endOfMotion(time)));
    }
    return fastest;
}


//- Of one opening at a time; a flow rate over the whole of its patch, which it
//  need not fill
static scalar openingSpeed(const riprap::PicOpening& opening, scalar area, scalar t)
{
    const riprap::Given given = riprap::givenAt(opening.kind);
    if (given == riprap::Given::discharge) return mag(opening.flowRate(t))/area;
    if (given != riprap::Given::velocity) return 0;
    const riprap::Vector3 u = opening.velocity(t);
    return mag(vector(u[0], u[1], u[2]));
}


//- Of all, as seen at some hundred moments
static scalar openingSpeed(const expectedSpeed::sources& of)
{
    const scalar thickness = of.config.dimensions == 2 ? of.mesh.bounds().span()[of.config.axes[2]]
                                                       : 1;
    const scalar begin = of.mesh.time().value(), end = endOfMotion(of.mesh.time());
    const label moments = 200;

    scalar fastest = 0;
    for (const riprap::PicOpening& opening : of.config.openings)
    {
        const label patchi = of.mesh.boundaryMesh().findPatchID(opening.name);
        const scalar area = sum(mag(of.mesh.boundaryMesh()[patchi].faceAreas()))/thickness;
        for (label i = 0; i <= moments; ++i)
        {
            fastest = max(fastest, openingSpeed(opening, area, begin + i*(end - begin)/moments));
        }
    }
    return fastest;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::expectedSpeed::expectedSpeed(const sources& of)
{
    const vector g(gravityOf(of.config));
    const scalar lowest = lowestPlace(of.mesh, g);
    const auto atLeast = [this](scalar speed, const char* what)
    {
        if (!by.empty() && speed <= value) return;
        value = speed;
        by = what;
    };
    atLeast
    (
        sqrt(largestEnergy(g, of.spacing, lowest, of.fluid.position, of.fluid.vectors["U"])),
        "the water's fall to the lowest place of the mesh with its velocities"
    );
    if (of.solids)
        atLeast(of.solids->fallSpeed(g, lowest),
            "the fall of solids to the lowest place of the mesh with their velocities");
    atLeast(openingSpeed(of), "velocities of openings");

    const scalar moved = movedSpeed(of);
    if (moved > 0)
    {
        OStringStream text;
        text << " and " << moved << " m/s of what is moved";
        by += text.str();
    }
    value = sqrt(sqr(value) + sqr(moved));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::expectedSpeed::step(const riprap::PicConfig& config, scalar atStart) const
{
    if (!config.adjustTimeStep) return atStart;
    return min(atStart,
        scalar(riprap::courantStep(
            config.maxCourant, config.cellSize, value, mag(gravityOf(config)))));
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyLog.H"
#include "moduleLog.H"
#include "vector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- More would hide the rest of the log
static const std::size_t mostBodies = 10;


static vector toVector(const riprap::Vector3& v)
{
    return vector(v[0], v[1], v[2]);
}


static void logBody
(
    const riprap::DemConfig& config,
    const riprap::DemInput& input,
    const riprap::DemClump& body
)
{
    const char* metre = config.dimensions == 2 ? " per metre" : "";
    logItem("rigid body");
    if (input.groups.size())
    {
        Info<< "group " << input.groups[body.group].name.c_str() << ", ";
    }
    Info<< "mass " << body.mass << " kg" << metre << ", centre "
        << toVector(body.position) << ", principal moments of inertia ";
    if (config.dimensions == 2) Info<< body.inertia[2];
    else Info<< toVector(body.inertia);
    Info<< " kg m2" << metre;
    if (body.volume > 0)
    {
        Info<< ", volume " << body.volume << " m3" << metre << ", "
            << body.mass/body.volume << " kg/m3";
    }
    Info<< nl;
}


static void logConstraint(const riprap::DemGroup& group)
{
    const riprap::DemConstraint& c = group.constraint;
    if (!c.any()) return;

    logItem("constrain") << "group " << group.name.c_str() << ": ";
    if (c.hinge)
    {
        Info<< "hinge about " << toVector(c.axis) << " through "
            << toVector(c.point) << nl;
        return;
    }
    switch (c.translation)
    {
        case riprap::TranslationKind::free: Info<< "moves freely"; break;
        case riprap::TranslationKind::line: Info<< "moves along " << toVector(c.direction); break;
        case riprap::TranslationKind::plane: Info<< "moves across " << toVector(c.direction); break;
        case riprap::TranslationKind::none: Info<< "does not move"; break;
    }
    switch (c.rotation)
    {
        case riprap::RotationKind::free: Info<< ", turns freely"; break;
        case riprap::RotationKind::axis: Info<< ", turns about " << toVector(c.axis); break;
        case riprap::RotationKind::none: Info<< ", does not turn"; break;
    }
    Info<< nl;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::logBodies
(
    const riprap::DemConfig& config,
    const riprap::DemInput& input
)
{
    const std::vector<riprap::DemClump>& all = input.clumps;
    for (std::size_t k = 0; k < all.size() && k < mostBodies; ++k)
    {
        logBody(config, input, all[k]);
    }
    if (all.size() > mostBodies)
    {
        logItem("rigid body") << "and " << label(all.size() - mostBodies)
            << " more" << nl;
    }
    for (const riprap::DemGroup& group : input.groups)
    {
        logConstraint(group);
        for (const riprap::DemSpring& s : group.springs)
        {
            logItem(s.slack ? "mooring" : "spring") << group.name.c_str()
                << '.' << s.name.c_str() << ": anchor " << toVector(s.anchor)
                << ", point " << toVector(s.point) << ", stiffness "
                << s.stiffness << " N/m, damping " << s.damping
                << " N s/m, length " << s.length << " m" << nl;
        }
    }
}


// ************************************************************************* //

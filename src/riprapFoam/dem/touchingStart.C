/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "touchingStart.H"
#include "HashSet.H"
#include "idIndex.H"
#include "point.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The bodies that contacts join
struct touchingBodies
{
    label count = 0;
    scalar mass = 0;                //- [kg] (2D: per metre)
    scalar smallest = GREAT;        //- Diameter of a particle [m]
    label deepest = 0;              //- Contact
};


static point positionOf(const riprap::DemState& now, label i)
{
    return point
    (
        now.position[3*i], now.position[3*i + 1], now.position[3*i + 2]
    );
}


static touchingBodies bodiesOf
(
    const riprap::DemContacts& contacts,
    const riprap::DemState& now,
    const idIndex& entryOfId,
    const riprap::DemInput& input
)
{
    touchingBodies result;
    labelHashSet singles, clumps;
    const auto add = [&](label i)
    {
        const label clump = now.clump.empty() ? -1 : now.clump[i];
        result.smallest = min(result.smallest, 2*now.radius[i]);
        if (clump < 0 ? singles.insert(i) : clumps.insert(clump))
        {
            ++result.count;
            result.mass += clump < 0 ? now.mass[i] : input.clumps[clump].mass;
        }
    };
    for (std::size_t k = 0; k < contacts.a.size(); ++k)
    {
        add(entryOfId(contacts.a[k]));
        if (contacts.b[k] >= 0) add(entryOfId(contacts.b[k]));
        if (contacts.overlap[k] > contacts.overlap[result.deepest])
        {
            result.deepest = k;
        }
    }
    return result;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::warnOfTouchingStart
(
    riprap::DemScene& solids,
    const riprap::DemConfig& config,
    const riprap::DemInput& input
)
{
    const scalar held = solids.energy().contact;
    const vector g(config.gravity[0], config.gravity[1], config.gravity[2]);
    if (!(held > 0) || mag(g) < SMALL)
    {
        return;
    }
    const riprap::DemContacts contacts(solids.contacts());
    if (contacts.a.empty())
    {
        return;
    }
    const riprap::DemState now(solids.particles());
    const idIndex entryOfId(now.id);
    const touchingBodies touching(bodiesOf(contacts, now, entryOfId, input));
    const scalar height = held/(touching.mass*mag(g));
    if (!(height > touching.smallest/20))
    {
        return;
    }

    const label k = touching.deepest;
    Info<< "Warning: solids touch at the start. The contacts of " << touching.count
        << (touching.count == 1 ? " body hold " : " bodies hold ") << held
        << " J, enough to throw them " << height << " m up. The deepest is " << contacts.overlap[k]
        << " m, gap included, of particle " << label(contacts.a[k]) << " at "
        << positionOf(now, entryOfId(contacts.a[k])) << " with "
        << (contacts.b[k] < 0 ? std::string("a wall")
                               : "particle " + std::to_string(contacts.b[k]))
                .c_str()
        << ". Place them farther apart, or give a smaller gap or stiffness in"
        << " constant/solidProperties" << nl << endl;
}


// ************************************************************************* //

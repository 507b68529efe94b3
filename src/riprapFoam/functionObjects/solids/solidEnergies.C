/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidEnergies.H"
#include "addToRunTimeSelectionTable.H"
#include "quaternion.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(solidEnergies, 0);
    addToRunTimeSelectionTable(functionObject, solidEnergies, dictionary);
}
}


namespace
{
    using Foam::vector;

    struct Momentum { vector linear = Foam::Zero, angular = Foam::Zero; };

    vector vectorOf(const std::vector<double>& v, const std::size_t i)
    {
        return vector(v[3*i], v[3*i + 1], v[3*i + 2]);
    }

    //- Of a rigid body, whose members' masses are not its own: about its centre, I w
    vector spinMomentum(const riprap::DemClump& body, const riprap::DemClumpState& now,
        const std::size_t k, const int emptyAxis)
    {
        const vector w(vectorOf(now.spin, k));
        if (emptyAxis >= 0) return body.inertia[2]*w;

        const double* q = &now.orientation[4*k];
        const Foam::quaternion turn(q[0], vector(q[1], q[2], q[3]));
        const vector I(body.inertia[0], body.inertia[1], body.inertia[2]);
        return turn.transform(Foam::cmptMultiply(I, turn.invTransform(w)));
    }

    Momentum momentumOf(const Foam::demSceneObject& solids,
        const std::vector<riprap::DemClump>& bodies, const riprap::DemConfig& config)
    {
        Momentum m;
        if (bodies.size())
        {
            const riprap::DemClumpState moving(solids.scene().clumps());
            for (std::size_t k = 0; k < bodies.size(); ++k)
            {
                if (moving.left[k]) continue;
                const vector p(bodies[k].mass*vectorOf(moving.velocity, k));
                m.linear += p;
                m.angular += (vectorOf(moving.position, k) ^ p)
                    + spinMomentum(
                        bodies[k], moving, k, config.dimensions == 2 ? config.axes[2] : -1);
            }
        }
        if (config.dimensions == 3)
        {
            const riprap::DemMomentum free(solids.scene().momentum());
            m.linear += vector(free.linear[0], free.linear[1], free.linear[2]);
            m.angular += vector(free.angular[0], free.angular[1], free.angular[2]);
            return m;
        }
        // one by one: with their places along the empty axis
        const riprap::DemState& now = solids.motion();
        for (std::size_t i = 0; i < now.id.size(); ++i)
        {
            if (now.clump.size() && now.clump[i] >= 0) continue;
            const vector x(vectorOf(now.position, i)), u(vectorOf(now.velocity, i)),
                w(vectorOf(now.spin, i));
            m.linear += now.mass[i]*u;
            m.angular += now.mass[i]*(x ^ u) + 0.5*now.mass[i]*Foam::sqr(now.radius[i])*w;
        }
        return m;
    }
}


Foam::functionObjects::solidEnergies::solidEnergies
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    demFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


bool Foam::functionObjects::solidEnergies::writeSample()
{
    const riprap::DemEnergy e(dem().scene().energy());
    const Momentum m(momentumOf(dem(), dem().input().clumps, dem().settings().config));

    OFstream& os = row(typeName,
        {"translation", "rotation", "potential", "contact", "bond", "total", "momentumX",
            "momentumY", "momentumZ", "angularX", "angularY", "angularZ", "spring"});
    for (const scalar value :
        {e.translation, e.rotation, e.potential, e.contact, e.bond, e.total()})
    {
        add(os, value);
    }
    for (const vector& v : {m.linear, m.angular})
    {
        for (int d = 0; d < vector::nComponents; ++d) add(os, v[d]);
    }
    add(os, e.spring);
    os  << endl;
    return true;
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidEnergies.H"
#include "addToRunTimeSelectionTable.H"

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

    Momentum momentumOf(const riprap::DemState& now, const int dimensions)
    {
        const double beta = dimensions == 2 ? 0.5 : 0.4;
        Momentum m;
        for (std::size_t i = 0; i < now.id.size(); ++i)
        {
            const vector x(now.position[3*i], now.position[3*i + 1], now.position[3*i + 2]);
            const vector u(now.velocity[3*i], now.velocity[3*i + 1], now.velocity[3*i + 2]);
            const vector w(now.spin[3*i], now.spin[3*i + 1], now.spin[3*i + 2]);
            m.linear += now.mass[i]*u;
            m.angular += now.mass[i]*(x ^ u) + beta*now.mass[i]*Foam::sqr(now.radius[i])*w;
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


bool Foam::functionObjects::solidEnergies::write()
{
    const riprap::DemEnergy e(dem().scene().energy());
    const Momentum m(momentumOf(dem().scene().particles(), dem().settings().config.dimensions));

    OFstream& os = row
    (
        typeName,
        {
            "translation", "rotation", "potential", "contact", "bond", "total", "momentumX", "momentumY",
            "momentumZ", "angularX", "angularY", "angularZ", "spring"
        }
    );
    for (const scalar value : {e.translation, e.rotation, e.potential, e.contact, e.bond, e.total()})
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

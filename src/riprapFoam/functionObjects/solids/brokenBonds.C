/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "brokenBonds.H"
#include "idIndex.H"
#include "nearestImage.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(brokenBonds, 0);
    addToRunTimeSelectionTable(functionObject, brokenBonds, dictionary);
}
}


Foam::functionObjects::brokenBonds::brokenBonds
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


bool Foam::functionObjects::brokenBonds::writeSample()
{
    const riprap::DemBondState bonds(dem().scene().bonds());
    const riprap::DemState& now = dem().motion();
    const idIndex entryOfId(now.id);

    label count[4] = {0, 0, 0, 0};
    scalar maxTension = 0, maxShear = 0;
    for (std::size_t i = 0; i < bonds.a.size(); ++i)
    {
        ++count[bonds.broken[i]];
        const label a = entryOfId(bonds.a[i]), b = entryOfId(bonds.b[i]);
        if (bonds.broken[i] || a < 0 || b < 0) continue;

        vector way, force;              // the force on a, which is pulled towards b
        for (int d = 0; d < vector::nComponents; ++d)
        {
            way[d] = now.position[3*b + d] - now.position[3*a + d];
            force[d] = bonds.force[3*i + d];
        }
        const vector n(normalised(nearestImage(dem().settings().config, way)));
        maxTension = max(maxTension, force & n);
        maxShear = max(maxShear, mag(force - (force & n)*n));
    }

    OFstream& os = row
    (
        typeName,
        {"whole", "broken", "inTension", "inShear", "lost", "maxTension", "maxShear"}
    );
    for (const scalar value : {scalar(count[0]), scalar(count[1] + count[2] + count[3]),
             scalar(count[1]), scalar(count[2]), scalar(count[3]), maxTension, maxShear})
    {
        add(os, value);
    }
    os  << endl;
    return true;
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidCentre.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(fluidCentre, 0);
    addToRunTimeSelectionTable(functionObject, fluidCentre, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::fluidCentre::fluidCentre
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fluidFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::fluidCentre::read(const dictionary& dict)
{
    fluidFunctionObject::read(dict);

    box_ = boundBox(point::uniform(-GREAT), point::uniform(GREAT));
    if (dict.found("box"))
    {
        ITstream& is = dict.lookup("box");
        const point low(is), high(is);
        if (!(cmptMin(high - low) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry box is " << low << ' ' << high
                << ": each component of the second corner must be larger"
                << exit(FatalIOError);
        }
        box_ = boundBox(low, high);
    }
    return true;
}


bool Foam::functionObjects::fluidCentre::writeSample()
{
    const riprap::FluidState state(fluid().fluidScene().fluid());

    vector x(Zero), v(Zero);
    label n = 0;
    for (std::size_t i = 0; i < state.id.size(); ++i)
    {
        const double* at = &state.position[3*i];
        const double* moves = &state.velocity[3*i];
        const point place(at[0], at[1], at[2]);
        if (!box_.contains(place)) continue;
        x += place;
        v += vector(moves[0], moves[1], moves[2]);
        ++n;
    }

    OFstream& os = row(typeName, {"particles", "x", "y", "z", "vx", "vy", "vz"});
    add(os, n);
    for (const vector& sum : {x, v})
    {
        for (int d = 0; d < vector::nComponents; ++d)
        {
            add(os, n ? sum[d]/n : 0);
        }
    }
    os  << endl;

    return true;
}


// ************************************************************************* //

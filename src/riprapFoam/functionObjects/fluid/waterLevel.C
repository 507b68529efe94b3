/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "waterLevel.H"
#include "levelCrossing.hpp"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(waterLevel, 0);
    addToRunTimeSelectionTable(functionObject, waterLevel, dictionary);
}
}


Foam::functionObjects::waterLevel::waterLevel
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


bool Foam::functionObjects::waterLevel::read(const dictionary& dict)
{
    fluidFunctionObject::read(dict);

    const vector up(upDirection(dict));
    const scalar spacing = fluid().fluidConfig().spacing;

    minThickness_ = notNegative(dict, "minThickness", dropThickness());
    feet_ = points(dict, "points");
    lines_.resize(feet_.size());
    solid_.resize(feet_.size());

    forAll(feet_, i)
    {
        const scalar length = gaugeLength(mesh_.bounds(), feet_[i], up);

        if (length <= 0 || !reach().contains(feet_[i] + 0.5*length*up))
        {
            FatalIOErrorInFunction(dict)
                << "Entry points of function object " << name() << ": gauge "
                << i << " at " << feet_[i] << " along " << up
                << " meets nothing of the mesh, which spans "
                << mesh_.bounds().min() << " to " << mesh_.bounds().max()
                << exit(FatalIOError);
        }

        lines_[i] = makeGaugeLine(mesh_.bounds(), feet_[i], up, spacing);
        solid_[i] = inSolid(lines_[i].points);
    }

    return true;
}


bool Foam::functionObjects::waterLevel::writeSample()
{
    pointField all;
    for (const gaugeLine& line : lines_)
    {
        all.append(line.points);
    }

    const std::vector<double> fraction(sample(all).volumeFraction);

    const label n = feet_.size();
    wordList columns(2*n);
    List<string> comments(n);
    scalarField levels(2*n);

    auto first = fraction.begin();
    forAll(feet_, i)
    {
        const auto last = first + lines_[i].points.size();
        const riprap::FluidLevel level
        (
            riprap::fluidLevel
            (
                lines_[i].height,
                std::vector<double>(first, last),
                minThickness_,
                solid_[i]
            )
        );
        first = last;

        levels[i] = level.top;
        levels[n + i] = level.lowest;
        columns[i] = "level" + Foam::name(i);
        columns[n + i] = "lowest" + Foam::name(i);

        OStringStream os;
        os  << "Gauge " << i << ' ' << feet_[i];
        comments[i] = os.str();
    }

    OFstream& os = row(typeName, columns, comments);
    for (const scalar level : levels)
    {
        add(os, level);
    }
    os  << endl;

    return true;
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Contacts that are too soft for the speeds and loads that occur: overlaps
    that are no small part of a body, and bodies that walls cannot hold. Neither
    stops a run; both are told.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "solvers/dem/demLaws.hpp"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::dem::checkOverlaps()
{
    // A part of a diameter, and steps between two looks at all contacts
    const scalar large = 0.05;
    const int64_t between = 32;

    if (overlapTold_ || run_.steps < overlapChecked_ + between)
    {
        return;
    }
    overlapChecked_ = run_.steps;

    const scalar deepest = scene_->deepestOverlap();
    if (!(deepest > large))
    {
        return;
    }
    overlapTold_ = true;

    const riprap::NormalNeeds law =
        riprap::normalNeeds(riprap::lawChoice(settings_.config));
    const scalar exactly = pow(deepest/0.01, law.stiffening);
    const scalar digit = pow(10.0, floor(log10(exactly)) - 1);
    const scalar stiffer = digit*round(exactly/digit);      // two digits
    Info<< "Warning: at time " << report_.time << " s bodies overlap by "
        << 100*deepest << " % of a diameter, above " << 100*large
        << " %: contacts are soft for these speeds and loads. "
        << law.stiffenedBy << " about " << stiffer
        << " times as large would keep it to 1 %; with overlaps of half a"
        << " diameter bodies pass each other and walls. Said once" << endl;
}


void Foam::solverModules::dem::logPassedWalls()
{
    if (report_.passedWalls)
    {
        passedWalls_ += report_.passedWalls;
        Info<< "Passed walls: " << int64_t(report_.passedWalls)
            << " particles (" << passedWalls_ << " since the start of this"
            << " run), one of them " << label(report_.passedId)
            << ": pressed through, a radius behind the surface" << endl;
    }

    label told = 0;
    for (std::size_t i = 0; i < report_.escaped.size(); ++i)
    {
        const riprap::Vector3& x = report_.escaped[i];
        const point where(x[0], x[1], x[2]);
        if (!boundary_.byOpening(where) && told++ < 5)
        {
            Info<< "Passed a wall: "
                << boundary_.particle(report_.escapedId[i], x).c_str()
                << endl;
        }
    }
    if (told > 5)
    {
        Info<< "Passed a wall: " << told - 5 << " more" << endl;
    }
}


// ************************************************************************* //

// SPDX-License-Identifier: GPL-3.0-or-later
/*  A case in which regions of fluid are placed, without walls, beside solids or alone. */
#pragma once

#include "solidRegionCase.hpp"

struct FluidRegionCase : SolidRegionCase
{
    using SolidRegionCase::SolidRegionCase;

    Foam::List<Foam::fluidObstacle> obstacles;

    //- As setParticles shows a region of solids to the water
    void addObstacle(const Foam::solidRegion& r)
    {
        obstacles.append(Foam::fluidObstacle{r.name, r.exact, r.position, r.radius,
            Foam::scalarField(r.mass/Foam::sum(r.mass))});
    }

    //- Of "a { .. } b { .. }"; others: entries beside the list, among them spacing
    Foam::List<Foam::particleRegion> waters(
        const std::string& list, const std::string& others) const
    {
        const Foam::dictionary dict(entries(others + " regions (" + list + ");"));
        const Foam::vector g(0, 0, -10);
        const Foam::wallPoints none;
        return Foam::readRegions(dict, Foam::readPacking(dict, mesh(), g),
            {mesh(), bodies.get(), none, g, 1000, obstacles});
    }

    Foam::particleRegion water(
        const std::string& text, const std::string& others = "spacing 0.05;") const
    {
        return waters("w { set fluid; " + text + " }", others)[0];
    }

    std::string waterSaid(
        const std::string& text, const std::string& others = "spacing 0.05;") const
    {
        return messageOf([&]() { water(text, others); });
    }
};

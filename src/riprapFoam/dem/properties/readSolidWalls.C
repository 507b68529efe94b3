/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/solidProperties: walls, their materials, and how they move.

        walls
        {
            patches     (floor "side.*");   // default: all of type wall
            material    steel;
            materials   { floor glass; "side.*" rubber; }
            planes      { slope { point (0 0 0); normal (-1 0 1); } }
            motion      { lid { patches (top); solidBodyMotionFunction ..; } }
        }
\*---------------------------------------------------------------------------*/

#include "readSolidProperties.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readSolidWalls(checkedDictionary& solids, demSettings& settings)
{
    demWalls& walls = settings.walls;
    walls.dict = solids.subDict("walls");
    checkedDictionary dict(walls.dict);

    walls.everyWallPatch = !dict.found("patches");
    if (!walls.everyWallPatch)
    {
        walls.patches = walls.dict.get<wordRes>("patches");
    }

    if (dict.found("material"))
    {
        walls.material = walls.dict.get<word>("material");
        settings.material(walls.material, walls.dict);
    }

    const dictionary& materials = dict.subDict("materials");
    for (const entry& e : materials)
    {
        if (!e.isStream() || e.stream().size() != 1)
        {
            FatalIOErrorInFunction(materials)
                << "Entry " << e.keyword() << " must be one word, the name of a"
                << " material" << exit(FatalIOError);
        }
        const word name(e.stream());
        settings.material(name, materials);
        walls.materials.append
        (
            Tuple2<wordRe, word>
            (
                e.keyword().isPattern()
              ? wordRe(e.keyword(), wordRe::REGEX)
              : wordRe(e.keyword(), wordRe::LITERAL),
                name
            )
        );
    }

    const dictionary& planes = dict.subDict("planes");
    for (const entry& e : planes)
    {
        walls.planes.append
        (
            Tuple2<word, dictionary>(e.keyword(), namedDict(planes, e))
        );
    }

    walls.motion = readWallMotion(dict.subDict("motion"));
    dict.end();
}


// ************************************************************************* //

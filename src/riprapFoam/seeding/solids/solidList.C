// SPDX-License-Identifier: GPL-3.0-or-later
/*  source csv for solids: a body a line. Columns by name, in any order: x, y, z and any of u, v, w
    (velocity), wx, wy, wz (spin), radius, mass, material, group. What has no column is the
    region's.
*/

#include "csvFile.H"
#include "didYouMean.H"
#include "listed.H"
#include "solidRegions.H"

namespace Foam
{

// Three columns, all or none of them
static vectorField vectors(const csvFile& file, const wordList& names, bool needed)
{
    label column[3], there = 0;
    forAll(names, d)
    {
        column[d] = file.column(names[d]);
        there += column[d] >= 0;
    }
    if (there != 3 && (needed || there))
    {
        file.fail(-1, "the columns " + listed(names) + " must be there, all of them");
    }
    if (!there) return vectorField();

    vectorField values(file.size());
    forAll(values, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
            values[i][d] = file.number(i, column[d]);
    }
    return values;
}


static scalarField positives(const csvFile& file, const word& name)
{
    const label column = file.column(name);
    if (column < 0) return scalarField();

    scalarField values(file.size());
    forAll(values, i)
    {
        values[i] = file.number(i, column);
        if (!(values[i] > 0))
            file.fail(i, name + " is " + file.text(i, column) + ": it must be positive");
    }
    return values;
}

} // namespace Foam


void Foam::readSolidList(checkedDictionary& dict, const solidSpace& space, solidRegion& region)
{
    static const wordList valid
    ({
        "x", "y", "z", "u", "v", "w", "wx", "wy", "wz", "radius", "mass", "material", "group"
    });
    const demSettings& settings = space.settings;
    const csvFile file(dict, space.mesh.time());
    for (const std::string& name : file.head())
    {
        if (!valid.found(word(name, false)))
        {
            file.fail(-1, "unknown column '" + name + "'; valid are " + listedFor(name, valid));
        }
    }

    region.position = vectors(file, {"x", "y", "z"}, true);
    region.velocity = vectors(file, {"u", "v", "w"}, false);
    region.spin = vectors(file, {"wx", "wy", "wz"}, false);
    region.radius = positives(file, "radius");
    region.mass = positives(file, "mass");
    if (region.radius.empty()) region.radius = scalarField(file.size(), dict.positive("radius"));

    for (const word& name : {word("material"), word("group")})
    {
        const label column = file.column(name);
        if (column < 0) continue;
        labelField& index = name == "group" ? region.group : region.material;
        index.setSize(file.size());
        forAll(index, i)
        {
            const word typed(file.text(i, column), false);
            index[i] = name == "group" ? settings.group(typed, region.dict)
                                       : settings.material(typed, region.dict);
        }
    }

    const auto& g = settings.config.gravity;
    const particlePacking frame(
        space.mesh, particlePacking::kind::square, 1, vector(g[0], g[1], g[2]));
    for (point& x : region.position) x = frame.inPlane(x);
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/solidProperties: what is done to groups of particles.

        groups
        {
            clamp { fixed all; }                // or (x y z spin), or none
            tip   { sharedForce (0 -1 0); }     // force (..): on each one
            lid   { motion { solidBodyMotionFunction ..; } }
            beam  { localDamping 0.7; }
            buoy  { constrain { .. } springs { .. } moorings { .. } }
        }                                       // readConstraints.C
\*---------------------------------------------------------------------------*/

#include "readSolidProperties.H"
#include "vector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void readFixed(checkedDictionary& dict, riprap::DemGroup& group)
{
    static const wordList axes({"x", "y", "z", "spin"});

    if (!dict.found("fixed")) return;

    wordList words;
    ITstream& is = dict.dict().lookup("fixed");
    const token first(is);
    is.rewind();
    if (first.isWord())
    {
        const word typed(is);
        if (typed == "all")
        {
            words = axes;
        }
        else if (typed != "none")
        {
            dict.unknownWord("fixed", typed, {"all", "none", "(x y z spin)"});
        }
    }
    else
    {
        is >> words;
    }
    dict.dict().checkITstream(is, "fixed");

    for (const word& typed : words)
    {
        const label axis = axes.find(typed);
        if (axis < 0)
        {
            dict.unknownWord("fixed", typed, axes);
        }
        if (axis == 3)
        {
            group.heldSpin = true;
        }
        else
        {
            group.held[axis] = true;
        }
    }
}


static riprap::Vector3 readVector(checkedDictionary& dict, const word& entry)
{
    if (!dict.found(entry))
    {
        return {{0, 0, 0}};
    }
    const vector v(dict.dict().get<vector>(entry));
    return {{v.x(), v.y(), v.z()}};
}


static demGroup readGroup
(
    const word& name,
    const dictionary& entries,
    const riprap::DemConfig& config,
    List<wallMotion>& motions
)
{
    checkedDictionary dict(entries);
    demGroup settings;
    riprap::DemGroup& group = settings.group;

    group.name = name;
    readFixed(dict, group);
    group.gravity = dict.either("gravity", "yes", "no", group.gravity);
    group.force = readVector(dict, "force");
    group.moment = readVector(dict, "moment");
    const auto shared = readVector(dict, "sharedForce");
    settings.sharedForce = vector(shared[0], shared[1], shared[2]);
    group.localDamping = dict.between("localDamping", 0, 0, 1);
    dict.require(group.localDamping < 1, "localDamping", group.localDamping, "less than 1");
    // [1/s]: no step follows what dies away within a nanosecond
    group.viscousDamping = dict.between("viscousDamping", 0, 0, 1e9);
    group.viscousSpinDamping = dict.between("viscousSpinDamping", 0, 0, 1e9);

    readConstraint(dict, config, group.constraint);
    readSprings(dict, group.springs);

    const dictionary& motion = dict.subDict("motion");
    settings.moves = entries.found("motion", keyType::LITERAL);
    if (settings.moves)
    {
        group.motion = motions.size();
        motions.append(readMotion(name, motion, false));
    }
    dict.end();

    const bool fixed = dict.dict().found("fixed", keyType::LITERAL);
    if (group.constraint.any() && (fixed || settings.moves))
    {
        FatalIOErrorInFunction(entries)
            << "Group " << name << " has both entries constrain and "
            << (fixed ? "fixed" : "motion") << exit(FatalIOError);
    }
    if (settings.moves && (group.heldSpin || group.held[0] || group.held[1] || group.held[2]))
    {
        FatalIOErrorInFunction(entries)
            << "Group " << name << " has both entries fixed and motion"
            << exit(FatalIOError);
    }
    return settings;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readSolidGroups(checkedDictionary& solids, demSettings& settings)
{
    const dictionary& all = solids.subDict("groups");

    if (!all.found("free", keyType::LITERAL))
    {
        demGroup free;
        free.group.name = "free";
        settings.groups.append(free);
    }
    for (const entry& e : all)
    {
        settings.groups.append
        (
            readGroup
            (
                e.keyword(),
                namedDict(all, e),
                settings.config,
                settings.groupMotion
            )
        );
    }
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/solidProperties: what rigid bodies of a group may do, and what
    holds them.

        groups
        {
            buoy
            {
                constrain
                {
                    line        (0 0 1);    // its centre moves along it alone
                    plane       (0 1 0);    // or across it alone
                    position    fixed;      // or not at all
                    axis        (0 1 0);    // it turns about it alone
                    orientation fixed;      // or not at all
                    hinge { point (0 0 0); axis (0 1 0); }  // nothing else
                }
                springs  { a { anchor (..); point (..); stiffness 100;
                               damping 0; restLength 0; } }
                moorings { b { anchor (..); point (..); stiffness 1e4;
                               damping 0; length 2; } }
            }
        }

    Directions, axes and anchors are in space. A point is on the body as
    setParticles has placed it. In 2D axes are the empty direction.
\*---------------------------------------------------------------------------*/

#include "readSolidProperties.H"
#include "vector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static riprap::Vector3 given(checkedDictionary& dict, const word& entry)
{
    dict.found(entry);
    const vector v(dict.dict().get<vector>(entry));
    return {{v.x(), v.y(), v.z()}};
}


//- A direction that has a length where the case is solved
static riprap::Vector3 directed
(
    checkedDictionary& dict,
    const word& entry,
    const riprap::DemConfig& config
)
{
    const riprap::Vector3 v(given(dict, entry));
    scalar length = 0;
    for (int d = 0; d < config.dimensions; ++d)
    {
        length += sqr(v[config.axes[d]]);
    }
    if (!(length > 0))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry " << entry << " is " << vector(v[0], v[1], v[2])
            << ": it needs a length"
            << (config.dimensions == 2 ? " in the plane of this 2D case" : "")
            << exit(FatalIOError);
    }
    return v;
}


//- An axis to turn about: in 2D there is one alone
static riprap::Vector3 axis
(
    checkedDictionary& dict,
    const riprap::DemConfig& config
)
{
    if (config.dimensions == 3)
    {
        return directed(dict, "axis", config);
    }
    riprap::Vector3 empty{{0, 0, 0}};
    empty[config.axes[2]] = 1;
    if (!dict.found("axis")) return empty;

    const riprap::Vector3 v(given(dict, "axis"));
    if (v[config.axes[0]] != 0 || v[config.axes[1]] != 0 || v[config.axes[2]] == 0)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry axis is " << vector(v[0], v[1], v[2])
            << ": bodies of this 2D case turn about its empty direction,"
            << " valid is " << vector(empty[0], empty[1], empty[2])
            << exit(FatalIOError);
    }
    return empty;
}


static void only
(
    checkedDictionary& dict,
    const word& a,
    const word& b
)
{
    if (dict.dict().found(a, keyType::LITERAL) && dict.dict().found(b, keyType::LITERAL))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entries " << a << " and " << b << " of constrain exclude each"
            << " other" << exit(FatalIOError);
    }
}


static void readHinge
(
    checkedDictionary& dict,
    const riprap::DemConfig& config,
    riprap::DemConstraint& constraint
)
{
    checkedDictionary hinge(dict.subDict("hinge"));
    constraint.hinge = true;
    constraint.point = given(hinge, "point");
    constraint.axis = axis(hinge, config);
    hinge.end();
    for (const word& other : wordList({"line", "plane", "axis", "orientation"}))
    {
        only(dict, "hinge", other);
    }
}


static riprap::DemSpring readSpring(const word& name, const dictionary& entries, bool slack)
{
    checkedDictionary dict(entries);
    riprap::DemSpring spring;
    spring.name = name;
    spring.slack = slack;
    spring.anchor = given(dict, "anchor");
    spring.point = given(dict, "point");
    spring.stiffness = dict.positive("stiffness");
    spring.damping = dict.notNegative("damping", 0);
    spring.length =
        slack ? dict.positive("length") : dict.notNegative("restLength", 0);
    dict.end();
    return spring;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readConstraint
(
    checkedDictionary& group,
    const riprap::DemConfig& config,
    riprap::DemConstraint& constraint
)
{
    const dictionary& entries = group.subDict("constrain");
    if (!group.dict().found("constrain", keyType::LITERAL)) return;

    checkedDictionary dict(entries);
    const bool hinge = entries.found("hinge", keyType::LITERAL);
    if (hinge) readHinge(dict, config, constraint);
    else dict.subDict("hinge");
    only(dict, "line", "plane");
    only(dict, "axis", "orientation");

    if (dict.found("line"))
    {
        constraint.translation = riprap::TranslationKind::line;
        constraint.direction = directed(dict, "line", config);
    }
    if (dict.found("plane"))
    {
        constraint.translation = riprap::TranslationKind::plane;
        constraint.direction = directed(dict, "plane", config);
    }
    if (dict.found("axis"))
    {
        constraint.rotation = riprap::RotationKind::axis;
        constraint.axis = axis(dict, config);
    }
    if (dict.either("orientation", "fixed", "free", false))
    {
        constraint.rotation = riprap::RotationKind::none;
    }
    if (dict.either("position", "fixed", "free", false))
    {
        only(dict, "position", "line");
        only(dict, "position", "plane");
        only(dict, "position", "hinge");
        constraint.translation = riprap::TranslationKind::none;
    }
    dict.end();
    if (!constraint.any())
    {
        FatalIOErrorInFunction(entries)
            << "Entry constrain constrains nothing; valid are (line plane"
            << " position axis orientation hinge)" << exit(FatalIOError);
    }
}


void Foam::readSprings
(
    checkedDictionary& group,
    std::vector<riprap::DemSpring>& springs
)
{
    for (const bool slack : {false, true})
    {
        const dictionary& all = group.subDict(slack ? "moorings" : "springs");
        for (const entry& e : all)
        {
            springs.push_back
            (
                readSpring(e.keyword(), namedDict(all, e), slack)
            );
        }
    }
}


// ************************************************************************* //

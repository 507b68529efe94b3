/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBodies.H"
#include <cmath>
#include "checkedDictionary.H"
#include "listed.H"
#include "singleValues.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- At which a motion is looked at
static const label nMoments = 256;


//- Moments that no period divides: multiples of the golden ratio, modulo 1
static scalar share(label i)
{
    const scalar golden = 0.5*(sqrt(5.0) - 1);
    return i*golden - floor(i*golden);
}


//- The functions know no time but their Time's: set its value, and nothing
//  else of it, while this lives
class momentOf
{
    scalar& value_;
    const scalar before_;

public:

    momentOf(const Time& time, scalar t)
    :
        value_(const_cast<Time&>(time).value()),
        before_(value_)
    {
        value_ = t;
    }

    ~momentOf()
    {
        value_ = before_;
    }
};


//- OpenFOAM's functions do not say which entries are wrong
static void stop(const wallMotion& motion, const error& e)
{
    FatalIOErrorInFunction(motion.dict)
        << "Motion " << motion.name << ": " << e.message().c_str()
        << exit(FatalIOError);
}


static autoPtr<solidBodyMotionFunction> functionOf(
    const wallMotion& motion, const dictionary& dict, const Time& time)
{
    try
    {
        return solidBodyMotionFunction::New(dict, time);
    }
    catch (const IOerror&)
    {
        throw;
    }
    catch (const error& e)
    {
        stop(motion, e);
    }
    return nullptr;
}


//- Names of the entries that the function of a motion reads
static wordList coefficients(const dictionary& motion)
{
    return motion.optionalSubDict(motion.get<word>("solidBodyMotionFunction") + "Coeffs").toc();
}


static point moved(const riprap::WallPose& pose, const point& x)
{
    const auto& R = pose.rotation;
    const auto& s = pose.translation;
    return point
    (
        R[0]*x.x() + R[1]*x.y() + R[2]*x.z() + s[0],
        R[3]*x.x() + R[4]*x.y() + R[5]*x.z() + s[1],
        R[6]*x.x() + R[7]*x.y() + R[8]*x.z() + s[2]
    );
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

//- The word of an entry solidBodyMotionFunction: one of OpenFOAM's
static word motionWord(const word& name, checkedDictionary& dict)
{
    const wordList valid
    (
        solidBodyMotionFunction::dictionaryConstructorTablePtr_->sortedToc()
    );
    if (!dict.found("solidBodyMotionFunction"))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Motion " << name << ": entry solidBodyMotionFunction is"
            << " missing; valid are " << listed(valid).c_str()
            << exit(FatalIOError);
    }
    word typed(dict.dict().get<word>("solidBodyMotionFunction"));
    if (!valid.found(typed))
    {
        dict.unknownWord("solidBodyMotionFunction", typed, valid);
    }
    return typed;
}


wallMotion readMotion(const word& name, const dictionary& entries, bool ofWalls)
{
    wallMotion motion;
    motion.name = name;
    motion.dict = entries;

    checkedDictionary dict(motion.dict);
    if (ofWalls)
    {
        dict.found("patches");
        motion.patches = wordRes(motion.dict.get<wordRes>("patches"));
    }
    const word coeffs(motionWord(name, dict) + "Coeffs");

    // Else the function takes its entries from this dictionary itself
    if (motion.dict.found(coeffs, keyType::LITERAL))
    {
        dict.subDict(coeffs);
        // Those of others may stand there, so that one word changes the motion
        for (const word& other :
            solidBodyMotionFunction::dictionaryConstructorTablePtr_->sortedToc())
        {
            const word others(other + "Coeffs");
            if (motion.dict.found(others)) dict.subDict(others);
        }
        dict.end();
    }
    requireSingleValues(motion.dict, "Motion " + name);
    return motion;
}


List<wallMotion> readWallMotion(const dictionary& dict)
{
    List<wallMotion> motion(dict.size());

    label i = 0;
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << e.keyword() << " is no dictionary: motion"
                << " holds one for each group of patches that moves"
                << exit(FatalIOError);
        }
        motion[i++] = readMotion(e.keyword(), e.dict(), true);
    }

    return motion;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallBodies::wallBodies
(
    const Time& time,
    const List<wallMotion>& groups
)
:
    time_(time),
    groups_(groups),
    functions_(groups.size())
{
    forAll(groups_, i)
    {
        functions_.set(i, functionOf(groups_[i], groups_[i].dict, time_));
        // Coefficients of others: one word makes them this motion's
        for (const word& other :
            solidBodyMotionFunction::dictionaryConstructorTablePtr_->sortedToc())
        {
            if (other == functions_[i].type()
                || !groups_[i].dict.found(other + "Coeffs", keyType::LITERAL))
                continue;
            dictionary dict(groups_[i].dict);
            dict.set("solidBodyMotionFunction", other);
            functionOf(groups_[i], dict, time_);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

riprap::WallPose Foam::wallBodies::pose(label body, scalar t) const
{
    // OpenFOAM's spline reads before its table where the time is the table's
    // first to the bit: the next number is in it
    const bool first = functions_[body].type() == "tabulated6DoFMotion"
        && t == time_.startTime().value() && time_.endTime().value() > t;
    const momentOf now(time_, first ? std::nextafter(t, GREAT) : t);
    septernion motion(septernion::I);
    try
    {
        motion = functions_[body].transformation();
    }
    catch (const error& e)
    {
        stop(groups_[body], e);
    }

    // Images of the origin and of the unit vectors: whatever the order in
    // which a septernion turns and moves
    const vector origin(motion.transformPoint(Zero));

    riprap::WallPose pose;
    for (direction j = 0; j < vector::nComponents; ++j)
    {
        vector unit(Zero);
        unit[j] = 1;
        const vector column(motion.transformPoint(unit) - origin);

        for (direction i = 0; i < vector::nComponents; ++i)
        {
            pose.rotation[3*i + j] = column[i];
        }
        pose.translation[j] = origin[j];
    }
    return pose;
}


riprap::WallMotion Foam::wallBodies::motion() const
{
    if (!size()) return riprap::WallMotion();
    return [this](int body, double t) { return pose(body, t); };
}


Foam::labelList Foam::wallBodies::bodyOf(const wordList& surfaces) const
{
    labelList body(surfaces.size(), -1);

    forAll(groups_, groupi)
    {
        const wallMotion& group = groups_[groupi];
        const labelList selected(group.patches.matching(surfaces));

        if (selected.empty())
        {
            FatalIOErrorInFunction(group.dict)
                << "Entry patches " << listed(group.patches).c_str()
                << " selects no wall; valid are " << listed(surfaces).c_str()
                << exit(FatalIOError);
        }

        for (const label i : selected)
        {
            if (body[i] >= 0)
            {
                FatalIOErrorInFunction(group.dict)
                    << "Wall " << surfaces[i] << " moves with "
                    << groups_[body[i]].name << " already"
                    << exit(FatalIOError);
            }
            body[i] = groupi;
        }
    }

    return body;
}


void Foam::wallBodies::requireNear
(
    label body,
    const boundBox& swept,
    const boundBox& mesh
) const
{
    const scalar away = max(mag(swept.min() - mesh.min()), mag(swept.max() - mesh.max()));
    if (away <= 1e4*mesh.mag()) return;
    FatalIOErrorInFunction(groups_[body].dict)
        << "Motion " << name(body) << " takes its walls " << away << " m away,"
        << " more than 10000 times the size of the mesh, " << mesh.mag()
        << " m, until endTime: is there a wrong unit among "
        << listed(coefficients(groups_[body].dict)).c_str() << '?' << exit(FatalIOError);
}


void Foam::wallBodies::requirePlanar
(
    label body,
    direction empty,
    scalar begin,
    scalar end
) const
{
    for (label i = 0; i <= nMoments; ++i)
    {
        const riprap::WallPose now(pose(body, begin + i*(end - begin)/nMoments));
        if
        (
            mag(now.rotation[4*empty] - 1) > 1e-9
         || mag(now.translation[empty]) > 1e-9
        )
        {
            FatalIOErrorInFunction(groups_[body].dict)
                << "Motion " << name(body) << " leaves the plane of this 2D"
                << " case: " << vector::componentNames[empty]
                << " is its empty direction" << exit(FatalIOError);
        }
    }
}


Foam::wordList Foam::wallBodies::resting(scalar begin, scalar end) const
{
    DynamicList<word> names;
    forAll(groups_, body)
    {
        const riprap::WallPose first(pose(body, begin));
        bool rests = true;
        for (label i = 1; i <= nMoments && rests; ++i)
        {
            const riprap::WallPose now(pose(body, begin + share(i)*(end - begin)));
            rests = now.rotation == first.rotation && now.translation == first.translation;
        }
        if (rests) names.append(name(body));
    }
    return wordList(std::move(names));
}


Foam::scalar Foam::wallBodies::largestSpeed
(
    label body,
    const boundBox& reference,
    scalar begin,
    scalar end
) const
{
    const label n = 4*nMoments;
    const scalar instant = min(scalar(1e-4), (end - begin)/n);
    const pointField corners(reference.points());

    scalar fastest = 0;
    for (label i = 0; i <= n && instant > 0; ++i)
    {
        const scalar t = begin + (i < n ? share(i) : 1)*(end - begin - instant);
        const riprap::WallPose now(pose(body, t));
        const riprap::WallPose later(pose(body, t + instant));
        for (const point& corner : corners)
        {
            fastest =
                max(fastest, mag(moved(later, corner) - moved(now, corner)));
        }
    }
    return instant > 0 ? fastest/instant : 0;
}


void Foam::wallBodies::sweep
(
    label body,
    const boundBox& reference,
    scalar begin,
    scalar end,
    boundBox& swept
) const
{
    const pointField corners(reference.points());
    for (label i = 0; i <= nMoments; ++i)
    {
        const riprap::WallPose now(pose(body, begin + i*(end - begin)/nMoments));
        for (const point& corner : corners)
        {
            swept.add(moved(now, corner));
        }
    }
}


// ************************************************************************* //

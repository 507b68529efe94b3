/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleDisplacement.H"
#include "idIndex.H"
#include "nearestImage.H"
#include "addToRunTimeSelectionTable.H"
#include <algorithm>
#include <limits>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(particleDisplacement, 0);
    addToRunTimeSelectionTable(functionObject, particleDisplacement, dictionary);
}
}


Foam::functionObjects::particleDisplacement::particleDisplacement
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


Foam::labelList Foam::functionObjects::particleDisplacement::nearest(const pointField& points) const
{
    // At the very start of the run, whenever it was
    const riprap::DemParticles& all = dem().input().particles;
    labelList ids(points.size(), -1);
    forAll(points, k)
    {
        scalar least = GREAT;
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            const point x(all.position[3*i], all.position[3*i + 1], all.position[3*i + 2]);
            if (mag(x - points[k]) < least)
            {
                least = mag(x - points[k]);
                ids[k] = all.id[i];
            }
        }
    }
    return ids;
}


bool Foam::functionObjects::particleDisplacement::read(const dictionary& dict)
{
    demFunctionObject::read(dict);
    if (dict.found("origIds") == dict.found("points"))
    {
        FatalIOErrorInFunction(dict)
            << "Function object " << name() << " needs one of the entries origIds and points"
            << exit(FatalIOError);
    }
    if (dict.found("origIds"))
    {
        const token first(dict.lookup("origIds"));
        if (first.isWord() && first.wordToken() == "all")
        {
            dict.get<word>("origIds");      // nothing may follow it
            const auto& all = dem().input().particles.id;
            ids_.setSize(label(all.size()));
            std::copy(all.begin(), all.end(), ids_.begin());
        }
        else
        {
            ids_ = dict.get<labelList>("origIds");
        }
    }
    else if (foundProperty("particles"))
    {
        getProperty("particles", ids_);
    }
    else
    {
        ids_ = nearest(dict.get<pointField>("points"));
        setProperty("particles", ids_);
    }
    if (ids_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << (dict.found("points") ? "points" : "origIds") << " of function object "
            << name() << " is empty" << exit(FatalIOError);
    }
    begin();
    return true;
}


//- Points that were kept for these particles, of whom that is known
Foam::HashTable<Foam::point, Foam::label, Foam::Hash<Foam::label>>
Foam::functionObjects::particleDisplacement::savedPoints
(
    const word& property
) const
{
    HashTable<point, label, Hash<label>> pointOf;
    const scalarList numbers(saved(property));
    labelList of;
    if (foundProperty("of")) getProperty("of", of);
    // of versions that did not say whose they are
    else if (numbers.size() == 3*ids_.size()) of = ids_;

    for (label k = 0; k < of.size() && 3*k + 2 < numbers.size(); ++k)
    {
        pointOf.set(of[k], point(numbers[3*k], numbers[3*k + 1], numbers[3*k + 2]));
    }
    return pointOf;
}


void Foam::functionObjects::particleDisplacement::keepPoints
(
    const word& property,
    const pointField& points
)
{
    scalarList numbers;
    for (const point& x : points) for (const scalar number : x) numbers.append(number);
    keep(property, numbers);
}


void Foam::functionObjects::particleDisplacement::begin()
{
    // those before the dictionary was edited have been followed
    HashTable<point, label, Hash<label>> nowOf(savedPoints("now"));
    forAll(now_, k) nowOf.set(followed_[k], now_[k]);
    const HashTable<point, label, Hash<label>> startOf(savedPoints("start"));

    const riprap::DemParticles& all = dem().input().particles;
    const idIndex entryOfId(all.id);
    start_.setSize(ids_.size());
    now_.setSize(ids_.size());
    forAll(ids_, k)
    {
        const label i = entryOfId(ids_[k]);
        if (startOf.found(ids_[k]))
        {
            start_[k] = startOf[ids_[k]];
        }
        else if (i >= 0)
        {
            const double* x = &all.position[3*std::size_t(i)];
            start_[k] = point(x[0], x[1], x[2]);
        }
        else
        {
            FatalIOErrorInFunction(dict_)
                << "Entry origIds of function object " << name() << ": there is no particle "
                << ids_[k] << "; there are " << label(all.size()) << exit(FatalIOError);
        }
        now_[k] = nowOf.found(ids_[k]) ? nowOf[ids_[k]] : start_[k];
    }
    followed_ = ids_;
    setProperty("of", ids_);
    keepPoints("start", start_);
    keepPoints("now", now_);
}


void Foam::functionObjects::particleDisplacement::follow()
{
    const riprap::DemState& motion = dem().motion();
    const idIndex entryOfId(motion.id);
    forAll(ids_, k)
    {
        const label at = entryOfId(ids_[k]);
        if (at < 0) continue;
        const double* at0 = &motion.position[3*std::size_t(at)];
        const point x(at0[0], at0[1], at0[2]);
        const vector back(now_[k] - x);
        now_[k] = x + (back - nearestImage(dem().settings().config, back));
    }
    followedAt_ = dem().scene().time();
}


bool Foam::functionObjects::particleDisplacement::executeSample()
{
    const riprap::DemConfig& config = dem().settings().config;
    scalar period = GREAT;
    for (label d = 0; d < 3; ++d)
    {
        if (config.periodic[d]) period = min(period, config.domainMax[d] - config.domainMin[d]);
    }
    if (period >= GREAT) return true;

    // places are read back where somebody may have gone a quarter of the shortest period
    fastest_ = max(fastest_, scalar(dem().lastReport().maxSpeed));
    if (time_.writeTime() || 4*fastest_*(dem().scene().time() - followedAt_) > period)
    {
        follow();
        fastest_ = 0;
        keepPoints("now", now_);
    }
    return true;
}


bool Foam::functionObjects::particleDisplacement::writeSample()
{
    follow();
    const riprap::DemState& now = dem().motion();
    const scalar none = std::numeric_limits<scalar>::quiet_NaN();

    wordList columns;
    DynamicList<scalar> values;
    const idIndex entryOfId(now.id);
    forAll(ids_, k)
    {
        const label at = entryOfId(ids_[k]);
        const bool there = at >= 0;
        for (const char* what : {"X", "D", "U", "W", "F"})
        {
            const std::vector<double>& field = *what == 'U' ? now.velocity
                : *what == 'W' ? now.spin
                : *what == 'F' ? now.force
                                                            : now.position;
            for (int d = 0; d < vector::nComponents; ++d)
            {
                const std::string axis(1, (*what == 'X' ? "XYZ" : "xyz")[d]);
                columns.append(
                    word(Foam::name(ids_[k]) + (*what == 'X' ? axis : what + axis), false));
                const scalar value = *what == 'D' ? now_[k][d] - start_[k][d] : field[3*at + d];
                values.append(there ? value : none);
            }
        }
    }

    OFstream& os = row(typeName, columns);
    for (const scalar value : values)
    {
        add(os, value);
    }
    os  << endl;
    return true;
}

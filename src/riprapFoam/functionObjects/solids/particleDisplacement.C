/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleDisplacement.H"
#include "idIndex.H"
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


void Foam::functionObjects::particleDisplacement::begin()
{
    if (foundProperty("start"))
    {
        getProperty("start", start_);
        if (start_.size() == ids_.size()) return;
    }

    const riprap::DemParticles& all = dem().input().particles;
    const idIndex entryOfId(all.id);
    start_.setSize(ids_.size());
    forAll(ids_, k)
    {
        const label i = entryOfId(ids_[k]);
        if (i >= 0)
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
    }
    setProperty("start", start_);
}


bool Foam::functionObjects::particleDisplacement::writeSample()
{
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
                values.append(there ? field[3*at + d] - (*what == 'D' ? start_[k][d] : 0) : none);
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

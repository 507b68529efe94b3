/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleForces.H"
#include "idIndex.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(particleForces, 0);
    addToRunTimeSelectionTable(functionObject, particleForces, dictionary);
}
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::label Foam::functionObjects::particleForces::empty() const
{
    for (label d = 0; mesh_.nGeometricD() == 2 && d < vector::nComponents; ++d)
    {
        if (mesh_.geometricD()[d] < 0) return d;
    }
    return -1;
}


void Foam::functionObjects::particleForces::add
(
    const kind which,
    const riprap::Vector3& place,
    const riprap::Vector3& force,
    const riprap::Vector3& moment
)
{
    const vector f(toVector(force));
    vector arm(toVector(place) - origin_);
    vector m(toVector(moment));
    const label across = empty();
    if (across >= 0)
    {
        const scalar turns = m[across];
        m = Zero;
        m[across] = turns;
        arm[across] = 0;
    }
    force_[which] += f;
    moment_[which] += m + (arm ^ f);
}


void Foam::functionObjects::particleForces::addFluid
(
    const std::vector<riprap::FluidForce>& forces,
    const boolList& wanted
)
{
    for (const riprap::FluidForce& f : forces)
    {
        if (!wanted[f.part]) continue;
        add(pressure, f.place, f.pressure, f.pressureMoment);
        add(viscous, f.place, f.viscous, f.viscousMoment);
    }
}


void Foam::functionObjects::particleForces::addContactsOnWalls()
{
    if (!parts_->ofSolids().found(true)) return;

    const std::vector<riprap::DemWallForce> forces
    (
        parts_->solids()->scene().wallForces()
    );
    const riprap::Vector3 origin{{0, 0, 0}};
    forAll(parts_->ofSolids(), i)
    {
        if (!parts_->ofSolids()[i]) continue;

        const riprap::DemWallForce& f = forces.at(i);
        riprap::Vector3 along, turning;
        for (label d = 0; d < 3; ++d)
        {
            along[d] = f.force[d] - f.normal[d];
            turning[d] = f.moment[d] - f.normalMoment[d];
        }
        add(normal, origin, f.normal, f.normalMoment);
        add(tangential, origin, along, turning);
    }
}


//- By everything that is not of the groups
void Foam::functionObjects::particleForces::addContactsOnGroups()
{
    if (!parts_->groups().found(true)) return;

    riprap::DemScene& scene = parts_->solids()->scene();
    const riprap::DemState& now = parts_->solids()->motion();
    const riprap::DemContacts contacts(scene.contacts());

    const idIndex at(now.id);
    const auto wanted = [&](std::int32_t id)
    {
        return id >= 0 && parts_->groups()[now.group[at(id)]];
    };

    for (std::size_t k = 0; k < contacts.a.size(); ++k)
    {
        const bool first = wanted(contacts.a[k]), second = wanted(contacts.b[k]);
        if (first == second) continue;

        const double* centre = &now.position[3*std::size_t(at(contacts.a[k]))];
        const double* force = &contacts.force[3*k];
        riprap::Vector3 place, across, along;
        vector n;
        for (label d = 0; d < 3; ++d)
        {
            place[d] = contacts.point[3*k + d];
            n[d] = place[d] - centre[d];
        }
        n /= max(mag(n), VSMALL);
        const scalar sign = first ? 1 : -1;
        const scalar size = n.x()*force[0] + n.y()*force[1] + n.z()*force[2];
        for (label d = 0; d < 3; ++d)
        {
            across[d] = sign*size*n[d];
            along[d] = sign*force[d] - across[d];
        }
        add(normal, place, across);
        add(tangential, place, along);
    }
}


void Foam::functionObjects::particleForces::writeSums
(
    const word& table,
    const sums& values,
    const word& title
)
{
    static const char* const names[kinds] =
        {"pressure", "viscous", "normal", "tangential"};

    const auto column = [](const word& name)
    {
        return word
        (
            '(' + name + "_x " + name + "_y " + name + "_z)",
            false
        );
    };

    wordList columns(1, column("total"));
    DynamicList<vector> written;
    vector total = Zero;
    Log << "    Sum of " << table << nl;
    for (label k = 0; k < kinds; ++k)
    {
        const bool there =
            k < normal ? parts_->fluid() != nullptr : parts_->solids() != nullptr;
        if (!there) continue;

        columns.append(column(names[k]));
        written.append(values[k]);
        total += values[k];
        Log << "        " << names[k] << " : " << values[k] << nl;
    }
    Log << "        total : " << total << nl;

    // As OpenFOAM's forces begin their files
    OStringStream centre;
    centre << "CofR";
    for (label i = 4; i < charWidth() - 2; ++i) centre << ' ';
    centre << ": " << origin_;

    OFstream& os = row
    (
        table,
        columns,
        List<string>({title, centre.str(), ""})
    );
    os  << tab << total;
    for (const vector& value : written)
    {
        os  << tab << value;
    }
    os  << endl;
}


Foam::wordList Foam::functionObjects::particleForces::entries() const
{
    wordList all(forceParts::entries());
    all.append(wordList({"CofR", "average", "impulse"}));
    return all;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::particleForces::particleForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    sceneFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::particleForces::read(const dictionary& dict)
{
    sceneFunctionObject::read(dict);
    log = dict_.lookupOrDefault("log", false);
    origin_ = dict_.lookupOrDefault<point>("CofR", Zero);
    parts_.reset(new forceParts(mesh_, dict_, name()));
    mean_.begin(notNegative(dict_, "average", 0), savedSamples(), 2*kinds*vector::nComponents);
    readImpulse(dict_);
    sampledAt_ = -GREAT;
    return true;
}


bool Foam::functionObjects::particleForces::writeSample()
{
    sample();

    Log << type() << ' ' << name() << " write:" << nl;
    writeSums("force", force_, "Force");
    writeSums("moment", moment_, "Moment");
    if (mean_.on())
    {
        sums force, moment;
        fromNumbers(mean_.mean(), force, moment);
        writeSums("forceMean", force, "Mean force");
        writeSums("momentMean", moment, "Mean moment");
    }
    if (wantImpulse_) writeSums("impulse", impulse_, "Impulse");
    Log << endl;
    return true;
}


// ************************************************************************* //

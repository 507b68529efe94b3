/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Bonds and clumps of a time directory: written and read.
\*---------------------------------------------------------------------------*/

#include "solidFiles.H"
#include "solidFileFields.H"
#include "core/ranks/joinRanks.hpp"
#include "pstreamTransport.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Values that the first process has read: others have none
template<class T>
static void takeFromMaster(Field<T>& values)
{
    if (!Pstream::parRun()) return;

    pstreamTransport ranks;
    std::vector<T> all(values.begin(), values.end());
    riprap::join(ranks, all);
    values.setSize(label(all.size()));
    std::copy(all.begin(), all.end(), values.begin());
}


//- Bonds as they stand in the files, of which the first process has those of all
struct bondFields
{
    labelField a, b, type, broken;
    scalarField gap;

    bondFields(const Time& time, const word& folder)
    {
        if (Pstream::master() && hasSolidField(time, folder, "a"))
        {
            read(time, folder);
        }
        for (labelField* values : {&a, &b, &type, &broken}) takeFromMaster(*values);
        takeFromMaster(gap);
    }

private:

    void read(const Time& time, const word& folder)
    {
        a = readSolidField<label>(time, folder, "a", -1);
        b = readSolidField<label>(time, folder, "b", a.size());
        type = readSolidField<label>(time, folder, "type", a.size());
        broken = readSolidField<label>(time, folder, "broken", a.size());
        gap = readSolidField<scalar>(time, folder, "gap", a.size());
    }
};


//- Rigid bodies likewise
struct clumpFields
{
    vectorField position, U, omega, axis, inertia, startPosition, startAxis;
    scalarField real, mass, volume, startReal;
    labelField group, shape;

    clumpFields(const Time& time, const word& folder)
    {
        if (Pstream::master() && hasSolidField(time, folder, "position"))
        {
            read(time, folder);
        }
        for
        (
            vectorField* values :
            {&position, &U, &omega, &axis, &inertia, &startPosition, &startAxis}
        )
        {
            takeFromMaster(*values);
        }
        for (scalarField* values : {&real, &mass, &volume, &startReal}) takeFromMaster(*values);
        for (labelField* values : {&group, &shape}) takeFromMaster(*values);
    }

private:

    void read(const Time& time, const word& folder)
    {
        position = readSolidField<vector>(time, folder, "position", -1);
        const label n = position.size();
        U = readSolidField<vector>(time, folder, "U", n);
        omega = readSolidField<vector>(time, folder, "omega", n);
        real = readSolidField<scalar>(time, folder, "orientationReal", n);
        axis = readSolidField<vector>(time, folder, "orientationImaginary", n);
        mass = readSolidField<scalar>(time, folder, "mass", n);
        inertia = readSolidField<vector>(time, folder, "inertia", n);
        group = readSolidField<label>(time, folder, "group", n);
        shape = labelField(n, -1);
        if (hasSolidField(time, folder, "shape"))
        {
            shape = readSolidField<label>(time, folder, "shape", n);
        }

        // Of files that know neither volumes nor where bodies stood at first
        volume = scalarField(n, Zero);
        startPosition = position;
        startReal = real;
        startAxis = axis;
        if (hasSolidField(time, folder, "startPosition"))
        {
            volume = readSolidField<scalar>(time, folder, "volume", n);
            startPosition = readSolidField<vector>(time, folder, "startPosition", n);
            startReal = readSolidField<scalar>(time, folder, "startOrientationReal", n);
            startAxis = readSolidField<vector>(time, folder, "startOrientationImaginary", n);
        }
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::solidSet::dropBroken()
{
    riprap::DemBonds left;
    for (std::size_t i = 0; i < bonds.size(); ++i)
    {
        if (brokenBond[i]) continue;
        left.a.push_back(bonds.a[i]);
        left.b.push_back(bonds.b[i]);
        left.type.push_back(bonds.type[i]);
        left.gap.push_back(bonds.gap[i]);
    }
    const label dropped = bonds.size() - left.size();
    bonds = left;
    brokenBond.assign(left.size(), false);
    return dropped;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::writeBondFiles(const Time& time, const riprap::DemBondState& bonds)
{
    if (bonds.a.empty()) return;

    const word folder("bonds");
    writeSolidField(time, folder, "a", toField<label>(bonds.a));
    writeSolidField(time, folder, "b", toField<label>(bonds.b));
    writeSolidField(time, folder, "type", toField<label>(bonds.type));
    writeSolidField(time, folder, "broken", toField<label>(bonds.broken));
    writeSolidField(time, folder, "gap", toField<scalar>(bonds.restGap));
}


void Foam::readBondFiles
(
    const Time& time,
    const solidNames& types,
    solidSet& solids
)
{
    const word folder("bonds");
    const bondFields file(time, folder);
    const labelField& a = file.a;
    const labelField& b = file.b;
    const std::string ofTypes(solidFile(time, folder, "type").objectPath());

    labelHashSet ids;
    for (const std::int32_t id : solids.particles.id)
    {
        ids.insert(id);
    }
    forAll(a, i)
    {
        // One whose particle has left
        if (file.broken[i] && (!ids.found(a[i]) || !ids.found(b[i])))
        {
            ++solids.lostBonds;
            continue;
        }
        if (!ids.found(a[i]) || !ids.found(b[i]) || a[i] == b[i])
        {
            FatalErrorInFunction
                << solidFile(time, folder, "a").objectPath() << ": bond " << i
                << " joins the particles " << a[i] << " and " << b[i]
                << ", which are not two of lagrangian/solids"
                << exit(FatalError);
        }
        solids.bonds.a.push_back(a[i]);
        solids.bonds.b.push_back(b[i]);
        solids.bonds.type.push_back(types(file.type[i], ofTypes, i));
        solids.bonds.gap.push_back(file.gap[i]);
        solids.brokenBond.push_back(file.broken[i]);
    }
}


void Foam::writeClumpFiles
(
    const Time& time,
    const std::vector<riprap::DemClump>& clumps
)
{
    if (clumps.empty()) return;

    const label n = clumps.size();
    vectorField position(n), U(n), omega(n), inertia(n), axis(n);
    vectorField startPosition(n), startAxis(n);
    scalarField real(n), mass(n), volume(n), startReal(n);
    labelField group(n), shape(n);
    bool shaped = false;
    forAll(position, i)
    {
        const riprap::DemClump& c = clumps[i];
        const riprap::DemPose start
        (
            c.moved ? c.start : riprap::DemPose{c.position, c.orientation}
        );
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            startPosition[i][d] = start.position[d];
            startAxis[i][d] = start.orientation[d + 1];
            position[i][d] = c.position[d];
            U[i][d] = c.velocity[d];
            omega[i][d] = c.spin[d];
            inertia[i][d] = c.inertia[d];
            axis[i][d] = c.orientation[d + 1];
        }
        real[i] = c.orientation[0];
        startReal[i] = start.orientation[0];
        mass[i] = c.mass;
        volume[i] = c.volume;
        group[i] = c.group;
        shape[i] = c.shape;
        shaped = shaped || c.shape >= 0;
    }

    const word folder("clumps");
    writeSolidField(time, folder, "position", position);
    writeSolidField(time, folder, "U", U);
    writeSolidField(time, folder, "omega", omega);
    writeSolidField(time, folder, "orientationReal", real);
    writeSolidField(time, folder, "orientationImaginary", axis);
    writeSolidField(time, folder, "mass", mass);
    writeSolidField(time, folder, "volume", volume);
    writeSolidField(time, folder, "inertia", inertia);
    writeSolidField(time, folder, "startPosition", startPosition);
    writeSolidField(time, folder, "startOrientationReal", startReal);
    writeSolidField(time, folder, "startOrientationImaginary", startAxis);
    writeSolidField(time, folder, "group", group);
    if (shaped) writeSolidField(time, folder, "shape", shape);
}


//- A quaternion of which a file of text has few digits; one that is none stays what it is
static void normalise(std::array<double, 4>& q)
{
    constexpr double exact = 1e-12, rounded = 1e-2;
    double norm = 0;
    for (const double e : q) norm += e*e;
    if (std::abs(norm - 1) < exact || std::abs(norm - 1) > rounded) return;
    for (double& e : q) e /= std::sqrt(norm);
}


void Foam::readClumpFiles
(
    const Time& time,
    const solidNames& groups,
    solidSet& solids
)
{
    const word folder("clumps");
    const clumpFields file(time, folder);
    const std::string ofGroups(solidFile(time, folder, "group").objectPath());
    const label n = file.position.size();
    solids.clumps.resize(n);
    forAll(file.position, i)
    {
        riprap::DemClump& c = solids.clumps[i];
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            c.position[d] = file.position[i][d];
            c.velocity[d] = file.U[i][d];
            c.spin[d] = file.omega[i][d];
            c.inertia[d] = file.inertia[i][d];
            c.orientation[d + 1] = file.axis[i][d];
            c.start.position[d] = file.startPosition[i][d];
            c.start.orientation[d + 1] = file.startAxis[i][d];
        }
        c.orientation[0] = file.real[i];
        c.start.orientation[0] = file.startReal[i];
        normalise(c.orientation);
        normalise(c.start.orientation);
        c.moved = true;
        c.volume = file.volume[i];
        c.mass = file.mass[i];
        c.group = groups(file.group[i], ofGroups, i);
        c.shape = file.shape[i];
    }
}


// ************************************************************************* //

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
        if (!Pstream::parRun()) return;

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

    //- Others have none
    template<class T>
    static void takeFromMaster(Field<T>& values)
    {
        pstreamTransport ranks;
        std::vector<T> all(values.begin(), values.end());
        riprap::join(ranks, all);
        values.setSize(label(all.size()));
        std::copy(all.begin(), all.end(), values.begin());
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
    const labelList& typeOfFile,
    solidSet& solids
)
{
    const word folder("bonds");
    const bondFields file(time, folder);
    const labelField& a = file.a;
    const labelField& b = file.b;

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
        solids.bonds.type.push_back(typeOfFile[file.type[i]]);
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


void Foam::readClumpFiles
(
    const Time& time,
    const labelList& groupOfFile,
    solidSet& solids
)
{
    const word folder("clumps");
    if (!hasSolidField(time, folder, "position")) return;

    const vectorField position(readSolidField<vector>(time, folder, "position", -1));
    const label n = position.size();
    const vectorField U(readSolidField<vector>(time, folder, "U", n));
    const vectorField omega(readSolidField<vector>(time, folder, "omega", n));
    const scalarField real(readSolidField<scalar>(time, folder, "orientationReal", n));
    const vectorField axis(readSolidField<vector>(time, folder, "orientationImaginary", n));
    const scalarField mass(readSolidField<scalar>(time, folder, "mass", n));
    const vectorField inertia(readSolidField<vector>(time, folder, "inertia", n));
    const labelField group(readSolidField<label>(time, folder, "group", n));
    labelField shape(n, -1);
    if (hasSolidField(time, folder, "shape"))
    {
        shape = readSolidField<label>(time, folder, "shape", n);
    }

    // Of files that know neither volumes nor where bodies stood at first
    const bool known = hasSolidField(time, folder, "startPosition");
    scalarField volume(n, Zero), startReal(real);
    vectorField startPosition(position), startAxis(axis);
    if (known)
    {
        volume = readSolidField<scalar>(time, folder, "volume", n);
        startPosition = readSolidField<vector>(time, folder, "startPosition", n);
        startReal = readSolidField<scalar>(time, folder, "startOrientationReal", n);
        startAxis = readSolidField<vector>(time, folder, "startOrientationImaginary", n);
    }

    solids.clumps.resize(n);
    forAll(position, i)
    {
        riprap::DemClump& c = solids.clumps[i];
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            c.position[d] = position[i][d];
            c.velocity[d] = U[i][d];
            c.spin[d] = omega[i][d];
            c.inertia[d] = inertia[i][d];
            c.orientation[d + 1] = axis[i][d];
            c.start.position[d] = startPosition[i][d];
            c.start.orientation[d + 1] = startAxis[i][d];
        }
        c.orientation[0] = real[i];
        c.start.orientation[0] = startReal[i];
        c.moved = true;
        c.volume = volume[i];
        c.mass = mass[i];
        c.group = groupOfFile[group[i]];
        c.shape = shape[i];
    }
}


// ************************************************************************* //

// SPDX-License-Identifier: GPL-3.0-or-later
/*  The cloud of solids, their bonds and rigid bodies. */

#include "setParticles.H"
#include "dividedCloud.H"
#include "OSspecific.H"
#include "sceneCloud.H"
#include "solidRegions.H"
#include "wallPoints.H"
#include "wholeBoundary.H"

namespace Foam
{

// What rounding to whole bodies, and clipping, have made of the shares
static void reportSizes(const solidRegion& region)
{
    const scalar mass = sum(region.mass);
    for (const scalar radius : region.sizes)
    {
        label n = 0;
        scalar own = 0;
        forAll(region.radius, i)
        {
            if (region.radius[i] != radius) continue;
            ++n;
            own += region.mass[i];
        }
        Info<< "        radius " << radius << " m: " << n << " particles, "
            << 100.0*n/region.size() << " % of the number, " << 100*own/mass
            << " % of the mass" << nl;
    }
}


static void reportRegions(const List<solidRegion>& regions, const demSettings& settings)
{
    const char* metre = settings.config.dimensions == 2 ? " per metre" : "";
    label total = 0;
    scalar all = 0;
    for (const solidRegion& region : regions)
    {
        scalar mass = 0;
        forAll(region.mass, i) if (region.clump[i] < 0) mass += region.mass[i];
        for (const riprap::DemClump& clump : region.clumps) mass += clump.mass;

        Info<< "    " << region.name << ": " << region.size() << " particles, radius "
            << min(region.radius);
        if (max(region.radius) > min(region.radius)) Info<< " to " << max(region.radius);
        Info<< " m, mass " << mass << " kg" << metre;
        if (region.clumps.size()) Info<< ", " << region.clumps.size() << " clumps";
        if (region.clipped) Info<< ", " << region.clipped << " clipped";
        Info<< nl;
        reportSizes(region);
        total += region.size();
        all += mass;
    }
    Info<< "    total: " << total << " particles, mass " << all << " kg" << metre << nl;
}


static void write
(
    const polyMesh& mesh,
    const demSettings& settings,
    const solidSet& solids,
    const riprap::DemBondState& bonds
)
{
    const Time& time = mesh.time();
    // Of an earlier run: what is there would not fit these particles
    rmDir(time.timePath()/"uniform"/"riprap", true);
    rmDir(time.timePath()/"uniform"/"lagrangian"/"solids", true);
    rmDir(time.timePath()/"lagrangian"/"solids", true);

    // Of several processes the first gives them to those that have their cells
    particleCloud cloud("solids");
    if (Pstream::master()) cloud = solidCloudOf(solids.particles);
    if (Pstream::parRun()) sendToCells(mesh, cloud);
    addSolidNames(cloud.properties, settings);
    if (solids.shapes.size()) cloud.properties.add("shapes", solids.shapes);
    if (solids.surfaces.size()) cloud.properties.add("surfaces", solids.surfaces);
    writeParticleCloud(mesh, cloud);
    if (Pstream::master())
    {
        writeBondFiles(time, bonds);
        writeClumpFiles(time, solids.clumps);
    }
    Info<< "Written " << label(solids.particles.size()) << " particles, " << label(bonds.a.size())
        << " bonds and " << label(solids.clumps.size()) << " clumps to " << time.timeName()
        << "/lagrangian/solids" << nl << endl;
}

} // namespace Foam


Foam::placedSolids Foam::placeSolids(const polyMesh& mesh, const dictionary& dict)
{
    checkedDictionary entries(dict);
    for (const char* other : {"overlapTolerance", "regions", "bonds"}) entries.found(other);
    const wordList ofFluid({"spacing", "packing"});
    if (hasSet(dict, "fluid"))
    {
        for (const word& other : ofFluid) entries.found(other);
    }
    entries.endButMacros(ofFluid);

    placedSolids placed;
    placed.settings = std::make_unique<const demSettings>(readDemSettings(wholeBoundary(mesh)));
    const auto bodies(wallGeometry(mesh.time()));
    Info<< nl << "Solids" << nl;
    placed.regions = readSolidRegions(dict, {mesh, *placed.settings, bodies.get()});
    reportRegions(placed.regions, *placed.settings);
    return placed;
}


void Foam::setSolids(const polyMesh& mesh, const dictionary& dict, const setOptions& options,
    const placedSolids& placed)
{
    const demSettings& settings = *placed.settings;
    const scalar tolerance = checkedDictionary(dict).notNegative("overlapTolerance", 1e-4);
    const solidSet solids(joined(placed.regions));
    const riprap::DemBondState bonds(bondSolids(dict, solids, settings));
    Info<< endl;
    checkSolidOverlap(placed.regions, solids, bonds, settings.config, tolerance);

    if (!options.dryRun) write(mesh, settings, solids, bonds);
}

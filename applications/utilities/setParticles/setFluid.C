// SPDX-License-Identifier: GPL-3.0-or-later
/*  The fluid's cloud, and the wall points that it will have. */

#include "setParticles.H"
#include "allRanks.H"
#include "checkWalls.H"
#include "dividedRegion.H"
#include "numberRanks.H"
#include "OSspecific.H"
#include "particleCloudIO.H"
#include "particleRegions.H"
#include "picGrid.H"
#include "picObstacles.H"
#include "sceneState.H"
#include "sphDictionaries.H"
#include "wholeBoundary.H"

namespace Foam
{

static wallPoints makeWalls
(
    const polyMesh& mesh,
    const sphSettings& settings,
    const labelList& patches,
    const geometryWalls* bodies
)
{
    wallPointsControls controls;
    controls.spacing = settings.config.wallSpacing;
    controls.layers = wallLayers(settings);
    controls.where = settings.walls.dict;
    return generateWallPoints(mesh, patches, bodies, controls);
}


// Particles that the guard of the first step would stop at
static void checkDensity(const particleRegion& region, const riprap::SphConfig& config)
{
    const scalar lowest = lowestPressure(config);

    label bad = -1;
    forAll(region.pressure, i)
    {
        const scalar rho = densityOfPressure(config, region.pressure[i]);
        if (region.pressure[i] > lowest
            && mag(rho/config.density - 1) <= config.maxDensityDeviation)
            continue;
        bad = i;
        break;
    }
    struct { scalar p; point x; } at{0, Zero};
    if (bad >= 0) at = {region.pressure[bad], region.position[bad]};
    const bool any = Pstream::parRun()
        ? ofLeast(bad < 0 ? noNumber : region.number[bad], bad >= 0, at) : bad >= 0;
    if (any)
    {
        FatalIOErrorInFunction(region.dict) << "Entry pressure: " << at.p << " Pa at "
                                            << at.x << " is beyond what the equation"
                                            << " of state and guards/densityDeviation of "
                                               "constant/sphProperties allow: the density would be "
                                            << densityOfPressure(config, at.p)
                                            << " kg/m3 at a sound speed of "
                                            << config.soundSpeed << " m/s" << exit(FatalIOError);
    }
}


// One after the other, numbered from 0; of several processes as one would number them
static particleCloud allRegions(const List<particleRegion>& regions, scalar spacing)
{
    particleCloud c("fluid");
    vectorField U;
    scalarField p;
    labelField id;
    int64_t before = 0;
    for (const particleRegion& region : regions)
    {
        c.position.append(region.position);
        U.append(region.velocity);
        p.append(region.pressure);
        if (!Pstream::parRun()) continue;
        c.cell.append(region.cell);
        id.append(idsOfRanks(region, before));
        if (before <= labelMax) continue;
        FatalIOErrorInFunction(region.dict)
            << "The regions up to " << region.name << " hold " << before << " particles, and ids "
            << "have 32 bits, for " << labelMax << exit(FatalIOError);
    }

    c.vectors.set("U", U);
    c.scalars.set("p", p);
    c.labels.set("id", Pstream::parRun() ? id : labelField(identity(c.size())));
    c.properties.add("spacing", exact(spacing));
    return c;
}


// Densities by the equation of state
static particleCloud makeCloud
(
    const polyMesh& mesh,
    const List<particleRegion>& regions,
    const vector& gravity,
    sphSettings& settings
)
{
    particleCloud c(allRegions(regions, settings.config.spacing));
    const scalarField& p = c.scalars["p"];

    // Solids and walls may make it higher when the run begins: pressures stay
    setMaxVelocity(settings, wholeBoundary(mesh), c.position, c.vectors["U"], otherSpeeds());
    const riprap::SphConfig& config = settings.config;
    for (const particleRegion& region : regions) checkDensity(region, config);

    scalarField rho(c.size());
    forAll(rho, i) rho[i] = densityOfPressure(config, p[i]);

    c.scalars.set("rho", rho);
    c.properties.add("soundSpeed", exact(config.soundSpeed));
    c.properties.add("density", exact(config.density));
    c.properties.add("gravity", exact(scalarList({gravity.x(), gravity.y(), gravity.z()})));
    c.scalars.set("h", scalarField(c.size(), config.smoothingRatio*config.spacing));
    return c;
}


static void reportRegions(
    const List<particleRegion>& regions, const particlePacking& packing, scalar density)
{
    const char* metre = packing.planar() ? " per metre" : "";
    int64_t total = 0;
    Info<< nl << "Fluid: spacing " << packing.spacing() << " m" << nl;
    for (const particleRegion& region : regions)
    {
        const int64_t size = sumOfRanks(region.size()), clipped = sumOfRanks(region.clipped);
        const scalar volume = size*packing.volume();
        Info<< "    " << region.name << ": " << size << " particles, volume " << volume
            << " m3" << metre << ", mass " << density*volume << " kg" << metre;
        if (clipped) Info<< ", " << clipped << " clipped";
        Info<< nl;
        total += size;
    }
    Info<< "    total: " << total << " particles, volume " << total*packing.volume() << " m3"
        << metre << ", mass " << density*total*packing.volume() << " kg" << metre << nl
        << endl;
}


static void reportShepard(const shepardRange& range)
{
    Info<< "Walls and fluid: Shepard sum over that of a lattice (" << range.lattice << ") at "
        << range.checked << " particles near walls (" << range.leftOut
        << " more at free surfaces or open patches)" << nl;
    if (range.checked)
    {
        Info<< "    least " << range.least << " at " << range.leastAt << nl
            << "    most " << range.most << " at " << range.mostAt << nl
            << "    rms difference from 1: " << Foam::sqrt(range.meanSquare) << nl;
    }
    Info<< endl;
}


static void write(
    const Time& time, const polyMesh& mesh, const particleCloud& cloud, const wallPoints& walls)
{
    // Of an earlier run: the state there would not fit these particles
    rmDir(time.timePath()/"uniform"/"riprap", true);
    rmDir(time.timePath()/"lagrangian"/cloud.name, true);
    writeParticleCloud(mesh, cloud);
    Info<< "Written " << sumOfRanks(cloud.size()) << " particles to " << time.timeName()
        << "/lagrangian/" << cloud.name;
    if (walls.size())
    {
        if (Pstream::master())
            writeWallPoints(walls, time.globalPath()/"VTK"/"walls.vtp");
        Info<< ", " << walls.size() << " wall points to VTK/walls.vtp";
    }
    Info<< nl << endl;
}


// Solids as water finds them
static List<fluidObstacle> obstacles(const placedSolids& placed)
{
    List<fluidObstacle> all(placed.regions.size());
    forAll(all, i)
    {
        const solidRegion& region = placed.regions[i];
        all[i] = fluidObstacle{region.name, region.exact, region.position, region.radius,
            scalarField(region.mass/sum(region.mass))};
    }
    return all;
}


// Water has no particle in a gap narrower than its spacing, and no pressure there
static void warnOfStanding(const placedSolids& placed, scalar spacing)
{
    for (const solidRegion& region : placed.regions)
    {
        if (region.clumps.empty() || region.wallGap >= (1 - 1e-6)*spacing) continue;
        IOWarningInFunction(region.dict)
            << "Region " << region.name << " stands " << max(region.wallGap, scalar(0))
            << " m off a wall, less than the water's spacing of " << spacing
            << " m: there is no water in between, and none presses there. A body that shall be "
               "lifted needs a gap of a spacing"
            << nl << endl;
    }
}


// With picDem: no wall points, no equation of state
static void setFluidOfGrid(const polyMesh& mesh, const dictionary& dict, const setOptions& options,
    const picSettings& settings)
{
    const riprap::PicConfig& config = settings.config;
    const vector gravity(config.gravity[0], config.gravity[1], config.gravity[2]);
    const particlePacking packing(readPacking(dict, mesh, gravity));
    const auto bodies(wallGeometry(mesh.time()));
    if (bodies.valid())
        requireObstacles(wholeBoundary(mesh), *bodies, settings.motion, packing.spacing());
    const wallPoints noWalls;
    const List<particleRegion> regions
    (
        readRegions(dict, packing, {mesh, bodies.get(), noWalls, gravity, config.density, {}})
    );
    reportRegions(regions, packing, config.density);
    if (options.checkWalls)
    {
        FatalErrorInFunction
            << "-checkWalls: with solver picDem there are no wall points, of which it would tell"
            << exit(FatalError);
    }
    if (!options.dryRun) write(mesh.time(), mesh, allRegions(regions, packing.spacing()), noWalls);
}


// What a cloud is for: the solver's; with any other than those of water, of whichever there are
// properties
static bool ofGrid(const Time& time, const word& solver, bool fluid)
{
    const fileName constant(time.globalPath()/time.constant());
    const bool properties = isFile(constant/"picProperties");
    // Solids alone need none of the water's files
    if (!fluid) return solver == "picDem" && properties;
    if (solver == "picDem" || solver == "sphDem") return solver == "picDem";
    return !isFile(constant/"sphProperties") && properties;
}

} // namespace Foam


std::unique_ptr<const Foam::picSettings> Foam::gridSettings(
    const polyMesh& mesh, const dictionary& dict, const setOptions& options)
{
    if (!ofGrid(mesh.time(), options.solver, hasSet(dict, "fluid") || !hasSet(dict, "solids")))
        return nullptr;
    auto settings = std::make_unique<const picSettings>(readPicSettings(wholeBoundary(mesh)));
    // the grid is made for its checks alone: NOLINTNEXTLINE(bugprone-unused-raii)
    picGrid(mesh, settings->config);
    return settings;
}


void Foam::setFluid
(
    const polyMesh& mesh,
    const dictionary& dict,
    const setOptions& options,
    const picSettings* grid,
    const placedSolids& placed
)
{
    if (grid)
    {
        setFluidOfGrid(mesh, dict, options, *grid);
        return;
    }

    sphSettings settings(readSphSettings(wholeBoundary(mesh)));
    riprap::SphConfig& config = settings.config;
    const vector gravity(config.gravity[0], config.gravity[1], config.gravity[2]);

    const particlePacking packing(readPacking(dict, mesh, gravity));
    setSpacing(settings, packing.spacing());

    const labelList patches
    (
        settings.walls.everyWallPatch
      ? wallPatches(wholeBoundary(mesh))
      : wallPatches(wholeBoundary(mesh), settings.walls.patches, settings.walls.dict)
    );
    const auto bodies(wallGeometry(mesh.time()));
    const wallPoints walls(makeWalls(mesh, settings, patches, bodies.get()));

    const List<particleRegion> regions(readRegions(
        dict, packing, {mesh, bodies.get(), walls, gravity, config.density, obstacles(placed)}));
    const particleCloud cloud(makeCloud(mesh, regions, gravity, settings));
    warnOfStanding(placed, packing.spacing());
    for (const solidRegion& region : placed.regions) requireCovered(region, mesh.time(), config);

    reportRegions(regions, packing, config.density);
    reportWallPoints(walls, Info());
    Info<< nl << "Sound speed " << config.soundSpeed << " m/s, highest pressure "
        << gMax(cloud.scalars["p"]) << " Pa, density up to " << gMax(cloud.scalars["rho"])
        << " kg/m3"
        << nl << endl;

    if (options.checkWalls)
    {
        reportShepard
        (
            checkWalls(mesh, bodies.get(), patches, walls, cloud.position, config)
        );
    }
    if (!options.dryRun) write(mesh.time(), mesh, cloud, walls);
}

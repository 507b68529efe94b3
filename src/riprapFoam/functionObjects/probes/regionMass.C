/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMass.H"
#include "addToRunTimeSelectionTable.H"
#include "particleRegions.H"
#include "runningScenes.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(regionMass, 0);
    addToRunTimeSelectionTable(functionObject, regionMass, dictionary);
}
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::functionObjects::regionMass::contents::add(
    const point& p, const scalar m, const scalar v)
{
    place.append(p);
    mass.append(m);
    volume.append(v);
}


Foam::functionObjects::regionMass::contents
Foam::functionObjects::regionMass::ofFluid() const
{
    const fluidSceneObject& scene = *runningFluid(mesh_);
    const riprap::FluidConfig& config = scene.fluidConfig();
    const std::vector<double> x(scene.fluidScene().fluid().position);
    const label n = x.size()/3;
    const scalar volume = std::pow(scene.particleSpacing(), config.dimensions);

    contents all;
    for (label i = 0; i < n; ++i)
    {
        all.add(point(x[3*i], x[3*i + 1], x[3*i + 2]), config.density*volume, volume);
    }
    return all;
}


//- Rigid bodies by their own mass, volume and centre; particles of no body by the density of their
//  material
Foam::functionObjects::regionMass::contents
Foam::functionObjects::regionMass::ofSolids() const
{
    const demSceneObject& scene = *runningSolids(mesh_);
    const demSettings& settings = scene.settings();
    const riprap::DemState& now = scene.motion();
    const std::vector<riprap::DemClump>& clumps = scene.input().clumps;

    contents all;
    labelList materialOf(clumps.size(), 0);
    for (std::size_t i = 0; i < now.id.size(); ++i)
    {
        if (now.clump.size() && now.clump[i] >= 0)
        {
            materialOf[now.clump[i]] = now.material[i];
            continue;
        }
        const double* x = &now.position[3*i];
        all.add(point(x[0], x[1], x[2]), now.mass[i],
            now.mass[i]/settings.materials[now.material[i]].density);
    }
    if (clumps.empty()) return all;

    const riprap::DemClumpState bodies(scene.scene().clumps());
    for (std::size_t k = 0; k < clumps.size(); ++k)
    {
        if (bodies.left[k]) continue;
        const double* x = &bodies.position[3*k];
        const scalar known = clumps[k].volume;
        const scalar volume = known > 0
            ? known
            : clumps[k].mass/settings.materials[materialOf[k]].density;
        all.add(point(x[0], x[1], x[2]), clumps[k].mass, volume);
    }
    return all;
}


Foam::vector Foam::functionObjects::regionMass::sum
(
    const contents& all,
    const volumeSource& region
) const
{
    const boundBox bounds(region.bounds());
    DynamicList<label> near;
    DynamicList<point> places;
    forAll(all.place, i)
    {
        const point p(frame_->inPlane(all.place[i]));
        if (!bounds.contains(p)) continue;
        near.append(i);
        places.append(p);
    }

    vector total(Zero);
    const boolList in(region.inside(pointField(places)));
    forAll(near, i)
    {
        if (in[i]) total += vector(1, all.mass[near[i]], all.volume[near[i]]);
    }
    return total;
}


void Foam::functionObjects::regionMass::readRegions(const dictionary& dict)
{
    const List<namedDictionary> entries(namedDictionaries(dict, "regions"));
    if (entries.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry regions of function object " << name()
            << " is empty: it is a list of dictionaries with names" << exit(FatalIOError);
    }

    names_.clear();
    volumes_.clear();
    regions_.clear();
    for (const namedDictionary& region : entries)
    {
        checkedDictionary entriesOfIt(region.dict);
        autoPtr<particleSource> source(particleSource::New(entriesOfIt, time_));
        entriesOfIt.end();

        const auto* volume = dynamic_cast<const volumeSource*>(&source());
        const point middle(frame_->inPlane(mesh_.bounds().centre()));
        const char* fault = nullptr;
        if (!volume)
        {
            fault = "its source is no volume: box, cylinder, sphere and surface are";
        }
        else if (frame_->planar())
        {
            const Foam::direction across = frame_->axis(2);
            const boundBox bounds(volume->bounds());
            if (bounds.min()[across] > middle[across] || bounds.max()[across] < middle[across])
            {
                fault = "the mid-plane of the 2D mesh does not cut it";
            }
        }
        if (fault)
        {
            FatalIOErrorInFunction(region.dict)
                << "Entry regions of function object " << name() << ", region " << region.name
                << ": " << fault << exit(FatalIOError);
        }

        names_.append(region.name);
        volumes_.append(volume->shape(*frame_).volume);
        regions_.append(dynamic_cast<volumeSource*>(source.ptr()));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::regionMass::regionMass
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

bool Foam::functionObjects::regionMass::read(const dictionary& dict)
{
    sceneFunctionObject::read(dict);
    if (!runningFluid(mesh_) && !runningSolids(mesh_))
    {
        FatalIOErrorInFunction(dict_) << "Function object " << name() << " of type " << type()
                                      << " needs a running scene of fluid or solids. riprapFoam "
                                         "has one, as has its option -postProcess;"
                                      << " the utility postProcess has none." << exit(FatalIOError);
    }

    // Shapes do not depend on the spacing
    frame_.reset(new particlePacking(mesh_, particlePacking::kind::square, 1, Zero));
    readRegions(dict_);
    return true;
}


bool Foam::functionObjects::regionMass::writeSample()
{
    const bool wet = runningFluid(mesh_), withSolids = runningSolids(mesh_);
    const contents water(wet ? ofFluid() : contents()),
        bodies(withSolids ? ofSolids() : contents());

    wordList columns;
    DynamicList<scalar> values;
    forAll(regions_, i)
    {
        const word& region = names_[i];
        if (wet)
        {
            const vector in(sum(water, regions_[i]));
            columns.append(wordList({region + "FluidMass", region + "FluidFraction"}));
            values.append(scalarList({in.y(), in.z()/volumes_[i]}));
        }
        if (withSolids)
        {
            const vector in(sum(bodies, regions_[i]));
            columns.append(
                wordList({region + "Solids", region + "SolidMass", region + "SolidFraction"}));
            values.append(scalarList({in.x(), in.y(), in.z()/volumes_[i]}));
        }
    }

    OFstream& os = row(typeName, columns);
    for (const scalar value : values) add(os, value);
    os  << endl;
    return true;
}


// ************************************************************************* //

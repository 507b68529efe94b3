/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The cloud of solids of a time directory, as a scene is given it.
\*---------------------------------------------------------------------------*/

#include "solidFileFields.H"
#include "dividedCloud.H"
#include "HashSet.H"
#include "listed.H"
#include "mathematicalConstants.H"
#include "toStdVector.H"
#include "sceneState.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What the numbers in the files mean, as indices of the settings
template<class IndexOf>
static labelList meaning
(
    const dictionary& properties,
    const word& entry,
    const IndexOf& indexOf
)
{
    labelList index;
    if (properties.found(entry))
    {
        const wordList names(properties.get<wordList>(entry));
        index.resize(names.size());
        forAll(names, i)
        {
            index[i] = indexOf(names[i], properties);
        }
    }
    return index;
}


//- Masses of the cloud are those of materials' rho of then: FatalIOError if
//  it has changed, since no one knows which masses follow it
static void requireDensities
(
    const Time& time,
    const dictionary& properties,
    const demSettings& settings,
    const labelList& meaningOf,
    const std::vector<std::int32_t>& material
)
{
    const scalarList then(exactList(properties, "densities"));
    labelHashSet used;
    for (const std::int32_t m : material) used.insert(m);

    forAll(then, i)
    {
        const label m = i < meaningOf.size() ? meaningOf[i] : -1;
        if (!used.found(m)) continue;

        const scalar now = settings.materials[m].density;
        if (mag(now - then[i]) <= 1e-9*then[i]) continue;

        FatalIOErrorInFunction(settings.dict.subDict("materials"))
            << "Material " << settings.materials[m].elastic.name.c_str()
            << ": rho is " << now << ", and the masses of lagrangian/solids"
            << " at time " << time.timeName() << " were made with " << then[i]
            << " (" << properties.name() << "). Run setParticles to make them"
            << " anew, or take rho back" << exit(FatalIOError);
    }
}


label solidNames::operator()
(
    const label value,
    const std::string& file,
    const label entry
) const
{
    const bool named = meaningOf.size();
    if (value < 0 || value >= (named ? meaningOf.size() : valid.size()))
    {
        FatalErrorInFunction
            << file.c_str() << " has the value " << value << " at entry " << entry
            << ": it counts from 0 in " << listed(valid).c_str() << exit(FatalError);
    }
    return named ? meaningOf[value] : value;
}


//- Field of indices, 0 where the cloud has none
static std::vector<std::int32_t> indices
(
    const particleCloud& cloud,
    const word& field,
    const solidNames& names
)
{
    std::vector<std::int32_t> index(cloud.size(), 0);
    if (!cloud.labels.found(field)) return index;

    const labelField& values = cloud.labels[field];
    const std::string file("lagrangian/solids/" + field);
    forAll(values, i) index[i] = names(values[i], file, i);
    return index;
}


//- rho times the volume of a sphere, or of a disk per metre
static std::vector<double> masses
(
    const demSettings& settings,
    const riprap::DemParticles& particles
)
{
    using constant::mathematical::pi;

    std::vector<double> mass(particles.size());
    for (std::size_t i = 0; i < mass.size(); ++i)
    {
        const scalar R = particles.radius[i];
        const scalar volume =
            settings.config.dimensions == 2 ? pi*R*R : 4*pi/3*R*R*R;
        mass[i] = settings.materials[particles.material[i]].density*volume;
    }
    return mass;
}


//- Places, sizes and velocities
static void setMotion
(
    const polyMesh& mesh,
    const particleCloud& cloud,
    riprap::DemParticles& p
)
{
    const word& name = cloud.name;
    p.position = toStdVector(name, "positions", cloud.position);
    p.velocity = toStdVector(name, "U", requiredVectors(mesh, cloud, "U"));
    p.spin.assign(3*cloud.size(), 0);
    if (cloud.vectors.found("omega"))
    {
        p.spin = toStdVector(name, "omega", cloud.vectors["omega"]);
    }
    p.radius = toStdVectorPositive(name, "radius", requiredScalars(mesh, cloud, "radius"));
}


//- As the cloud has them, else the masses of their materials
static void setInertia
(
    const particleCloud& cloud,
    const demSettings& settings,
    riprap::DemParticles& p
)
{
    const word& name = cloud.name;
    p.mass =
        cloud.scalars.found("mass")
      ? toStdVectorPositive(name, "mass", cloud.scalars["mass"])
      : masses(settings, p);
    if (cloud.scalars.found("inertia"))
    {
        p.inertia = toStdVectorPositive(name, "inertia", cloud.scalars["inertia"]);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::solidSet Foam::readSolids
(
    const polyMesh& mesh,
    const demSettings& settings
)
{
    const word name("solids");
    particleCloud cloud(readWholeCloud(mesh, name));
    if (!cloud.labels.found("origId"))
    {
        cloud.labels.set("origId", labelField(identity(cloud.size())));
    }

    // That of a scene's input, by which a saved state knows its particles
    sortByLabel(cloud, "origId");

    const dictionary properties(readCloudProperties(mesh.time(), name));
    auto materialOf = [&](const word& w, const dictionary& d) { return settings.material(w, d); };
    auto groupOf = [&](const word& w, const dictionary& d) { return settings.group(w, d); };
    auto typeOf = [&](const word& w, const dictionary& d) { return settings.bondType(w, d); };
    const labelList groups(meaning(properties, "groups", groupOf));
    const labelList materials(meaning(properties, "materials", materialOf));

    solidSet solids;
    riprap::DemParticles& p = solids.particles;
    setMotion(mesh, cloud, p);
    p.material = indices(cloud, "material", {materials, settings.materialNames()});
    if (cloud.scalars.found("mass"))
    {
        requireDensities
        (
            mesh.time(), properties, settings, materials, p.material
        );
    }
    const solidNames ofGroups{groups, settings.groupNames()};
    p.group = indices(cloud, "group", ofGroups);
    p.id = uniqueIds(name, "origId", cloud.labels["origId"]);
    setInertia(cloud, settings, p);

    readBondFiles
    (
        mesh.time(),
        {meaning(properties, "bondTypes", typeOf), settings.bondNames()},
        solids
    );
    readClumpFiles(mesh.time(), ofGroups, solids);
    if (solids.clumps.size() && cloud.labels.found("clump"))
    {
        const labelField& clump = cloud.labels["clump"];
        p.clump.assign(clump.begin(), clump.end());
    }
    return solids;
}


Foam::particleCloud Foam::solidCloudOf(const riprap::DemParticles& p)
{
    particleCloud cloud("solids");
    cloud.position = toVectors(p.position);
    cloud.vectors.set("U", toVectors(p.velocity));
    cloud.vectors.set("omega", toVectors(p.spin));
    cloud.scalars.set("radius", toField<scalar>(p.radius));
    cloud.scalars.set("mass", toField<scalar>(p.mass));
    if (p.inertia.size())
    {
        cloud.scalars.set("inertia", toField<scalar>(p.inertia));
    }
    cloud.labels.set("material", toField<label>(p.material));
    cloud.labels.set("group", toField<label>(p.group));
    cloud.labels.set("origId", toField<label>(p.id));
    if (p.clump.size())
    {
        cloud.labels.set("clump", toField<label>(p.clump));
    }
    return cloud;
}


void Foam::addSolidNames(dictionary& properties, const demSettings& settings)
{
    scalarList densities(settings.materials.size());
    forAll(densities, i)
    {
        densities[i] = settings.materials[i].density;
    }
    properties.add("materials", settings.materialNames(), true);
    properties.add("densities", exact(densities), true);
    properties.add("groups", settings.groupNames(), true);
    properties.add("bondTypes", settings.bondNames(), true);
}


// ************************************************************************* //

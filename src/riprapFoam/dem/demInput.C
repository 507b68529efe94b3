/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demInput.H"
#include "listed.H"
#include "tensor.H"
#include "Map.H"
#include "dem/bond/calibration.hpp"
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static labelHashSet materialsOf(const std::vector<std::int32_t>& material)
{
    labelHashSet used;
    for (const std::int32_t m : material)
    {
        used.insert(m);
    }
    return used;
}


//- Each pair that can meet must be there
static void requirePairs
(
    const demSettings& settings,
    const labelHashSet& solids,
    const std::vector<riprap::DemWall>& walls
)
{
    labelHashSet others(solids);
    for (const riprap::DemWall& wall : walls)
    {
        others.insert(wall.material);
    }

    const wordList names(settings.materialNames());
    wordHashSet missing;
    for (const label a : solids)
    {
        for (const label b : others)
        {
            bool known = false;
            for (const riprap::DemPair& pair : settings.pairs)
            {
                known = known
                 || (pair.a == a && pair.b == b)
                 || (pair.a == b && pair.b == a);
            }
            if (!known)
            {
                missing.insert(names[min(a, b)] + '-' + names[max(a, b)]);
            }
        }
    }

    if (missing.size())
    {
        FatalIOErrorInFunction(settings.dict)
            << "Entry pairs: missing are "
            << listed(missing.sortedToc()).c_str() << ", which can meet;"
            << " an entry default serves all that have none"
            << exit(FatalIOError);
    }
}


//- Contacts that begin farther away than this are a wrong unit
static void requireNarrowGaps
(
    const demSettings& settings,
    const std::vector<double>& radius
)
{
    scalar largest = 0;
    for (const scalar r : radius)
    {
        largest = max(largest, 2*r);
    }
    const wordList names(settings.materialNames());
    for (const riprap::DemPair& pair : settings.pairs)
    {
        const scalar gap = pair.properties.gap;
        if (largest > 0 && gap > 100*largest)
        {
            FatalIOErrorInFunction(settings.dict)
                << "Entry pairs: gap of " << names[pair.a] << '-'
                << names[pair.b] << " is " << gap << " m, more than 100 times"
                << " the largest particle, " << largest << " m across"
                << exit(FatalIOError);
        }
    }
}


static std::vector<riprap::DemGroup> groupsOf
(
    const demSettings& settings,
    const riprap::DemParticles& particles,
    const std::vector<riprap::DemClump>& clumps
)
{
    // A rigid body gets its group's force once, whatever it is made of
    labelList members(settings.groups.size(), Zero);
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        const bool member = particles.clump.size() && particles.clump[i] >= 0;
        if (!member) ++members[particles.group[i]];
    }
    for (const riprap::DemClump& clump : clumps)
    {
        ++members[clump.group];
    }

    std::vector<riprap::DemGroup> groups;
    forAll(settings.groups, i)
    {
        riprap::DemGroup group(settings.groups[i].group);
        for (direction d = 0; members[i] && d < vector::nComponents; ++d)
        {
            group.force[d] += settings.groups[i].sharedForce[d]/members[i];
        }
        groups.push_back(group);
    }
    return groups;
}


//- A bond type for each calibrated kind and sum of radii
static void setBonds
(
    const demSettings& settings,
    riprap::DemInput& input,
    labelList& typeOfBondType
)
{
    const riprap::DemParticles& particles = input.particles;
    riprap::DemBonds& bonds = input.bonds;

    Map<scalar> radiusOfId(2*label(particles.size()));
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        radiusOfId.insert(particles.id[i], particles.radius[i]);
    }

    // As float: sums that differ by round-off are one. In the order of their
    // keys, so that a continued run numbers them alike
    std::map<std::pair<label, float>, std::pair<int, scalar>> typeOf;
    auto sumOf = [&](std::size_t i) -> scalar
    {
        const bool byRadii =
            riprap::calibrationOf(settings.bondTypes[bonds.type[i]].calibration).byRadii;
        return byRadii ? radiusOfId[bonds.a[i]] + radiusOfId[bonds.b[i]] : 1;
    };
    auto keyOf = [&](std::size_t i)
    {
        return std::make_pair(label(bonds.type[i]), float(sumOf(i)));
    };
    for (std::size_t i = 0; i < bonds.size(); ++i)
    {
        typeOf.insert({keyOf(i), {0, sumOf(i)}});
    }

    DynamicList<label> kinds;
    for (auto& entry : typeOf)
    {
        const label kind = entry.first.first;
        const scalar sum = entry.second.second;
        riprap::DemBondType type(settings.bondTypes[kind].type);
        type.normalStiffness /= sum;
        type.shearStiffness /= sum;
        entry.second.first = input.bondTypes.size();
        input.bondTypes.push_back(type);
        kinds.append(kind);
    }
    for (std::size_t i = 0; i < bonds.size(); ++i)
    {
        bonds.type[i] = typeOf[keyOf(i)].first;
    }

    if (input.bondTypes.size() > 100000)
    {
        FatalIOErrorInFunction(settings.dict)
            << "Entry bonds: the particles' radii make "
            << label(input.bondTypes.size()) << " different stiffnesses; calibration "
            << riprap::DirectCalibration::word << " has one" << exit(FatalIOError);
    }
    typeOfBondType = kinds;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

riprap::DemInput Foam::demInput
(
    const demSettings& settings,
    const solidSet& solids,
    const std::vector<riprap::DemWall>& walls,
    labelList& typeOfBondType
)
{
    riprap::DemInput input;

    for (const demMaterial& material : settings.materials)
    {
        input.materials.push_back(material.elastic);
    }
    input.pairs.assign(settings.pairs.begin(), settings.pairs.end());
    for (riprap::DemPair& pair : input.pairs)
    {
        const riprap::DemMaterial& a = input.materials[pair.a];
        const riprap::DemMaterial& b = input.materials[pair.b];
        pair.properties.youngA = a.young;
        pair.properties.youngB = b.young;
        pair.properties.poissonA = a.poisson;
        pair.properties.poissonB = b.poisson;
    }

    input.particles = solids.particles;
    input.clumps = solids.clumps;
    input.bonds = solids.bonds;
    input.walls = walls;
    input.groups = groupsOf(settings, input.particles, input.clumps);

    requirePairs(settings, materialsOf(input.particles.material), walls);
    requireNarrowGaps(settings, input.particles.radius);
    setBonds(settings, input, typeOfBondType);

    return input;
}


void Foam::requireBeforePlanes
(
    const demSettings& settings,
    const riprap::DemInput& input
)
{
    const riprap::DemParticles& particles = input.particles;
    for (const riprap::DemWall& wall : input.walls)
    {
        if (!wall.plane || wall.motion >= 0)
        {
            continue;
        }
        for (std::size_t i = 0; i < particles.size(); ++i)
        {
            scalar before = 0;
            for (int d = 0; d < vector::nComponents; ++d)
            {
                before += wall.normal[d]*(particles.position[3*i + d] - wall.point[d]);
            }
            if (before > -particles.radius[i])
            {
                continue;
            }
            FatalIOErrorInFunction(settings.dict)
                << "Entry planes of walls: of " << wall.name.c_str()
                << ", particle " << label(particles.id.empty() ? i : particles.id[i])
                << " is " << -before << " m behind the entry point, and its radius is "
                << particles.radius[i] << " m: the plane's normal must point to"
                << " the particles" << exit(FatalIOError);
        }
    }
}


riprap::RigidMotion Foam::rigidMotion
(
    const wallBodies& bodies,
    label body,
    scalar t,
    scalar begin,
    scalar end
)
{
    // Short against any motion, long against the round-off of t
    const scalar h = 1e-6;
    const scalar middle = max(min(t, end > begin + 2*h ? end - h : t), begin + h);
    const riprap::WallPose before(bodies.pose(body, middle - h));
    const riprap::WallPose now(bodies.pose(body, middle));
    const riprap::WallPose after(bodies.pose(body, middle + h));

    tensor rate;
    tensor R;
    riprap::RigidMotion motion;
    for (direction i = 0; i < 9; ++i)
    {
        rate[i] = (after.rotation[i] - before.rotation[i])/(2*h);
        R[i] = now.rotation[i];
    }
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        // x = R X + s: the image of the origin moves with ds/dt
        motion.centre[d] = now.translation[d];
        motion.velocity[d] =
            (after.translation[d] - before.translation[d])/(2*h);
    }

    const tensor W(rate & R.T());
    motion.spin =
    {{
        0.5*(W.zy() - W.yz()),
        0.5*(W.xz() - W.zx()),
        0.5*(W.yx() - W.xy())
    }};
    return motion;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    How fast solids may become, for the fluid's maxVelocity auto.
\*---------------------------------------------------------------------------*/

#include "coupledSolids.H"
#include "boundBox.H"
#include "Map.H"
#include "sweptDomain.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What is held together, by rigid bodies and bonds: the lowest index of each
static labelList bodyOfParticle(const riprap::DemInput& input)
{
    const riprap::DemParticles& p = input.particles;
    labelList parent(identity(label(p.size())));

    const auto first = [&](label i)
    {
        while (parent[i] != i)
        {
            i = parent[i] = parent[parent[i]];
        }
        return i;
    };
    const auto join = [&](label a, label b)
    {
        a = first(a);
        b = first(b);
        parent[max(a, b)] = min(a, b);
    };

    labelList firstOfClump(label(input.clumps.size()), -1);
    for (label i = 0; i < label(p.clump.size()); ++i)
    {
        if (p.clump[i] < 0) continue;
        label& member = firstOfClump[p.clump[i]];
        if (member < 0) member = i; else join(member, i);
    }

    Map<label> indexOfId(2*p.size());
    for (label i = 0; i < label(p.size()); ++i)
    {
        indexOfId.set(p.id.empty() ? i : p.id[i], i);
    }
    for (std::size_t k = 0; k < input.bonds.size(); ++k)
    {
        join(indexOfId[input.bonds.a[k]], indexOfId[input.bonds.b[k]]);
    }

    for (label i = 0; i < parent.size(); ++i)
    {
        parent[i] = first(i);
    }
    return parent;
}


//- Can gravity make particles of this group fall?
static bool falls(const riprap::DemGroup& group, const vector& g)
{
    bool free = group.motion < 0 && group.gravity;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        free = free && !(group.held[d] && mag(g[d]) > 1e-9*mag(g));
    }
    return free;
}


static vector vectorAt(const std::vector<double>& xyz, label i)
{
    return xyz.empty() ? vector(Zero) : vector(xyz[3*i], xyz[3*i + 1], xyz[3*i + 2]);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupledSolids::fallSpeed(const vector& g, scalar lowest) const
{
    const riprap::DemParticles& p = input_.particles;
    const labelList body(bodyOfParticle(input_));

    // Of each body: |g| times its height above the floor, and its speed
    scalarField fall(body.size(), VGREAT);
    scalarField speed(body.size(), Zero);
    forAll(body, i)
    {
        const label group = p.group.empty() ? 0 : p.group[i];
        const bool free =
            input_.groups.empty() || falls(input_.groups[group], g);
        const scalar height =
            lowest - (vectorAt(p.position, i) & g) - mag(g)*p.radius[i];

        scalar& least = fall[body[i]];
        least = min(least, free ? max(height, scalar(0)) : scalar(0));
        speed[body[i]] = max(speed[body[i]], mag(vectorAt(p.velocity, i)));
    }

    scalar most = 0;
    forAll(body, i)
    {
        if (body[i] == i)
        {
            most = max(most, sqr(speed[i]) + 2*fall[i]);
        }
    }
    return sqrt(most);
}


Foam::scalar Foam::coupledSolids::movedSpeed() const
{
    const scalar begin = runTime_.value();
    const scalar end = endOfMotion(runTime_);

    List<boundBox> ofWalls(movingWalls_.size());
    for (const riprap::DemWall& wall : input_.walls)
    {
        for (label i = 0; wall.motion >= 0 && 3*i < label(wall.vertices.size()); ++i)
        {
            ofWalls[wall.motion].add(vectorAt(wall.vertices, i));
        }
    }
    List<boundBox> ofGroups(movingGroups_.size());
    for (std::size_t i = 0; i < input_.particles.group.size(); ++i)
    {
        const label motion = input_.groups[input_.particles.group[i]].motion;
        if (motion >= 0)
        {
            ofGroups[motion].add(vectorAt(input_.particles.position, i));
        }
    }

    scalar fastest = 0;
    const auto include = [&](const wallBodies& bodies, const List<boundBox>& bounds)
    {
        forAll(bounds, i)
        {
            if (bounds[i].empty()) continue;
            fastest =
                max(fastest, bodies.largestSpeed(i, bounds[i], begin, end));
        }
    };
    include(movingWalls_, ofWalls);
    include(movingGroups_, ofGroups);
    return fastest;
}


// ************************************************************************* //

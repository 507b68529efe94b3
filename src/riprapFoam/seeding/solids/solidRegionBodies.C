// SPDX-License-Identifier: GPL-3.0-or-later
/*  Bodies of regions of solids: dropped where they cannot be, and joined to one set. */

#include "solidRegions.H"
#include "HashSet.H"

void Foam::solidRegion::keep(const boolList& those)
{
    // A clump stays whole: it goes if one of its spheres does
    labelHashSet clumpGoes;
    forAll(those, i) if (!those[i] && clump[i] >= 0) clumpGoes.insert(clump[i]);

    labelList newClump(clumps.size(), -1);
    DynamicList<riprap::DemClump> left;
    forAll(clumps, c)
    {
        if (clumpGoes.found(c)) continue;
        newClump[c] = left.size();
        left.append(clumps[c]);
    }
    clumps.transfer(left);

    label n = 0;
    forAll(those, i)
    {
        const bool stays = clump[i] >= 0 ? !clumpGoes.found(clump[i]) : those[i];
        if (!stays) continue;
        position[n] = position[i];
        velocity[n] = velocity[i];
        spin[n] = spin[i];
        radius[n] = radius[i];
        mass[n] = mass[i];
        material[n] = material[i];
        group[n] = group[i];
        clump[n] = clump[i] >= 0 ? newClump[clump[i]] : -1;
        ++n;
    }
    clipped += size() - n;
    for (vectorField* f : {&velocity, &spin}) f->setSize(n);
    for (scalarField* f : {&radius, &mass}) f->setSize(n);
    for (labelField* f : {&material, &group, &clump}) f->setSize(n);
    position.setSize(n);
}


Foam::solidSet Foam::joined(const List<solidRegion>& regions)
{
    solidSet all;
    riprap::DemParticles& p = all.particles;
    bool clumps = false;
    for (const solidRegion& region : regions)
    {
        const label before = all.clumps.size();
        forAll(region.position, i)
        {
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                p.position.push_back(region.position[i][d]);
                p.velocity.push_back(region.velocity[i][d]);
                p.spin.push_back(region.spin[i][d]);
            }
            p.radius.push_back(region.radius[i]);
            p.mass.push_back(region.mass[i]);
            p.material.push_back(region.material[i]);
            p.group.push_back(region.group[i]);
            p.clump.push_back(region.clump[i] < 0 ? -1 : before + region.clump[i]);
            p.id.push_back(p.id.size());
        }
        const int shape = region.shape.empty() ? -1 : all.shapes.size();
        if (region.surface.size() && region.clumps.size() == 1)
        {
            dictionary surface(region.surface);
            surface.add("body", before);
            all.surfaces.add(region.name, surface);
        }
        for (riprap::DemClump clump : region.clumps)
        {
            clump.shape = shape;
            all.clumps.push_back(clump);
        }
        if (shape >= 0) all.shapes.add(region.name, region.shape);
        clumps = clumps || region.clumps.size();
    }
    if (!clumps) p.clump.clear();
    return all;
}

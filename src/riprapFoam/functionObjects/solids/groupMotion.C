/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "groupMotion.H"
#include "addToRunTimeSelectionTable.H"
#include "boundBox.H"
#include "mathematicalConstants.H"
#include <eigen3/Eigen/Geometry>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(groupMotion, 0);
    addToRunTimeSelectionTable(functionObject, groupMotion, dictionary);
}
}


namespace
{
    using Foam::vector;

    struct Motion
    {
        double particles = 0, mass = 0;
        vector centre = Foam::Zero, velocity = Foam::Zero;
        Foam::boundBox extents = Foam::boundBox(vector::zero, vector::zero);
    };

    void addMass(const double mass, const double* x, const double* u, Motion& m)
    {
        m.mass += mass;
        m.centre += mass*vector(x[0], x[1], x[2]);
        m.velocity += mass*vector(u[0], u[1], u[2]);
    }

    // Rigid bodies with their own mass and centre
    Motion motionOfBodies
    (
        const riprap::DemClumpState& bodies,
        const std::vector<riprap::DemClump>& clumps,
        const int group
    )
    {
        Motion m;
        for (std::size_t k = 0; k < clumps.size(); ++k)
        {
            if (clumps[k].group == group && !bodies.left[k])
                addMass(clumps[k].mass, &bodies.position[3*k], &bodies.velocity[3*k], m);
        }
        return m;
    }

    // Summed on the device
    void addParticles(riprap::DemScene& scene, const int group, Motion& m)
    {
        const riprap::DemGroupSums s(scene.groupSums(group));
        const auto vectorOf = [](const riprap::Vector3& v) { return vector(v[0], v[1], v[2]); };
        m.particles = s.particles;
        m.mass += s.mass;
        m.centre += vectorOf(s.massPosition);
        m.velocity += vectorOf(s.momentum);
        m.extents = Foam::boundBox(vectorOf(s.min), vectorOf(s.max));
    }

    //- Along the axis, as long as the angle [degrees]
    vector rotationVector(const std::array<double, 9>& r)
    {
        Eigen::Matrix3d matrix;
        matrix << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
        const Eigen::AngleAxisd turn(matrix);
        const Eigen::Vector3d v(turn.axis()*(turn.angle()*180/Foam::constant::mathematical::pi));
        return vector(v[0], v[1], v[2]);
    }

    // One by one: in 2D with their places along the empty axis
    void addParticles(const riprap::DemState& now, const int group, Motion& m)
    {
        for (std::size_t i = 0; i < now.id.size(); ++i)
        {
            if (now.group[i] != group) continue;

            const vector x(now.position[3*i], now.position[3*i + 1], now.position[3*i + 2]);
            const vector reach(now.radius[i]*vector::one);
            if (m.particles == 0)
            {
                m.extents = Foam::boundBox(x - reach, x + reach);
            }
            m.extents.min() = Foam::min(m.extents.min(), x - reach);
            m.extents.max() = Foam::max(m.extents.max(), x + reach);
            m.particles += 1;
            const bool member = now.clump.size() && now.clump[i] >= 0;
            if (!member) addMass(now.mass[i], &now.position[3*i], &now.velocity[3*i], m);
        }
    }
}


Foam::functionObjects::groupMotion::groupMotion
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    demFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


bool Foam::functionObjects::groupMotion::read(const dictionary& dict)
{
    demFunctionObject::read(dict);
    groups_ = groups(dict);
    readRotation(dict_);
    return true;
}


Foam::word Foam::functionObjects::groupMotion::poseProperty(const label i) const
{
    return "pose_" + dem().settings().groupNames()[groups_[i]];
}


void Foam::functionObjects::groupMotion::readRotation(const dictionary& dict)
{
    // Of the run so far where the dictionary was edited
    HashTable<scalarList> poses;
    forAll(bodies_, i)
    {
        if (bodies_.set(i))
            poses.set("pose_" + bodies_[i].name(), gaugeBody::state(bodies_[i].pose()));
    }

    bodies_.clear();
    if (!dict.lookupOrDefault("rotation", false)) return;

    // Others have zeros in all columns
    std::vector<bool> filled(dem().settings().groups.size(), false);
    for (const std::int32_t group : dem().motion().group) filled[group] = true;

    bodies_.setSize(groups_.size());
    forAll(groups_, i)
    {
        if (!filled[groups_[i]]) continue;
        bodies_.set(i, new gaugeBody(mesh_));
        bodies_[i].take(groups_[i]);
        const word kept(poseProperty(i));
        bodies_[i].begin(dict, poses.found(kept) ? poses[kept] : saved(kept), "rotation");
    }
}


bool Foam::functionObjects::groupMotion::executeSample()
{
    for (label i = 0; time_.writeTime() && i < bodies_.size(); ++i)
    {
        if (bodies_.set(i)) keep(poseProperty(i), gaugeBody::state(bodies_[i].pose()));
    }
    return true;
}


bool Foam::functionObjects::groupMotion::writeSample()
{
    const std::vector<riprap::DemClump>& clumps = dem().input().clumps;
    const riprap::DemClumpState bodies
    (
        clumps.size() ? dem().scene().clumps() : riprap::DemClumpState()
    );
    const wordList names(dem().settings().groupNames());

    wordList columns;
    DynamicList<scalar> values;
    forAll(groups_, i)
    {
        const label group = groups_[i];
        Motion m(motionOfBodies(bodies, clumps, group));
        if (dem().settings().config.dimensions == 3) addParticles(dem().scene(), group, m);
        else addParticles(dem().motion(), group, m);
        if (m.mass > 0)
        {
            m.centre /= m.mass;
            m.velocity /= m.mass;
        }
        const word& name = names[group];
        columns.append(wordList({name + "Particles", name + "CentreX", name + "CentreY",
            name + "CentreZ", name + "MinX", name + "MinY", name + "MinZ", name + "MaxX",
            name + "MaxY", name + "MaxZ", name + "Ux", name + "Uy", name + "Uz", name + "Mass"}));
        values.append(m.particles);
        for (const vector& v : {m.centre, m.extents.min(), m.extents.max(), m.velocity})
        {
            for (int d = 0; d < vector::nComponents; ++d) values.append(v[d]);
        }
        values.append(m.mass);
        if (bodies_.empty()) continue;

        columns.append(wordList({name + "RotationX", name + "RotationY", name + "RotationZ"}));
        const vector turned(
            bodies_.set(i) ? rotationVector(bodies_[i].pose().rotation) : vector(Zero));
        for (int d = 0; d < vector::nComponents; ++d) values.append(turned[d]);
    }

    OFstream& os = row(typeName, columns);
    for (const scalar value : values)
    {
        add(os, value);
    }
    os  << endl;
    return true;
}

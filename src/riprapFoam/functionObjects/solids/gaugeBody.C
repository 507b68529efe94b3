/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gaugeBody.H"
#include "didYouMean.H"
#include "nearestImage.H"
#include "runningScenes.H"
#include "wallBodies.H"
#include "principalAxes.H"
#include <algorithm>
#include <unordered_map>

namespace
{
    //- Are the points spread enough to tell how they turn: not one, in 3D not on a line?
    bool tellTurns(const std::vector<riprap::Vector3>& points, bool planar)
    {
        Foam::vector mean(Foam::Zero);
        for (const riprap::Vector3& x : points)
        {
            mean += Foam::vector(x[0], x[1], x[2])/Foam::scalar(points.size());
        }
        Foam::tensor spread(Foam::Zero), axes;
        for (const riprap::Vector3& x : points)
        {
            const Foam::vector d(Foam::vector(x[0], x[1], x[2]) - mean);
            spread += d*d;
        }
        Foam::vector moments(Foam::principalMoments(spread, axes));
        std::sort(moments.begin(), moments.end());
        return planar ? moments[2] > 0 : moments[1] > 1e-6*moments[2];
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::gaugeBody::wallNames() const
{
    const wallBodies& bodies = runningFluid(mesh_)->bodies();
    wordList names(bodies.size());
    forAll(names, body)
    {
        names[body] = bodies.name(body);
    }
    return names;
}


Foam::wordList Foam::functionObjects::gaugeBody::solidNames() const
{
    const demSceneObject* dem = runningSolids(mesh_);
    return dem ? dem->settings().groupNames() : wordList();
}


void Foam::functionObjects::gaugeBody::follow(const riprap::DemState& now)
{
    const riprap::DemConfig& config = runningSolids(mesh_)->settings().config;

    std::unordered_map<std::int32_t, std::size_t> at;
    for (std::size_t i = 0; i < now.id.size(); ++i)
    {
        at[now.id[i]] = i;
    }

    for (std::size_t k = 0; k < ids_.size(); ++k)
    {
        const auto found = at.find(ids_[k]);
        if (found == at.end()) continue;

        const double* x = &now.position[3*found->second];
        vector step;
        for (direction d = 0; d < 3; ++d) step[d] = x[d] - last_[k][d];
        step = nearestImage(config, step);
        for (direction d = 0; d < 3; ++d) last_[k][d] += step[d];
    }
}


std::array<double, 9> Foam::functionObjects::gaugeBody::turned
(
    const riprap::DemState& now
) const
{
    const auto at = std::find(now.id.begin(), now.id.end(), ids_[0]) - now.id.begin();
    if (now.orientation.empty() || std::size_t(at) == now.id.size())
    {
        return turnedAtBegin_;
    }
    const double* q = &now.orientation[4*at];
    return riprap::rotationOf({{q[0], q[1], q[2], q[3]}});
}


void Foam::functionObjects::gaugeBody::beginSolids
(
    const dictionary& dict,
    const word& entry
)
{
    const demSceneObject& dem = *runningSolids(mesh_);
    const riprap::DemState& now = dem.motion();
    const bool planar = dem.settings().config.dimensions == 2;

    ids_.clear();
    begin_.clear();
    labelHashSet clumps;
    for (std::size_t i = 0; i < now.id.size(); ++i)
    {
        if (now.group[i] != index_) continue;

        ids_.push_back(now.id[i]);
        begin_.push_back({{now.position[3*i], now.position[3*i + 1], now.position[3*i + 2]}});
        clumps.insert(now.clump.empty() ? -1 : now.clump[i]);
    }
    last_ = begin_;

    const char* fault = ids_.empty() ? "has no particles"
        : clumps.size() > 1 ? "is several bodies: this is for one"
        : ids_.size() == 1 && now.orientation.empty()
        ? "is one particle, of which only orientation yes; of constant/solidProperties tells how "
          "it turns"
        : ids_.size() > 1 && !tellTurns(begin_, planar)
        ? "lies on one line, which does not tell how it turns"
        : nullptr;
    if (fault)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << ": group " << name_ << " of solids " << fault
            << exit(FatalIOError);
    }

    turnedAtBegin_ = turned(now);
}


riprap::WallPose Foam::functionObjects::gaugeBody::fitted()
{
    const demSceneObject& dem = *runningSolids(mesh_);
    const riprap::DemConfig& config = dem.settings().config;
    const riprap::DemState& now = dem.motion();
    follow(now);

    riprap::WallPose pose
    (
        riprap::rigidFit(begin_, last_, config.dimensions == 2 ? config.axes[2] : -1)
    );
    if (ids_.size() == 1)
    {
        pose.rotation = riprap::productOf(turned(now), riprap::transposeOf(turnedAtBegin_));
        for (label d = 0; d < 3; ++d)
        {
            const double* row = &pose.rotation[3*d];
            pose.translation[d] = last_[0][d] - row[0]*begin_[0][0] - row[1]*begin_[0][1]
                - row[2]*begin_[0][2];
        }
    }

    // From the beginning of this run on; before it, the pose then
    riprap::WallPose whole;
    whole.rotation = riprap::productOf(pose.rotation, poseAtBegin_.rotation);
    for (label d = 0; d < 3; ++d)
    {
        const double* row = &pose.rotation[3*d];
        const riprap::Vector3& s = poseAtBegin_.translation;
        whole.translation[d] = pose.translation[d] + row[0]*s[0] + row[1]*s[1] + row[2]*s[2];
    }
    return whole;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::functionObjects::gaugeBody::find
(
    const dictionary& dict,
    const word& functionObject
)
{
    kind_ = kind::none;
    if (!dict.found("body")) return;

    name_ = dict.get<word>("body");
    const wordList walls(wallNames()), solids(solidNames());

    if (walls.found(name_) == solids.found(name_))
    {
        wordList others(walls);
        others.append(solids);
        if (walls.found(name_)) others.clear();
        FatalIOErrorInFunction(dict)
            << "Entry body of function object " << functionObject << ": "
            << name_
            << (
                   walls.found(name_)
                 ? " is a group of walls and one of solids: rename one"
                 : " is no group of walls that moves and none of solids"
               )
            << "; valid are, of walls, " << listed(walls).c_str()
            << ", of solids, " << listed(solids).c_str() << didYouMean(name_, others).c_str()
            << exit(FatalIOError);
    }

    kind_ = walls.found(name_) ? kind::walls : kind::solids;
    index_ = kind_ == kind::walls ? walls.find(name_) : solids.find(name_);
}


void Foam::functionObjects::gaugeBody::take(const label group)
{
    kind_ = kind::solids;
    index_ = group;
    name_ = solidNames()[group];
}


void Foam::functionObjects::gaugeBody::begin
(
    const dictionary& dict,
    const scalarList& before,
    const word& entry
)
{
    if (kind_ != kind::solids) return;

    poseAtBegin_ = riprap::WallPose();
    if (before.size() == 12)
    {
        std::copy(before.begin(), before.begin() + 9, poseAtBegin_.rotation.begin());
        std::copy(before.begin() + 9, before.end(), poseAtBegin_.translation.begin());
    }
    beginSolids(dict, entry);
}


riprap::WallPose Foam::functionObjects::gaugeBody::pose()
{
    if (kind_ == kind::walls)
    {
        const fluidSceneObject& fluid = *runningFluid(mesh_);
        return fluid.bodies().pose(index_, fluid.fluidScene().time());
    }
    return kind_ == kind::solids ? fitted() : riprap::WallPose();
}


Foam::scalarList Foam::functionObjects::gaugeBody::state
(
    const riprap::WallPose& pose
)
{
    scalarList all(12);
    std::copy(pose.rotation.begin(), pose.rotation.end(), all.begin());
    std::copy(pose.translation.begin(), pose.translation.end(), all.begin() + 9);
    return all;
}


// ************************************************************************* //

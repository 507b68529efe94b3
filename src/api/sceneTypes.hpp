/*  What the facades of all scenes share. SI, double, host memory; no types of either side of the
    facade.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace riprap
{

using Vector3 = std::array<double, 3>;

enum class DeviceKind {automatic, cpu, gpu};
enum class PrecisionKind {mixed, doubled};

//- Pose of a moving wall group: x(t) = R(t) X + translation(t), X the reference position
struct WallPose
{
    std::array<double, 9> rotation{{1, 0, 0, 0, 1, 0, 0, 0, 1}};   // row-major
    Vector3 translation{{0, 0, 0}};
};

//- Pose of moving wall group `body` at time t; called on the host, a few times a call of advance
using WallMotion = std::function<WallPose(int body, double t)>;

//- A device array as the user sees it in the report of what a scene holds
struct ArrayInfo { std::string set, name; std::size_t bytesPerParticle = 0, bytes = 0; };

//- What one of several processes has and has sent, all in all
struct RankReport
{
    std::size_t owned = 0, ghosts = 0;      // particles now
    std::int64_t arrivals = 0;              // that came from others
    std::int64_t divisions = 0;             // of space over ranks
    std::int64_t bytesInSteps = 0, bytesAtRebuilds = 0;
    // the last division: most of a rank over the mean, before (0: there was none) and after
    double unevenBefore = 0, unevenAfter = 0;
    double atWork = 0;                      // [s] in steps, without waiting for others
    bool direct = false;                    // GPUs send in steps without the host
};

struct KernelInfo { std::string name; std::int64_t launches = 0; double seconds = 0; };

} // namespace riprap

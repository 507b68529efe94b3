/*  Where moving groups of walls are in the interval that is being advanced.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "api/sphScene.hpp"
#include "core/backend/launch.hpp"
#include "sph/boundary/movingWall.hpp"

namespace riprap
{

template<class Backend>
class WallPoses
{
public:
    WallPoses(Context<Backend>& context, WallMotion motion)
        : context_(context), motion_(std::move(motion))
    {}

    //- Memory for so many groups
    void allocate(int groups);

    //- Poses over the interval that is about to be advanced
    void set(double begin, double end);

    PoseTable table() const { return PoseTable{samples_.data(), intervals, begin_, step_}; }
    std::size_t bytes() const { return samples_.bytes(); }

private:

    static constexpr int intervals = 32;

    Context<Backend>& context_;
    WallMotion motion_;
    int groups_ = 0;
    Array<Backend, PoseSample> samples_;
    double begin_ = 0, step_ = 1;
};

template<class Backend>
void WallPoses<Backend>::allocate(int groups)
{
    groups_ = groups;
    samples_.allocate(context_, std::size_t(groups_)*(intervals + 1));
}

//- Poses of the moving groups over the interval that is about to be advanced. None is asked for
//  before it or, unless it is shorter than a millisecond, after it: a table may begin and end there
template<class Backend>
void WallPoses<Backend>::set(double begin, double end)
{
    begin_ = begin;
    // second differences of instants that are closer drown in round-off
    step_ = std::max(end - begin, 1e-3)/intervals;
    std::vector<PoseSample> samples(std::size_t(groups_)*(intervals + 1));
    const auto pose = [&](int body, double t)
    {
        const WallPose p = motion_(body, t);
        std::array<double, 12> r;
        for (int k = 0; k < 9; ++k) r[k] = p.rotation[k];
        for (int k = 0; k < 3; ++k) r[9 + k] = p.translation[k];
        return r;
    };
    const double dt = 0.02*step_;
    for (int b = 0; b < groups_; ++b)
        for (int k = 0; k <= intervals; ++k)
        {
            const bool first = k == 0, last = k == intervals;
            const double t = last ? begin + std::max(end - begin, 1e-3) : begin + k*step_;
            const auto now = pose(b, t);
            // three instants, all on one side at the ends
            const auto p = pose(b, first ? t + dt : t - dt),
                       q = pose(b, first ? t + 2*dt : (last ? t - 2*dt : t + dt));
            PoseSample& s = samples[std::size_t(b)*(intervals + 1) + k];
            for (int e = 0; e < 12; ++e)
            {
                s.value[e] = now[e];
                s.rate[e] = first || last
                    ? (first ? 1 : -1)*(4*p[e] - 3*now[e] - q[e])/(2*dt)
                    : (q[e] - p[e])/(2*dt);
            }
        }
    context_.toDevice(samples_.data(), samples.data(), samples.size()*sizeof(PoseSample));
}

} // namespace riprap

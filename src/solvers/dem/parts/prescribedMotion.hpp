/*  Prescribed motions of groups and walls, sampled over a window of time for the device.

    Motions are asked for from now to the target, and neither before nor after: a table may begin
    where the run does and end with it. Beyond the target, where the last sample of all may lie,
    they are continued on straight lines.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "dem/motion/motionTable.hpp"
#include "dem/walls/moveWalls.hpp"
#include "solvers/dem/parts/demSetting.hpp"

namespace riprap
{

namespace detail
{

//- A motion's numbers over begin .. end, continued beyond the end
template<std::size_t N, class Numbers>
struct BoundedMotion
{
    Numbers given;              // of a time
    double begin, end;

    using Row = std::array<double, N>;

    Row numbers(double t) const { return given(std::max(begin, std::min(t, end))); }

    //- a p + b q + c r
    static Row sum(double a, const Row& p, double b, const Row& q, double c, const Row& r)
    {
        Row s;
        for (std::size_t k = 0; k < N; ++k) s[k] = a*p[k] + b*q[k] + c*r[k];
        return s;
    }

    //- Derivative from three instants `e` apart, all within the bounds
    Row rate(double t, double e) const
    {
        e = std::min(e, 0.5*(end - begin));
        t = std::min(t, end);
        const double f = 0.5/e;
        if (t - e < begin) return sum(-3*f, numbers(t), 4*f, numbers(t + e), -f, numbers(t + 2*e));
        if (t + e > end) return sum(3*f, numbers(t), -4*f, numbers(t - e), f, numbers(t - 2*e));
        return sum(f, numbers(t + e), -f, numbers(t - e), 0, numbers(t));
    }

    Row at(double t, double e) const
    {
        if (t <= end) return numbers(t);
        const Row last = numbers(end);
        return sum(1, last, t - end, rate(end, e), 0, last);
    }
};

template<std::size_t N, class Numbers>
BoundedMotion<N, Numbers> bounded(Numbers numbers, double begin, double end)
{
    return {numbers, begin, end};
}

} // namespace detail

template<class Backend, int D, class P>
class PrescribedMotion
{
public:

    static constexpr int windowSteps = 64;

    explicit PrescribedMotion(DemSetting<Backend, D, P>& set) : set_(set) {}

    //- Memory for so many motions
    void holdGroups(int count);
    void holdWalls(int count);

    int groups() const { return groups_; }
    int walls() const { return walls_; }

    //- Motions sampled over the steps to come; the host's clock must be current
    void sample(DemClockData&);

    MotionTable groupTable() const
    {
        return MotionTable{groupTable_.data(), samples, rigidMotionNumbers, begin_, step_};
    }
    MotionTable wallTable() const
    {
        return MotionTable{wallTable_.data(), samples, poseNumbers, begin_, step_};
    }

private:

    static constexpr int samples = 2*windowSteps + 3;

    void sampleGroups(double end);
    void sampleWalls(double end);

    DemSetting<Backend, D, P>& set_;
    int groups_ = 0, walls_ = 0;
    double begin_ = 0, step_ = 1;
    std::vector<double> groupSamples_, wallSamples_;
    Array<Backend, double> groupTable_, wallTable_;
};

template<class Backend, int D, class P>
void PrescribedMotion<Backend, D, P>::holdGroups(int count)
{
    groups_ = count;
    if (count) groupTable_.allocate(set_.context, std::size_t(count)*samples*rigidMotionNumbers);
}

template<class Backend, int D, class P>
void PrescribedMotion<Backend, D, P>::holdWalls(int count)
{
    walls_ = count;
    if (count) wallTable_.allocate(set_.context, std::size_t(count)*samples*poseNumbers);
}

template<class Backend, int D, class P>
void PrescribedMotion<Backend, D, P>::sample(DemClockData& clock)
{
    clock.needWindow = 0;
    clock.windowEnd = 1e300;
    if (!groups_ && !walls_) return;
    const double dt = clock.fullDt;
    step_ = 0.5*dt;
    begin_ = clock.time;
    // at the start there is no target yet
    const double target = clock.target > clock.time ? clock.target : clock.time + dt;
    // a step may end half its length beyond the window
    const double end = std::min(clock.time + (windowSteps + 1)*dt, target);
    clock.windowEnd = std::min(clock.time + windowSteps*dt, target);
    if (groups_) sampleGroups(end);
    if (walls_) sampleWalls(end);
}

template<class Backend, int D, class P>
void PrescribedMotion<Backend, D, P>::sampleGroups(double end)
{
    groupSamples_.resize(std::size_t(groups_)*samples*rigidMotionNumbers);
    double* to = groupSamples_.data();
    for (int m = 0; m < groups_; ++m)
    {
        const auto motion = detail::bounded<rigidMotionNumbers>([&](double t)
        {
            const RigidMotion r = set_.input.groupMotion(m, t);
            std::array<double, rigidMotionNumbers> row;
            for (int d = 0; d < 3; ++d)
            {
                const int axis = set_.config.axes[d];
                row[d] = r.velocity[axis];
                row[3 + d] = D == 2 && d == 2 ? set_.spinSign()*r.spin[axis]
                                              : (D == 2 ? 0 : r.spin[axis]);
                row[6 + d] = r.centre[axis];
            }
            return row;
        }, begin_, end);
        for (int k = 0; k < samples; ++k)
            for (const double x : motion.at(begin_ + k*step_, step_)) *to++ = x;
    }
    set_.context.toDevice(
        groupTable_.data(), groupSamples_.data(), groupSamples_.size()*sizeof(double));
}

template<class Backend, int D, class P>
void PrescribedMotion<Backend, D, P>::sampleWalls(double end)
{
    wallSamples_.resize(std::size_t(walls_)*samples*poseNumbers);
    double* to = wallSamples_.data();
    for (int m = 0; m < walls_; ++m)
    {
        const auto motion = detail::bounded<poseNumbers/2>([&](double t)
        {
            const WallPose p = set_.input.wallMotion(m, t);
            std::array<double, poseNumbers/2> r;
            for (int a = 0; a < 3; ++a)
            {
                for (int b = 0; b < 3; ++b)
                    r[3*a + b] = p.rotation[3*set_.config.axes[a] + set_.config.axes[b]];
                r[9 + a] = p.translation[set_.config.axes[a]];
            }
            return r;
        }, begin_, end);
        for (int k = 0; k < samples; ++k)
        {
            const double t = begin_ + k*step_;
            for (const double x : motion.at(t, step_)) *to++ = x;
            for (const double x : motion.rate(t, step_)) *to++ = x;
        }
    }
    set_.context.toDevice(
        wallTable_.data(), wallSamples_.data(), wallSamples_.size()*sizeof(double));
}

} // namespace riprap

/*  DemSolver: prescribed motions, sampled over a window of time for the device.

    Motions are asked for from now to the target, and neither before nor after: a table may begin where the run does and end with
    it. Beyond the target, where the last sample of all may lie, they are continued on straight lines.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/demSolver.hpp"

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
BoundedMotion<N, Numbers> bounded(Numbers numbers, double begin, double end) { return {numbers, begin, end}; }

} // namespace detail

//- Motions sampled over the steps to come; the host's clock must be current
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setWindow()
{
    host_.needWindow = 0;
    host_.windowEnd = 1e300;
    if (!groupMotions_ && !wallMotions_) return;
    const double dt = host_.fullDt;
    windowStep_ = 0.5*dt;
    windowBegin_ = host_.time;
    // at the start there is no target yet
    const double target = host_.target > host_.time ? host_.target : host_.time + dt;
    // a step may end half its length beyond the window
    const double end = std::min(host_.time + (windowSteps + 1)*dt, target);
    host_.windowEnd = std::min(host_.time + windowSteps*dt, target);
    if (groupMotions_) sampleGroups(end);
    if (wallMotions_) samplePoses(end);
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::sampleGroups(double end)
{
    motionSamples_.resize(std::size_t(groupMotions_)*samples*rigidMotionNumbers);
    double* to = motionSamples_.data();
    for (int m = 0; m < groupMotions_; ++m)
    {
        const auto motion = detail::bounded<rigidMotionNumbers>([&](double t)
        {
            const RigidMotion r = input_.groupMotion(m, t);
            std::array<double, rigidMotionNumbers> row;
            for (int d = 0; d < 3; ++d)
            {
                const int axis = config_.axes[d];
                row[d] = r.velocity[axis];
                row[3 + d] = D == 2 && d == 2 ? spinSign()*r.spin[axis] : (D == 2 ? 0 : r.spin[axis]);
                row[6 + d] = r.centre[axis];
            }
            return row;
        }, windowBegin_, end);
        for (int k = 0; k < samples; ++k)
            for (const double x : motion.at(windowBegin_ + k*windowStep_, windowStep_)) *to++ = x;
    }
    context_.toDevice(motions_.data(), motionSamples_.data(), motionSamples_.size()*sizeof(double));
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::samplePoses(double end)
{
    poseSamples_.resize(std::size_t(wallMotions_)*samples*poseNumbers);
    double* to = poseSamples_.data();
    for (int m = 0; m < wallMotions_; ++m)
    {
        const auto motion = detail::bounded<poseNumbers/2>([&](double t)
        {
            const WallPose p = input_.wallMotion(m, t);
            std::array<double, poseNumbers/2> r;
            for (int a = 0; a < 3; ++a)
            {
                for (int b = 0; b < 3; ++b) r[3*a + b] = p.rotation[3*config_.axes[a] + config_.axes[b]];
                r[9 + a] = p.translation[config_.axes[a]];
            }
            return r;
        }, windowBegin_, end);
        for (int k = 0; k < samples; ++k)
        {
            const double t = windowBegin_ + k*windowStep_;
            for (const double x : motion.at(t, windowStep_)) *to++ = x;
            for (const double x : motion.rate(t, windowStep_)) *to++ = x;
        }
    }
    context_.toDevice(poses_.data(), poseSamples_.data(), poseSamples_.size()*sizeof(double));
}

} // namespace riprap

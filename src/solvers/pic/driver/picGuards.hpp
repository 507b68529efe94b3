/*  What stops a run: particles or solids that go too far or too fast, or that are lost.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/driver/picReadings.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class PicGuards
{
public:

    using real = typename P::real;

    PicGuards(PicParts<Backend, D, P>& parts, PicReadings<Backend, D, P>& readings)
    :
        p_(parts), readings_(readings)
    {}

    //- \return may a step dt follow? speed: of the fastest particle
    bool pass(PicReport&, double speed, double dt);
    void stopAtSolids(PicReport&, const std::string& why);

private:

    double speedLimit(double now);
    void stopTooFast(PicReport&, double speed);
    void findOffender(PicReport&, double courant);
    void agree(PicReport&, double worst) const;

    PicParts<Backend, D, P>& p_;
    PicReadings<Backend, D, P>& readings_;
    double speedLimit_ = 0;                     // [m/s] above it a guard fires
};

template<class Backend, int D, class P>
bool PicGuards<Backend, D, P>::pass(PicReport& report, double speed, double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    const PicConfig& config = p_.set.config;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    const double courant = speed*dt/grid.h;
    report.maxSpeed = std::max(report.maxSpeed, speed);
    if (!(speed < 1e30)) report.stop = StopReason::notANumber;
    else if (!(courant < config.maxCourantEver)) report.stop = StopReason::speed;
    else if (!(speed <= speedLimit(speed))) stopTooFast(report, speed);
    else if (solids.bodies
        && !(solids.bodies->table.fastest()*dt < config.maxCourantEver*grid.h))
        stopAtSolids(report,
            "would go " + std::to_string(solids.bodies->table.fastest()*dt/grid.h)
                + " cells in a step; guards/Courant allows "
                + std::to_string(config.maxCourantEver));
    else if (solids.bodies && solids.bodies->table.acrossPeriodic(grid))
        stopAtSolids(report, "reaches across a periodic side, where it cannot be followed");
    if (report.stop == StopReason::none) return true;
    findOffender(report, courant);
    return false;
}

template<class Backend, int D, class P>
void PicGuards<Backend, D, P>::stopAtSolids(PicReport& report, const std::string& why)
{
    report.stop = StopReason::solids;
    report.stopMessage = "a solid " + why;
}

//- Steps that follow the Courant number shrink as fast as speeds grow: no other guard would end a
//  run that blows up. 0 at the first step: not known yet
template<class Backend, int D, class P>
double PicGuards<Backend, D, P>::speedLimit(double now)
{
    const PicConfig& config = p_.set.config;
    if (config.maxSpeed > 0) return config.maxSpeed;
    if (speedLimit_ == 0)
    {
        double fall = 0;
        for (int d = 0; d < 3; ++d)
            fall += 2*std::abs(config.gravity[d])*(config.domainMax[d] - config.domainMin[d]);
        const double known = std::max(std::sqrt(fall), now);
        speedLimit_ = known > 0 ? PicConfig::fallSpeeds*known : 1e30;
    }
    return speedLimit_;
}

template<class Backend, int D, class P>
void PicGuards<Backend, D, P>::stopTooFast(PicReport& report, double speed)
{
    report.stop = StopReason::tooFast;
    report.stopMessage = "goes at " + std::to_string(speed) + " m/s; guards/maxSpeed allows "
        + std::to_string(speedLimit(speed)) + " m/s";
}

//- Which particle made a guard fire
template<class Backend, int D, class P>
void PicGuards<Backend, D, P>::findOffender(PicReport& report, double courant)
{
    const FluidState all = readings_.fluid();
    double worst = -1;
    for (std::size_t i = 0; i < all.id.size(); ++i)
    {
        const double* v = &all.velocity[3*i];
        const double speed = std::sqrt(v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
        const double value = std::isfinite(speed) ? speed : 1e300;
        if (value <= worst) continue;
        worst = value;
        report.stopId = all.id[i];
        report.stopPosition = Vector3{
            {all.position[3*i], all.position[3*i + 1], all.position[3*i + 2]}};
        report.stopValue = courant;
    }
    if (p_.halo) agree(report, worst);
}

//- On the rank whose particle is worst, the first of those where it is as bad
template<class Backend, int D, class P>
void PicGuards<Backend, D, P>::agree(PicReport& report, double worst) const
{
    struct Found { double worst, value; Vector3 position; std::int32_t id; };
    std::vector<Found> all{
        Found{worst, report.stopValue, report.stopPosition, report.stopId}};
    join(p_.halo->ranks(), all);
    const Found& found = *std::max_element(all.begin(), all.end(),
        [](const Found& a, const Found& b) { return a.worst < b.worst; });
    report.stopValue = found.value;
    report.stopPosition = found.position;
    report.stopId = found.id;
}

} // namespace riprap

/*  What a call of advance says: steps and their limit, particles that left, and which one made a
    guard fire.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "solvers/sph/driver/sphNeighbours.hpp"
#include "solvers/sph/parts/sphReadBack.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SphReports
{
public:

    using real = typename P::real;

    SphReports(SphParts<Backend, D, P>& parts, SphNeighbours<Backend, D, P>& neighbours)
        : p_(parts), neighbours_(neighbours)
    {}

    //- After the steps of a call. before: steps of the calls before it
    void finish(SphReport&, std::int64_t before);

private:

    void collectEscaped(SphReport&);
    void findOffender(SphReport&);
    double findWorst(SphReport&);
    std::vector<double> suspicion(int n);

    SphParts<Backend, D, P>& p_;
    SphNeighbours<Backend, D, P>& neighbours_;
};

template<class Backend, int D, class P>
void SphReports<Backend, D, P>::finish(SphReport& report, std::int64_t before)
{
    ClockData& now = p_.clock.now;
    now.settleAge();
    if (now.halt == Halt::none)
    {
        now.halt = p_.set.limits.halt(now);
        if (now.halt != Halt::none) p_.clock.write();
    }

    report.time = now.time;
    report.lastTimeStep = now.dt;
    report.steps = now.step - before;
    report.totalSteps = now.step;
    report.minTimeStep = report.steps ? now.minDt : 0;
    report.maxTimeStep = now.maxDt;
    report.limit = wordOf(now.limit);
    report.maxDensityDeviation = now.maxima[2];
    report.maxSpeed = now.maxima[3];
    report.skinExceeded = now.skinViolations;
    if (now.halt != Halt::none) findOffender(report);
    // the last step may have carried particles out: a sort now says so in this call. The next one
    // sorts to the same order
    else if (report.steps && now.needRebuild) neighbours_.sortNow();
    collectEscaped(report);
}

//- Particles that left: sorted to the end by the last rebuild, reported once
template<class Backend, int D, class P>
void SphReports<Backend, D, P>::collectEscaped(SphReport& report)
{
    if (p_.ranks)
    {
        p_.ranks->report(report);
        report.rank.bytesInSteps += p_.wallRanks->bytesShared() + p_.solidRanks->bytesShared();
        return;
    }
    const int active = p_.fluid.active();
    report.fluid = active;
    if (active >= p_.fluid.reported) return;
    std::vector<std::int64_t> x[D];
    std::vector<double> metres;
    for (int d = 0; d < D; ++d)
        x[d] = p_.fluid.values.template download<std::int64_t>(p_.set.context, p_.fluid.at.x + d);
    const auto id = p_.fluid.values.template download<std::int32_t>(p_.set.context, p_.fluid.at.id);
    p_.set.toMetres(x, p_.fluid.n, metres);
    const auto deviation = p_.fluid.values.template download<real>(
        p_.set.context, p_.fluid.at.deviation);
    std::vector<real> v[D];
    for (int d = 0; d < D; ++d)
        v[d] = p_.fluid.values.template download<real>(p_.set.context, p_.fluid.at.v + d);
    for (int i = active; i < p_.fluid.reported; ++i)
    {
        if (id[i] < 0)
        {
            double speed2 = 0;
            for (int d = 0; d < D; ++d) speed2 += double(v[d][i])*v[d][i];
            report.wild.push_back(WildParticle{-1 - id[i],
                Vector3{{metres[3*i], metres[3*i + 1], metres[3*i + 2]}}, deviation[i],
                std::sqrt(speed2)});
            continue;
        }
        report.escaped.push_back(Vector3{{metres[3*i], metres[3*i + 1], metres[3*i + 2]}});
        report.escapedId.push_back(id[i]);
    }
    p_.fluid.reported = active;
}

//- What pairs saw of each particle in the last pass, in units of what is usual. A number that is
//  none makes those that it meets so too, within the pass: what it was made of tells the one that
//  began from the others
template<class Backend, int D, class P>
std::vector<double> SphReports<Backend, D, P>::suspicion(int n)
{
    Array<Backend, double> result;
    result.allocate(p_.set.context, n);
    forEach(p_.set.context, n,
        Suspicion<Backend, D, P>{p_.fluid.records.view(), p_.set.config.soundSpeed,
            p_.set.config.density, result.data()});
    return result.download();
}

//- Which particle made a guard fire
template<class Backend, int D, class P>
void SphReports<Backend, D, P>::findOffender(SphReport& report)
{
    // DemScene::lastReport has more
    if (p_.clock.now.halt == Halt::solids) { report.stop = StopReason::solids; return; }
    report.stop = p_.clock.now.halt == Halt::notANumber ? StopReason::notANumber
        : (p_.clock.now.halt == Halt::density ? StopReason::density : StopReason::speed);
    const double worst = findWorst(report);
    if (p_.ranks) p_.ranks->agreeOnOffender(report, worst);
}

//- Of those of this rank. \return what it was found by
template<class Backend, int D, class P>
double SphReports<Backend, D, P>::findWorst(SphReport& report)
{
    const int n = p_.fluid.active();
    const auto deviation = p_.fluid.values.template download<real>(
        p_.set.context, p_.fluid.at.deviation);
    std::vector<real> v[D], a[D];
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d)
    {
        v[d] = p_.fluid.values.template download<real>(p_.set.context, p_.fluid.at.v + d);
        a[d] = p_.fluid.values.template download<real>(p_.set.context, p_.fluid.at.a + d);
        x[d] = p_.fluid.values.template download<std::int64_t>(p_.set.context, p_.fluid.at.x + d);
    }
    const auto id = p_.fluid.values.template download<std::int32_t>(p_.set.context, p_.fluid.at.id);
    std::vector<double> metres, suspect;
    p_.set.toMetres(x, n, metres);
    if (report.stop == StopReason::notANumber) suspect = suspicion(n);
    double worst = -1;
    for (int i = 0; i < n; ++i)
    {
        if (p_.ranks && p_.ranks->ghost(i)) continue;
        real speed2 = 0, a2 = 0;
        for (int d = 0; d < D; ++d) { speed2 += v[d][i]*v[d][i]; a2 += a[d][i]*a[d][i]; }
        double value = report.stop == StopReason::density ? std::abs(double(deviation[i]))
                                                          : std::sqrt(double(speed2));
        if (report.stop == StopReason::notANumber)
        {
            // the bounds are the clock's; speed^2 may overflow where the speed does not
            const bool fine = a2 < 1e30 && std::sqrt(speed2) < 1e30 && std::abs(deviation[i]) < 1e30
                && deviation[i] > -1;
            value = fine ? -0.5
                         : (std::isfinite(suspect[i]) ? suspect[i]
                                                      : std::numeric_limits<double>::infinity());
        }
        if (value <= worst) continue;
        worst = value;
        report.stopId = id[i];
        report.stopPosition = Vector3{{metres[3*i], metres[3*i + 1], metres[3*i + 2]}};
        report.stopValue = report.stop == StopReason::notANumber ? std::sqrt(double(speed2))
                                                                 : value;
    }
    return worst;
}

} // namespace riprap

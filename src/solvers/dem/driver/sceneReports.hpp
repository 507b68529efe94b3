/*  What an interval of steps has brought, and which particle made a guard fire.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include <sstream>
#include "solvers/dem/driver/sleepers.hpp"

namespace riprap
{

static constexpr const char* passingCure =
    ": it passes through what it meets; take a shorter step, and contacts that are stiff enough "
    "for this speed";

template<class Backend, int D, class P>
class SceneReports
{
public:

    using real = typename P::real;

    DemReport last;

    SceneReports(DemParts<Backend, D, P>& parts, RankedSolids<Backend, D, P>& ranks,
        Neighbours<Backend, D, P>& neighbours, Sleepers<Backend, D, P>& sleepers)
        : p_(parts), ranks_(ranks), neighbours_(neighbours), sleepers_(sleepers)
    {}

    //- What was done since a step, after the last one
    void finish(DemReport&, std::int64_t before);

private:

    void collectEscaped(DemReport&);
    void collectPassed(DemReport&);
    void findOffender(DemReport&);
    void findOffenderOfRanks(DemReport&);
    void describeOffender(DemReport&, int worst, double offence);
    std::vector<double> offences(int n);

    DemParts<Backend, D, P>& p_;
    RankedSolids<Backend, D, P>& ranks_;
    Neighbours<Backend, D, P>& neighbours_;
    Sleepers<Backend, D, P>& sleepers_;
};

template<class Backend, int D, class P>
void SceneReports<Backend, D, P>::finish(DemReport& report, std::int64_t before)
{
    if (p_.clock.now.needRebuild && p_.clock.now.halt == DemHalt::none)
    {
        neighbours_.adaptSkin();
        neighbours_.rebuild();
        ++report.rebuilds;
        p_.clock.read();
        if (p_.sleeps()) sleepers_.check(false);
    }
    report.time = p_.clock.now.time;
    report.lastTimeStep = p_.clock.now.dt;
    report.steps = p_.clock.now.step - before;
    report.totalSteps = p_.clock.now.step;
    report.maxSpeed = neighbours_.largestSpeed();
    report.brokenBonds = ranks_.others ? ranks_.bonds.broken() : p_.bonds.broken();
    report.asleep = p_.sleeps() ? sleepers_.asleep() : 0;
    collectEscaped(report);
    collectPassed(report);
    if (p_.clock.now.halt != DemHalt::none) findOffender(report);
}

//- Particles that left: sorted to the end by the last rebuild, reported once
template<class Backend, int D, class P>
void SceneReports<Backend, D, P>::collectEscaped(DemReport& report)
{
    if (ranks_.others)
    {
        report.particles = std::size_t(ranks_.others->total());
        report.escaped.swap(ranks_.escaped);
        report.escapedId.swap(ranks_.escapedId);
        ranks_.others->work(false);
        const ParticleExchange::Counts& c = ranks_.others->counts();
        const PieceOwners& owners = ranks_.others->owners();
        report.rank = DemRankReport{std::size_t(ranks_.others->ownedHere()),
            std::size_t(ranks_.others->ghostsHere()), c.arrivals, c.divisions,
            c.bytesShared + p_.clumps.share.bytes, c.bytesMigrating, owners.unevenBefore(),
            owners.unevenAfter(), owners.atWork()};
        return;
    }
    const int active = p_.order.active();
    report.particles = active;
    if (active >= p_.particles.reported) return;
    const std::vector<double> x = p_.particles.positions(p_.particles.reported);
    const auto key = p_.particles.template field<std::int32_t>(p_.particles.at.id);
    for (int i = active; i < p_.particles.reported; ++i)
    {
        report.escaped.push_back(Vector3{{x[3*i], x[3*i + 1], x[3*i + 2]}});
        report.escapedId.push_back(p_.particles.ids[key[i]]);
    }
    p_.particles.reported = active;
}

//- Particles that have gone through walls since the last report
template<class Backend, int D, class P>
void SceneReports<Backend, D, P>::collectPassed(DemReport& report)
{
    if (!p_.walls.surfaces) return;
    const WallPassings passed = p_.walls.passed.download()[0];
    const std::int64_t count = passed.count + ranks_.passedBefore;
    if (!count) return;
    report.passedWalls = std::size_t(count);
    report.passedId = ranks_.passedBefore ? ranks_.passedIdBefore : p_.particles.ids[passed.key];
    ranks_.passedBefore = 0;
    p_.walls.clearPassed(p_.particles.n);
}

//- The way of particle i in the last step, of its radius, which the guard tested. No number:
//  infinity
template<class Backend, int D, class P>
std::vector<double> SceneReports<Backend, D, P>::offences(int n)
{
    std::vector<double> value(n, 0.0);
    const auto radius = p_.particles.template field<real>(p_.particles.at.radius);
    for (int d = 0; d < D; ++d)
    {
        const auto v = p_.particles.template field<double>(p_.particles.at.v + d);
        for (int i = 0; i < n; ++i)
        {
            const double way = v[i]*p_.clock.now.dt/double(radius[i]);
            value[i] += std::isfinite(v[i]) ? way*way : std::numeric_limits<double>::infinity();
        }
    }
    for (double& w : value) w = std::sqrt(w);
    return value;
}

//- Which particle made a guard fire, and why: "particle 7 at .. " goes before it
template<class Backend, int D, class P>
void SceneReports<Backend, D, P>::findOffender(DemReport& report)
{
    if (p_.clock.now.halt == DemHalt::wallTooFar)
    {
        report.stop = DemStop::tooFast;
        std::ostringstream s;
        s.precision(6);
        s << "a wall goes farther in a step of " << p_.clock.now.dt
          << " s than the radius of the smallest particle, " << p_.reach.radii.smallest << " m"
          << passingCure;
        report.stopMessage = s.str();
        return;
    }
    if (ranks_.others) return findOffenderOfRanks(report);
    const int n = p_.order.active();
    const std::vector<double> offence = offences(n);
    if (n == 0) return;
    const int worst = int(std::max_element(offence.begin(), offence.end()) - offence.begin());
    describeOffender(report, worst, offence[worst]);
}

//- A guard has fired: the rank of the worst particle says which it is, and all report it
template<class Backend, int D, class P>
void SceneReports<Backend, D, P>::findOffenderOfRanks(DemReport& report)
{
    Transport& ranks = *p_.set.config.ranks;
    const int n = p_.order.active();
    const std::vector<double> offence = offences(n);
    int worst = -1;
    for (int i = 0; i < n; ++i)
        if (!ranks_.ghost(i) && (worst < 0 || offence[i] > offence[worst])) worst = i;
    const double here = worst < 0 ? -1 : offence[worst], most = ranks_.largest(here);
    const int speaker = ranks.size()
        - int(ranks_.largest(here == most ? ranks.size() - ranks.rank() : 0));
    std::vector<RankBytes> out(ranks.size()), in;
    if (ranks.rank() == speaker && worst >= 0)
    {
        describeOffender(report, worst, offence[worst]);
        RankBytes said;
        putValues(said, &report.stop);
        putValues(said, &report.stopId);
        putValues(said, report.stopPosition.data(), 3);
        putValues(said, &report.stopValue);
        putValues(said, report.stopMessage.data(), report.stopMessage.size());
        out.assign(ranks.size(), said);
    }
    ranks.exchange(out, in);
    if (ranks.rank() == speaker || in[speaker].empty()) return;
    const unsigned char* from = in[speaker].data();
    const unsigned char* const end = from + in[speaker].size();
    takeValues(from, &report.stop);
    takeValues(from, &report.stopId);
    takeValues(from, report.stopPosition.data(), 3);
    takeValues(from, &report.stopValue);
    report.stopMessage.assign(reinterpret_cast<const char*>(from), std::size_t(end - from));
}

//- offence: as offences() has it
template<class Backend, int D, class P>
void SceneReports<Backend, D, P>::describeOffender(DemReport& report, int worst, double offence)
{
    std::ostringstream s;
    s.precision(6);
    const std::vector<double> x = p_.particles.positions(worst + 1);
    double speed2 = 0;
    for (int d = 0; d < D; ++d)
    {
        const double v = p_.particles.template field<double>(p_.particles.at.v + d)[worst];
        speed2 += v*v;
    }
    report.stopId =
        p_.particles.ids[p_.particles.template field<std::int32_t>(p_.particles.at.id)[worst]];
    report.stopPosition = Vector3{{x[3*worst], x[3*worst + 1], x[3*worst + 2]}};
    report.stopValue = std::isfinite(offence) ? std::sqrt(speed2)
                                              : std::numeric_limits<double>::infinity();
    report.stop = !std::isfinite(offence) ? DemStop::notANumber : DemStop::tooFast;
    if (report.stop == DemStop::notANumber) s << "has a velocity that is not a number";
    else
    {
        const double radius = double(
            p_.particles.template field<real>(p_.particles.at.radius)[worst]);
        s << "goes " << offence*radius << " m in a step of " << p_.clock.now.dt << " s, at "
          << report.stopValue << " m/s, and ";
        if (p_.reach.driven)
            s << "lists of neighbours reach " << double(p_.reach.halfSkin)
              << " m: the fluid's blow on it is too hard for this time step";
        else s << "its radius is " << radius << " m" << passingCure;
    }
    report.stopMessage = s.str();
}

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/ranks/rankCosts.hpp"
#include <algorithm>
#include <chrono>
#include "core/ranks/joinRanks.hpp"

namespace riprap
{

RankCosts::RankCosts(Transport& transport, std::function<double()> clock)
    : transport_(transport), clock_(std::move(clock))
{
    if (clock_) return;
    clock_ = []
    {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration<double>(now).count();
    };
}

void RankCosts::takeTime()
{
    const double now = clock_(), waited = transport_.seconds();
    if (on_)
    {
        const double worked = now - last_ - (waited - waitedBefore_);
        seconds_ += std::max(worked, 0.0);
        all_ += std::max(worked, 0.0);
    }
    last_ = now;
    waitedBefore_ = waited;
}

void RankCosts::work(bool on)
{
    takeTime();
    on_ = on;
}

bool RankCosts::measure(std::int64_t particles)
{
    takeTime();
    particles_ += double(particles);
    std::vector<double> all{seconds_, particles_};
    join(transport_, all);
    const std::size_t ranks = all.size()/2;
    double seconds = 0, sum = 0;
    for (std::size_t r = 0; r < ranks; ++r) { seconds += all[2*r]; sum += all[2*r + 1]; }
    if (!(seconds >= enough*double(ranks)) || !(sum > 0)) return false;
    perParticle_.assign(ranks, 1.0);
    for (std::size_t r = 0; r < ranks; ++r)
        if (all[2*r + 1] > 0 && all[2*r] > 0)
            perParticle_[r] = all[2*r]/all[2*r + 1]*(sum/seconds);
    seconds_ = particles_ = 0;
    return true;
}

} // namespace riprap

/*  What a particle of each rank costs: the time that the rank is at work on its particles, without
    waiting for others. Bricks that follow it are even in time, where numbers of particles are not
    (walls, contacts, dense and thin parts, processors of unequal speed).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <functional>
#include "core/ranks/transport.hpp"

namespace riprap
{

class RankCosts
{
public:

    //- clock: seconds since any moment; empty: the machine's
    explicit RankCosts(Transport&, std::function<double()> clock = {});

    //- Steps begin, or have ended: what a rank does besides is no cost of its particles
    void work(bool on);

    //- Of all ranks, with the particles of this one until now. \return whether they have worked for
    //  long enough since the last time that it was true: then it is known what a particle costs
    bool measure(std::int64_t particles);

    //- Of a particle of each rank, 1 in the mean; the same numbers on all ranks
    const std::vector<double>& perParticle() const { return perParticle_; }
    double atWork() const { return all_; }          // [s] of this rank, all in all

    //- [s] of work, in the mean of all ranks, after which measure() says what it has found: many
    //  steps, so that what else a machine does is a small part of it
    static constexpr double enough = 0.2;

private:

    void takeTime();

    Transport& transport_;
    std::function<double()> clock_;
    bool on_ = false;
    double last_ = 0, waitedBefore_ = 0, all_ = 0;
    double seconds_ = 0, particles_ = 0;            // since the last result; particles: a sum
    std::vector<double> perParticle_;
};

} // namespace riprap

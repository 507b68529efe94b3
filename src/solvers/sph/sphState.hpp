/*  SphSolver: the exact state as words, so that a run continues bit for bit.

    Layout (32-bit words): magic, version, dimensions, bytes of real, backend, particles, fields,
    lanes, steps a cycle, bytes of the clock, walls, wall fields, fit of the cycle, solids; the
    clock; the energy of changes of the speed of sound; each field in the device's order; those of
    moving walls; of the solids that have not left ids, velocity, acceleration and force
    (interpolated: that of the step before, too), and the state of their own scene, its length
    before it; a checksum (FNV-1a over all words before it).

    Of several ranks the first is sent all fields while the state is saved: the words are those of
    one process, and any number of ranks goes on with them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include "solvers/sph/sphSolver.hpp"
#include "solvers/checkpointWords.hpp"

namespace riprap
{

namespace detail
{

static constexpr std::int32_t stateMagic = 0x72697031, stateVersion = 8;
static constexpr int stateHeader = 14;

[[noreturn]] inline void refuseState(const std::string& why)
{
    throw std::invalid_argument("saved state: " + why);
}

//- Is it a whole state of such a scene? least: words
inline void requireState(const std::vector<std::int32_t>& words, std::size_t least, int dimensions,
    std::size_t real, bool gpu)
{
    if (words.size() < least) refuseState("too short");
    if (words[0] != stateMagic) refuseState("not a riprap state");
    if (words[1] != stateVersion)
        refuseState("version " + std::to_string(words[1]) + " is not supported");
    if (checksum(words, words.size() - 1) != words.back())
        refuseState("checksum does not match: the data are damaged");
    if (words[2] != dimensions) refuseState("it is of " + std::to_string(words[2]) + " dimensions");
    if (words[3] != int(real)) refuseState("it was written with another precision");
    if (words[4] != int(gpu)) refuseState("it was written on another kind of device");
}

} // namespace detail

//- By key, -1 of those that have left; and the keys of the others, ascending
template<class Backend, int D, class P>
std::vector<std::int32_t> SphSolver<Backend, D, P>::solidIds(std::vector<int>& there)
{
    std::vector<std::int32_t> ids(nSolids_, -1);
    if (!solids_) return ids;
    const std::vector<std::int32_t> keys = solids_->order(), id = solidScene_->motion().id;
    for (std::size_t i = 0; i < keys.size(); ++i) ids[keys[i]] = id[i];
    for (int key = 0; key < nSolids_; ++key) if (ids[key] >= 0) there.push_back(key);
    return ids;
}

template<class Backend, int D, class P>
std::vector<std::int32_t> SphSolver<Backend, D, P>::saveState()
{
    readClock();
    const int n = ranks_ ? int(ranks_->particles().total()) : activeFluid();
    double stiffening = stiffening_;
    if (ranks_) ranks_->sum(host_, stiffening);
    std::vector<int> there;
    const std::vector<std::int32_t> ids = solidIds(there);
    std::vector<std::int32_t> words{detail::stateMagic, detail::stateVersion, D, int(sizeof(real)),
        int(Backend::gpu), n, fluid_.fields(), shift_, cycle_.steps, int(sizeof(ClockData)),
        nBodies_ ? nWalls_ : 0, nBodies_ ? wall_.fields() : 0, int(cycle_.fitted) + 2*cycle_.full,
        int(there.size())};
    detail::appendBytes(words, &host_, sizeof(ClockData));
    detail::appendBytes(words, &stiffening, sizeof(stiffening));
    std::size_t expected = words.size() + 1;
    for (int f = 0; f < fluid_.fields(); ++f)
        expected += (std::size_t(n)*fluid_.elementBytes(f) + 3)/4;
    const bool here = !ranks_ || ranks_->first();
    if (here) words.reserve(expected);
    const auto append = [&](FieldSet<Backend>& set, int count)
    {
        for (int f = 0; f < set.fields(); ++f)
        {
            const std::size_t at = words.size(), bytes = std::size_t(count)*set.elementBytes(f);
            if (here) words.resize(at + (bytes + 3)/4, 0);
            if (ranks_) ranks_->gather(set, f, words.data() + at);
            else if (count) context_.toHost(&words[at], set.bytes(f), bytes);
        }
    };
    append(fluid_, n);
    if (nBodies_) append(wall_, nWalls_);
    if (solids_)
    {
        for (const int key : there) words.push_back(ids[key]);
        for (const auto* a :
            {&solidVelocity_, &solidAcceleration_, &solidForce_, &solidForceBefore_})
        {
            if (!a->size()) continue;
            const std::vector<real> all = a->download();
            std::vector<real> values;
            for (const int key : there)
                values.insert(
                    values.end(), &all[std::size_t(key)*D], &all[std::size_t(key)*D] + D);
            detail::appendBytes(words, values.data(), values.size()*sizeof(real));
        }
        const std::vector<std::int32_t> own = solidScene_->saveState();
        words.push_back(std::int32_t(std::uint32_t(own.size())));
        words.insert(words.end(), own.begin(), own.end());
    }
    if (ranks_) readClock();
    if (!here) return {};
    words.push_back(detail::checksum(words, words.size()));
    return words;
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::loadState(const std::vector<std::int32_t>& given)
{
    const std::vector<std::int32_t> received = ranks_ ? ranks_->ofFirst(given)
                                                      : std::vector<std::int32_t>();
    const std::vector<std::int32_t>& words = ranks_ ? received : given;
    const auto fail = detail::refuseState;
    const std::size_t clockWords = (sizeof(ClockData) + 3)/4, energyWords = sizeof(stiffening_)/4;
    detail::requireState(
        words, detail::stateHeader + clockWords + energyWords + 1, D, sizeof(real), Backend::gpu);
    if (words[6] != fluid_.fields()) fail("it has other fields (models were switched on or off)");
    if (words[9] != int(sizeof(ClockData))) fail("it was written by another version");
    if (words[10] != (nBodies_ ? nWalls_ : 0) || words[11] != (nBodies_ ? wall_.fields() : 0))
        fail("it has other moving walls");
    if (words[13] != nSolids_)
        fail("it is of " + std::to_string(words[13]) + " solid particles, the case of "
            + std::to_string(nSolids_));
    const int n = words[5], most = ranks_ ? int(ranks_->particles().total()) : n_;
    if (n < 0 || n > most)
        fail("it holds " + std::to_string(n) + " particles, the case " + std::to_string(most));
    std::size_t at = detail::stateHeader + clockWords + energyWords, expected = at + 1;
    for (int f = 0; f < fluid_.fields(); ++f)
        expected += (std::size_t(n)*fluid_.elementBytes(f) + 3)/4;
    for (int f = 0; f < words[11]; ++f)
        expected += (std::size_t(nWalls_)*wall_.elementBytes(f) + 3)/4;
    const std::size_t solidsAt = expected - 1,
                      solidWords = (std::size_t(nSolids_)*D*sizeof(real) + 3)/4;
    if (solids_)
    {
        expected += nSolids_ + (solidForceBefore_.size() ? 4 : 3)*solidWords + 1;
        if (expected > words.size()) fail("wrong length");
        expected += std::uint32_t(words[expected - 2]);
    }
    if (expected != words.size()) fail("wrong length");
    if (solids_) loadSolids(words, solidsAt);

    std::memcpy(static_cast<void*>(&host_), &words[detail::stateHeader], sizeof(ClockData));
    std::memcpy(&stiffening_, &words[detail::stateHeader + clockWords], sizeof(stiffening_));
    const auto take = [&](FieldSet<Backend>& set, int count)
    {
        for (int f = 0; f < set.fields(); ++f)
        {
            const std::size_t bytes = std::size_t(count)*set.elementBytes(f);
            if (count) context_.toDevice(set.bytes(f), &words[at], bytes);
            at += (bytes + 3)/4;
        }
    };
    if (ranks_) setCapacity(n);
    take(fluid_, n);
    if (nBodies_) take(wall_, nWalls_);
    n_ = reported_ = n;
    shift_ = words[7];
    cycle_.steps = words[8];
    cycle_.fitted = words[12] & 1;
    cycle_.full = words[12]/2;
    // memory laid out by the number of particles
    fluidReference_.allocate(context_, std::size_t(n_)*D);
    fluidSort_.allocate(context_, n_, grid_.cells);
    if (solids_) allocateAction();
    if constexpr (Backend::gpu)
    {
        parts_.graphs.recorded = false;
        allocateLists();
    }
    if (ranks_) ranks_->begin(host_, stiffening_);
    writeClock();
    rebuild();
    if (ranks_) fitCapacity();
    context_.synchronise();
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::loadSolids(const std::vector<std::int32_t>& words, std::size_t at)
{
    std::vector<int> there;
    const std::vector<std::int32_t> ids = solidIds(there);
    std::map<std::int32_t, int> keyOf;
    for (const int key : there) keyOf[ids[key]] = key;
    std::vector<int> keys(nSolids_);
    for (int i = 0; i < nSolids_; ++i)
    {
        const auto found = keyOf.find(words[at + i]);
        if (found == keyOf.end())
            throw std::invalid_argument("saved state: it is of other solid particles");
        keys[i] = found->second;
        keyOf.erase(found);
    }
    at += nSolids_;
    for (auto* a : {&solidVelocity_, &solidAcceleration_, &solidForce_, &solidForceBefore_})
    {
        if (!a->size()) continue;
        std::vector<real> values(std::size_t(nSolids_)*D), all(values.size());
        std::memcpy(values.data(), &words[at], values.size()*sizeof(real));
        for (int i = 0; i < nSolids_; ++i)
            std::copy_n(&values[std::size_t(i)*D], D, &all[std::size_t(keys[i])*D]);
        context_.toDevice(a->data(), all.data(), all.size()*sizeof(real));
        at += (all.size()*sizeof(real) + 3)/4;
    }
    const std::vector<std::int32_t> own(
        words.begin() + at + 1, words.begin() + at + 1 + std::uint32_t(words[at]));
    solidScene_->loadState(own);
    showForces();
}

} // namespace riprap

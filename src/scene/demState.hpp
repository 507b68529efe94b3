/*  DemSolver: the exact state as words, so that a run continues bit for bit.

    Neighbours are sought anew before saving, so that the saving scene and the loading one go on with the same lists. Layout (32-bit
    words): magic, version, dimensions, bytes of real, backend, histories, particles with memory, in the scene, fields, bonds,
    clumps, walls, entries of contact lists, of walls; the clock; then arrays; a checksum (FNV-1a over all words before it).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "scene/demSolver.hpp"

namespace riprap
{

namespace detail
{

static constexpr std::int32_t demMagic = 0x72697064, demVersion = 1;

inline std::int32_t demChecksum(const std::vector<std::int32_t>& words, std::size_t n)
{
    std::uint32_t h = 2166136261u;
    for (std::size_t i = 0; i < n; ++i) h = (h ^ std::uint32_t(words[i]))*16777619u;
    return std::int32_t(h);
}

//- Appends device memory to the words, or fills it from them
template<class Context>
struct StateWriter
{
    Context& context;
    std::vector<std::int32_t>& words;

    void operator()(const void* data, std::size_t bytes)
    {
        const std::size_t at = words.size();
        words.resize(at + (bytes + 3)/4, 0);
        if (bytes) context.toHost(&words[at], data, bytes);
    }
};

template<class Context>
struct StateReader
{
    Context& context;
    const std::vector<std::int32_t>& words;
    std::size_t at;

    void operator()(void* data, std::size_t bytes)
    {
        const std::size_t next = at + (bytes + 3)/4;
        if (next + 1 > words.size()) throw std::invalid_argument("saved state: wrong length");
        if (bytes) context.toDevice(data, &words[at], bytes);
        at = next;
    }
};

} // namespace detail

//- What does not follow from positions: contacts' histories, bonds, clumps, walls
template<class Backend, int D, class P>
template<class F>
void DemSolver<Backend, D, P>::forEachMemory(F f)
{
    const ContactListView<Backend, real> list = list_.view();
    const std::size_t entries = list_.entries();
    f(list.entry, entries*sizeof(std::uint32_t));
    if (Backend::gpu) for (int c = 0; c < histories_; ++c) f(list.history + c*list.stride, entries*sizeof(real));
    else f(list.history, entries*list.historyWords(histories_)*sizeof(real));
    if (nBonds_)
    {
        f(bondRest_.data(), nBonds_*sizeof(double));
        f(bondBroken_.data(), nBonds_*sizeof(std::int32_t));
        f(bondHistory_.data(), std::size_t(nBonds_)*bondHistory<D>*sizeof(real));
        f(bondForce_.data(), nBonds_*sizeof(BondForce<D, real>));
    }
    if (nClumps_) f(clumps_.data(), nClumps_*sizeof(ClumpData));
    if (!nWalls_) return;
    f(walls_.data(), nWalls_*sizeof(WallData));
    const std::size_t slots = std::size_t(wallMemory_.entries)*wallTouches;
    f(wallMemory_.on.data(), slots*sizeof(int));
    f(wallMemory_.normal.data(), slots*D*sizeof(real));
    f(wallMemory_.history.data(), slots*histories_*sizeof(real));
    f(wallMemory_.force.data(), std::size_t(wallMemory_.entries)*wallWords<D>*sizeof(real));
}

template<class Backend, int D, class P>
std::vector<std::int32_t> DemSolver<Backend, D, P>::saveState()
{
    rebuild();
    readClock();
    host_.windowEnd = -1e300;               // motions are sampled anew, by both
    writeClock();
    const int n = activeSolids();
    std::vector<std::int32_t> words
    {
        detail::demMagic, detail::demVersion, D, int(sizeof(real)), int(Backend::gpu), histories_, int(input_.particles.size()),
        n, fields_.fields(), nBonds_, nClumps_, nWalls_, int(list_.entries()), wallMemory_.entries
    };
    detail::StateWriter<Context<Backend>> write{context_, words};
    write(clock_.data(), sizeof(DemClockData));
    for (int f = 0; f < fields_.fields(); ++f) write(fields_.bytes(f), std::size_t(n_)*fields_.elementBytes(f));
    forEachMemory(write);
    words.push_back(detail::demChecksum(words, words.size()));
    return words;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::loadState(const std::vector<std::int32_t>& words)
{
    const auto fail = [](const std::string& why) { throw std::invalid_argument("saved state: " + why); };
    constexpr std::size_t header = 14;
    if (words.size() < header + sizeof(DemClockData)/4 + 1) fail("too short");
    if (words[0] != detail::demMagic) fail("not a state of riprap's solids");
    if (words[1] != detail::demVersion) fail("version " + std::to_string(words[1]) + " is not supported");
    if (detail::demChecksum(words, words.size() - 1) != words.back()) fail("checksum does not match: the data are damaged");
    if (words[2] != D) fail("it is of " + std::to_string(words[2]) + " dimensions");
    if (words[3] != int(sizeof(real))) fail("it was written with another precision");
    if (words[4] != int(Backend::gpu)) fail("it was written on another kind of device");
    if (words[5] != histories_ || words[8] != fields_.fields()) fail("it has other fields (models were switched on or off)");
    if (words[6] != n_) fail("it is of " + std::to_string(words[6]) + " particles, the case of " + std::to_string(n_));
    if (words[9] != nBonds_ || words[10] != nClumps_ || words[11] != nWalls_) fail("it has other bonds, clumps or walls");
    detail::StateReader<Context<Backend>> read{context_, words, header};
    read(clock_.data(), sizeof(DemClockData));
    for (int f = 0; f < fields_.fields(); ++f) read(fields_.bytes(f), std::size_t(n_)*fields_.elementBytes(f));
    // those that had left stay behind, as they were
    context_.toDevice(const_cast<int*>(sort_.active()), &words[7], sizeof(int));
    reported_ = words[7];
    restoreNeighbours(read, words[12], words[13]);
    readClock();
    host_.fullDt = plan_.timeStep;
    host_.needRebuild = 0;
    writeClock();
    context_.synchronise();
}

//- Lists of the restored positions, then what contacts remember
template<class Backend, int D, class P>
template<class Reader>
void DemSolver<Backend, D, P>::restoreNeighbours(Reader& read, int entries, int wallEntries)
{
    const auto check = [](bool good)
    { if (!good) throw std::invalid_argument("saved state: its contacts do not fit (another skin, or walls elsewhere)"); };
    // bonds and walls' poses stand behind the lists of contacts in the words: read them ahead
    Reader ahead = read;
    ahead.at += std::size_t(entries) + (Backend::gpu ? std::size_t(histories_)*((entries*sizeof(real) + 3)/4)
        : (std::size_t(entries)*ContactListView<Backend, real>::historyWords(histories_)*sizeof(real) + 3)/4);
    if (nBonds_)
    {
        ahead(bondRest_.data(), nBonds_*sizeof(double));
        ahead(bondBroken_.data(), nBonds_*sizeof(std::int32_t));
        ahead(bondHistory_.data(), std::size_t(nBonds_)*bondHistory<D>*sizeof(real));
        ahead(bondForce_.data(), nBonds_*sizeof(BondForce<D, real>));
    }
    if (nClumps_) ahead(clumps_.data(), nClumps_*sizeof(ClumpData));
    if (nWalls_) ahead(walls_.data(), nWalls_*sizeof(WallData));
    rebuild(true);
    check(int(list_.entries()) == entries && wallMemory_.entries == wallEntries);
    forEachMemory(read);
}

} // namespace riprap

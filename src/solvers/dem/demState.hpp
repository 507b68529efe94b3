/*  DemSolver: the exact state as words, so that a run continues bit for bit.

    Neighbours are sought anew before saving, so that the saving scene and the loading one go on with the same lists. A scene that
    particles have left is loaded by one that was made of those that stayed: particles are known by their ids, and cells are those
    of the saving scene, whose skin may come from a particle that is no more. Of several ranks the first has all particles while the
    state is saved or loaded: the words are those of one process, so any number of ranks goes on with them. Layout (32-bit words): magic, version, dimensions,
    bytes of real, backend, histories, particles, fields, bonds, clumps, walls, entries of contact lists, of walls; the clock; the
    search; ids; then arrays; a checksum (FNV-1a over all words before it).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/demSolver.hpp"

namespace riprap
{

namespace detail
{

static constexpr std::int32_t demMagic = 0x72697064, demVersion = 4;

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

//- Bonds with both ends in the scene, in order: a scene of those that stayed has them too
template<class Backend, int D, class P>
std::vector<int> DemSolver<Backend, D, P>::keptBonds()
{
    std::vector<int> kept;
    if (!nBonds_) return kept;
    const auto slotOf = slotOf_.download(), a = bondIds_[0].download(), b = bondIds_[1].download();
    for (int k = 0; k < nBonds_; ++k) if (slotOf[a[k]] >= 0 && slotOf[b[k]] >= 0) kept.push_back(k);
    return kept;
}

//- Histories lie in rows over all entries, so many numbers of an entry together in each
template<class Backend, int D, class P>
std::size_t DemSolver<Backend, D, P>::historyTogether() const
{
    using List = ContactListView<Backend, real>;
    return Backend::gpu ? List::wordsTogether(histories_) : List::historyWords(histories_);
}

template<class Backend, int D, class P>
std::size_t DemSolver<Backend, D, P>::historyRows() const
{
    const std::size_t together = historyTogether();
    return together ? ContactListView<Backend, real>::historyWords(histories_)/together : 0;
}

//- f(array, numbers a bond) for what bonds remember
template<class Backend, int D, class P>
template<class F>
void DemSolver<Backend, D, P>::forEachBondMemory(const std::vector<int>& kept, F f)
{
    if (kept.empty()) return;
    f(bondRest_, 1);
    f(bondBroken_, 1);
    f(bondHistory_, bondHistory<D>);
    f(bondForce_, 1);
}

//- What does not follow from positions: contacts' histories, clumps, walls
template<class Backend, int D, class P>
template<class F>
void DemSolver<Backend, D, P>::forEachMemory(F f)
{
    const ContactListView<Backend, real> list = list_.view();
    const std::size_t entries = list_.entries();
    f(list.entry, entries*sizeof(std::uint32_t));
    const std::size_t together = historyTogether(), rows = historyRows();
    for (std::size_t q = 0; q < rows; ++q) f(list.history + q*list.stride*together, entries*together*sizeof(real));
    if (!nWalls_) return;
    f(walls_.data(), nWalls_*sizeof(WallData));
    const std::size_t slots = std::size_t(wallMemory_.entries)*wallTouches;
    f(wallMemory_.on.data(), slots*sizeof(int));
    f(wallMemory_.normal.data(), slots*D*sizeof(real));
    f(wallMemory_.history.data(), slots*histories_*sizeof(real));
    f(wallMemory_.force.data(), std::size_t(wallMemory_.entries)*wallWords<D>*sizeof(real));
}

//- What fills up blocks of entries, and histories of what does not touch, are whatever was there before: the same state of n particles shall be the same words
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::clearUnused(std::vector<std::int32_t>& words, std::size_t at, int n) const
{
    using List = ContactListView<Backend, real>;
    const std::size_t entries = list_.entries(), each = sizeof(real)/4, entry = at;
    const auto clear = [&](std::size_t from, std::size_t reals) { std::fill_n(words.begin() + from, reals*each, 0); };
    const auto free = [&](std::size_t e) { return !(std::uint32_t(words[entry + e]) & List::touching); };
    if (Backend::gpu)
    {
        const std::vector<char> used = list_.used(n);
        for (std::size_t e = 0; e < entries; ++e) if (!used[e]) words[entry + e] = 0;
    }
    at += entries;
    const std::size_t together = historyTogether(), rows = historyRows();
    for (std::size_t q = 0; q < rows; ++q, at += entries*together*each)
        for (std::size_t e = 0; e < entries; ++e) if (free(e)) clear(at + e*together*each, together);
    if (!nWalls_) return;
    at += nWalls_*sizeof(WallData)/4;
    const std::size_t slots = std::size_t(wallMemory_.entries)*wallTouches, on = at;
    at += slots;
    for (const int numbers : {D, histories_})
    {
        for (std::size_t s = 0; s < slots; ++s) if (!words[on + s]) clear(at + s*numbers*each, numbers);
        at += slots*numbers*each;
    }
}

//- Marks of ghosts are not part of a state
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::isSaved(int f) const { return f != calmField_ || sleeps(); }

template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::savedFields() const
{
    int n = 0;
    for (int f = 0; f < fields_.fields(); ++f) n += isSaved(f);
    return n;
}

template<class Backend, int D, class P>
std::vector<std::int32_t> DemSolver<Backend, D, P>::saveState()
{
    if (!others_)
    {
        rebuild();
        return stateWords();
    }
    others_->gatherOn(0);
    rebuild();
    std::vector<std::int32_t> words = stateWords();
    if (config_.ranks->rank() != 0) words.clear();
    others_->gatherOn(-1);
    rebuild();
    return words;
}

//- Of all particles here, which have just been sorted
template<class Backend, int D, class P>
std::vector<std::int32_t> DemSolver<Backend, D, P>::stateWords()
{
    readClock();
    searchedAt_ = host_.step;
    host_.windowEnd = -1e300;               // motions are sampled anew, by both
    writeClock();
    const int n = activeSolids();
    const std::vector<int> kept = keptBonds();
    std::vector<std::int32_t> words
    {
        detail::demMagic, detail::demVersion, D, int(sizeof(real)), int(Backend::gpu), histories_, n, savedFields(),
        int(kept.size()), nClumps_, nWalls_, int(list_.entries()), wallMemory_.entries
    };
    // Room for most of it, without which it would be copied again and again
    std::size_t expected = words.size() + n + (sizeof(DemClockData) + sizeof(DemSearchState))/4 + 1024;
    for (int f = 0; f < fields_.fields(); ++f) if (isSaved(f)) expected += (std::size_t(n)*fields_.elementBytes(f) + 3)/4;
    forEachMemory([&](const void*, std::size_t bytes) { expected += (bytes + 3)/4; });
    if (nClumps_) expected += (nClumps_*sizeof(ClumpData) + 3)/4 + 6*std::size_t(n);
    words.reserve(expected);
    const auto append = [&](const void* data, std::size_t bytes)
    {
        const std::size_t at = words.size();
        words.resize(at + (bytes + 3)/4, 0);
        if (bytes) std::memcpy(&words[at], data, bytes);
    };
    detail::StateWriter<Context<Backend>> write{context_, words};
    write(clock_.data(), sizeof(DemClockData));
    DemSearchState search;
    search.radii = radii_;
    search.skin = skin_;
    for (int d = 0; d < D; ++d) { search.lower[d] = box_.lower[d]; search.length[d] = box_.length[d]; }
    append(&search, sizeof(search));
    const auto key = field<std::int32_t>(idField_);
    for (int i = 0; i < n; ++i) words.push_back(ids_[key[i]]);
    for (int f = 0; f < fields_.fields(); ++f)
    {
        // keys count particles of this scene alone
        if (f == idField_) words.resize(words.size() + n, 0);
        else if (isSaved(f)) write(fields_.bytes(f), std::size_t(n)*fields_.elementBytes(f));
    }
    forEachBondMemory(kept, [&](auto& array, int numbers)
    {
        const auto all = array.download();
        for (const int k : kept) append(&all[std::size_t(k)*numbers], numbers*sizeof(all[0]));
    });
    if (nClumps_)
    {
        write(clumps_.data(), nClumps_*sizeof(ClumpData));
        const auto offset = offset_.download();
        for (int i = 0; i < n; ++i) append(&offset[3*std::size_t(key[i])], 3*sizeof(double));
    }
    const std::size_t memory = words.size();
    forEachMemory(write);
    clearUnused(words, memory, n);
    words.push_back(detail::demChecksum(words, words.size()));
    return words;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::loadState(const std::vector<std::int32_t>& words)
{
    if (!others_) return takeState(words);
    const std::vector<std::int32_t> all = wordsOfFirst(words);
    collectAll();
    // as one process that has everything, then in parts again
    std::unique_ptr<ParticleExchange> others(std::move(others_));
    takeState(all);
    others_ = std::move(others);
    setPieces();
    others_->begin(n_);
    rebuild();
    setCapacity(others_->residents() + others_->residents()/4 + 256);
    rebuild();
}

//- The first rank's
template<class Backend, int D, class P>
std::vector<std::int32_t> DemSolver<Backend, D, P>::wordsOfFirst(const std::vector<std::int32_t>& words) const
{
    Transport& ranks = *config_.ranks;
    std::vector<RankBytes> out(ranks.size()), in;
    if (ranks.rank() == 0)
    {
        RankBytes bytes;
        putValues(bytes, words.data(), words.size());
        out.assign(ranks.size(), bytes);
    }
    ranks.exchange(out, in);
    std::vector<std::int32_t> all(in[0].size()/sizeof(std::int32_t));
    const unsigned char* from = in[0].data();
    takeValues(from, all.data(), all.size());
    return all;
}

//- Memory for all particles on each rank, and who they are, in the order of ids
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::collectAll()
{
    Transport& ranks = *config_.ranks;
    const auto key = field<std::int32_t>(idField_);
    std::vector<RankBytes> out(ranks.size()), in;
    RankBytes own;
    for (int i = 0; i < others_->residents(); ++i)
    {
        if (ghost(i)) continue;
        const double empty = D == 2 ? emptyCoordinate_[key[i]] : 0;
        putValues(own, &ids_[key[i]]);
        putValues(own, &empty);
    }
    out.assign(ranks.size(), own);
    ranks.exchange(out, in);
    std::map<std::int32_t, double> all;
    for (const RankBytes& bytes : in)
        for (const unsigned char* from = bytes.data(); from < bytes.data() + bytes.size();)
        {
            std::int32_t id;
            double empty;
            takeValues(from, &id);
            takeValues(from, &empty);
            all[id] = empty;
        }
    setCapacity(int(all.size()));
    ids_.clear();
    emptyCoordinate_.clear();
    for (const auto& one : all)
    {
        ids_.push_back(one.first);
        if (D == 2) emptyCoordinate_.push_back(one.second);
    }
    // nobody is a ghost
    fields_.upload(context_, calmField_, std::vector<std::int32_t>(n_, -1));
}

//- As one process that has all particles
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::takeState(const std::vector<std::int32_t>& words)
{
    const auto fail = [](const std::string& why) { throw std::invalid_argument("saved state: " + why); };
    constexpr std::size_t header = 13;
    if (words.size() < header + (sizeof(DemClockData) + sizeof(DemSearchState))/4 + 1) fail("too short");
    if (words[0] != detail::demMagic) fail("not a state of riprap's solids");
    if (words[1] != detail::demVersion) fail("version " + std::to_string(words[1]) + " is not supported");
    if (detail::demChecksum(words, words.size() - 1) != words.back()) fail("checksum does not match: the data are damaged");
    if (words[2] != D) fail("it is of " + std::to_string(words[2]) + " dimensions");
    if (words[3] != int(sizeof(real))) fail("it was written with another precision");
    if (words[4] != int(Backend::gpu)) fail("it was written on another kind of device");
    if (words[5] != histories_ || words[7] != savedFields()) fail("it has other fields (models were switched on or off)");
    const int n = words[6];
    if (n != n_) fail("it is of " + std::to_string(n) + " particles, the case of " + std::to_string(n_));
    if (words[8] != nBonds_ || words[9] != nClumps_ || words[10] != nWalls_) fail("it has other bonds, clumps or walls");
    detail::StateReader<Context<Backend>> read{context_, words, header};
    const auto take = [&](void* data, std::size_t bytes)
    {
        const std::size_t next = read.at + (bytes + 3)/4;
        if (next + 1 > words.size()) fail("wrong length");
        if (bytes) std::memcpy(data, &words[read.at], bytes);
        read.at = next;
    };
    read(clock_.data(), sizeof(DemClockData));
    DemSearchState search;
    take(&search, sizeof(search));
    restoreSearch(search);
    std::vector<std::int32_t> ids(n);
    take(ids.data(), ids.size()*sizeof(std::int32_t));
    for (int f = 0; f < fields_.fields(); ++f) if (isSaved(f)) read(fields_.bytes(f), std::size_t(n)*fields_.elementBytes(f));
    restoreIds(ids);
    std::vector<int> all(nBonds_);
    for (int k = 0; k < nBonds_; ++k) all[k] = k;
    forEachBondMemory(all, [&](auto& array, int numbers)
    {
        auto values = array.download();
        for (int k = 0; k < nBonds_; ++k) take(&values[std::size_t(k)*numbers], numbers*sizeof(values[0]));
        array.upload(context_, values);
    });
    if (nClumps_)
    {
        read(clumps_.data(), nClumps_*sizeof(ClumpData));
        const auto key = field<std::int32_t>(idField_);
        auto offset = offset_.download();
        for (int i = 0; i < n; ++i) take(&offset[3*std::size_t(key[i])], 3*sizeof(double));
        offset_.upload(context_, offset);
    }
    restoreNeighbours(read, words[11], words[12]);
    readClock();
    host_.fullDt = plan_.timeStep;
    host_.needRebuild = 0;
    searchedAt_ = host_.step;
    writeClock();
    context_.synchronise();
}

//- Cells as the saving scene had them
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::restoreSearch(const DemSearchState& s)
{
    bool fits = true;
    for (int d = 0; d < D; ++d)
    {
        const int axis = config_.axes[d];
        const double lo = config_.domainMin[axis], hi = config_.domainMax[axis];
        if (config_.periodic[axis]) fits = fits && lo == s.lower[d] && hi - lo == s.length[d];
        else fits = fits && lo > s.lower[d] && hi < s.lower[d] + s.length[d];
    }
    if (!fits)
        throw std::invalid_argument("saved state: it is of another domain: moving walls reach farther, as with a later endTime, or the mesh has changed");
    const double cell = wallCell();
    radii_ = s.radii;
    for (int d = 0; d < D; ++d) box_.set(d, s.lower[d], s.length[d], config_.periodic[config_.axes[d]]);
    setSkin(config_.skin >= 0 ? leastSkin() : s.skin);
    if (wallCell() != cell) setWalls();
}

//- Whom each row of the state is about, and that all of them are there
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::restoreIds(const std::vector<std::int32_t>& ids)
{
    const int n = int(ids.size());
    const auto fail = [] { throw std::invalid_argument("saved state: it is of other particles"); };
    std::vector<int> keyOf(n ? *std::max_element(ids_.begin(), ids_.end()) + 1 : 0, -1);
    for (int key = 0; key < n; ++key) keyOf[ids_[key]] = key;
    std::vector<std::int32_t> keys(n);
    for (int i = 0; i < n; ++i)
    {
        if (ids[i] < 0 || std::size_t(ids[i]) >= keyOf.size() || keyOf[ids[i]] < 0) fail();
        keys[i] = keyOf[ids[i]];
        keyOf[ids[i]] = -1;
    }
    fields_.upload(context_, idField_, keys);
    context_.toDevice(const_cast<int*>(sort_.active()), &n, sizeof(int));
    reported_ = n;
}

//- Lists of the restored positions, then what contacts remember
template<class Backend, int D, class P>
template<class Reader>
void DemSolver<Backend, D, P>::restoreNeighbours(Reader& read, int entries, int wallEntries)
{
    const auto check = [](bool good)
    { if (!good) throw std::invalid_argument("saved state: its contacts do not fit (another skin, or walls elsewhere)"); };
    // walls' poses stand behind the lists of contacts in the words: read them ahead
    Reader ahead = read;
    ahead.at += std::size_t(entries)*(1 + historyRows()*historyTogether()*sizeof(real)/4);
    if (nWalls_) ahead(walls_.data(), nWalls_*sizeof(WallData));
    rebuild(true, Backend::gpu);
    check(int(list_.entries()) == entries && wallMemory_.entries == wallEntries);
    forEachMemory(read);
}

} // namespace riprap

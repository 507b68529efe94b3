/*  The exact state as words, so that a run continues bit for bit.

    Neighbours are sought anew before saving, so that the saving scene and the loading one go on
    with the same lists. A scene that particles have left is loaded by one that was made of those
    that stayed: particles are known by their ids, and cells are those of the saving scene, whose
    skin may come from a particle that is no more. Of several ranks the first has all particles
    while the state is saved or loaded: the words are those of one process, so any number of ranks
    goes on with them. Layout (32-bit words): magic, version, dimensions, bytes of real, backend,
    histories, particles, fields, bonds, clumps, walls, entries of contact lists, of walls; the
    clock; the search; ids; then arrays; a checksum of all words before it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include "solvers/checkpointWords.hpp"
#include "solvers/dem/driver/neighbours.hpp"

namespace riprap
{

namespace detail
{

static constexpr std::int32_t demMagic = 0x72697064, demVersion = 4;

//- Words behind lists of contacts that stand for nothing. All but entries are counted in words
struct UnusedWords
{
    std::size_t entry = 0, entries = 0;         // of the lists: where they begin, how many
    std::uint32_t touching = 0;
    std::size_t together = 0, rows = 0;         // of their histories: each entry's in a row, rows
    std::size_t walls = 0;                      // that stand between
    std::size_t slots = 0, ofSlot[2] = {0, 0};  // of touched walls, of a normal, of a history
    std::function<std::vector<char>()> used;    // which entries are a particle's; null: all are

    void clear(std::vector<std::int32_t>& words) const
    {
        const auto clear = [&](std::size_t from, std::size_t count)
        { std::fill_n(words.begin() + from, count, 0); };
        const std::vector<char> its = used ? used() : std::vector<char>(entries, 1);
        #pragma omp parallel for schedule(static) if (entries > 10000)
        for (std::size_t e = 0; e < entries; ++e) if (!its[e]) words[entry + e] = 0;
        std::size_t at = entry + entries;
        for (std::size_t q = 0; q < rows; ++q, at += entries*together)
        {
            #pragma omp parallel for schedule(static) if (entries > 10000)
            for (std::size_t e = 0; e < entries; ++e)
                if (!(std::uint32_t(words[entry + e]) & touching))
                    clear(at + e*together, together);
        }
        at += walls;
        const std::size_t on = at;
        at += slots;
        for (const std::size_t numbers : ofSlot)
        {
            for (std::size_t s = 0; s < slots; ++s)
                if (!words[on + s]) clear(at + s*numbers, numbers);
            at += slots*numbers;
        }
    }
};

//- Fills device memory from the words
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

template<class Backend, int D, class P>
class Checkpoint
{
public:

    using real = typename P::real;

    Checkpoint(DemParts<Backend, D, P>& parts, RankedSolids<Backend, D, P>& ranks,
        Neighbours<Backend, D, P>& neighbours)
        : p_(parts), ranks_(ranks), neighbours_(neighbours)
    {}

    Later<std::vector<std::int32_t>> save(bool later);
    void load(const std::vector<std::int32_t>& words);

private:

    using Words = std::vector<std::int32_t>;

    bool isSaved(int field) const;
    int savedFields() const;
    Later<Words> checkpointWords(bool later);
    std::size_t wordsExpected(int n);
    static constexpr std::size_t header = 13;       // words
    void checkHeader(const std::vector<std::int32_t>& words) const;
    void takeState(const std::vector<std::int32_t>& words);
    std::vector<std::int32_t> wordsOfFirst(const std::vector<std::int32_t>& words) const;
    void collectAll();
    template<class F> void forEachMemory(F f);
    std::size_t historyTogether() const;
    std::size_t historyRows() const;
    std::function<void(Words&)> clearUnused(Snapshot<Backend>&, std::size_t at, int n) const;
    void restoreSearch(const DemSearchState&);
    void restoreIds(const std::vector<std::int32_t>& ids);
    template<class Reader> void restoreNeighbours(Reader&, int entries, int wallEntries);

    DemParts<Backend, D, P>& p_;
    RankedSolids<Backend, D, P>& ranks_;
    Neighbours<Backend, D, P>& neighbours_;
};

//- Histories lie in rows over all entries, so many numbers of an entry together in each
template<class Backend, int D, class P>
std::size_t Checkpoint<Backend, D, P>::historyTogether() const
{
    using List = ContactListView<Backend, real>;
    return Backend::gpu ? List::wordsTogether(p_.pairs.histories())
                        : List::historyWords(p_.pairs.histories());
}

template<class Backend, int D, class P>
std::size_t Checkpoint<Backend, D, P>::historyRows() const
{
    const std::size_t together = historyTogether();
    return together ? ContactListView<Backend, real>::historyWords(p_.pairs.histories())/together
                    : 0;
}

//- What does not follow from positions: contacts' histories, clumps, walls
template<class Backend, int D, class P>
template<class F>
void Checkpoint<Backend, D, P>::forEachMemory(F f)
{
    const ContactListView<Backend, real> list = p_.order.list.view();
    const std::size_t entries = p_.order.list.entries();
    f(list.entry, entries*sizeof(std::uint32_t));
    const std::size_t together = historyTogether(), rows = historyRows();
    for (std::size_t q = 0; q < rows; ++q)
        f(list.history + q*list.stride*together, entries*together*sizeof(real));
    if (!p_.walls.count) return;
    f(p_.walls.walls.data(), p_.walls.count*sizeof(WallData));
    const std::size_t slots = std::size_t(p_.walls.memory.entries)*wallTouches;
    f(p_.walls.memory.on.data(), slots*sizeof(int));
    f(p_.walls.memory.normal.data(), slots*D*sizeof(real));
    f(p_.walls.memory.history.data(), slots*p_.pairs.histories()*sizeof(real));
    f(p_.walls.memory.force.data(), std::size_t(p_.walls.memory.entries)*wallWords<D>*sizeof(real));
}

//- What fills up blocks of entries, and histories of what does not touch, are whatever was there
//  before: the same state of n particles shall be the same words. at: where forEachMemory begins
template<class Backend, int D, class P>
std::function<void(std::vector<std::int32_t>&)> Checkpoint<Backend, D, P>::clearUnused(
    Snapshot<Backend>& now, std::size_t at, int n) const
{
    using List = ContactListView<Backend, real>;
    detail::UnusedWords unused;
    unused.entry = at;
    unused.entries = p_.order.list.entries();
    unused.touching = List::touching;
    unused.together = historyTogether()*sizeof(real)/4;
    unused.rows = historyRows();
    if (p_.walls.count)
    {
        unused.walls = p_.walls.count*sizeof(WallData)/4;
        unused.slots = std::size_t(p_.walls.memory.entries)*wallTouches;
        unused.ofSlot[0] = D*sizeof(real)/4;
        unused.ofSlot[1] = p_.pairs.histories()*sizeof(real)/4;
    }
    if (Backend::gpu) unused.used = p_.order.list.used(now, n);
    return [unused](Words& words) { unused.clear(words); };
}

//- Marks of ghosts are not part of a state
template<class Backend, int D, class P> bool Checkpoint<Backend, D, P>::isSaved(int f) const
{
    return f != p_.particles.at.calm || p_.sleeps();
}

template<class Backend, int D, class P>
int Checkpoint<Backend, D, P>::savedFields() const
{
    int n = 0;
    for (int f = 0; f < p_.particles.values.fields(); ++f) n += isSaved(f);
    return n;
}

template<class Backend, int D, class P>
Later<std::vector<std::int32_t>> Checkpoint<Backend, D, P>::save(bool later)
{
    if (!ranks_.others)
    {
        neighbours_.rebuild();
        return checkpointWords(later);
    }
    ranks_.others->gatherOn(0);
    neighbours_.rebuild();
    Words words = checkpointWords(false).take();
    if (p_.set.config.ranks->rank() != 0) words.clear();
    ranks_.others->gatherOn(-1);
    neighbours_.rebuild();
    return knownWords(std::move(words));
}

//- About how many there are of n particles
template<class Backend, int D, class P>
std::size_t Checkpoint<Backend, D, P>::wordsExpected(int n)
{
    std::size_t expected = header + n + (sizeof(DemClockData) + sizeof(DemSearchState))/4 + 1024;
    for (int f = 0; f < p_.particles.values.fields(); ++f)
        if (isSaved(f)) expected += (std::size_t(n)*p_.particles.values.elementBytes(f) + 3)/4;
    forEachMemory([&](const void*, std::size_t bytes) { expected += (bytes + 3)/4; });
    if (p_.clumps.any())
        expected += (p_.clumps.total()*sizeof(ClumpData) + 3)/4 + 6*std::size_t(n);
    return expected;
}

//- Of all particles here, which have just been sorted
template<class Backend, int D, class P>
Later<std::vector<std::int32_t>> Checkpoint<Backend, D, P>::checkpointWords(bool later)
{
    p_.clock.read();
    p_.reach.searchedAt = p_.clock.now.step;
    p_.clock.now.windowEnd = -1e300;               // motions are sampled anew, by both
    p_.clock.write();
    const int n = p_.order.active();
    const std::vector<int> kept = p_.bonds.kept(p_.order.slotOf);
    detail::StateWords<Backend> words(p_.set.context, later,
        {detail::demMagic, detail::demVersion, D, int(sizeof(real)), int(Backend::gpu),
            p_.pairs.histories(), n, savedFields(), int(kept.size()), p_.clumps.total(),
            p_.walls.count, int(p_.order.list.entries()), p_.walls.memory.entries});
    words.expect(wordsExpected(n));
    words.addOfDevice(p_.clock.data(), sizeof(DemClockData));
    const DemSearchState search = p_.reach.state();
    words.add(&search, sizeof(search));
    const auto keys = p_.particles.template fieldOf<std::int32_t>(
        words.now(), n, p_.particles.at.id);
    words.addMade({std::size_t(n), [this, keys]
    {
        Words ids = keys();
        for (std::int32_t& id : ids) id = p_.particles.ids[id];
        return ids;
    }});
    for (int f = 0; f < p_.particles.values.fields(); ++f)
    {
        // keys count particles of this scene alone
        if (f == p_.particles.at.id) words.addZeros(n);
        else if (isSaved(f))
            words.addOfDevice(
                p_.particles.values.bytes(f), std::size_t(n)*p_.particles.values.elementBytes(f));
    }
    p_.bonds.forEachMemory(kept, [&](auto& array, int numbers)
    {
        const auto all = array.download();
        for (const int k : kept) words.add(&all[std::size_t(k)*numbers], numbers*sizeof(all[0]));
    });
    if (p_.clumps.any())
    {
        const std::vector<ClumpData> bodies = p_.clumps.known();
        words.add(bodies.data(), bodies.size()*sizeof(ClumpData));
        const auto key = p_.particles.template field<std::int32_t>(p_.particles.at.id);
        const auto offset = p_.clumps.offset().download();
        for (int i = 0; i < n; ++i) words.add(&offset[3*std::size_t(key[i])], 3*sizeof(double));
    }
    words.after(clearUnused(words.now(), words.size(), n));
    forEachMemory([&](const void* data, std::size_t bytes) { words.addOfDevice(data, bytes); });
    return words.done();
}

template<class Backend, int D, class P>
void Checkpoint<Backend, D, P>::load(const std::vector<std::int32_t>& words)
{
    if (!ranks_.others) return takeState(words);
    const std::vector<std::int32_t> all = wordsOfFirst(words);
    collectAll();
    // as one process that has everything, then in parts again
    std::unique_ptr<ParticleExchange> others(std::move(ranks_.others));
    takeState(all);
    ranks_.others = std::move(others);
    ranks_.setPieces();
    ranks_.others->begin(p_.particles.n);
    neighbours_.rebuild();
    ranks_.setCapacity();
    neighbours_.rebuild();
}

//- The first rank's
template<class Backend, int D, class P>
std::vector<std::int32_t> Checkpoint<Backend, D, P>::wordsOfFirst(
    const std::vector<std::int32_t>& words) const
{
    Transport& ranks = *p_.set.config.ranks;
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
void Checkpoint<Backend, D, P>::collectAll()
{
    Transport& ranks = *p_.set.config.ranks;
    const auto key = p_.particles.template field<std::int32_t>(p_.particles.at.id);
    std::vector<RankBytes> out(ranks.size()), in;
    RankBytes own;
    for (int i = 0; i < ranks_.others->residents(); ++i)
    {
        if (ranks_.ghost(i)) continue;
        const double empty = D == 2 ? p_.particles.emptyCoordinate[key[i]] : 0;
        const std::int32_t row = ranks_.bodies.row(i);
        putValues(own, &p_.particles.ids[key[i]]);
        putValues(own, &empty);
        putValues(own, &row);
    }
    out.assign(ranks.size(), own);
    ranks.exchange(out, in);
    std::map<std::int32_t, std::pair<double, std::int32_t>> all;
    for (const RankBytes& bytes : in)
        for (const unsigned char* from = bytes.data(); from < bytes.data() + bytes.size();)
        {
            std::int32_t id, row;
            double empty;
            takeValues(from, &id);
            takeValues(from, &empty);
            takeValues(from, &row);
            all[id] = {empty, row};
        }
    ranks_.setCapacity(int(all.size()));
    p_.particles.ids.clear();
    p_.particles.emptyCoordinate.clear();
    std::vector<std::int32_t> rows;
    for (const auto& one : all)
    {
        p_.particles.ids.push_back(one.first);
        if (D == 2) p_.particles.emptyCoordinate.push_back(one.second.first);
        rows.push_back(one.second.second);
    }
    ranks_.bonds.collect();
    ranks_.bodies.collect(rows);
    // nobody is a ghost
    p_.particles.values.upload(
        p_.set.context, p_.particles.at.calm, std::vector<std::int32_t>(p_.particles.n, -1));
}

//- Is it a state of this scene?
template<class Backend, int D, class P>
void Checkpoint<Backend, D, P>::checkHeader(const std::vector<std::int32_t>& words) const
{
    const auto fail = [](const std::string& why)
    { throw std::invalid_argument("saved state: " + why); };
    if (words.size() < header + (sizeof(DemClockData) + sizeof(DemSearchState))/4 + 1)
        fail("too short");
    if (words[0] != detail::demMagic) fail("not a state of riprap's solids");
    if (words[1] != detail::demVersion)
        fail("version " + std::to_string(words[1]) + " is not supported");
    if (!detail::checksumFits(words))
        fail("checksum does not match: the data are damaged");
    if (words[2] != D) fail("it is of " + std::to_string(words[2]) + " dimensions");
    if (words[3] != int(sizeof(real))) fail("it was written with another precision");
    if (words[4] != int(Backend::gpu)) fail("it was written on another kind of device");
    if (words[5] != p_.pairs.histories() || words[7] != savedFields())
        fail("it has other fields (models were switched on or off)");
    if (words[6] != p_.particles.n)
        fail("it is of " + std::to_string(words[6]) + " particles, the case of "
            + std::to_string(p_.particles.n));
    if (words[8] != p_.bonds.count() || words[9] != p_.clumps.total()
        || words[10] != p_.walls.count)
        fail("it has other bonds, clumps or walls");
}

//- As one process that has all particles
template<class Backend, int D, class P>
void Checkpoint<Backend, D, P>::takeState(const std::vector<std::int32_t>& words)
{
    checkHeader(words);
    const int n = p_.particles.n;
    detail::StateReader<Context<Backend>> read{p_.set.context, words, header};
    const auto take = [&](void* data, std::size_t bytes)
    {
        const std::size_t next = read.at + (bytes + 3)/4;
        if (next + 1 > words.size()) throw std::invalid_argument("saved state: wrong length");
        if (bytes) std::memcpy(data, &words[read.at], bytes);
        read.at = next;
    };
    read(p_.clock.data(), sizeof(DemClockData));
    DemSearchState search;
    take(&search, sizeof(search));
    restoreSearch(search);
    std::vector<std::int32_t> ids(n);
    take(ids.data(), ids.size()*sizeof(std::int32_t));
    for (int f = 0; f < p_.particles.values.fields(); ++f)
        if (isSaved(f))
            read(
                p_.particles.values.bytes(f), std::size_t(n)*p_.particles.values.elementBytes(f));
    restoreIds(ids);
    std::vector<int> all(p_.bonds.count());
    for (int k = 0; k < p_.bonds.count(); ++k) all[k] = k;
    p_.bonds.forEachMemory(all, [&](auto& array, int numbers)
    {
        auto values = array.download();
        for (int k = 0; k < p_.bonds.count(); ++k)
            take(&values[std::size_t(k)*numbers], numbers*sizeof(values[0]));
        array.upload(p_.set.context, values);
    });
    if (p_.clumps.any())
    {
        read(p_.clumps.data(), p_.clumps.total()*sizeof(ClumpData));
        const auto key = p_.particles.template field<std::int32_t>(p_.particles.at.id);
        auto offset = p_.clumps.offset().download();
        for (int i = 0; i < n; ++i) take(&offset[3*std::size_t(key[i])], 3*sizeof(double));
        p_.clumps.offset().upload(p_.set.context, offset);
    }
    restoreNeighbours(read, words[11], words[12]);
    p_.clock.read();
    p_.clock.now.fullDt = p_.set.plan.timeStep;
    p_.clock.now.needRebuild = 0;
    p_.reach.searchedAt = p_.clock.now.step;
    p_.clock.write();
    p_.set.context.synchronise();
}

//- Cells as the saving scene had them
template<class Backend, int D, class P>
void Checkpoint<Backend, D, P>::restoreSearch(const DemSearchState& s)
{
    bool fits = true;
    for (int d = 0; d < D; ++d)
    {
        const int axis = p_.set.config.axes[d];
        const double lo = p_.set.config.domainMin[axis], hi = p_.set.config.domainMax[axis];
        if (p_.set.config.periodic[axis]) fits = fits && lo == s.lower[d] && hi - lo == s.length[d];
        else fits = fits && lo > s.lower[d] && hi < s.lower[d] + s.length[d];
    }
    if (!fits)
        throw std::invalid_argument("saved state: it is of another domain: moving walls reach "
                                    "farther, as with a later endTime, or the mesh has changed");
    const double cell = p_.reach.wallCell();
    p_.reach.radii = s.radii;
    for (int d = 0; d < D; ++d)
        p_.set.box.set(d, s.lower[d], s.length[d], p_.set.config.periodic[p_.set.config.axes[d]]);
    neighbours_.setSkin(p_.set.config.skin >= 0 ? p_.reach.leastSkin() : s.skin);
    if (p_.reach.wallCell() != cell) p_.walls.set(p_.reach.wallCell(), p_.particles.n);
}

//- Whom each row of the state is about, and that all of them are there
template<class Backend, int D, class P>
void Checkpoint<Backend, D, P>::restoreIds(const std::vector<std::int32_t>& ids)
{
    const int n = int(ids.size());
    const auto fail = [] { throw std::invalid_argument("saved state: it is of other particles"); };
    std::vector<int> keyOf(
        n ? *std::max_element(p_.particles.ids.begin(), p_.particles.ids.end()) + 1 : 0, -1);
    for (int key = 0; key < n; ++key) keyOf[p_.particles.ids[key]] = key;
    std::vector<std::int32_t> keys(n);
    for (int i = 0; i < n; ++i)
    {
        if (ids[i] < 0 || std::size_t(ids[i]) >= keyOf.size() || keyOf[ids[i]] < 0) fail();
        keys[i] = keyOf[ids[i]];
        keyOf[ids[i]] = -1;
    }
    p_.particles.values.upload(p_.set.context, p_.particles.at.id, keys);
    p_.set.context.toDevice(const_cast<int*>(p_.order.sort.active()), &n, sizeof(int));
    p_.particles.reported = n;
}

//- Lists of the restored positions, then what contacts remember
template<class Backend, int D, class P>
template<class Reader>
void Checkpoint<Backend, D, P>::restoreNeighbours(Reader& read, int entries, int wallEntries)
{
    const auto check = [](bool good)
    {
        if (!good)
            throw std::invalid_argument(
                "saved state: its contacts do not fit (another skin, or walls elsewhere)");
    };
    // walls' poses stand behind the lists of contacts in the words: read them ahead
    Reader ahead = read;
    ahead.at += std::size_t(entries)*(1 + historyRows()*historyTogether()*sizeof(real)/4);
    if (p_.walls.count) ahead(p_.walls.walls.data(), p_.walls.count*sizeof(WallData));
    neighbours_.rebuild(true, Backend::gpu);
    check(int(p_.order.list.entries()) == entries && p_.walls.memory.entries == wallEntries);
    forEachMemory(read);
}

} // namespace riprap

/*  The fluid of a scene on several ranks: each owns that of its brick, and has ghosts of that of
    others that it may see.

    Ghosts stand among a rank's own particles in the order of their cells. They are sources of its
    passes and never targets. That order is the one of one process, and all that is in a row of
    cells within reach is there: packs of neighbours, and lists of the GPU, hold the same particles
    in the same lanes, sums are added up in the same order, and results are the same bits.

    Points of walls: solvers/sph/parts/wallRanks.hpp.

    In a step ranks send the pair records of ghosts, of each pass, and agree on the clock's maxima
    and flags: the time step is that of one process. At a rebuild particles change their ranks with
    all their fields.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellSort.hpp"
#include "core/ranks/joinRanks.hpp"
#include "core/ranks/slotExchange.hpp"
#include "solvers/sph/parts/sphClock.hpp"
#include "solvers/sph/parts/sphParticles.hpp"
#include "solvers/sph/sphFamilies.hpp"

namespace riprap
{

//- What pairs see of a particle, as bytes for another rank
template<class Backend, int D, class P>
struct PutRecord
{
    RecordsView<Backend, D, P> records;

    HD void operator()(int i, unsigned char* to) const
    {
        const Vec<D, typename P::position> x = records.loadPosition(i);
        const auto p = records.h ? records.template load<true>(i) : records.template load<false>(i);
        for (int d = 0; d < D; ++d) { putWord(to, x.c[d]); putWord(to, p.velocity.c[d]); }
        putWord(to, p.pressureTerm);
        putWord(to, p.density);
        if (records.h) putWord(to, p.h);
    }
};

template<class Backend, int D, class P>
struct TakeRecord
{
    RecordsView<Backend, D, P> records;

    HD void operator()(int i, const unsigned char* from) const
    {
        Vec<D, typename P::position> x;
        PairParticle<D, typename P::real> p;
        for (int d = 0; d < D; ++d) { takeWord(from, x.c[d]); takeWord(from, p.velocity.c[d]); }
        takeWord(from, p.pressureTerm);
        takeWord(from, p.density);
        p.h = 0;
        if (records.h) takeWord(from, p.h);
        records.storePosition(i, x);
        records.store(i, p);
    }
};

//- f(value) for what ranks agree on of a clock: the largest of each
template<class F>
HD void eachAgreed(ClockData& c, F f)
{
    for (float& most : c.maxima) f(most);
    f(c.needRebuild);
    f(c.skinViolations);
    for (int k = 0; k < 2; ++k) { f(c.aged[k]); f(c.missed[k]); }
    for (int& overflow : c.overflow) f(overflow);
}

//- The same between GPUs (DevicePeers)
struct AgreeOnClock
{
    static constexpr const char* name = "agreeOnClock";
    static constexpr int count = maximaCount + 2 + 4 + 5;
    ClockData* clock;

    HD void put(double* to) const
    {
        eachAgreed(*clock, [&](auto value) { *to++ = double(value); });
    }
    HD void take(const double* from) const
    {
        eachAgreed(*clock, [&](auto& value) { value = std::decay_t<decltype(value)>(*from++); });
    }
};

template<class Backend, int D, class P>
class FluidRanks
{
    using real = typename P::real;
    using position = typename P::position;

public:

    //- Of the solver: what is divided
    struct Scene
    {
        Context<Backend>& context;
        const SphConfig& config;
        const Box<D, P>& box;
        const CellGrid<D, P>& grid;
        FieldSet<Backend>& fluid;
        Records<Backend, D, P>& records;
        CellSort<Backend>& sort;
        const int& n;               // slots
        const double& nowhere;      // [m] coordinate along the empty axis
        FluidFieldNumbers& at;
    };

    //- Before there are fields; cells are known
    explicit FluidRanks(const Scene&);

    //- Neighbours are sought from as far as `radius`, by particles that are up to `way` from the
    //  cell that they were in [m]
    void setReach(double radius, double way);

    //- All particles of the scene are here, as the words of a state have them; sums since the start
    //  are the first rank's
    void begin(ClockData&, double& stiffening);

    bool first() const { return ranks().rank() == 0; }
    const SlotExchange<Backend>& particles() const { return exchange_; }
    SlotExchange<Backend>& particles() { return exchange_; }
    //- Slots for what is here, and some more
    int room() const
    {
        const int here = exchange_.residents();
        return 2*here - exchange_.ownedHere() + here/8 + 256;
    }

    //- After keys of all particles were found, before they are sorted: who is here from now on.
    //  grow(n): memory for so many
    template<class Grow> void migrate(const Grow& grow);
    //- Particles are in their new places, `active` of them
    void settle(int active);

    bool ghost(int i) const { return exchange_.ghost(i); }
    GhostMarks<Backend> marks() const { return exchange_.marks(); }
    std::uint32_t cellOf(const Vec<D, position>& x) const;
    std::uint32_t cellOf(const Vec<D, std::int64_t>& x) const;      // as fields have it
    Context<Backend>& context() const { return s_.context; }
    //- Is a point in a cell of this rank?
    bool has(const Vec<D, position>& x) const
    {
        return exchange_.ownerOf(cellOf(x)) == ranks().rank();
    }

    //- What pairs see of fluid that is a ghost elsewhere
    void shareRecords();

    //- What the last pass, its step or a rebuild has raised on any rank. Where GPUs reach each
    //  other, hosts launch ahead and `interrupted` is not looked at: agreeToStop() is for that
    void agree(SphClock<Backend>&, bool interrupted);
    //- At a rebuild, before lists are made: the largest h there is
    void agreeOnH(SphClock<Backend>&);
    //- Before the first step of a call
    void agreeToStop(bool interrupted)
    {
        stop_ = largestOfRanks(ranks(), double(interrupted)) > 0;
    }
    bool stopAgreed() const { return stop_; }

    //- Rows of ghosts out of what is read back, `each` numbers a row
    template<class T> void dropGhosts(std::vector<T>&, int each) const;
    void report(SphReport&);
    //- A guard has fired: the rank whose particle is worst says which it is, and all report it.
    //  here: how bad that of this rank is
    void agreeOnOffender(SphReport&, double here) const;
    //- What ranks have summed since the start
    void sum(ClockData&, double& stiffening) const;
    //- A field of all particles, on the first rank, in the order of one process
    void gather(FieldSet<Backend>&, int field, std::int32_t* to) const;
    //- The largest of all ranks
    double largest(double here) const { return largestOfRanks(ranks(), here); }
    //- How many particles are this rank's own
    std::size_t owned() const;
    //- A state that the first rank has, on all of them
    std::vector<std::int32_t> ofFirst(const std::vector<std::int32_t>& words) const;

private:

    Transport& ranks() const { return *s_.config.ranks; }
    void noticeLeft();

    Scene s_;
    SlotExchange<Backend> exchange_;
    bool stop_ = false;
    // escaped and wild particles since the last report
    SphReport left_;
};

template<class Backend, int D, class P>
FluidRanks<Backend, D, P>::FluidRanks(const Scene& scene)
    : s_(scene), exchange_(scene.context, *scene.config.ranks, scene.config.imbalance,
        scene.config.measured, scene.config.direct)
{}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::setReach(double radius, double way)
{
    PieceGrid g;
    for (int d = 0; d < 3; ++d) { g.n[d] = s_.grid.n[d]; g.stride[d] = s_.grid.stride[d]; }
    for (int d = 0; d < D; ++d)
    {
        g.lower[d] = s_.box.lower[d];
        g.size[d] = s_.box.length[d]/s_.grid.n[d];
        g.periodic[d] = s_.grid.periodic[d];
    }
    // who seeks may be as far from its cell as those that it finds; rows of cells are searched a
    // hair beyond the radius (CellGrid)
    // on GPUs pieces are as long as the search radius: fewer of them for the host to look at
    const int least = Backend::gpu ? std::max(1, int(s_.grid.radius*s_.grid.inverse[0])) : 1;
    exchange_.setPieces({g}, 1.001*radius + way, least);
    exchange_.begin(s_.n);
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::begin(ClockData& c, double& stiffening)
{
    exchange_.begin(s_.n);
    left_ = SphReport();
    if (first()) return;
    c.faces.contacts = c.faces.energy = c.faces.atBodies = 0;
    for (std::int64_t& impulse : c.faces.impulse) impulse = 0;
    stiffening = 0;
}

//- Own particles that are in no cell: they have escaped, or ran wild
template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::noticeLeft()
{
    for (int k = 0; k < exchange_.left(); ++k)
    {
        const auto take = [&](int field, auto& value)
        {
            std::memcpy(&value,
                exchange_.leftRecord(k) + FieldRecords<Backend>::offset(s_.fluid, field),
                sizeof(value));
        };
        Vector3 x{{s_.nowhere, s_.nowhere, s_.nowhere}};
        double speed2 = 0;
        for (int d = 0; d < D; ++d)
        {
            std::int64_t position;
            real v;
            take(s_.at.x + d, position);
            take(s_.at.v + d, v);
            x[s_.config.axes[d]] = s_.box.toMetres(d, position);
            speed2 += double(v)*v;
        }
        std::int32_t id;
        real deviation;
        take(s_.at.id, id);
        take(s_.at.deviation, deviation);
        if (id < 0)
        {
            left_.wild.push_back(WildParticle{-1 - id, x, deviation, std::sqrt(speed2)});
            continue;
        }
        left_.escaped.push_back(x);
        left_.escapedId.push_back(id);
    }
}

template<class Backend, int D, class P>
template<class Grow>
void FluidRanks<Backend, D, P>::migrate(const Grow& grow)
{
    exchange_.migrate(s_.fluid, s_.sort, s_.n, grow);
    noticeLeft();
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::settle(int active) { exchange_.settle(s_.sort, s_.n, active); }

template<class Backend, int D, class P>
std::uint32_t FluidRanks<Backend, D, P>::cellOf(const Vec<D, position>& x) const
{
    Vec<D, real> r;
    for (int d = 0; d < D; ++d) r.c[d] = s_.box.pairRelative(d, x.c[d]);
    return std::uint32_t(s_.grid.cellOf(r));
}

template<class Backend, int D, class P>
std::uint32_t FluidRanks<Backend, D, P>::cellOf(const Vec<D, std::int64_t>& x) const
{
    Vec<D, position> p;
    for (int d = 0; d < D; ++d) p.c[d] = s_.box.pairPosition(d, x.c[d]);
    return cellOf(p);
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::shareRecords()
{
    const RecordsView<Backend, D, P> r = s_.records.view();
    exchange_.share(sizeof(real)*(2*D + 2 + (r.h ? 1 : 0)), PutRecord<Backend, D, P>{r},
        TakeRecord<Backend, D, P>{r});
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::agree(SphClock<Backend>& clock, bool interrupted)
{
    if (exchange_.peers.there()) return exchange_.peers.largest(AgreeOnClock{clock.data()});
    const AgreeOnClock clockOf{&clock.taken()};
    std::vector<double> most(AgreeOnClock::count + 1, double(interrupted));
    clockOf.put(most.data());
    ranks().largest(most);
    clockOf.take(most.data());
    stop_ = most.back() > 0;
    clock.give();
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::agreeOnH(SphClock<Backend>& clock)
{
    ClockData& c = clock.taken();
    c.foundH = float(largestOfRanks(ranks(), double(c.foundH)));
    clock.give();
}

template<class Backend, int D, class P>
template<class T>
void FluidRanks<Backend, D, P>::dropGhosts(std::vector<T>& v, int each) const
{
    std::size_t to = 0;
    for (int i = 0; i < exchange_.residents(); ++i)
    {
        if (ghost(i)) continue;
        std::copy_n(v.begin() + std::size_t(i)*each, each, v.begin() + to);
        to += each;
    }
    v.resize(to);
}

template<class Backend, int D, class P>
std::size_t FluidRanks<Backend, D, P>::owned() const
{
    std::size_t n = 0;
    for (int i = 0; i < exchange_.residents(); ++i) n += !ghost(i);
    return n;
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::report(SphReport& report)
{
    report.fluid = std::size_t(exchange_.total());
    report.escaped.swap(left_.escaped);
    report.escapedId.swap(left_.escapedId);
    report.wild.swap(left_.wild);
    left_ = SphReport();
    exchange_.peers.noticeWaiting();
    exchange_.work(false);
    const auto& c = exchange_.counts;
    const int own = exchange_.ownedHere();
    report.rank = RankReport{std::size_t(own), std::size_t(exchange_.residents() - own), c.arrivals,
        exchange_.owners().cuts(), c.bytesShared, c.bytesMigrating,
        exchange_.owners().unevenBefore(), exchange_.owners().unevenAfter(),
        exchange_.owners().atWork(), exchange_.peers.there()};
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::agreeOnOffender(SphReport& report, double here) const
{
    const double most = largestOfRanks(ranks(), here);
    const int size = ranks().size(),
              speaker = size
        - int(largestOfRanks(ranks(), here == most ? size - ranks().rank() : 0));
    RankBytes own;
    putValues(own, &report.stopId);
    putValues(own, report.stopPosition.data(), 3);
    putValues(own, &report.stopValue);
    if (speaker >= size) return;
    const std::vector<RankBytes> all = toAll(ranks(), own);
    const unsigned char* from = all[speaker].data();
    takeValues(from, &report.stopId);
    takeValues(from, report.stopPosition.data(), 3);
    takeValues(from, &report.stopValue);
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::sum(ClockData& c, double& stiffening) const
{
    std::vector<std::int64_t> sums{c.faces.contacts, c.faces.energy, c.faces.atBodies};
    sums.insert(sums.end(), c.faces.impulse, c.faces.impulse + 3);
    std::vector<double> energy(1, stiffening);
    ranks().sum(sums);
    addByRank(ranks(), energy);
    c.faces.contacts = sums[0];
    c.faces.energy = sums[1];
    c.faces.atBodies = sums[2];
    std::copy_n(sums.begin() + 3, 3, c.faces.impulse);
    stiffening = energy[0];
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::gather(FieldSet<Backend>& set, int field, std::int32_t* to) const
{
    const std::size_t each = set.elementBytes(field);
    std::vector<unsigned char> here(exchange_.residents()*each);
    if (!here.empty()) s_.context.toHost(here.data(), set.bytes(field), here.size());
    const std::vector<std::int64_t> numbers = exchange_.numbers();
    std::vector<RankBytes> out(ranks().size()), in;
    for (int i = 0; i < exchange_.residents(); ++i)
    {
        if (ghost(i)) continue;
        putValues(out[0], &numbers[i]);
        putValues(out[0], here.data() + i*each, each);
    }
    ranks().exchange(out, in);
    for (const RankBytes& bytes : in)
        for (const unsigned char* from = bytes.data(); from < bytes.data() + bytes.size();)
        {
            std::int64_t number;
            takeValues(from, &number);
            takeValues(from, reinterpret_cast<unsigned char*>(to) + number*each, each);
        }
}

template<class Backend, int D, class P>
std::vector<std::int32_t> FluidRanks<Backend, D, P>::ofFirst(
    const std::vector<std::int32_t>& words) const
{
    RankBytes own;
    if (first()) putValues(own, words.data(), words.size());
    const std::vector<RankBytes> all = toAll(ranks(), own);
    std::vector<std::int32_t> found(all[0].size()/sizeof(std::int32_t));
    if (!found.empty()) std::memcpy(found.data(), all[0].data(), all[0].size());
    return found;
}

} // namespace riprap

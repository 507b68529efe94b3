/*  Solids on several ranks (CPU): each owns the particles of its brick, and has ghosts of those of
    others that they may touch.

    Ghosts stand among a rank's own particles in the order of their cells, marked as asleep: they
    act, and nothing acts on them. That order is the one of one process, so pairs have the same
    owner there, forces are added up in the same order, and results are the same bits. What a pair
    across a border remembers is kept by both ranks, each of which works it out.

    In a step ranks send positions and velocities of ghosts, and agree on the clock's flags. At a
    rebuild particles change their ranks with all their fields, histories of contacts and of walls,
    their bonds (rankedBonds.hpp) and rigid bodies (rankedBodies.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "solvers/dem/driver/rankedBodies.hpp"
#include "solvers/dem/driver/rankedBonds.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class RankedSolids
{
public:

    using real = typename P::real;
    using position = typename P::position;
    static constexpr int S = spins<D>;

    std::unique_ptr<ParticleExchange> others;       // null: there is one rank
    RankedBonds<Backend, D, P> bonds;
    RankedBodies<Backend, D, P> bodies;
    std::vector<Vector3> escaped;                   // since the last report,
    std::vector<std::int32_t> escapedId;
    // walls, of particles whose keys have changed since; one of them
    std::int64_t passedBefore = 0;
    std::int32_t passedIdBefore = -1;

    explicit RankedSolids(DemParts<Backend, D, P>& parts) : bonds(parts), bodies(parts), p_(parts)
    {}

    //- Before there are fields; cells are known
    void begin();
    void setPieces();

    //- Memory for so many particles from now on
    void setCapacity(int n);
    // for what is here
    void setCapacity() { setCapacity(others->residents() + others->residents()/4 + 256); }

    //- In a rebuild: who is here from now on; particles are in their new places; what contacts of
    //  arrivals remember; where to cut blocks
    void regroup();
    void settle(const std::uint32_t* newOrder);
    void takeContacts();
    void takeWallContacts();
    std::vector<int> blockCuts();

    void shareStep();
    void start()
    {
        p_.interrupted = stopAgreed_ = false;
        if (others) others->work(true);
    }
    bool finished() const { return p_.over() || stopped(); }
    bool stopped() const { return others ? stopAgreed_ : bool(p_.interrupted); }

    bool ghost(int i) { return others && others->kind(i) == ParticleExchange::ghost; }
    template<class T> void dropGhosts(std::vector<T>& v, int each);
    double largest(double) const;
    void requireAlone(const char* what) const;

private:

    void noteLeavers(bool any);
    void recordGhost(int slot, int touching);
    void takeKey(int slot, std::int32_t id);
    void packParticle(int slot, bool whole, RankBytes& to);
    void packContacts(int slot, RankBytes& to);
    void packWalls(int slot, RankBytes& to);
    void unpackParticle(int slot, bool whole, const unsigned char*& from);

    DemParts<Backend, D, P>& p_;
    // entries of each slot, where they are asked for
    std::vector<std::vector<std::size_t>> touchingOf_;
    // owner and other: numbers of the order before, then slots of then
    struct RankContact { std::int64_t a, b; };
    std::vector<RankContact> arrivedContacts_;
    std::vector<real> arrivedHistories_;
    struct RankWall { int particle, wall, on[wallTouches]; };
    std::vector<RankWall> arrivedWalls_;
    std::vector<real> arrivedWallNumbers_;              // of each: normals, histories, force
    bool stopAgreed_ = false;
};

template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::begin()
{
    if (Backend::gpu) throw std::invalid_argument("several processes run on CPUs alone");
    others = std::make_unique<ParticleExchange>(
        *p_.set.config.ranks, p_.set.config.imbalance, p_.set.config.measured);
    setPieces();
    others->begin(p_.particles.n);
}

template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::setPieces()
{
    std::vector<PieceGrid> grids;
    for (int k = 0; k < p_.reach.classes.classes; ++k)
    {
        const CellGrid<D, P>& from = p_.reach.classes.grid[k];
        PieceGrid g;
        for (int d = 0; d < 3; ++d) { g.n[d] = from.n[d]; g.stride[d] = from.stride[d]; }
        for (int d = 0; d < D; ++d)
        {
            g.lower[d] = p_.set.box.lower[d];
            g.size[d] = p_.set.box.length[d]/from.n[d];
            g.periodic[d] = from.periodic[d];
        }
        g.radius = double(p_.reach.classes.largest[k]);
        grids.push_back(g);
    }
    others->setPieces(grids, std::max(p_.reach.reach, bonds.reach()));
}

//- Memory for so many particles from now on; residents stay in their slots, and a rebuild does the
//  rest
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::setCapacity(int n)
{
    const int residents = std::min(others->residents(), p_.particles.n), active = p_.order.active();
    const auto key = p_.particles.template field<std::int32_t>(p_.particles.at.id);
    bodies.rekey(residents, n);
    std::vector<std::int32_t> ids(n, -1), keys(n);
    std::vector<double> empty(D == 2 ? n : 0, 0.0);
    for (int i = 0; i < n; ++i)
    {
        keys[i] = i;
        if (i >= std::min(n, p_.particles.n)) continue;
        ids[i] = p_.particles.ids[key[i]];
        if (D == 2) empty[i] = p_.particles.emptyCoordinate[key[i]];
    }
    p_.particles.ids.swap(ids);
    p_.particles.emptyCoordinate.swap(empty);

    FieldSet<Backend> old(std::move(p_.particles.values));
    p_.particles.values = FieldSet<Backend>();
    const auto info = old.info();
    for (int f = 0; f < old.fields(); ++f)
    {
        if (old.elementBytes(f) == 8) p_.particles.values.template add<std::int64_t>(info[f].name);
        else p_.particles.values.template add<std::int32_t>(info[f].name);
    }
    p_.particles.values.allocate(p_.set.context, n);
    for (int f = 0; f < p_.particles.values.fields(); ++f)
        std::memcpy(p_.particles.values.bytes(f), old.bytes(f),
            std::size_t(residents)*old.elementBytes(f));
    p_.particles.values.upload(p_.set.context, p_.particles.at.id, keys);

    // lists of before are about the slots of before: those behind have none
    const auto longer = [&](Array<Backend, int>& a, std::size_t size, int rest)
    {
        std::vector<int> all = a.download();
        all.resize(size, all.empty() ? 0 : (rest < 0 ? all.back() : rest));
        Array<Backend, int> fresh;
        fresh.upload(p_.set.context, all);
        a.swap(fresh);
    };
    p_.order.list.resize(p_.set.context, n);
    if (p_.walls.count)
        for (WallMemoryArrays<Backend, real>* w : {&p_.walls.memory, &p_.walls.oldMemory})
        {
            longer(w->entryFirst, std::size_t(n) + 1, -1);
            longer(w->elementFirst, std::size_t(n) + 1, -1);
        }
    p_.order.records = SolidRecordMemory<Backend, D, P>();
    p_.order.records.allocate(p_.set.context, n);
    p_.order.reference = Array<Backend, position>();
    p_.order.reference.allocate(p_.set.context, std::size_t(n)*D);
    p_.order.inverse = Array<Backend, int>();
    p_.order.inverse.allocate(p_.set.context, n);
    bonds.rekey(residents, n);
    p_.order.sort = CellSort<Backend>();
    p_.order.setCells(n, p_.reach.classes.cells(), active);
    p_.particles.n = n;
}

//- Who is in a slot from now on
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::takeKey(int slot, std::int32_t id)
{
    p_.particles.ids[p_.particles.values.template data<std::int32_t>(p_.particles.at.id)[slot]] =
        id;
}

template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::packParticle(int slot, bool whole, RankBytes& to)
{
    const int key = p_.particles.values.template data<std::int32_t>(p_.particles.at.id)[slot];
    putValues(to, &p_.particles.ids[key]);
    if (D == 2) putValues(to, &p_.particles.emptyCoordinate[key]);
    for (int f = 0; f < p_.particles.values.fields(); ++f)
    {
        if (f == p_.particles.at.id || f == p_.particles.at.calm) continue;
        const std::size_t each = p_.particles.values.elementBytes(f);
        putValues(to, p_.particles.values.bytes(f) + slot*each, each);
    }
    bodies.pack(slot, whole, to);
    if (!whole) return;
    packContacts(slot, to);
    packWalls(slot, to);
    bonds.pack(slot, to);
}

//- Touching pairs of a particle with what they remember
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::packContacts(
    [[maybe_unused]] int slot, [[maybe_unused]] RankBytes& to)
{
    if constexpr (!Backend::gpu)
    {
        const ContactListView<Backend, real> list = p_.order.list.view();
        const int words = list.historyWords(p_.pairs.histories());
        if (touchingOf_.empty())
        {
            touchingOf_.resize(others->residents());
            for (int i = 0, last = p_.order.active(); i < last; ++i)
                for (int k = 0; k < list.count[i]; ++k)
                {
                    const std::size_t e = list.index(i, k);
                    if (!(list.entry[e] & list.touching)) continue;
                    touchingOf_[i].push_back(e);
                    touchingOf_[list.other(list.entry[e])].push_back(e);
                }
        }
        const std::int32_t count = std::int32_t(touchingOf_[slot].size());
        putValues(to, &count);
        for (const std::size_t e : touchingOf_[slot])
        {
            const std::int64_t pair[2] = {
                others->number(list.owner[e]), others->number(list.other(list.entry[e]))};
            putValues(to, pair, 2);
            putValues(to, list.history + e*words, p_.pairs.histories());
        }
    }
}

//- What a particle remembers of walls
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::packWalls(int slot, RankBytes& to)
{
    const WallMemoryArrays<Backend, real>& m = p_.walls.memory;
    const int first = p_.walls.count ? m.entryFirst.data()[slot] : 0;
    const std::int32_t count = p_.walls.count ? m.entryFirst.data()[slot + 1] - first : 0;
    putValues(to, &count);
    for (int e = first; e < first + count; ++e)
    {
        const std::size_t at = std::size_t(e)*wallTouches;
        putValues(to, &m.entry.data()[e].wall);
        putValues(to, m.on.data() + at, wallTouches);
        putValues(to, m.normal.data() + at*D, wallTouches*D);
        putValues(to, m.history.data() + at*p_.pairs.histories(), wallTouches*p_.pairs.histories());
        putValues(to, m.force.data() + std::size_t(e)*wallWords<D>, wallWords<D>);
    }
}

template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::unpackParticle(int slot, bool whole, const unsigned char*& from)
{
    if (slot >= p_.particles.n)
        setCapacity(std::max(slot + 1, p_.particles.n + p_.particles.n/4) + 64);
    std::int32_t id;
    takeValues(from, &id);
    takeKey(slot, id);
    if (D == 2)
        takeValues(from,
            &p_.particles.emptyCoordinate[p_.particles.values.template data<std::int32_t>(
                p_.particles.at.id)[slot]]);
    for (int f = 0; f < p_.particles.values.fields(); ++f)
    {
        if (f == p_.particles.at.id || f == p_.particles.at.calm) continue;
        const std::size_t each = p_.particles.values.elementBytes(f);
        takeValues(from, p_.particles.values.bytes(f) + slot*each, each);
    }
    bodies.unpack(slot, whole, from);
    if (!whole) return;
    std::int32_t contacts, walls;
    takeValues(from, &contacts);
    for (int k = 0; k < contacts; ++k)
    {
        std::int64_t pair[2];
        takeValues(from, pair, 2);
        arrivedContacts_.push_back(RankContact{pair[0], pair[1]});
        arrivedHistories_.resize(arrivedHistories_.size() + p_.pairs.histories());
        takeValues(from, arrivedHistories_.data() + arrivedHistories_.size() - p_.pairs.histories(),
            p_.pairs.histories());
    }
    takeValues(from, &walls);
    for (int k = 0; k < walls; ++k)
    {
        RankWall w;
        w.particle = slot;
        takeValues(from, &w.wall);
        takeValues(from, w.on, wallTouches);
        arrivedWalls_.push_back(w);
        const std::size_t numbers = std::size_t(wallTouches)*(D + p_.pairs.histories())
            + wallWords<D>;
        arrivedWallNumbers_.resize(arrivedWallNumbers_.size() + numbers);
        takeValues(
            from, arrivedWallNumbers_.data() + arrivedWallNumbers_.size() - numbers, numbers);
    }
    bonds.unpack(from);
}

//- After keys of all particles were found, before they are sorted: who is here from now on
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::regroup()
{
    if constexpr (!Backend::gpu)
    {
        if (p_.walls.surfaces)
        {
            // keys change their particles
            const WallPassings passed = p_.walls.passed.download()[0];
            if (passed.count && !passedBefore) passedIdBefore = p_.particles.ids[passed.key];
            passedBefore += passed.count;
            p_.walls.clearPassed(p_.particles.n);
        }
        for (auto* v : {&arrivedHistories_, &arrivedWallNumbers_}) v->clear();
        arrivedContacts_.clear();
        arrivedWalls_.clear();
        touchingOf_.clear();
        if (bonds.adaptReach()) setPieces();
        const std::int64_t before = others->total();
        others->migrate(
            p_.order.sort.keys(),
            [&](int slot, bool whole, RankBytes& to) { packParticle(slot, whole, to); },
            [&](int slot, bool whole, const unsigned char*& from)
            { unpackParticle(slot, whole, from); });
        for (RankContact& c : arrivedContacts_)
        {
            c.a = others->slotOf(c.a);
            c.b = others->slotOf(c.b);
        }
        noteLeavers(others->total() != before);
        const SolidFields<D, P> f = p_.particles.view();
        std::vector<char> here(p_.particles.n, 0);
        int k = 0;
        for (const int slot : others->sequence())
        {
            f.calm[slot] = ghost(slot) ? ghostMark : -1;
            here[slot] = 1;
            p_.order.sort.keys()[k] = others->cell(slot);
            p_.order.sort.indices()[k++] = std::uint32_t(slot);
        }
        for (int slot = 0; slot < p_.particles.n; ++slot)
        {
            if (here[slot]) continue;
            p_.order.sort.keys()[k] = std::uint32_t(p_.reach.classes.cells());
            p_.order.sort.indices()[k++] = std::uint32_t(slot);
        }
    }
}

//- Of this rank. any: from any rank
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::noteLeavers(bool any)
{
    const SolidFields<D, P> f = p_.particles.view();
    std::vector<std::int32_t> ids;
    for (const int slot : others->left())
    {
        Vector3 x{{0, 0, 0}};
        if (D == 2) x[p_.set.config.axes[2]] = p_.particles.emptyCoordinate[f.id[slot]];
        for (int d = 0; d < D; ++d)
            x[p_.set.config.axes[d]] = p_.set.box.toMetres(d, f.x[d][slot]);
        escaped.push_back(x);
        ids.push_back(p_.particles.ids[f.id[slot]]);
    }
    escapedId.insert(escapedId.end(), ids.begin(), ids.end());
    bonds.noteLeavers(ids, any);
}

template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::settle(const std::uint32_t* newOrder)
{
    others->settle(newOrder, p_.order.active());
    bodies.settle(*others);
}

//- What contacts of arrivals remember, after the lists were written
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::takeContacts()
{
    if constexpr (!Backend::gpu)
    {
        int turns = 0;
        withLaw(p_.set.laws, [&](auto law) { turns = decltype(law)::template turnsFrom<D>; });
        const ContactListView<Backend, real> list = p_.order.list.view();
        const int words = list.historyWords(p_.pairs.histories()), active = p_.order.active();
        for (std::size_t c = 0; c < arrivedContacts_.size(); ++c)
        {
            const RankContact& pair = arrivedContacts_[c];
            if (pair.a < 0 || pair.b < 0) continue;
            const int i = p_.order.inverse.data()[pair.a], j = p_.order.inverse.data()[pair.b];
            if (i >= active || j >= active) continue;
            const bool turn = j < i;
            const int owner = turn ? j : i, partner = turn ? i : j;
            for (int k = 0; k < list.count[owner]; ++k)
            {
                const std::size_t e = list.index(owner, k);
                if (list.other(list.entry[e]) != partner) continue;
                list.entry[e] |= list.touching;
                for (int h = 0; h < p_.pairs.histories(); ++h)
                {
                    const real value = arrivedHistories_[c*p_.pairs.histories() + h];
                    list.history[e*words + h] = turn && h >= turns ? -value : value;
                }
            }
        }
    }
}

template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::takeWallContacts()
{
    WallMemoryArrays<Backend, real>& m = p_.walls.memory;
    const std::size_t numbers = std::size_t(wallTouches)*(D + p_.pairs.histories()) + wallWords<D>;
    for (std::size_t k = 0; k < arrivedWalls_.size(); ++k)
    {
        const RankWall& w = arrivedWalls_[k];
        const int i = p_.order.inverse.data()[w.particle];
        for (int e = m.entryFirst.data()[i]; e < m.entryFirst.data()[i + 1]; ++e)
        {
            if (m.entry.data()[e].wall != w.wall) continue;
            const real* from = &arrivedWallNumbers_[k*numbers];
            const std::size_t at = std::size_t(e)*wallTouches;
            std::copy_n(w.on, wallTouches, m.on.data() + at);
            std::copy_n(from, wallTouches*D, m.normal.data() + at*D);
            std::copy_n(from + wallTouches*D, wallTouches*p_.pairs.histories(),
                m.history.data() + at*p_.pairs.histories());
            std::copy_n(from + wallTouches*(D + p_.pairs.histories()), wallWords<D>,
                m.force.data() + std::size_t(e)*wallWords<D>);
        }
    }
}

//- Blocks of contacts are those of one process, as far as they are here
template<class Backend, int D, class P>
std::vector<int> RankedSolids<Backend, D, P>::blockCuts()
{
    std::vector<int> cuts(1, 0);
#ifndef __CUDACC__
    const std::int64_t n = others->total(), blocks = DeferredForces<D, real>::blocksOf(n);
    std::int64_t block = 0;
    for (int i = 0; i < others->residents(); ++i)
    {
        const std::int64_t before = block;
        while (others->number(i) >= n*(block + 1)/blocks) ++block;
        if (i > 0 && block > before) cuts.push_back(i);
    }
    cuts.push_back(others->residents());
#endif
    return cuts;
}

//- After particles were moved: ghosts follow, and ranks agree on what the step has raised
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::shareStep()
{
    if constexpr (!Backend::gpu)
    {
        const SolidFields<D, P> f = p_.particles.view();
        const bool any = p_.clumps.any();
        others->share(
            D*(sizeof(std::int64_t) + sizeof(double)) + S*sizeof(real) + any*sizeof(int),
            [&](int i, unsigned char* to)
            {
                for (int d = 0; d < D; ++d)
                {
                    std::memcpy(to + 8*d, f.x[d] + i, 8);
                    std::memcpy(to + 8*(D + d), f.v[d] + i, 8);
                }
                for (int c = 0; c < S; ++c)
                    std::memcpy(to + 16*D + c*sizeof(real), f.w[c] + i, sizeof(real));
                if (!any) return;
                const int touching = bodies.touching(i);
                std::memcpy(to + 16*D + S*sizeof(real), &touching, sizeof(touching));
            },
            [&](int i, const unsigned char* from)
            {
                for (int d = 0; d < D; ++d)
                {
                    std::memcpy(f.x[d] + i, from + 8*d, 8);
                    std::memcpy(f.v[d] + i, from + 8*(D + d), 8);
                }
                for (int c = 0; c < S; ++c)
                    std::memcpy(f.w[c] + i, from + 16*D + c*sizeof(real), sizeof(real));
                int touching = 0;
                if (any)
                    std::memcpy(&touching, from + 16*D + S*sizeof(real), sizeof(touching));
                recordGhost(i, touching);
            });
        DemClockData& c = *p_.clock.data();
        std::vector<double> flags{double(c.needRebuild), double(c.aged[0]), double(c.aged[1]),
            double(c.far[0]), double(c.far[1]), double(int(c.halt)), double(p_.interrupted)};
        p_.set.config.ranks->largest(flags);
        int k = 0;
        for (int* to : {&c.needRebuild, c.aged, c.aged + 1, c.far, c.far + 1})
            *to = int(flags[k++]);
        c.halt = DemHalt(int(flags[k++]));
        stopAgreed_ = flags[k] > 0;
    }
}

//- What pairs read of a ghost, at its new place. touching: members of its body on which a contact
//  acts
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::recordGhost(int i, int touching)
{
    const SolidFields<D, P> f = p_.particles.view();
    real mass = f.mass[i];
    if (p_.clumps.any())
    {
        bodies.setTouching(i, touching);
        mass = bodies.massInContacts(i, mass);
    }
    Vec<D, position> p;
    for (int d = 0; d < D; ++d) p.c[d] = p_.set.box.pairPosition(d, f.x[d][i]);
    p_.order.records.view().store(i, p,
        ContactBody<D, real>{convert<real>(f.velocity(i)), f.spin(i), f.radius[i], mass},
        f.material[i]);
}

//- What is no number counts as infinite
template<class Backend, int D, class P>
double RankedSolids<Backend, D, P>::largest(double value) const
{
    if (!others) return value;
    std::vector<double> v(1, value == value ? value : std::numeric_limits<double>::infinity());
    p_.set.config.ranks->largest(v);
    return v[0];
}

//- Rows of ghosts out of what is read back, `each` numbers a row
template<class Backend, int D, class P>
template<class T>
void RankedSolids<Backend, D, P>::dropGhosts(std::vector<T>& v, int each)
{
    if (!others || v.empty()) return;
    std::size_t to = 0;
    for (int i = 0; i < others->residents(); ++i)
    {
        if (ghost(i)) continue;
        std::copy_n(v.begin() + std::size_t(i)*each, each, v.begin() + to);
        to += each;
    }
    v.resize(to);
}

//- What parts of a scene cannot do yet
template<class Backend, int D, class P>
void RankedSolids<Backend, D, P>::requireAlone(const char* what) const
{ if (others) throw std::invalid_argument(std::string(what) + ": on one process alone"); }

} // namespace riprap

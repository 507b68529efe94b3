/*  DemSolver on several ranks (CPU): each owns the particles of its brick, and has ghosts of those of others that they may touch.

    Ghosts stand among a rank's own particles in the order of their cells, marked as asleep: they act, and nothing acts on them. That order is
    the one of one process, so pairs have the same owner there, forces are added up in the same order, and results are the same bits. What a pair
    across a border remembers is kept by both ranks, each of which works it out.

    In a step ranks send positions and velocities of ghosts, and agree on the clock's flags. At a rebuild particles change their ranks with all
    their fields, histories of contacts and of walls.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "solvers/dem/demSolver.hpp"

namespace riprap
{

//- Before there are fields; cells are known
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setRanks()
{
    if (Backend::gpu) throw std::invalid_argument("several processes run on CPUs alone");
    others_ = std::make_unique<ParticleExchange>(*config_.ranks, config_.imbalance);
    setPieces();
    others_->begin(n_);
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setPieces()
{
    std::vector<PieceGrid> grids;
    for (int k = 0; k < classes_.classes; ++k)
    {
        const CellGrid<D, P>& from = classes_.grid[k];
        PieceGrid g;
        for (int d = 0; d < 3; ++d) { g.n[d] = from.n[d]; g.stride[d] = from.stride[d]; }
        for (int d = 0; d < D; ++d)
        {
            g.lower[d] = box_.lower[d];
            g.size[d] = box_.length[d]/from.n[d];
            g.periodic[d] = from.periodic[d];
        }
        g.radius = double(classes_.largest[k]);
        grids.push_back(g);
    }
    others_->setPieces(grids, reach_);
}

//- Memory for so many particles from now on; residents stay in their slots, and a rebuild does the rest
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setCapacity(int n)
{
    const int residents = std::min(others_->residents(), n_), active = activeSolids();
    const auto key = field<std::int32_t>(idField_);
    std::vector<std::int32_t> ids(n, -1), keys(n);
    std::vector<double> empty(D == 2 ? n : 0, 0.0);
    for (int i = 0; i < n; ++i)
    {
        keys[i] = i;
        if (i >= std::min(n, n_)) continue;
        ids[i] = ids_[key[i]];
        if (D == 2) empty[i] = emptyCoordinate_[key[i]];
    }
    ids_.swap(ids);
    emptyCoordinate_.swap(empty);

    FieldSet<Backend> old(std::move(fields_));
    fields_ = FieldSet<Backend>();
    const auto info = old.info();
    for (int f = 0; f < old.fields(); ++f)
    {
        if (old.elementBytes(f) == 8) fields_.template add<std::int64_t>(info[f].name);
        else fields_.template add<std::int32_t>(info[f].name);
    }
    fields_.allocate(context_, n);
    for (int f = 0; f < fields_.fields(); ++f) std::memcpy(fields_.bytes(f), old.bytes(f), std::size_t(residents)*old.elementBytes(f));
    fields_.upload(context_, idField_, keys);

    // lists of before are about the slots of before: those behind have none
    const auto longer = [&](Array<Backend, int>& a, std::size_t size, int rest)
    {
        std::vector<int> all = a.download();
        all.resize(size, all.empty() ? 0 : (rest < 0 ? all.back() : rest));
        Array<Backend, int> fresh;
        fresh.upload(context_, all);
        a.swap(fresh);
    };
    list_.resize(context_, n);
    if (nWalls_)
        for (WallMemoryArrays<Backend, real>* w : {&wallMemory_, &oldWallMemory_})
        {
            longer(w->entryFirst, std::size_t(n) + 1, -1);
            longer(w->elementFirst, std::size_t(n) + 1, -1);
        }
    records_ = SolidRecordMemory<Backend, D, P>();
    records_.allocate(context_, n);
    reference_ = Array<Backend, position>();
    reference_.allocate(context_, std::size_t(n)*D);
    inverse_ = Array<Backend, int>();
    inverse_.allocate(context_, n);
    slotOf_ = Array<Backend, int>();
    slotOf_.allocate(context_, n);
    sort_ = CellSort<Backend>();
    sort_.allocate(context_, n, classes_.cells());
    context_.toDevice(const_cast<int*>(sort_.active()), &active, sizeof(int));
    n_ = n;
}

//- Who is in a slot from now on
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::takeKey(int slot, std::int32_t id)
{
    ids_[fields_.template data<std::int32_t>(idField_)[slot]] = id;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::packParticle(int slot, bool whole, RankBytes& to)
{
    const int key = fields_.template data<std::int32_t>(idField_)[slot];
    putValues(to, &ids_[key]);
    if (D == 2) putValues(to, &emptyCoordinate_[key]);
    for (int f = 0; f < fields_.fields(); ++f)
    {
        if (f == idField_ || f == calmField_) continue;
        const std::size_t each = fields_.elementBytes(f);
        putValues(to, fields_.bytes(f) + slot*each, each);
    }
    if (!whole) return;
    packContacts(slot, to);
    packWalls(slot, to);
}

//- Touching pairs of a particle with what they remember
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::packContacts([[maybe_unused]] int slot, [[maybe_unused]] RankBytes& to)
{
    if constexpr (!Backend::gpu)
    {
        const ContactListView<Backend, real> list = list_.view();
        const int words = list.historyWords(histories_);
        if (touchingOf_.empty())
        {
            touchingOf_.resize(others_->residents());
            for (int i = 0, last = activeSolids(); i < last; ++i)
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
            const std::int64_t pair[2] = {others_->number(list.owner[e]), others_->number(list.other(list.entry[e]))};
            putValues(to, pair, 2);
            putValues(to, list.history + e*words, histories_);
        }
    }
}

//- What a particle remembers of walls
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::packWalls(int slot, RankBytes& to)
{
    const WallMemoryArrays<Backend, real>& m = wallMemory_;
    const int first = nWalls_ ? m.entryFirst.data()[slot] : 0;
    const std::int32_t count = nWalls_ ? m.entryFirst.data()[slot + 1] - first : 0;
    putValues(to, &count);
    for (int e = first; e < first + count; ++e)
    {
        const std::size_t at = std::size_t(e)*wallTouches;
        putValues(to, &m.entry.data()[e].wall);
        putValues(to, m.on.data() + at, wallTouches);
        putValues(to, m.normal.data() + at*D, wallTouches*D);
        putValues(to, m.history.data() + at*histories_, wallTouches*histories_);
        putValues(to, m.force.data() + std::size_t(e)*wallWords<D>, wallWords<D>);
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::unpackParticle(int slot, bool whole, const unsigned char*& from)
{
    if (slot >= n_) setCapacity(std::max(slot + 1, n_ + n_/4) + 64);
    std::int32_t id;
    takeValues(from, &id);
    takeKey(slot, id);
    if (D == 2) takeValues(from, &emptyCoordinate_[fields_.template data<std::int32_t>(idField_)[slot]]);
    for (int f = 0; f < fields_.fields(); ++f)
    {
        if (f == idField_ || f == calmField_) continue;
        const std::size_t each = fields_.elementBytes(f);
        takeValues(from, fields_.bytes(f) + slot*each, each);
    }
    if (!whole) return;
    std::int32_t contacts, walls;
    takeValues(from, &contacts);
    for (int k = 0; k < contacts; ++k)
    {
        std::int64_t pair[2];
        takeValues(from, pair, 2);
        arrivedContacts_.push_back(RankContact{pair[0], pair[1]});
        arrivedHistories_.resize(arrivedHistories_.size() + histories_);
        takeValues(from, arrivedHistories_.data() + arrivedHistories_.size() - histories_, histories_);
    }
    takeValues(from, &walls);
    for (int k = 0; k < walls; ++k)
    {
        RankWall w;
        w.particle = slot;
        takeValues(from, &w.wall);
        takeValues(from, w.on, wallTouches);
        arrivedWalls_.push_back(w);
        const std::size_t numbers = std::size_t(wallTouches)*(D + histories_) + wallWords<D>;
        arrivedWallNumbers_.resize(arrivedWallNumbers_.size() + numbers);
        takeValues(from, arrivedWallNumbers_.data() + arrivedWallNumbers_.size() - numbers, numbers);
    }
}

//- After keys of all particles were found, before they are sorted: who is here from now on
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::regroup()
{
    if constexpr (!Backend::gpu)
    {
        if (surfaces_)
        {
            // keys change their particles
            const WallPassings passed = passed_.download()[0];
            if (passed.count && !passedBefore_) passedIdBefore_ = ids_[passed.key];
            passedBefore_ += passed.count;
            clearPassed();
        }
        for (auto* v : {&arrivedHistories_, &arrivedWallNumbers_}) v->clear();
        arrivedContacts_.clear();
        arrivedWalls_.clear();
        touchingOf_.clear();
        others_->migrate(sort_.keys(),
            [&](int slot, bool whole, RankBytes& to) { packParticle(slot, whole, to); },
            [&](int slot, bool whole, const unsigned char*& from) { unpackParticle(slot, whole, from); });
        for (RankContact& c : arrivedContacts_)
        {
            c.a = others_->slotOf(c.a);
            c.b = others_->slotOf(c.b);
        }
        const SolidFields<D, P> f = fields();
        for (const int slot : others_->left())
        {
            Vector3 x{{0, 0, 0}};
            if (D == 2) x[config_.axes[2]] = emptyCoordinate_[f.id[slot]];
            for (int d = 0; d < D; ++d) x[config_.axes[d]] = box_.toMetres(d, f.x[d][slot]);
            escaped_.push_back(x);
            escapedId_.push_back(ids_[f.id[slot]]);
        }
        std::vector<char> here(n_, 0);
        int k = 0;
        for (const int slot : others_->sequence())
        {
            f.calm[slot] = ghost(slot) ? ghostMark : -1;
            here[slot] = 1;
            sort_.keys()[k] = others_->cell(slot);
            sort_.indices()[k++] = std::uint32_t(slot);
        }
        for (int slot = 0; slot < n_; ++slot)
        {
            if (here[slot]) continue;
            sort_.keys()[k] = std::uint32_t(classes_.cells());
            sort_.indices()[k++] = std::uint32_t(slot);
        }
    }
}

//- Particles are in their new places
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::settleRanks()
{ others_->settle(newOrder(), activeSolids()); }

//- What contacts of arrivals remember, after the lists were written
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::takeContacts()
{
    if constexpr (!Backend::gpu)
    {
        int turns = 0;
        withLaw(laws_, [&](auto law) { turns = decltype(law)::template turnsFrom<D>; });
        const ContactListView<Backend, real> list = list_.view();
        const int words = list.historyWords(histories_), active = activeSolids();
        for (std::size_t c = 0; c < arrivedContacts_.size(); ++c)
        {
            const RankContact& pair = arrivedContacts_[c];
            if (pair.a < 0 || pair.b < 0) continue;
            const int i = inverse_.data()[pair.a], j = inverse_.data()[pair.b];
            if (i >= active || j >= active) continue;
            const bool turn = j < i;
            const int owner = turn ? j : i, partner = turn ? i : j;
            for (int k = 0; k < list.count[owner]; ++k)
            {
                const std::size_t e = list.index(owner, k);
                if (list.other(list.entry[e]) != partner) continue;
                list.entry[e] |= list.touching;
                for (int h = 0; h < histories_; ++h)
                {
                    const real value = arrivedHistories_[c*histories_ + h];
                    list.history[e*words + h] = turn && h >= turns ? -value : value;
                }
            }
        }
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::takeWallContacts()
{
    WallMemoryArrays<Backend, real>& m = wallMemory_;
    const std::size_t numbers = std::size_t(wallTouches)*(D + histories_) + wallWords<D>;
    for (std::size_t k = 0; k < arrivedWalls_.size(); ++k)
    {
        const RankWall& w = arrivedWalls_[k];
        const int i = inverse_.data()[w.particle];
        for (int e = m.entryFirst.data()[i]; e < m.entryFirst.data()[i + 1]; ++e)
        {
            if (m.entry.data()[e].wall != w.wall) continue;
            const real* from = &arrivedWallNumbers_[k*numbers];
            const std::size_t at = std::size_t(e)*wallTouches;
            std::copy_n(w.on, wallTouches, m.on.data() + at);
            std::copy_n(from, wallTouches*D, m.normal.data() + at*D);
            std::copy_n(from + wallTouches*D, wallTouches*histories_, m.history.data() + at*histories_);
            std::copy_n(from + wallTouches*(D + histories_), wallWords<D>, m.force.data() + std::size_t(e)*wallWords<D>);
        }
    }
}

//- Blocks of contacts are those of one process, as far as they are here
template<class Backend, int D, class P>
std::vector<int> DemSolver<Backend, D, P>::blockCuts()
{
    std::vector<int> cuts(1, 0);
#ifndef __CUDACC__
    const std::int64_t n = others_->total(), blocks = DeferredForces<D, real>::blocksOf(n);
    std::int64_t block = 0;
    for (int i = 0; i < others_->residents(); ++i)
    {
        const std::int64_t before = block;
        while (others_->number(i) >= n*(block + 1)/blocks) ++block;
        if (i > 0 && block > before) cuts.push_back(i);
    }
    cuts.push_back(others_->residents());
#endif
    return cuts;
}

//- After particles were moved: ghosts follow, and ranks agree on what the step has raised
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::shareStep()
{
    if constexpr (!Backend::gpu)
    {
        const SolidFields<D, P> f = fields();
        const SolidRecords<D, P> solids = records_.view();
        others_->share(D*(sizeof(std::int64_t) + sizeof(double)) + S*sizeof(real), [&](int i, unsigned char* to)
        {
            for (int d = 0; d < D; ++d)
            {
                std::memcpy(to + 8*d, f.x[d] + i, 8);
                std::memcpy(to + 8*(D + d), f.v[d] + i, 8);
            }
            for (int c = 0; c < S; ++c) std::memcpy(to + 16*D + c*sizeof(real), f.w[c] + i, sizeof(real));
        },
        [&](int i, const unsigned char* from)
        {
            for (int d = 0; d < D; ++d)
            {
                std::memcpy(f.x[d] + i, from + 8*d, 8);
                std::memcpy(f.v[d] + i, from + 8*(D + d), 8);
            }
            for (int c = 0; c < S; ++c) std::memcpy(f.w[c] + i, from + 16*D + c*sizeof(real), sizeof(real));
            Vec<D, position> p;
            for (int d = 0; d < D; ++d) p.c[d] = box_.pairPosition(d, f.x[d][i]);
            solids.store(i, p, ContactBody<D, real>{convert<real>(f.velocity(i)), f.spin(i), f.radius[i], f.mass[i]}, f.material[i]);
        });
        DemClockData& c = *clock_.data();
        std::vector<double> flags
        {
            double(c.needRebuild), double(c.aged[0]), double(c.aged[1]), double(c.far[0]), double(c.far[1]), double(int(c.halt)), double(interrupted_)
        };
        config_.ranks->largest(flags);
        int k = 0;
        for (int* to : {&c.needRebuild, c.aged, c.aged + 1, c.far, c.far + 1}) *to = int(flags[k++]);
        c.halt = DemHalt(int(flags[k++]));
        stopAgreed_ = flags[k] > 0;
    }
}

//- What is no number counts as infinite
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::largestOfRanks(double value) const
{
    if (!others_) return value;
    std::vector<double> v(1, value == value ? value : std::numeric_limits<double>::infinity());
    config_.ranks->largest(v);
    return v[0];
}

//- A guard has fired: the rank of the worst particle says which it is, and all report it
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::findOffenderOfRanks(DemReport& report)
{
    Transport& ranks = *config_.ranks;
    const int n = activeSolids();
    const std::vector<double> offence = offences(n);
    int worst = -1;
    for (int i = 0; i < n; ++i) if (!ghost(i) && (worst < 0 || offence[i] > offence[worst])) worst = i;
    const double here = worst < 0 ? -1 : offence[worst], most = largestOfRanks(here);
    const int speaker = ranks.size() - int(largestOfRanks(here == most ? ranks.size() - ranks.rank() : 0));
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

//- Rows of ghosts out of what is read back, `each` numbers a row
template<class Backend, int D, class P>
template<class T>
void DemSolver<Backend, D, P>::dropGhosts(std::vector<T>& v, int each)
{
    if (!others_ || v.empty()) return;
    std::size_t to = 0;
    for (int i = 0; i < others_->residents(); ++i)
    {
        if (ghost(i)) continue;
        std::copy_n(v.begin() + std::size_t(i)*each, each, v.begin() + to);
        to += each;
    }
    v.resize(to);
}

//- What parts of a scene cannot do yet
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::requireAlone(const char* what) const
{ if (others_) throw std::invalid_argument(std::string(what) + ": on one process alone"); }

} // namespace riprap

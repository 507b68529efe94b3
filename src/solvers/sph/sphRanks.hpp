/*  SphSolver on several ranks (CPU): each owns the fluid of its brick, and has ghosts of that of others that it may see.

    Ghosts stand among a rank's own particles in the order of their cells. They are sources of its passes and never targets. That order is the one of
    one process, and all that is in a row of cells within reach is there: packs of neighbours hold the same particles in the same lanes, sums are
    added up in the same order, and results are the same bits.

    Points of walls stand still, and are all on each rank. What the fluid about a point gives it is worked out by the rank that has its cell, and sent to those
    whose fluid may see it.

    In a step ranks send the pair records of ghosts, of each pass, and agree on the clock's maxima and flags: the time step is that of one process. At
    a rebuild particles change their ranks with all their fields.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/ranks/joinRanks.hpp"
#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

//- Before there are fields; cells are known
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setRanks()
{
    if (Backend::gpu) throw std::invalid_argument("several processes run on CPUs alone");
    others_ = std::make_unique<ParticleExchange>(*config_.ranks, config_.imbalance);
    PieceGrid g;
    for (int d = 0; d < 3; ++d) { g.n[d] = grid_.n[d]; g.stride[d] = grid_.stride[d]; }
    for (int d = 0; d < D; ++d)
    {
        g.lower[d] = box_.lower[d];
        g.size[d] = box_.length[d]/grid_.n[d];
        g.periodic[d] = grid_.periodic[d];
    }
    // who seeks may be as far from its cell as those that it finds; rows of cells are searched a hair beyond the radius (CellGrid)
    others_->setPieces({g}, 1.001*double(grid_.radius) + double(allowedWay_));
    others_->begin(n_);
}

//- All particles of the scene are here, as the words of a state have them
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::beginAnew()
{
    others_->begin(n_);
    left_ = SphReport();
    if (config_.ranks->rank() == 0) return;
    // sums of the first rank
    host_.faceContacts = host_.faceEnergy = host_.bodyContacts = 0;
    for (std::int64_t& c : host_.faceImpulse) c = 0;
    stiffening_ = 0;
    writeClock();
}

//- Memory for so many particles from now on; residents stay in their slots, and a rebuild does the rest
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setCapacity(int n)
{
    const int active = std::min(activeFluid(), n), kept = std::min({others_->residents(), n_, n});
    FieldSet<Backend> old(std::move(fluid_));
    fluid_ = FieldSet<Backend>();
    const auto info = old.info();
    for (int f = 0; f < old.fields(); ++f)
    {
        if (old.elementBytes(f) == 8) fluid_.template add<std::int64_t>(info[f].name);
        else fluid_.template add<std::int32_t>(info[f].name);
    }
    fluid_.allocate(context_, n);
    for (int f = 0; f < fluid_.fields(); ++f) std::memcpy(fluid_.bytes(f), old.bytes(f), std::size_t(kept)*old.elementBytes(f));
    fluidRecords_ = Records<Backend, D, P>();
    fluidRecords_.allocate(context_, n, model_.variableH);
    fluidReference_ = Array<Backend, position>();
    fluidReference_.allocate(context_, std::size_t(n)*D);
    fluidSort_ = CellSort<Backend>();
    fluidSort_.allocate(context_, n, grid_.cells);
    context_.toDevice(const_cast<int*>(fluidSort_.active()), &active, sizeof(int));
    n_ = n;
}

//- Memory for what is here, and some more
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::fitCapacity()
{
    setCapacity(others_->residents() + others_->residents()/4 + 256);
    rebuild();
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::packParticle(int slot, RankBytes& to)
{
    for (int f = 0; f < fluid_.fields(); ++f)
    {
        const std::size_t each = fluid_.elementBytes(f);
        putValues(to, fluid_.bytes(f) + slot*each, each);
    }
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::unpackParticle(int slot, const unsigned char*& from)
{
    if (slot >= n_) setCapacity(std::max(slot + 1, n_ + n_/4) + 64);
    for (int f = 0; f < fluid_.fields(); ++f)
    {
        const std::size_t each = fluid_.elementBytes(f);
        takeValues(from, fluid_.bytes(f) + slot*each, each);
    }
}

//- An own particle that is in no cell: it has escaped, or ran wild
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::noticeLeft(int slot)
{
    const FluidFields<D, P> f = fluidFields();
    Vector3 x{{emptyCoordinate_, emptyCoordinate_, emptyCoordinate_}};
    double speed2 = 0;
    for (int d = 0; d < D; ++d)
    {
        x[config_.axes[d]] = box_.toMetres(d, f.x[d][slot]);
        speed2 += double(f.v[d][slot])*f.v[d][slot];
    }
    if (f.id[slot] < 0)
    {
        left_.wild.push_back(WildParticle{-1 - f.id[slot], x, f.deviation[slot], std::sqrt(speed2)});
        return;
    }
    left_.escaped.push_back(x);
    left_.escapedId.push_back(f.id[slot]);
}

//- After keys of all particles were found, before they are sorted: who is here from now on
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::regroup()
{
    if constexpr (!Backend::gpu)
    {
        others_->migrate(fluidSort_.keys(),
            [&](int slot, bool, RankBytes& to) { packParticle(slot, to); },
            [&](int slot, bool, const unsigned char*& from) { unpackParticle(slot, from); });
        for (const int slot : others_->left()) noticeLeft(slot);
        std::vector<char> here(n_, 0);
        int k = 0;
        const auto put = [&](int slot, std::uint32_t cell)
        {
            fluidSort_.keys()[k] = cell;
            fluidSort_.indices()[k++] = std::uint32_t(slot);
        };
        for (const int slot : others_->sequence())
        {
            here[slot] = 1;
            put(slot, others_->cell(slot));
        }
        for (int slot = 0; slot < n_; ++slot) if (!here[slot]) put(slot, std::uint32_t(grid_.cells));
    }
}

//- Particles are in their new places
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::settleRanks()
{
    if constexpr (!Backend::gpu)
    {
        others_->settle(fluidSort_.order(), activeFluid());
        ghostMarks_.assign(n_, 0);
        for (int i = 0; i < others_->residents(); ++i) ghostMarks_[i] = ghost(i);
        if (others_->divisions() == wallsDivided_) return;
        divideWalls();
        wallsDivided_ = others_->divisions();
    }
}

template<class Backend, int D, class P>
std::uint32_t SphSolver<Backend, D, P>::cellOfPoint(const Vec<D, position>& x) const
{
    Vec<D, real> r;
    for (int d = 0; d < D; ++d) r.c[d] = box_.pairRelative(d, x.c[d]);
    return std::uint32_t(grid_.cellOf(r));
}

//- Which rank works out each point of the walls, and who is told
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::divideWalls()
{
    if constexpr (!Backend::gpu)
    {
        const int me = config_.ranks->rank(), size = config_.ranks->size();
        const RecordsView<Backend, D, P> walls = wallRecords_.view();
        std::vector<std::vector<int>> to(size), from(size);
        wallMarks_.assign(nWalls_, 0);
        for (int i = 0; i < nWalls_; ++i)
        {
            const std::uint32_t cell = cellOfPoint(walls.loadPosition(i));
            const int owner = others_->ownerOf(cell);
            wallMarks_[i] = owner != me;
            for (const int rank : others_->ghostsOf(cell))
            {
                if (owner == me) to[rank].push_back(i);
                else if (rank == me) from[owner].push_back(i);
            }
        }
        wallShares_.clear();
        for (int rank = 0; rank < size; ++rank)
        {
            wallShares_.send(rank, std::move(to[rank]));
            wallShares_.receive(rank, std::move(from[rank]));
        }
    }
}

template<class Backend, int D, class P>
GhostMarks<Backend> SphSolver<Backend, D, P>::marks([[maybe_unused]] const std::vector<char>& of) const
{
    if constexpr (Backend::gpu) return {};
    else return {of.empty() ? nullptr : of.data()};
}

//- What pairs see of fluid that is a ghost elsewhere
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::shareRecords()
{
    if constexpr (!Backend::gpu)
    {
        const RecordsView<Backend, D, P> r = fluidRecords_.view();
        constexpr std::size_t word = sizeof(real);
        others_->share(word*(2*D + 2 + (r.h ? 1 : 0)), [&](int i, unsigned char* to)
        {
            const auto put = [&](const auto* from) { std::memcpy(to, from + i, word); to += word; };
            for (int d = 0; d < D; ++d) { put(r.x[d]); put(r.velocity[d]); }
            put(r.pressureTerm);
            put(r.density);
            if (r.h) put(r.h);
        },
        [&](int i, const unsigned char* from)
        {
            const auto take = [&](auto* to) { std::memcpy(to + i, from, word); from += word; };
            for (int d = 0; d < D; ++d) { take(r.x[d]); take(r.velocity[d]); }
            take(r.pressureTerm);
            take(r.density);
            if (r.h) take(r.h);
        });
    }
}

//- The same of walls, which stand still; their h is that of the start
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::shareWalls()
{
    if constexpr (!Backend::gpu)
    {
        const RecordsView<Backend, D, P> r = wallRecords_.view();
        constexpr std::size_t word = sizeof(real);
        wallBytes_ += wallShares_.share(*config_.ranks, word*(D + 2), [&](int i, unsigned char* to)
        {
            const auto put = [&](const auto* from) { std::memcpy(to, from + i, word); to += word; };
            for (int d = 0; d < D; ++d) put(r.velocity[d]);
            put(r.pressureTerm);
            put(r.density);
        },
        [&](int i, const unsigned char* from)
        {
            const auto take = [&](auto* to) { std::memcpy(to + i, from, word); from += word; };
            for (int d = 0; d < D; ++d) take(r.velocity[d]);
            take(r.pressureTerm);
            take(r.density);
        });
    }
}

//- What the last pass, its step or a rebuild has raised on any rank
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::agree()
{
    if constexpr (!Backend::gpu)
    {
        ClockData& c = *clock_.data();
        std::vector<double> most(c.maxima, c.maxima + maximaCount);
        for (const int flag : {c.needRebuild, c.skinViolations, int(interrupted_)}) most.push_back(flag);
        config_.ranks->largest(most);
        for (int k = 0; k < maximaCount; ++k) c.maxima[k] = float(most[k]);
        c.needRebuild = int(most[maximaCount]);
        c.skinViolations = int(most[maximaCount + 1]);
        stopAgreed_ = most[maximaCount + 2] > 0;
    }
}

//- Before the first step of a call
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::agreeToStop()
{ stopAgreed_ = largestOfRanks(*config_.ranks, double(interrupted_)) > 0; }

//- Rows of ghosts out of what is read back, `each` numbers a row
template<class Backend, int D, class P>
template<class T>
void SphSolver<Backend, D, P>::dropGhosts(std::vector<T>& v, int each) const
{
    std::size_t to = 0;
    for (int i = 0; i < others_->residents(); ++i)
    {
        if (ghost(i)) continue;
        std::copy_n(v.begin() + std::size_t(i)*each, each, v.begin() + to);
        to += each;
    }
    v.resize(to);
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::reportRanks(SphReport& report)
{
    report.fluid = std::size_t(others_->total());
    report.escaped.swap(left_.escaped);
    report.escapedId.swap(left_.escapedId);
    report.wild.swap(left_.wild);
    left_ = SphReport();
    const ParticleExchange::Counts& c = others_->counts();
    report.rank = RankReport
    {
        std::size_t(others_->ownedHere()), std::size_t(others_->ghostsHere()), c.arrivals, c.divisions, c.bytesShared + wallBytes_, c.bytesMigrating
    };
}

//- A guard has fired: the rank of the worst particle says which it is, and all report it
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::findOffenderOfRanks(SphReport& report)
{
    Transport& ranks = *config_.ranks;
    const double here = findWorst(report), most = largestOfRanks(ranks, here);
    const int speaker = ranks.size() - int(largestOfRanks(ranks, here == most ? ranks.size() - ranks.rank() : 0));
    RankBytes own;
    putValues(own, &report.stopId);
    putValues(own, report.stopPosition.data(), 3);
    putValues(own, &report.stopValue);
    if (speaker >= ranks.size()) return;
    const std::vector<RankBytes> all = toAll(ranks, own);
    const unsigned char* from = all[speaker].data();
    takeValues(from, &report.stopId);
    takeValues(from, report.stopPosition.data(), 3);
    takeValues(from, &report.stopValue);
}

//- What ranks have summed since the start
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::sumOfRanks(ClockData& c, double& stiffening) const
{
    std::vector<std::int64_t> sums{c.faceContacts, c.faceEnergy, c.bodyContacts};
    sums.insert(sums.end(), c.faceImpulse, c.faceImpulse + 3);
    std::vector<double> energy(1, stiffening);
    config_.ranks->sum(sums);
    addByRank(*config_.ranks, energy);
    c.faceContacts = sums[0];
    c.faceEnergy = sums[1];
    c.bodyContacts = sums[2];
    std::copy_n(sums.begin() + 3, 3, c.faceImpulse);
    stiffening = energy[0];
}

//- A field of all particles, on the first rank, in the order of one process
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::fieldOfRanks(FieldSet<Backend>& set, int field, std::int32_t* to)
{
    Transport& ranks = *config_.ranks;
    const std::size_t each = set.elementBytes(field);
    std::vector<RankBytes> out(ranks.size()), in;
    for (int i = 0; i < others_->residents(); ++i)
    {
        if (ghost(i)) continue;
        const std::int64_t number = others_->number(i);
        putValues(out[0], &number);
        putValues(out[0], set.bytes(field) + i*each, each);
    }
    ranks.exchange(out, in);
    for (const RankBytes& bytes : in)
        for (const unsigned char* from = bytes.data(); from < bytes.data() + bytes.size();)
        {
            std::int64_t number;
            takeValues(from, &number);
            takeValues(from, reinterpret_cast<unsigned char*>(to) + number*each, each);
        }
}

//- As farEndOf, of the particles of this rank: where the fluid of all ranks ends decides
template<class Backend, int D, class P>
FluidEnd SphSolver<Backend, D, P>::farEndOfRanks(const Vector3& direction, double reach)
{
    const std::vector<double> x = fluid().position;
    FluidEnd end;
    end.particles = x.size()/3;
    std::vector<double> along(end.particles, 0.0);
    double most = -1e300, size = 0;
    for (int d = 0; d < D; ++d) size += std::abs(box_.lower[d]) + 2*box_.length[d];
    for (std::size_t i = 0; i < along.size(); ++i)
    {
        for (int d = 0; d < D; ++d) along[i] += direction[config_.axes[d]]*x[3*i + config_.axes[d]];
        most = std::max(most, along[i]);
    }
    const double least = largestOfRanks(*config_.ranks, most) - reach - 1e-12*size;
    for (std::size_t i = 0; i < along.size(); ++i)
        if (along[i] >= least) end.position.insert(end.position.end(), &x[3*i], &x[3*i] + 3);
    return end;
}

//- A state that the first rank has, on all of them
template<class Backend, int D, class P>
std::vector<std::int32_t> SphSolver<Backend, D, P>::wordsOfFirst(const std::vector<std::int32_t>& words)
{
    RankBytes own;
    if (config_.ranks->rank() == 0) putValues(own, words.data(), words.size());
    const std::vector<RankBytes> all = toAll(*config_.ranks, own);
    std::vector<std::int32_t> first(all[0].size()/sizeof(std::int32_t));
    if (!first.empty()) std::memcpy(first.data(), all[0].data(), all[0].size());
    return first;
}

} // namespace riprap

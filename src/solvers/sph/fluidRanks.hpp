/*  The fluid of a scene on several ranks (CPU): each owns that of its brick, and has ghosts of that
    of others that it may see.

    Ghosts stand among a rank's own particles in the order of their cells. They are sources of its
    passes and never targets. That order is the one of one process, and all that is in a row of
    cells within reach is there: packs of neighbours hold the same particles in the same lanes, sums
    are added up in the same order, and results are the same bits.

    Points of walls: solvers/sph/parts/wallRanks.hpp.

    In a step ranks send the pair records of ghosts, of each pass, and agree on the clock's maxima
    and flags: the time step is that of one process. At a rebuild particles change their ranks with
    all their fields.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellSort.hpp"
#include "core/ranks/ghostMarks.hpp"
#include "core/ranks/joinRanks.hpp"
#include "core/ranks/particleExchange.hpp"
#include "solvers/sph/sphFamilies.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class FluidRanks
{
    using real = typename P::real;
    using position = typename P::position;

public:

    //- Of the solver: what is divided
    struct Scene
    {
        const SphConfig& config;
        const Box<D, P>& box;
        const CellGrid<D, P>& grid;
        FieldSet<Backend>& fluid;
        Records<Backend, D, P>& records;
        CellSort<Backend>& sort;
        const int& n;               // slots
        const double& nowhere;      // [m] coordinate along the empty axis
    };

    //- Before there are fields; cells are known. way: of a particle, for which neighbours hold [m]
    FluidRanks(const Scene&, double way);

    //- All particles of the scene are here, as the words of a state have them; sums since the start
    //  are the first rank's
    void begin(ClockData&, double& stiffening);

    bool first() const { return ranks().rank() == 0; }
    const ParticleExchange& particles() const { return exchange_; }
    ParticleExchange& particles() { return exchange_; }
    //- Slots for what is here, and some more
    int room() const { return exchange_.residents() + exchange_.residents()/4 + 256; }

    //- After keys of all particles were found, before they are sorted: who is here from now on.
    //  grow(n): memory for so many; fields(): the fluid's, as they lie then
    template<class Grow, class Fields>
    void migrate(const Grow& grow, const Fields& fields);
    //- Particles are in their new places, `active` of them
    void settle(int active);

    bool ghost(int i) const { return exchange_.kind(i) == ParticleExchange::ghost; }
    GhostMarks<Backend> marks() const { return ghostMarks<Backend>(ghosts_); }
    std::uint32_t cellOf(const Vec<D, position>& x) const;
    //- Is a point in a cell of this rank?
    bool has(const Vec<D, position>& x) const
    {
        return exchange_.ownerOf(cellOf(x)) == ranks().rank();
    }

    //- What pairs see of fluid that is a ghost elsewhere
    void shareRecords();

    //- What the last pass, its step or a rebuild has raised on any rank
    void agree(ClockData&, bool interrupted);
    //- Before the first step of a call
    void agreeToStop(bool interrupted) { stop_ = largestOfRanks(ranks(), double(interrupted)) > 0; }
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
    //- Those of this rank within reach of where the fluid of all ranks ends. x: all of this rank,
    //  three coordinates each
    FluidEnd farEnd(const std::vector<double>& x, const Vector3& direction, double reach) const;
    //- A state that the first rank has, on all of them
    std::vector<std::int32_t> ofFirst(const std::vector<std::int32_t>& words) const;

private:

    Transport& ranks() const { return *s_.config.ranks; }
    void noticeLeft(int slot, const FluidFields<D, P>&);

    Scene s_;
    ParticleExchange exchange_;
    std::vector<char> ghosts_;
    bool stop_ = false;
    // escaped and wild particles since the last report
    SphReport left_;
};

template<class Backend, int D, class P>
FluidRanks<Backend, D, P>::FluidRanks(const Scene& scene, double way)
    : s_(scene), exchange_(*scene.config.ranks, scene.config.imbalance)
{
    if (Backend::gpu) throw std::invalid_argument("several processes run on CPUs alone");
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
    exchange_.setPieces({g}, 1.001*double(s_.grid.radius) + way);
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

//- An own particle that is in no cell: it has escaped, or ran wild
template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::noticeLeft(int slot, const FluidFields<D, P>& f)
{
    Vector3 x{{s_.nowhere, s_.nowhere, s_.nowhere}};
    double speed2 = 0;
    for (int d = 0; d < D; ++d)
    {
        x[s_.config.axes[d]] = s_.box.toMetres(d, f.x[d][slot]);
        speed2 += double(f.v[d][slot])*f.v[d][slot];
    }
    if (f.id[slot] < 0)
    {
        left_.wild.push_back(
            WildParticle{-1 - f.id[slot], x, f.deviation[slot], std::sqrt(speed2)});
        return;
    }
    left_.escaped.push_back(x);
    left_.escapedId.push_back(f.id[slot]);
}

template<class Backend, int D, class P>
template<class Grow, class Fields>
void FluidRanks<Backend, D, P>::migrate(const Grow& grow, const Fields& fields)
{
    if constexpr (!Backend::gpu)
    {
        const auto pack = [&](int slot, bool, RankBytes& to)
        {
            for (int f = 0; f < s_.fluid.fields(); ++f)
            {
                const std::size_t each = s_.fluid.elementBytes(f);
                putValues(to, s_.fluid.bytes(f) + slot*each, each);
            }
        };
        const auto unpack = [&](int slot, bool, const unsigned char*& from)
        {
            if (slot >= s_.n) grow(std::max(slot + 1, s_.n + s_.n/4) + 64);
            for (int f = 0; f < s_.fluid.fields(); ++f)
            {
                const std::size_t each = s_.fluid.elementBytes(f);
                takeValues(from, s_.fluid.bytes(f) + slot*each, each);
            }
        };
        exchange_.migrate(s_.sort.keys(), pack, unpack);
        for (const int slot : exchange_.left()) noticeLeft(slot, fields());
        std::vector<char> here(s_.n, 0);
        int k = 0;
        const auto put = [&](int slot, std::uint32_t cell)
        {
            s_.sort.keys()[k] = cell;
            s_.sort.indices()[k++] = std::uint32_t(slot);
        };
        for (const int slot : exchange_.sequence())
        {
            here[slot] = 1;
            put(slot, exchange_.cell(slot));
        }
        for (int slot = 0; slot < s_.n; ++slot)
            if (!here[slot]) put(slot, std::uint32_t(s_.grid.cells));
    }
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::settle(int active)
{
    if constexpr (!Backend::gpu)
    {
        exchange_.settle(s_.sort.order(), active);
        ghosts_.assign(s_.n, 0);
        for (int i = 0; i < exchange_.residents(); ++i) ghosts_[i] = ghost(i);
    }
}

template<class Backend, int D, class P>
std::uint32_t FluidRanks<Backend, D, P>::cellOf(const Vec<D, position>& x) const
{
    Vec<D, real> r;
    for (int d = 0; d < D; ++d) r.c[d] = s_.box.pairRelative(d, x.c[d]);
    return std::uint32_t(s_.grid.cellOf(r));
}

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::shareRecords()
{
    if constexpr (!Backend::gpu)
    {
        const RecordsView<Backend, D, P> r = s_.records.view();
        constexpr std::size_t word = sizeof(real);
        exchange_.share(word*(2*D + 2 + (r.h ? 1 : 0)), [&](int i, unsigned char* to)
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

template<class Backend, int D, class P>
void FluidRanks<Backend, D, P>::agree(ClockData& c, bool interrupted)
{
    std::vector<double> most(c.maxima, c.maxima + maximaCount);
    for (const int flag : {c.needRebuild, c.skinViolations, int(interrupted)}) most.push_back(flag);
    ranks().largest(most);
    for (int k = 0; k < maximaCount; ++k) c.maxima[k] = float(most[k]);
    c.needRebuild = int(most[maximaCount]);
    c.skinViolations = int(most[maximaCount + 1]);
    stop_ = most[maximaCount + 2] > 0;
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
void FluidRanks<Backend, D, P>::report(SphReport& report)
{
    report.fluid = std::size_t(exchange_.total());
    report.escaped.swap(left_.escaped);
    report.escapedId.swap(left_.escapedId);
    report.wild.swap(left_.wild);
    left_ = SphReport();
    const ParticleExchange::Counts& c = exchange_.counts();
    report.rank = RankReport{std::size_t(exchange_.ownedHere()),
        std::size_t(exchange_.ghostsHere()), c.arrivals, c.divisions, c.bytesShared,
        c.bytesMigrating};
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
    std::vector<RankBytes> out(ranks().size()), in;
    for (int i = 0; i < exchange_.residents(); ++i)
    {
        if (ghost(i)) continue;
        const std::int64_t number = exchange_.number(i);
        putValues(out[0], &number);
        putValues(out[0], set.bytes(field) + i*each, each);
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
FluidEnd FluidRanks<Backend, D, P>::farEnd(
    const std::vector<double>& x, const Vector3& direction, double reach) const
{
    FluidEnd end;
    end.particles = x.size()/3;
    std::vector<double> along(end.particles, 0.0);
    double most = -1e300, size = 0;
    for (int d = 0; d < D; ++d) size += std::abs(s_.box.lower[d]) + 2*s_.box.length[d];
    for (std::size_t i = 0; i < along.size(); ++i)
    {
        for (int d = 0; d < D; ++d)
            along[i] += direction[s_.config.axes[d]]*x[3*i + s_.config.axes[d]];
        most = std::max(most, along[i]);
    }
    const double least = largestOfRanks(ranks(), most) - reach - 1e-12*size;
    for (std::size_t i = 0; i < along.size(); ++i)
        if (along[i] >= least) end.position.insert(end.position.end(), &x[3*i], &x[3*i] + 3);
    return end;
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

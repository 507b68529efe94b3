/*  Particles that walk at random on ranks, beside the same without ranks: for tests of who goes
    where, on threads and on processes.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include "core/ranks/particleExchange.hpp"

namespace riprap
{

constexpr double walkReach = 0.02;

//- A box of cells for particles of one or two sizes
struct Tank
{
    double lower[3], length[3];
    bool periodic[3];
    std::vector<PieceGrid> grids;
    std::vector<int> firstCell{0};

    Tank(double lx, double ly, double lz, std::array<bool, 3> wraps,
        const std::vector<double>& radii, bool zFirst = false)
    {
        const double l[3] = {lx, ly, lz};
        for (int d = 0; d < 3; ++d)
        {
            lower[d] = -0.3 + d;
            length[d] = l[d];
            periodic[d] = wraps[d];
        }
        for (const double r : radii)
        {
            PieceGrid g;
            for (int d = 0; d < 3; ++d)
            {
                g.n[d] = std::max(1, int(l[d]/((2*r + walkReach)/(d == 0 ? 2 : 1))));
                g.lower[d] = lower[d];
                g.size[d] = l[d]/g.n[d];
                g.periodic[d] = wraps[d];
            }
            g.stride[zFirst ? 2 : 1] = g.n[0];
            g.stride[zFirst ? 1 : 2] = g.n[0]*g.n[zFirst ? 2 : 1];
            g.radius = r;
            grids.push_back(g);
            firstCell.push_back(firstCell.back() + g.n[0]*g.n[1]*g.n[2]);
        }
    }

    int cells() const { return firstCell.back(); }

    //- Of a particle of size class k; cells(): it is out
    std::uint32_t cellOf(const double* x, int k) const
    {
        const PieceGrid& g = grids[k];
        int cell = firstCell[k];
        for (int d = 0; d < 3; ++d)
        {
            if (!periodic[d] && (x[d] < lower[d] || x[d] > lower[d] + length[d]*(1 + 1e-9)))
                return std::uint32_t(cells());
            const int c = std::min(g.n[d] - 1, std::max(0, int((x[d] - lower[d])/g.size[d])));
            cell += c*g.stride[d];
        }
        return std::uint32_t(cell);
    }

    double distance2(const double* a, const double* b) const
    {
        double sum = 0;
        for (int d = 0; d < 3; ++d)
        {
            double s = std::abs(a[d] - b[d]);
            if (periodic[d]) s = std::min(s, length[d] - s);
            sum += s*s;
        }
        return sum;
    }
};

//- A particle: where it is follows from its id and how often it has moved, so all ranks can tell
//  what another has
struct Walker { std::int32_t id = -1, size = 0; double x[3] = {0, 0, 0}; std::int64_t state = 0; };

//- Numbers in [0, 1) that follow from the seed (splitmix64)
struct Numbers
{
    std::uint64_t state;
    double operator()()
    {
        std::uint64_t z = state += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30))*0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27))*0x94d049bb133111ebull;
        return double((z ^ (z >> 31)) >> 11)/9007199254740992.0;
    }
};

//- Moves of any length: most are short, some across the tank, some onto corners and edges of cells
struct Walk
{
    const Tank& tank;
    double far, leaves;

    void move(Walker& w, int step) const
    {
        Numbers u{std::uint64_t(w.id)*1000003u + std::uint64_t(step)};
        const double kind = u();
        for (int d = 0; d < 3; ++d)
        {
            const PieceGrid& g = tank.grids[w.size];
            if (kind < far) w.x[d] = tank.lower[d] + u()*tank.length[d];
            else if (kind < 1.2*far) w.x[d] = tank.lower[d] + int(u()*(g.n[d] + 1))*g.size[d];
            else w.x[d] += (u() - 0.5)*g.size[d];
            const double from = tank.lower[d], l = tank.length[d];
            if (tank.periodic[d]) w.x[d] -= std::floor((w.x[d] - from)/l)*l;
            else if (!(kind > 1 - leaves)) w.x[d] = std::min(from + l, std::max(from, w.x[d]));
        }
        if (kind > 1 - leaves)
            w.x[1] = tank.lower[1] + (tank.periodic[1] ? 0.5 : 1.5)*tank.length[1];
        w.state = w.state*6364136223846793005ll + w.id + step;
    }
};

inline std::vector<Walker> crowd(const Tank& tank, int n, double within = 1)
{
    std::vector<Walker> all(n);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(0, 1);
    for (int i = 0; i < n; ++i)
    {
        all[i].id = 3*i + 1;
        all[i].size = int(i % tank.grids.size());
        for (int d = 0; d < 3; ++d) all[i].x[d] = tank.lower[d] + within*u(random)*tank.length[d];
    }
    return all;
}

//- Particles of a rank, as a solver has them
struct Here
{
    const Tank& tank;
    ParticleExchange exchange;
    std::vector<Walker> walker;

    Here(const Tank& t, Transport& transport, const std::vector<Walker>& all, double imbalance)
    : tank(t), exchange(transport, imbalance), walker(all)
    {
        exchange.setPieces(tank.grids, walkReach);
        exchange.begin(int(all.size()));
    }

    void rebuild()
    {
        std::vector<std::uint32_t> cell(walker.size());
        for (std::size_t i = 0; i < walker.size(); ++i)
            cell[i] = tank.cellOf(walker[i].x, walker[i].size);
        exchange.migrate(
            cell.data(),
            [&](int slot, bool whole, RankBytes& to)
            {
                putValues(to, &walker[slot]);
                if (whole) putValues(to, &walker[slot].state);
            },
            [&](int slot, bool whole, const unsigned char*& from)
            {
                if (slot >= int(walker.size())) walker.resize(slot + 1);
                takeValues(from, &walker[slot]);
                std::int64_t again = 0;
                if (whole) takeValues(from, &again);
                if (whole && again != walker[slot].state)
                    throw std::logic_error("a particle came with another's extra numbers");
            });
        std::vector<std::uint32_t> order(exchange.sequence().begin(), exchange.sequence().end());
        std::stable_sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return exchange.cell(a) < exchange.cell(b); });
        exchange.settle(order.data(), int(order.size()));
        std::vector<Walker> sorted;
        for (const std::uint32_t slot : order) sorted.push_back(walker[slot]);
        walker.swap(sorted);
    }

    //- Own particles move, ghosts follow by a message
    void step(const Walk& walk, int number)
    {
        for (std::size_t i = 0; i < walker.size(); ++i)
            if (exchange.kind(int(i)) == ParticleExchange::owned) walk.move(walker[i], number);
        exchange.share(
            sizeof(double)*3 + sizeof(std::int64_t),
            [&](int i, unsigned char* to)
            {
                std::memcpy(to, walker[i].x, 24);
                std::memcpy(to + 24, &walker[i].state, 8);
            },
            [&](int i, const unsigned char* from)
            {
                std::memcpy(walker[i].x, from, 24);
                std::memcpy(&walker[i].state, from + 24, 8);
            });
    }
};

//- The same without ranks: the order that one process has
struct Alone
{
    const Tank& tank;
    std::vector<Walker> walker;

    void rebuild()
    {
        std::vector<Walker> in;
        for (const Walker& w : walker)
            if (tank.cellOf(w.x, w.size) < std::uint32_t(tank.cells())) in.push_back(w);
        std::stable_sort(in.begin(), in.end(), [&](const Walker& a, const Walker& b)
        { return tank.cellOf(a.x, a.size) < tank.cellOf(b.x, b.size); });
        walker.swap(in);
    }
    void step(const Walk& walk, int number) { for (Walker& w : walker) walk.move(w, number); }
};

inline bool same(const Walker& a, const Walker& b)
{
    return a.id == b.id && a.state == b.state && std::memcmp(a.x, b.x, sizeof(a.x)) == 0;
}

//- After a rebuild: each particle has one owner, ranks have them in the order of one process, and
//  all that own particles may touch are here
inline void compare(Here& here, const Alone& alone, bool pairs)
{
    const auto require = [](bool good, const char* why)
    {
        if (!good) throw std::runtime_error(why);
    };
    std::vector<std::int64_t> owners(alone.walker.size(), 0);
    std::int64_t before = -1;
    require(here.walker.size() == std::size_t(here.exchange.residents()),
        "residents are not those that are here");
    for (std::size_t i = 0; i < here.walker.size(); ++i)
    {
        const std::int64_t number = here.exchange.number(int(i));
        require(
            number > before && number < std::int64_t(alone.walker.size()), "numbers do not ascend");
        before = number;
        require(same(here.walker[i], alone.walker[number]),
            "a particle is another than on one process, or elsewhere in the order");
        owners[number] += here.exchange.kind(int(i)) == ParticleExchange::owned;
    }
    here.exchange.transport().sum(owners);
    for (const std::int64_t o : owners) require(o == 1, "a particle has no owner, or several");
    for (std::size_t i = 0; pairs && i < here.walker.size(); ++i)
    {
        if (here.exchange.kind(int(i)) != ParticleExchange::owned) continue;
        const Walker& a = here.walker[i];
        for (std::size_t j = 0; j < alone.walker.size(); ++j)
        {
            const Walker& b = alone.walker[j];
            const double touch = here.tank.grids[a.size].radius + here.tank.grids[b.size].radius
                + walkReach;
            require(!(here.tank.distance2(a.x, b.x) < touch*touch)
                    || here.exchange.slotOf(std::int64_t(j)) >= 0,
                "a neighbour is not here");
        }
    }
}

struct WalkSum { std::int64_t arrivals = 0, divisions = 0, leftOver = 0; };

//- What each rank runs. comparePairsEvery: so many rebuilds; 0: never
inline WalkSum walkOnRank(Transport& transport, const Tank& tank, int n, int rebuilds,
    const Walk& walk, double imbalance, int comparePairsEvery, double within = 1)
{
    const std::vector<Walker> all = crowd(tank, n, within);
    Here here(tank, transport, all, imbalance);
    Alone alone{tank, all};
    int step = 0;
    for (int k = 0; k < rebuilds; ++k)
    {
        here.rebuild();
        alone.rebuild();
        compare(here, alone, comparePairsEvery && k % comparePairsEvery == 0);
        for (int s = 0; s < 2; ++s, ++step) { here.step(walk, step); alone.step(walk, step); }
    }
    std::vector<std::int64_t> arrivals(1, here.exchange.counts().arrivals);
    transport.sum(arrivals);
    return WalkSum{
        arrivals[0], here.exchange.counts().divisions, std::int64_t(alone.walker.size())};
}

} // namespace riprap

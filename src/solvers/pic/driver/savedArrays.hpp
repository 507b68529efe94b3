/*  Arrays of a saved state, which holds those of all ranks in the order of one process.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

//- Where it is, bytes of a value; direction: of the faces, -1: of cells, or of particles
struct SavedArray
{
    static constexpr int particles = -2;
    unsigned char* data;
    std::size_t each;
    int direction;
};

//- Values of all ranks
template<class Backend, int D, class P>
std::size_t savedCount(
    const PicParts<Backend, D, P>& p, const SavedArray& a, std::int64_t particles)
{
    const UniformGrid<D>& grid = p.set.whole();
    if (a.direction == SavedArray::particles) return std::size_t(particles);
    return std::size_t(a.direction < 0 ? grid.cells() : grid.faces(a.direction));
}

//- Where one process has the particles that ranks have, one rank's after the other's: in the order
//  of cells. Of one rank: empty
template<class Backend, int D, class P>
std::vector<std::size_t> orderOfAll(PicParts<Backend, D, P>& p)
{
    std::vector<std::size_t> order;
    if (!p.halo) return order;
    const UniformGrid<D>& grid = p.set.grid;
    const std::vector<int> start = p.particles.starts(), own = p.particles.own();
    std::vector<std::int64_t> cells;
    int cell = 0;
    for (const int i : own)
    {
        while (start[cell + 1] <= i) ++cell;
        auto c = grid.cellIndex(cell);
        for (int d = 0; d < D; ++d) c.c[d] += grid.first[d];
        cells.push_back(p.set.whole().cell(c));
    }
    join(p.halo->ranks(), cells);
    order.resize(cells.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
        [&](std::size_t a, std::size_t b) { return cells[a] < cells[b]; });
    return order;
}

//- f(a number of the array's type)
template<class F>
void withBytes(std::size_t bytes, const F& f)
{
    if (bytes == 8) return f(std::uint64_t());
    f(std::uint32_t());
}

//- Of several ranks, in the order of one process
template<class Backend, int D, class P>
void saveOfRanks(PicParts<Backend, D, P>& p, const SavedArray& a,
    const std::vector<std::size_t>& order, std::int32_t* to)
{
    withBytes(a.each, [&](auto type)
    {
        using T = decltype(type);
        const T* from = reinterpret_cast<const T*>(a.data);
        std::vector<T> values;
        if (a.direction != SavedArray::particles) values = p.halo->gather(from, a.direction);
        else
        {
            values.resize(std::size_t(p.particles.n));
            if (!values.empty()) p.set.context.toHost(values.data(), from, values.size()*a.each);
            std::vector<T> own;
            for (const int i : p.particles.own()) own.push_back(values[i]);
            join(p.halo->ranks(), own);
            arrange(own, 1, order);
            values.swap(own);
        }
        if (!values.empty()) std::memcpy(to, values.data(), values.size()*a.each);
    });
}

//- Of a state's particles those in cells of this rank's part. fields: of the state, places first
template<class Backend, int D, class P>
std::vector<std::size_t> seenOf(const PicParts<Backend, D, P>& p,
    const std::vector<const std::int32_t*>& fields, std::size_t particles)
{
    const CellBox part = p.set.bricks->part(p.set.bricks->rank());
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < particles; ++i)
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) std::memcpy(&x.c[d], fields[d] + 2*i, sizeof(double));
        const auto c = InCell<D, typename P::real>(p.set.whole(), x).index();
        if (part.has(c.c)) own.push_back(i);
    }
    return own;
}

//- own: the particles of the state that are kept; of one rank all are
template<class Backend, int D, class P>
void loadArray(PicParts<Backend, D, P>& p, const SavedArray& a,
    const std::vector<std::size_t>& own, const std::int32_t* from, std::int64_t particles)
{
    withBytes(a.each, [&](auto type)
    {
        using T = decltype(type);
        std::vector<T> values(savedCount(p, a, particles));
        if (!values.empty()) std::memcpy(values.data(), from, values.size()*a.each);
        if (p.halo && a.direction != SavedArray::particles)
            values = p.halo->partOf(values, a.direction);
        else if (p.halo)
        {
            std::vector<T> seen;
            seen.reserve(own.size());
            for (const std::size_t i : own) seen.push_back(values[i]);
            values.swap(seen);
        }
        if (!values.empty()) p.set.context.toDevice(a.data, values.data(), values.size()*a.each);
    });
}

//- On all ranks what the first has
inline std::vector<std::int32_t> wordsOfFirst(
    Transport& ranks, const std::vector<std::int32_t>& words)
{
    RankBytes own;
    if (ranks.rank() == 0) putValues(own, words.data(), words.size());
    const std::vector<RankBytes> all = toAll(ranks, own);
    std::vector<std::int32_t> found(all[0].size()/sizeof(std::int32_t));
    if (!found.empty()) std::memcpy(found.data(), all[0].data(), all[0].size());
    return found;
}

} // namespace riprap

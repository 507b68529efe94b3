/*  Water without a surface where ranks divide the grid: pockets (pic/pressure/pockets.hpp) that may
    lie on several of them.

    Each rank finds what holds together in its brick, and calls it by the number that the first cell
    has in the block. Ranks tell these numbers, with whether p = 0 is tied to there, to those beside
    them; pairs of numbers that a face joins are told to all, who unite them alike. Sums over a
    pocket are of integers, as on one process.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>
#include "pic/pressure/pockets.hpp"
#include "pic/ranks/levelHalo.hpp"

namespace riprap
{

//- The number of what a cell holds together with, from 1 on, below 0 where p = 0 is tied to; 0: no
//  unknown. Bits: is it joined to the cell below it along each direction?
template<int D>
struct NamePockets
{
    static constexpr const char* name = "pressurePocketName";
    FineData<D> f;
    const int* parent;
    const std::int64_t* sums;
    int first[3], n[3];         // of the part in the block; cells of that
    int* label;
    unsigned char* joined;

    HD void operator()(int i) const
    {
        label[i] = 0;
        joined[i] = 0;
        const Place<D> c = f.shape.place(i);
        if (!f.shape.inside(c)) return;
        for (int d = 0; d < D; ++d)
            joined[i] |= static_cast<unsigned char>((f.a[d][i] > 0 ? 1 : 0) << d);
        if (!(f.inverse[i] > 0)) return;
        const int root = parent[i];
        const Place<D> p = f.shape.place(root);
        int number = 0;
        for (int d = D - 1; d >= 0; --d) number = number*n[d] + first[d] + p.x[d];
        label[i] = sums[3*root] ? -1 - number : 1 + number;
    }
};

//- Which names ranks' faces have made one
class PocketNames
{
public:

    //- Below 0: p = 0 is tied to
    void join(int a, int b)
    {
        for (const int name : {a, b}) if (name < 0) tied_.insert(root(-name));
        const int one = root(std::abs(a)), two = root(std::abs(b));
        if (one == two) return;
        const int least = std::min(one, two), other = std::max(one, two);
        up_[other] = least;
        if (tied_.count(other)) tied_.insert(least);
    }

    //- Of water without a surface its common name; 0: it has one
    int pocket(int name) const
    {
        if (name <= 0) return 0;
        const int common = root(name);
        return tied_.count(common) ? 0 : common;
    }

private:

    int root(int name) const
    {
        for (auto up = up_.find(name); up != up_.end(); up = up_.find(name)) name = up->second;
        return name;
    }

    std::map<int, int> up_;
    std::set<int> tied_;
};

template<class Backend, int D>
class DividedPockets
{
public:

    DividedPockets(const GridBricks<D>& bricks, LevelHalo<Backend, D>& halo)
        : bricks_(bricks), halo_(halo)
    {}

    //- Of the brick's unknowns; part: memory for those of the rank's part. \return are there any,
    //  on any rank?
    bool find(Context<Backend>& context, Pockets<Backend, D>& part, const FineData<D>& f,
        const TiledCells<D>& cells);

    //- After find(): the right-hand side sums to zero over each
    void balance(Context<Backend>& context, const FineData<D>& f)
    {
        takeMean(context, f, f.rhs, true);
    }

    //- p has a mean of zero in each
    void level(Context<Backend>& context, const FineData<D>& f)
    {
        takeMean(context, f, f.x, false);
    }

private:

    struct Cell { int at, pocket; std::int64_t weight; };
    struct Sums { int pocket; std::int64_t value, weight; };

    PocketNames unite(const GridShape<D>& shape, const std::vector<int>& label,
        const std::vector<unsigned char>& joined) const;
    void takeMean(
        Context<Backend>& context, const FineData<D>& f, double* values, bool byDiagonal);

    const GridBricks<D>& bricks_;
    LevelHalo<Backend, D>& halo_;
    Array<Backend, int> label_;
    Array<Backend, unsigned char> joined_;
    std::vector<Cell> cells_;                   // of this rank that lie in one
};

//- Across the lower ends of the brick: each face between two bricks is such a one's
template<class Backend, int D>
PocketNames DividedPockets<Backend, D>::unite(const GridShape<D>& shape,
    const std::vector<int>& label, const std::vector<unsigned char>& joined) const
{
    const CellBox brick = halo_.brickInPart();
    const int origin[3] = {0, 0, 0};
    int stride[3] = {1, 0, 0};
    for (int d = 0; d < D; ++d) stride[d] = shape.stride[d];
    std::set<std::pair<int, int>> found;
    for (int d = 0; d < D; ++d)
    {
        if (brick.low[d] == 0) continue;        // of the block: parts are larger than bricks
        CellBox layer = brick;
        layer.high[d] = layer.low[d] + 1;
        const BoxInArray box(layer, origin, stride);
        for (int i = 0; i < layer.count(); ++i)
        {
            const int c = box.at(i), below = c - stride[d];
            if (joined[c] >> d & 1 && label[c] && label[below])
                found.insert({label[c], label[below]});
        }
    }
    std::vector<int> pairs;
    for (const auto& p : found) { pairs.push_back(p.first); pairs.push_back(p.second); }
    join(bricks_.ranks(), pairs);
    PocketNames names;
    for (std::size_t k = 0; k < pairs.size(); k += 2) names.join(pairs[k], pairs[k + 1]);
    return names;
}

template<class Backend, int D>
bool DividedPockets<Backend, D>::find(Context<Backend>& context, Pockets<Backend, D>& part,
    const FineData<D>& f, const TiledCells<D>& cells)
{
    part.find(context, f, cells);
    label_.allocate(context, f.shape.cells);
    joined_.allocate(context, f.shape.cells);
    NamePockets<D> name{f, part.parents(), part.sums(), {}, {}, label_.data(), joined_.data()};
    const CellBox box = bricks_.part(bricks_.rank());
    for (int d = 0; d < D; ++d)
    {
        name.first[d] = box.low[d];
        name.n[d] = bricks_.whole().n[d];
    }
    forEach(context, f.shape.cells, name);
    halo_.exchange(context, label_.data());
    const std::vector<int> label = label_.download();
    const PocketNames names = unite(f.shape, label, joined_.download());
    std::vector<float> inverse(f.shape.cells);
    context.toHost(inverse.data(), f.inverse, inverse.size()*sizeof(float));
    cells_.clear();
    for (int i = 0; i < f.shape.cells; ++i)
    {
        // those beside the brick have their owners' names
        const int pocket = inverse[i] > 0 ? names.pocket(label[i]) : 0;
        if (pocket) cells_.push_back(Cell{i, pocket, pocketWeight(inverse[i])});
    }
    return largestOfRanks(bricks_.ranks(), double(cells_.size())) > 0;
}

template<class Backend, int D>
void DividedPockets<Backend, D>::takeMean(
    Context<Backend>& context, const FineData<D>& f, double* values, bool byDiagonal)
{
    std::vector<double> v(f.shape.cells), size(1, 0.0);
    context.toHost(v.data(), values, v.size()*sizeof(double));
    for (const Cell& c : cells_) size[0] += std::fabs(v[c.at]);
    addByRank(bricks_.ranks(), size);
    const double scale = pocketScale(size[0]);
    if (!(scale > 0)) return;                   // on all ranks
    std::map<int, Sums> own;
    for (const Cell& c : cells_)
    {
        Sums& s = own.emplace(c.pocket, Sums{c.pocket, 0, 0}).first->second;
        s.value += std::int64_t(v[c.at]*scale);
        s.weight += byDiagonal ? c.weight : 1;
    }
    std::vector<Sums> all;
    all.reserve(own.size());
    for (const auto& s : own) all.push_back(s.second);
    join(bricks_.ranks(), all);
    own.clear();
    for (const Sums& s : all)
    {
        Sums& to = own.emplace(s.pocket, Sums{s.pocket, 0, 0}).first->second;
        to.value += s.value;
        to.weight += s.weight;
    }
    for (const Cell& c : cells_)
    {
        const Sums& s = own.at(c.pocket);
        const double share = (byDiagonal ? double(c.weight) : 1.0)/double(s.weight);
        v[c.at] -= double(s.value)/scale*share;
    }
    if (!cells_.empty()) context.toDevice(values, v.data(), v.size()*sizeof(double));
}

} // namespace riprap

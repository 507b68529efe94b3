/*  BodyDeflation: the matrix E = Z^T (A + U U^T) Z.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/bodies/deflationBeyond.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace riprap
{

namespace
{

void sortUnique(std::vector<int>& v)
{
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
}

//- Of each row the pieces that have it, and where in them it stands
struct PlacesOfRows
{
    std::vector<std::size_t> start;
    std::vector<int> piece, at;

    PlacesOfRows(int rows, const std::vector<DeflationPiece>& pieces) : start(rows + 1, 0)
    {
        for (const DeflationPiece& z : pieces) for (const int r : z.row) ++start[r + 1];
        std::partial_sum(start.begin(), start.end(), start.begin());
        piece.resize(start.back());
        at.resize(start.back());
        std::vector<std::size_t> next(start.begin(), start.end() - 1);
        for (std::size_t b = 0; b < pieces.size(); ++b)
            for (std::size_t i = 0; i < pieces[b].row.size(); ++i)
            {
                const std::size_t k = next[pieces[b].row[i]]++;
                piece[k] = int(b);
                at[k] = int(i);
            }
    }
};

} // namespace

//- E = Z^T A Z + (U^T Z)^T (U^T Z)
void BodyDeflation::makeCoarse()
{
    findMeetings();
    std::vector<int> first(columns_);
    for (std::size_t b = 0; b < pieces_.size(); ++b)
    {
        int least = firstColumn_[b];
        for (const int c : meets_[b]) least = std::min(least, firstColumn_[c]);
        for (const int body : touches_[b])
            for (const int c : seenBy_[body]) least = std::min(least, firstColumn_[c]);
        for (int m = 0; m < pieces_[b].modes; ++m) first[firstColumn_[b] + m] = least;
    }
    coarse_ = Skyline(first);
    multiplyPieces();
    sum(coarse_.values());
    coupleThroughBodies();
    leaveOutConstants();
    coarse_.factorise();
}

//- Which boxes overlap or lie side by side; which bodies have a surface in a box
void BodyDeflation::findMeetings()
{
    const ReducedSystem& s = system_;
    const int count = int(pieces_.size());
    meets_.assign(count, {});
    touches_.assign(count, {});
    seenBy_.assign(s.bodies.size(), {});
    // sides of the grid that are periodic lie beside each other
    const auto beside = [&](const DeflationPiece& a, const DeflationPiece& b, int d)
    {
        const bool around = s.periodic[d]
            && ((a.low[d] == 0 && b.high[d] == s.n[d] - 1)
                || (b.low[d] == 0 && a.high[d] == s.n[d] - 1));
        return around || (a.low[d] <= b.high[d] + 1 && b.low[d] <= a.high[d] + 1);
    };
    for (int a = 0; a < count; ++a)
        for (int b = a; b < count; ++b)
        {
            if (!beside(pieces_[a], pieces_[b], 0) || !beside(pieces_[a], pieces_[b], 1)
                || !beside(pieces_[a], pieces_[b], 2))
                continue;
            meets_[a].push_back(b);
            if (b != a) meets_[b].push_back(a);
        }
    std::vector<std::vector<int>> bodiesAt(s.rows());
    for (std::size_t c = 0; c < s.bodies.size(); ++c)
        for (const int r : s.bodies[c].row) bodiesAt[r].push_back(int(c));
    for (int b = 0; b < count; ++b)
    {
        for (const int r : pieces_[b].row)
            touches_[b].insert(touches_[b].end(), bodiesAt[r].begin(), bodiesAt[r].end());
        sortUnique(touches_[b]);
    }
    if (ranks_) uniteTouches();
    for (int b = 0; b < count; ++b)
        for (const int c : touches_[b]) seenBy_[c].push_back(b);
}

//- On any rank: only bodies whose box meets that of the piece can
void BodyDeflation::uniteTouches()
{
    const auto each = [&](const auto& f)
    {
        std::size_t at = 0;
        for (std::size_t b = 0; b < pieces_.size(); ++b)
            for (std::size_t c = 0; c < low_.size(); ++c)
            {
                bool meet = true;
                for (int d = 0; d < 3; ++d)
                    meet = meet && pieces_[b].low[d] <= high_[c][d]
                        && low_[c][d] <= pieces_[b].high[d];
                if (meet) f(b, int(c), at++);
            }
    };
    std::vector<double> touches;
    each([&](std::size_t b, int c, std::size_t)
        { touches.push_back(std::binary_search(touches_[b].begin(), touches_[b].end(), c)); });
    sum(touches);
    for (auto& t : touches_) t.clear();
    each(
        [&](std::size_t b, int c, std::size_t at)
        {
            if (touches[at] > 0) touches_[b].push_back(c);
        });
}

//- A block of E: rows of a's columns, columns of b's
void BodyDeflation::add(int a, int b, const std::vector<double>& block)
{
    const int na = pieces_[a].modes, nb = pieces_[b].modes;
    for (int i = 0; i < na; ++i)
        for (int j = 0; j < nb; ++j)
            if (firstColumn_[b] + j <= firstColumn_[a] + i)
                coarse_.at(firstColumn_[a] + i, firstColumn_[b] + j) += block[i*nb + j];
}

//- Of each column its values beyond this rank's rows
std::vector<std::vector<double>> BodyDeflation::columnsBeyond()
{
    std::vector<const DeflationPiece*> columns;
    std::vector<int> mode;
    for (const DeflationPiece& z : pieces_)
        for (int m = 0; m < z.modes; ++m)
        {
            columns.push_back(&z);
            mode.push_back(m);
        }
    return beyond(columns,
        [&](std::size_t c, std::size_t i)
        { return columns[c]->value[i*columns[c]->modes + mode[c]]; });
}

//- Rows where A times piece b may be something, in order; seen: of each row the last piece that met
//  it
void BodyDeflation::findReach(int b, std::vector<int>& seen, std::vector<int>& reach) const
{
    const int rows = system_.rows();
    reach.clear();
    const auto meet = [&](int r) { if (seen[r] != b) { seen[r] = b; reach.push_back(r); } };
    for (const int r : pieces_[b].row)
    {
        meet(r);
        for (int k = start_[r]; k < start_[r + 1]; ++k) if (other_[k] < rows) meet(other_[k]);
    }
    for (const int f : pieces_[b].in) meet(beside_[f]);
    std::sort(reach.begin(), reach.end());
}

//- Z^T A Z: A times a piece is nothing but in its box and beside it
void BodyDeflation::multiplyPieces()
{
    const int rows = system_.rows();
    const int count = int(pieces_.size());
    std::vector<int> seen(rows, -1), reach;
    const PlacesOfRows places(rows, pieces_);
    std::vector<int> block(count, -1);
    std::vector<std::vector<double>> blocks;
    std::vector<double> product;
    const std::vector<std::vector<double>> there = columnsBeyond();
    std::size_t column = 0;
    for (int b = 0; b < count; ++b)
    {
        const int modes = pieces_[b].modes;
        findReach(b, seen, reach);
        const std::vector<int>& in = pieces_[b].in;
        product.assign(reach.size()*modes, 0.0);
        for (int m = 0; m < modes; ++m, ++column)
        {
            for (std::size_t i = 0; i < pieces_[b].row.size(); ++i)
                whole_[pieces_[b].row[i]] = pieces_[b].value[i*modes + m];
            for (std::size_t f = 0; f < in.size(); ++f) whole_[rows + in[f]] = there[column][f];
            for (std::size_t i = 0; i < reach.size(); ++i)
                product[i*modes + m] = rowTimes(reach[i]);
            for (const int r : pieces_[b].row) whole_[r] = 0;
            for (const int f : in) whole_[rows + f] = 0;
        }
        std::vector<int> others;
        for (const int c : meets_[b])
        {
            if (firstColumn_[c] > firstColumn_[b]) continue;
            block[c] = int(others.size());
            others.push_back(c);
        }
        blocks.resize(std::max(blocks.size(), others.size()));
        for (std::size_t k = 0; k < others.size(); ++k)
            blocks[k].assign(modes*pieces_[others[k]].modes, 0.0);
        for (std::size_t i = 0; i < reach.size(); ++i)
            for (std::size_t k = places.start[reach[i]]; k < places.start[reach[i] + 1]; ++k)
            {
                const int c = places.piece[k];
                if (block[c] < 0) continue;
                const int theirs = pieces_[c].modes;
                const double* value = &pieces_[c].value[std::size_t(places.at[k])*theirs];
                double* to = blocks[block[c]].data();
                for (int m = 0; m < modes; ++m)
                    for (int n = 0; n < theirs; ++n)
                        to[m*theirs + n] += product[i*modes + m]*value[n];
            }
        for (std::size_t k = 0; k < others.size(); ++k)
        {
            add(b, others[k], blocks[k]);
            block[others[k]] = -1;
        }
    }
}

//- (U^T Z)^T (U^T Z): columns whose boxes touch the same body
void BodyDeflation::coupleThroughBodies()
{
    // of each piece and body in touches_: its modes x the piece's
    std::vector<std::vector<std::vector<double>>> g(pieces_.size());
    for (int b = 0; b < int(pieces_.size()); ++b)
    {
        const int modes = pieces_[b].modes;
        for (const int c : touches_[b])
            g[b].push_back(std::vector<double>(system_.bodies[c].modes*modes, 0.0));
        for (int m = 0; m < modes; ++m)
        {
            for (std::size_t i = 0; i < pieces_[b].row.size(); ++i)
                whole_[pieces_[b].row[i]] = pieces_[b].value[i*modes + m];
            for (std::size_t t = 0; t < touches_[b].size(); ++t)
            {
                const BodyRows& u = system_.bodies[touches_[b][t]];
                for (std::size_t i = 0; i < u.row.size(); ++i)
                    for (int k = 0; k < u.modes; ++k)
                        g[b][t][k*modes + m] += u.u[i*u.modes + k]*whole_[u.row[i]];
            }
            for (const int r : pieces_[b].row) whole_[r] = 0;
        }
    }
    if (ranks_)
    {
        std::vector<double> all;
        for (const auto& piece : g)
            for (const auto& block : piece) all.insert(all.end(), block.begin(), block.end());
        sum(all);
        auto from = all.begin();
        for (auto& piece : g)
            for (auto& block : piece)
            {
                std::copy(from, from + block.size(), block.begin());
                from += block.size();
            }
    }
    const auto of = [&](int b, int c) -> const std::vector<double>& {
        return g[b]
                [std::lower_bound(touches_[b].begin(), touches_[b].end(), c) - touches_[b].begin()];
    };
    for (int c = 0; c < int(seenBy_.size()); ++c)
        for (const int a : seenBy_[c])
            for (const int b : seenBy_[c])
            {
                if (firstColumn_[b] > firstColumn_[a]) continue;
                const int na = pieces_[a].modes, nb = pieces_[b].modes;
                std::vector<double> block(na*nb, 0.0);
                for (int k = 0; k < system_.bodies[c].modes; ++k)
                    for (int i = 0; i < na; ++i)
                        for (int j = 0; j < nb; ++j)
                            block[i*nb + j] += of(a, c)[k*na + i]*of(b, c)[k*nb + j];
                add(a, b, block);
            }
}

//- Where hats sum to the constant and nothing ties the water to p = 0, that sum has no energy: E is
//  singular, and its last pivot is what round-off leaves, of either sign. One of these hats is left
//  out then; with the constant, which takes no part in anything, the others span the same. The one
//  with the largest diagonal: next to it the pivots of the others are large
void BodyDeflation::leaveOutConstants()
{
    const int rows = system_.rows();
    std::vector<int> group(columns_, -1);       // of hats that E joins: one of their columns
    const auto groupOf = [&](int column)
    {
        while (group[column] != column) column = group[column];
        return column;
    };
    for (std::size_t b = 0; b < pieces_.size(); ++b)
        if (pieces_[b].hat) group[firstColumn_[b]] = firstColumn_[b];
    for (int i = 0; i < columns_; ++i)
        for (int j = coarse_.first(i); j < i && group[i] >= 0; ++j)
            if (group[j] >= 0 && coarse_.at(i, j) != 0)
                group[std::max(groupOf(i), groupOf(j))] = std::min(groupOf(i), groupOf(j));
    std::vector<double> sums(rows, 0.0), product(rows), energy(columns_, 0.0), size(columns_, 0.0);
    std::vector<int> of(rows, -1), largest(columns_, -1);
    for (std::size_t b = 0; b < pieces_.size(); ++b)
    {
        const int column = firstColumn_[b];
        if (!pieces_[b].hat) continue;
        const int to = groupOf(column);
        for (std::size_t i = 0; i < pieces_[b].row.size(); ++i)
        {
            sums[pieces_[b].row[i]] += pieces_[b].value[i];
            of[pieces_[b].row[i]] = to;
        }
        const double diagonal = coarse_.at(column, column);
        size[to] += std::sqrt(std::max(0.0, diagonal));
        if (largest[to] < 0 || diagonal > coarse_.at(largest[to], largest[to]))
            largest[to] = column;
    }
    this->product(sums.data(), product.data());
    for (int r = 0; r < rows; ++r) if (of[r] >= 0) energy[of[r]] += sums[r]*product[r];
    sum(energy);
    // what round-off of the factors may make of nothing: they are those of a matrix that is off by
    // some eps sqrt(E_ii E_jj)
    constexpr double roundOff = std::numeric_limits<double>::epsilon();
    for (int i = 0; i < columns_; ++i)
        if (largest[i] >= 0 && energy[i] <= roundOff*size[i]*size[i])
            coarse_.at(largest[i], largest[i]) = 0;
}

} // namespace riprap

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/bodies/deflation.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace riprap
{

BodyDeflation::BodyDeflation(const ReducedSystem& system, const DeflationControls& controls, const Ranks* ranks)
:
    system_(system),
    ranks_(ranks)
{
    connect();
    placeBodies(controls.in(system.dimensions));
    if (pieces_.empty()) return;
    order();
    makeCoarse();
}

void BodyDeflation::connect()
{
    const ReducedSystem& s = system_;
    for (std::size_t b = 0; b < s.borders.size(); ++b)
        for (const int r : s.borders[b].row) { border_.push_back(int(b)); beside_.push_back(r); }
    start_.assign(s.rows() + 1, 0);
    for (std::size_t f = 0; f < s.owner.size(); ++f) { ++start_[s.owner[f] + 1]; ++start_[s.neighbour[f] + 1]; }
    for (const int r : beside_) ++start_[r + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    other_.resize(start_.back());
    coefficient_.resize(start_.back());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (std::size_t f = 0; f < s.owner.size(); ++f)
        for (const bool lower : {false, true})
        {
            const int at = next[lower ? s.neighbour[f] : s.owner[f]]++;
            other_[at] = lower ? s.owner[f] : s.neighbour[f];
            coefficient_[at] = s.offDiagonal[f];
        }
    int face = 0;
    for (const RankBorder& border : s.borders)
        for (std::size_t i = 0; i < border.row.size(); ++i, ++face)
        {
            const int at = next[border.row[i]]++;
            other_[at] = s.rows() + face;
            coefficient_[at] = border.offDiagonal[i];
        }
    if (!ranks_) return;
    std::vector<std::vector<double>> cell(s.borders.size()), there(s.borders.size());
    for (std::size_t b = 0; b < s.borders.size(); ++b)
    {
        for (const int r : s.borders[b].row) cell[b].push_back(s.cell[r]);
        there[b].resize(cell[b].size());
    }
    ranks_->swap(cell, there);
    for (const auto& cells : there) for (const double c : cells) beyond_.push_back(cornerOf(s, int(c)));
}

//- The cells beside each body
void BodyDeflation::findBoxes()
{
    const ReducedSystem& s = system_;
    low_.assign(s.bodies.size(), CellCorner{{s.n[0], s.n[1], s.n[2]}});
    high_.assign(s.bodies.size(), CellCorner{{-1, -1, -1}});
    for (std::size_t b = 0; b < s.bodies.size(); ++b)
        for (const int r : s.bodies[b].row)
        {
            const CellCorner x = cornerOf(s, s.cell[r]);
            for (int d = 0; d < 3; ++d) { low_[b][d] = std::min(low_[b][d], x[d]); high_[b][d] = std::max(high_[b][d], x[d]); }
        }
    if (!ranks_) return;
    std::vector<int> ends;
    for (std::size_t b = 0; b < s.bodies.size(); ++b)
        for (int d = 0; d < 3; ++d) { ends.push_back(low_[b][d]); ends.push_back(-high_[b][d]); }
    ranks_->least(ends);
    for (std::size_t b = 0; b < s.bodies.size(); ++b)
        for (int d = 0; d < 3; ++d) { low_[b][d] = ends[6*b + 2*d]; high_[b][d] = -ends[6*b + 2*d + 1]; }
}

//- Local solutions for light bodies, and hats between those
void BodyDeflation::placeBodies(const DeflationControls& controls)
{
    const ReducedSystem& s = system_;
    const std::size_t atOnce = ranks_ ? 64 : 1;     // together, so that ranks wait for each other less often
    findBoxes();
    std::vector<CellCorner> lows, highs;
    std::vector<const BodyRows*> lights;
    double width = 0;
    for (std::size_t b = 0; b < s.bodies.size(); ++b)
    {
        const CellCorner& low = low_[b];
        const CellCorner& high = high_[b];
        const bool light = s.bodies[b].light;
        if (!(light || controls.heavyHats) || high[0] < low[0]) continue;
        lows.push_back(low);
        highs.push_back(high);
        for (int d = 0; d < s.dimensions; ++d) width += double(high[d] - low[d] + 1)/s.dimensions;
        if (!light) continue;
        DeflationPiece z;
        lights.push_back(&s.bodies[b]);
        for (int d = 0; d < 3; ++d)
        {
            const int wider = d < s.dimensions ? std::max(1, int(controls.margin*0.5*(high[d] - low[d] + 1) + 0.5)) : 0;
            z.low[d] = std::max(0, low[d] - wider);
            z.high[d] = std::min(s.n[d] - 1, high[d] + wider);
        }
        pieces_.push_back(std::move(z));
    }
    if (lows.empty()) return;
    rowOfCell_.set(s);
    whole_.assign(s.rows() + beside_.size(), 0.0);
    for (std::size_t b = 0; b < lights.size(); b += atOnce)
        solveLocally({lights.begin() + b, lights.begin() + std::min(lights.size(), b + atOnce)}, controls.localIterations, &pieces_[b]);
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), [](const DeflationPiece& z) { return !z.modes; }), pieces_.end());
    if (!(controls.hats > 0)) return;
    std::vector<int> closed(1, s.closed);
    if (ranks_) ranks_->least(closed);
    for (DeflationPiece& hat : hatsBetween(s, rowOfCell_, lows, highs, controls.hats*width/lows.size(), closed[0] && controls.hatsEverywhere)) pieces_.push_back(std::move(hat));
    dropEmpty();
    for (DeflationPiece& z : pieces_) findFaces(z);
}

//- Pieces without a row on any rank
void BodyDeflation::dropEmpty()
{
    std::vector<double> rows;
    for (const DeflationPiece& z : pieces_) rows.push_back(double(z.row.size()));
    sum(rows);
    std::size_t kept = 0;
    for (std::size_t b = 0; b < pieces_.size(); ++b)
        if (rows[b] > 0)
        {
            if (kept != b) pieces_[kept] = std::move(pieces_[b]);
            ++kept;
        }
    pieces_.resize(kept);
}

void BodyDeflation::findFaces(DeflationPiece& z) const
{
    z.out.clear();
    z.in.clear();
    for (std::size_t f = 0; f < beside_.size(); ++f)
    {
        if (z.holds(cornerOf(system_, system_.cell[beside_[f]]))) z.out.push_back(int(f));
        if (z.holds(beyond_[f])) z.in.push_back(int(f));
    }
}

template<class F>
std::vector<std::vector<double>> BodyDeflation::beyond(const std::vector<const DeflationPiece*>& columns, const F& value)
{
    std::vector<std::vector<double>> values(columns.size());
    if (!ranks_) return values;
    std::vector<std::vector<double>> out(system_.borders.size()), in(out.size());
    std::vector<std::size_t> size(out.size(), 0);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
        const DeflationPiece& z = *columns[c];
        for (const int f : z.in) ++size[border_[f]];
        if (z.out.empty()) continue;
        for (std::size_t i = 0; i < z.row.size(); ++i) whole_[z.row[i]] = value(c, i);
        for (const int f : z.out) out[border_[f]].push_back(whole_[beside_[f]]);
        for (const int r : z.row) whole_[r] = 0;
    }
    for (std::size_t b = 0; b < in.size(); ++b) in[b].resize(size[b]);
    ranks_->swap(out, in);
    size.assign(size.size(), 0);
    for (std::size_t c = 0; c < columns.size(); ++c)
        for (const int f : columns[c]->in) values[c].push_back(in[border_[f]][size[border_[f]]++]);
    return values;
}

//- Along the direction in which they are spread most, so that E has a narrow band
void BodyDeflation::order()
{
    const int count = int(pieces_.size());
    CellCorner least = pieces_[0].low, most = pieces_[0].low;
    for (const DeflationPiece& z : pieces_)
        for (int d = 0; d < 3; ++d) { least[d] = std::min(least[d], z.low[d]); most[d] = std::max(most[d], z.low[d]); }
    int along = 0;
    for (int d = 1; d < 3; ++d) if (most[d] - least[d] > most[along] - least[along]) along = d;
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return pieces_[a].low[along] < pieces_[b].low[along]; });
    firstColumn_.resize(count);
    for (const int b : order_) { firstColumn_[b] = columns_; columns_ += pieces_[b].modes; }
}

double BodyDeflation::rowTimes(int row) const
{
    double sum = system_.diagonal[row]*whole_[row];
    for (int k = start_[row]; k < start_[row + 1]; ++k) sum += coefficient_[k]*whole_[other_[k]];
    return sum;
}

//- Conjugate gradients with the diagonal on the rows in each body's box, for each column u of U. u^T A^-1 u is by how much the body moves the eigenvalue 1 of its mode
void BodyDeflation::solveLocally(const std::vector<const BodyRows*>& bodies, int iterations, DeflationPiece* z)
{
    constexpr double slow = 0.1;
    const ReducedSystem& s = system_;
    struct Column { std::vector<double> r, p, q, x; double before = 0, moved = 0; bool ends = false; };
    std::vector<Column> columns;
    std::vector<const DeflationPiece*> at;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        const BodyRows& body = *bodies[b];
        rowOfCell_.each(z[b].low, z[b].high, [&](int row, const CellCorner&) { z[b].row.push_back(row); });
        findFaces(z[b]);
        const std::size_t n = z[b].row.size();
        for (int m = 0; m < body.modes; ++m)
        {
            Column c;
            for (std::vector<double>* v : {&c.r, &c.p, &c.q, &c.x}) v->assign(n, 0.0);
            for (std::size_t i = 0; i < body.row.size(); ++i) whole_[body.row[i]] = body.u[i*body.modes + m];
            for (std::size_t i = 0; i < n; ++i) c.r[i] = whole_[z[b].row[i]];
            for (const int row : body.row) whole_[row] = 0;
            columns.push_back(std::move(c));
            at.push_back(&z[b]);
        }
    }
    std::vector<double> rz(columns.size()), pq(columns.size());
    for (int k = 0; k < iterations; ++k)
    {
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            const std::vector<double>& r = columns[c].r;
            const std::vector<int>& row = at[c]->row;
            double part = 0;
            for (std::size_t i = 0; i < r.size(); ++i) part += r[i]*r[i]/s.diagonal[row[i]];
            rz[c] = part;
        }
        sum(rz);
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            Column& v = columns[c];
            v.ends = v.ends || !(rz[c] > 0);
            if (v.ends) continue;
            const std::vector<int>& row = at[c]->row;
            const double beta = k ? rz[c]/v.before : 0;
            for (std::size_t i = 0; i < row.size(); ++i) v.p[i] = v.r[i]/s.diagonal[row[i]] + beta*v.p[i];
        }
        const std::vector<std::vector<double>> there = beyond(at, [&](std::size_t c, std::size_t i) { return columns[c].p[i]; });
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            Column& v = columns[c];
            pq[c] = 0;
            if (v.ends) continue;
            double part = 0;
            const std::vector<int>& row = at[c]->row;
            const std::vector<int>& in = at[c]->in;
            for (std::size_t i = 0; i < row.size(); ++i) whole_[row[i]] = v.p[i];
            for (std::size_t f = 0; f < in.size(); ++f) whole_[s.rows() + in[f]] = there[c][f];
            for (std::size_t i = 0; i < row.size(); ++i) { v.q[i] = rowTimes(row[i]); part += v.p[i]*v.q[i]; }
            pq[c] = part;
            for (const int r : row) whole_[r] = 0;
            for (const int f : in) whole_[s.rows() + f] = 0;
        }
        sum(pq);
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            Column& v = columns[c];
            v.ends = v.ends || !(pq[c] > 0);
            if (v.ends) continue;
            v.moved += rz[c]*rz[c]/pq[c];       // what each step adds to u^T x
            const double alpha = rz[c]/pq[c];
            for (std::size_t i = 0; i < v.x.size(); ++i)
            {
                v.x[i] += alpha*v.p[i];
                v.r[i] -= alpha*v.q[i];
            }
            v.before = rz[c];
        }
    }
    std::size_t first = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        std::vector<const std::vector<double>*> kept;
        for (int m = 0; m < bodies[b]->modes; ++m, ++first) if (columns[first].moved > slow) kept.push_back(&columns[first].x);
        z[b].modes = int(kept.size());
        z[b].value.resize(z[b].row.size()*z[b].modes);
        for (std::size_t i = 0; i < z[b].row.size(); ++i) for (int m = 0; m < z[b].modes; ++m) z[b].value[i*z[b].modes + m] = (*kept[m])[i];
    }
}

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
        for (const int body : touches_[b]) for (const int c : seenBy_[body]) least = std::min(least, firstColumn_[c]);
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
        const bool around = s.periodic[d] && ((a.low[d] == 0 && b.high[d] == s.n[d] - 1) || (b.low[d] == 0 && a.high[d] == s.n[d] - 1));
        return around || (a.low[d] <= b.high[d] + 1 && b.low[d] <= a.high[d] + 1);
    };
    for (int a = 0; a < count; ++a)
        for (int b = a; b < count; ++b)
        {
            if (!beside(pieces_[a], pieces_[b], 0) || !beside(pieces_[a], pieces_[b], 1) || !beside(pieces_[a], pieces_[b], 2)) continue;
            meets_[a].push_back(b);
            if (b != a) meets_[b].push_back(a);
        }
    std::vector<std::vector<int>> bodiesAt(s.rows());
    for (std::size_t c = 0; c < s.bodies.size(); ++c) for (const int r : s.bodies[c].row) bodiesAt[r].push_back(int(c));
    for (int b = 0; b < count; ++b)
    {
        for (const int r : pieces_[b].row) touches_[b].insert(touches_[b].end(), bodiesAt[r].begin(), bodiesAt[r].end());
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
                for (int d = 0; d < 3; ++d) meet = meet && pieces_[b].low[d] <= high_[c][d] && low_[c][d] <= pieces_[b].high[d];
                if (meet) f(b, int(c), at++);
            }
    };
    std::vector<double> touches;
    each([&](std::size_t b, int c, std::size_t) { touches.push_back(std::binary_search(touches_[b].begin(), touches_[b].end(), c)); });
    sum(touches);
    for (auto& t : touches_) t.clear();
    each([&](std::size_t b, int c, std::size_t at) { if (touches[at] > 0) touches_[b].push_back(c); });
}

//- A block of E: rows of a's columns, columns of b's
void BodyDeflation::add(int a, int b, const std::vector<double>& block)
{
    const int na = pieces_[a].modes, nb = pieces_[b].modes;
    for (int i = 0; i < na; ++i)
        for (int j = 0; j < nb; ++j)
            if (firstColumn_[b] + j <= firstColumn_[a] + i) coarse_.at(firstColumn_[a] + i, firstColumn_[b] + j) += block[i*nb + j];
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
    std::vector<const DeflationPiece*> columns;
    std::vector<int> mode;
    for (const DeflationPiece& z : pieces_) for (int m = 0; m < z.modes; ++m) { columns.push_back(&z); mode.push_back(m); }
    const std::vector<std::vector<double>> there =
        beyond(columns, [&](std::size_t c, std::size_t i) { return columns[c]->value[i*columns[c]->modes + mode[c]]; });
    std::size_t column = 0;
    for (int b = 0; b < count; ++b)
    {
        const int modes = pieces_[b].modes;
        reach.clear();
        const auto meet = [&](int r) { if (seen[r] != b) { seen[r] = b; reach.push_back(r); } };
        for (const int r : pieces_[b].row)
        {
            meet(r);
            for (int k = start_[r]; k < start_[r + 1]; ++k) if (other_[k] < rows) meet(other_[k]);
        }
        const std::vector<int>& in = pieces_[b].in;
        for (const int f : in) meet(beside_[f]);
        std::sort(reach.begin(), reach.end());
        product.assign(reach.size()*modes, 0.0);
        for (int m = 0; m < modes; ++m, ++column)
        {
            for (std::size_t i = 0; i < pieces_[b].row.size(); ++i) whole_[pieces_[b].row[i]] = pieces_[b].value[i*modes + m];
            for (std::size_t f = 0; f < in.size(); ++f) whole_[rows + in[f]] = there[column][f];
            for (std::size_t i = 0; i < reach.size(); ++i) product[i*modes + m] = rowTimes(reach[i]);
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
        for (std::size_t k = 0; k < others.size(); ++k) blocks[k].assign(modes*pieces_[others[k]].modes, 0.0);
        for (std::size_t i = 0; i < reach.size(); ++i)
            for (std::size_t k = places.start[reach[i]]; k < places.start[reach[i] + 1]; ++k)
            {
                const int c = places.piece[k];
                if (block[c] < 0) continue;
                const int theirs = pieces_[c].modes;
                const double* value = &pieces_[c].value[std::size_t(places.at[k])*theirs];
                double* to = blocks[block[c]].data();
                for (int m = 0; m < modes; ++m)
                    for (int n = 0; n < theirs; ++n) to[m*theirs + n] += product[i*modes + m]*value[n];
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
    std::vector<std::vector<std::vector<double>>> g(pieces_.size());     // of each piece and body in touches_: its modes x the piece's
    for (int b = 0; b < int(pieces_.size()); ++b)
    {
        const int modes = pieces_[b].modes;
        for (const int c : touches_[b]) g[b].push_back(std::vector<double>(system_.bodies[c].modes*modes, 0.0));
        for (int m = 0; m < modes; ++m)
        {
            for (std::size_t i = 0; i < pieces_[b].row.size(); ++i) whole_[pieces_[b].row[i]] = pieces_[b].value[i*modes + m];
            for (std::size_t t = 0; t < touches_[b].size(); ++t)
            {
                const BodyRows& u = system_.bodies[touches_[b][t]];
                for (std::size_t i = 0; i < u.row.size(); ++i)
                    for (int k = 0; k < u.modes; ++k) g[b][t][k*modes + m] += u.u[i*u.modes + k]*whole_[u.row[i]];
            }
            for (const int r : pieces_[b].row) whole_[r] = 0;
        }
    }
    if (ranks_)
    {
        std::vector<double> all;
        for (const auto& piece : g) for (const auto& block : piece) all.insert(all.end(), block.begin(), block.end());
        sum(all);
        auto from = all.begin();
        for (auto& piece : g) for (auto& block : piece) { std::copy(from, from + block.size(), block.begin()); from += block.size(); }
    }
    const auto of = [&](int b, int c) -> const std::vector<double>&
    { return g[b][std::lower_bound(touches_[b].begin(), touches_[b].end(), c) - touches_[b].begin()]; };
    for (int c = 0; c < int(seenBy_.size()); ++c)
        for (const int a : seenBy_[c])
            for (const int b : seenBy_[c])
            {
                if (firstColumn_[b] > firstColumn_[a]) continue;
                const int na = pieces_[a].modes, nb = pieces_[b].modes;
                std::vector<double> block(na*nb, 0.0);
                for (int k = 0; k < system_.bodies[c].modes; ++k)
                    for (int i = 0; i < na; ++i)
                        for (int j = 0; j < nb; ++j) block[i*nb + j] += of(a, c)[k*na + i]*of(b, c)[k*nb + j];
                add(a, b, block);
            }
}

//- Where hats sum to the constant and nothing ties the water to p = 0, that sum has no energy: E is singular, and its last pivot is what round-off leaves, of either sign. One of these hats is left out then; with the constant,
//  which takes no part in anything, the others span the same. The one with the largest diagonal: next to it the pivots of the others are large
void BodyDeflation::leaveOutConstants()
{
    const int rows = system_.rows();
    std::vector<int> group(columns_, -1);       // of hats that E joins: one of their columns
    const auto groupOf = [&](int column) { while (group[column] != column) column = group[column]; return column; };
    for (std::size_t b = 0; b < pieces_.size(); ++b) if (pieces_[b].hat) group[firstColumn_[b]] = firstColumn_[b];
    for (int i = 0; i < columns_; ++i)
        for (int j = coarse_.first(i); j < i && group[i] >= 0; ++j)
            if (group[j] >= 0 && coarse_.at(i, j) != 0) group[std::max(groupOf(i), groupOf(j))] = std::min(groupOf(i), groupOf(j));
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
        if (largest[to] < 0 || diagonal > coarse_.at(largest[to], largest[to])) largest[to] = column;
    }
    this->product(sums.data(), product.data());
    for (int r = 0; r < rows; ++r) if (of[r] >= 0) energy[of[r]] += sums[r]*product[r];
    sum(energy);
    // what round-off of the factors may make of nothing: they are those of a matrix that is off by some eps sqrt(E_ii E_jj)
    constexpr double roundOff = std::numeric_limits<double>::epsilon();
    for (int i = 0; i < columns_; ++i)
        if (largest[i] >= 0 && energy[i] <= roundOff*size[i]*size[i]) coarse_.at(largest[i], largest[i]) = 0;
}

void BodyDeflation::product(const double* x, double* y) const
{
    const int n = system_.rows();
    const double* v = x;
    std::vector<double> wide;               // with the cells beyond
    if (ranks_)
    {
        std::vector<std::vector<double>> out(system_.borders.size()), in(out.size());
        for (std::size_t f = 0; f < beside_.size(); ++f) out[border_[f]].push_back(x[beside_[f]]);
        for (std::size_t b = 0; b < out.size(); ++b) in[b].resize(out[b].size());
        ranks_->swap(out, in);
        wide.assign(x, x + n);
        for (const auto& values : in) wide.insert(wide.end(), values.begin(), values.end());
        v = wide.data();
    }
    #pragma omp parallel for if (n > 2048)
    for (int i = 0; i < n; ++i)
    {
        double sum = system_.diagonal[i]*x[i];
        for (int k = start_[i]; k < start_[i + 1]; ++k) sum += coefficient_[k]*v[other_[k]];
        y[i] = sum;
    }
    addBodies(x, y);
}

double BodyDeflation::rowSum(int row) const
{
    double sum = system_.diagonal[row];
    for (int k = start_[row]; k < start_[row + 1]; ++k) sum += coefficient_[k];
    return sum;
}

void BodyDeflation::addBodies(const double* x, double* y) const
{
    if (ranks_) return addDividedBodies(x, y);
    for (const BodyRows& b : system_.bodies)
    {
        double sum[6] = {};
        for (std::size_t i = 0; i < b.row.size(); ++i)
            for (int m = 0; m < b.modes; ++m) sum[m] += b.u[i*b.modes + m]*x[b.row[i]];
        for (std::size_t i = 0; i < b.row.size(); ++i)
            for (int m = 0; m < b.modes; ++m) y[b.row[i]] += b.u[i*b.modes + m]*sum[m];
    }
}

//- The same with all ranks' parts of U^T x in one sum
void BodyDeflation::addDividedBodies(const double* x, double* y) const
{
    std::vector<double> all;
    for (const BodyRows& b : system_.bodies)
    {
        double sum[6] = {};
        for (std::size_t i = 0; i < b.row.size(); ++i)
            for (int m = 0; m < b.modes; ++m) sum[m] += b.u[i*b.modes + m]*x[b.row[i]];
        all.insert(all.end(), sum, sum + b.modes);
    }
    sum(all);
    const double* of = all.data();
    for (const BodyRows& b : system_.bodies)
    {
        for (std::size_t i = 0; i < b.row.size(); ++i)
            for (int m = 0; m < b.modes; ++m) y[b.row[i]] += b.u[i*b.modes + m]*of[m];
        of += b.modes;
    }
}

void BodyDeflation::correct(const double* r, double* z) const
{
    if (!columns_) return;
    std::vector<double> c(columns_, 0.0);
    for (std::size_t b = 0; b < pieces_.size(); ++b)
    {
        const int modes = pieces_[b].modes;
        for (std::size_t i = 0; i < pieces_[b].row.size(); ++i)
            for (int m = 0; m < modes; ++m) c[firstColumn_[b] + m] += pieces_[b].value[i*modes + m]*r[pieces_[b].row[i]];
    }
    sum(c);
    coarse_.solve(c);
    for (std::size_t b = 0; b < pieces_.size(); ++b)
    {
        const int modes = pieces_[b].modes;
        for (std::size_t i = 0; i < pieces_[b].row.size(); ++i)
            for (int m = 0; m < modes; ++m) z[pieces_[b].row[i]] += pieces_[b].value[i*modes + m]*c[firstColumn_[b] + m];
    }
}

} // namespace riprap

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/bodies/deflation.hpp"
#include <algorithm>
#include <numeric>

namespace riprap
{

BodyDeflation::BodyDeflation(const ReducedSystem& system, const DeflationControls& controls)
:
    system_(system)
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
    start_.assign(s.rows() + 1, 0);
    for (std::size_t f = 0; f < s.owner.size(); ++f) { ++start_[s.owner[f] + 1]; ++start_[s.neighbour[f] + 1]; }
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
}

//- Local solutions for light bodies, and hats between those
void BodyDeflation::placeBodies(const DeflationControls& controls)
{
    const ReducedSystem& s = system_;
    std::vector<CellCorner> lows, highs;
    double width = 0;
    for (const BodyRows& body : s.bodies)
    {
        if (!body.light || body.row.empty()) continue;
        if (rowOfCell_.empty())
        {
            whole_.assign(s.rows(), 0.0);
            rowOfCell_.assign(std::size_t(s.n[0])*s.n[1]*s.n[2], -1);
            for (int i = 0; i < s.rows(); ++i) rowOfCell_[s.cell[i]] = i;
        }
        DeflationPiece z;
        CellCorner low{{s.n[0], s.n[1], s.n[2]}}, high{{-1, -1, -1}};
        for (const int r : body.row)
        {
            const int c = s.cell[r], x[3] = {c % s.n[0], c/s.n[0] % s.n[1], c/(s.n[0]*s.n[1])};
            for (int d = 0; d < 3; ++d) { low[d] = std::min(low[d], x[d]); high[d] = std::max(high[d], x[d]); }
        }
        lows.push_back(low);
        highs.push_back(high);
        for (int d = 0; d < 3; ++d)
        {
            width += d < s.dimensions ? double(high[d] - low[d] + 1)/s.dimensions : 0;
            const int wider = d < s.dimensions ? std::max(1, int(controls.margin*0.5*(high[d] - low[d] + 1) + 0.5)) : 0;
            z.low[d] = std::max(0, low[d] - wider);
            z.high[d] = std::min(s.n[d] - 1, high[d] + wider);
        }
        solveLocally(body, controls.localIterations, z);
        if (z.modes) pieces_.push_back(std::move(z));
    }
    if (lows.empty() || !(controls.hats > 0)) return;
    bool closed = true;                     // nowhere p = 0
    for (int i = 0; i < s.rows() && closed; ++i) closed = rowSum(i) <= 1e-9*s.diagonal[i];
    for (DeflationPiece& hat : hatsBetween(s, rowOfCell_, lows, highs, controls.hats*width/lows.size(), closed)) pieces_.push_back(std::move(hat));
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

//- Conjugate gradients with the diagonal on the rows in the body's box, for each column u of U. u^T A^-1 u is by how much the body moves the eigenvalue 1 of its mode
void BodyDeflation::solveLocally(const BodyRows& body, int iterations, DeflationPiece& z)
{
    constexpr double slow = 0.1;
    const ReducedSystem& s = system_;
    eachRowInBox(s, rowOfCell_, z.low, z.high, [&](int row, const CellCorner&) { z.row.push_back(row); });
    const int n = int(z.row.size());
    std::vector<std::vector<double>> kept;
    std::vector<double> r(n), p(n), q(n), x(n);
    for (int m = 0; m < body.modes; ++m)
    {
        for (std::size_t i = 0; i < body.row.size(); ++i) whole_[body.row[i]] = body.u[i*body.modes + m];
        for (int i = 0; i < n; ++i) { r[i] = whole_[z.row[i]]; x[i] = 0; }
        for (const int row : body.row) whole_[row] = 0;
        double before = 0, moved = 0;
        for (int k = 0; k < iterations; ++k)
        {
            double rz = 0, pq = 0;
            for (int i = 0; i < n; ++i) rz += r[i]*r[i]/s.diagonal[z.row[i]];
            if (!(rz > 0)) break;
            for (int i = 0; i < n; ++i) p[i] = r[i]/s.diagonal[z.row[i]] + (k ? rz/before*p[i] : 0);
            for (int i = 0; i < n; ++i) whole_[z.row[i]] = p[i];
            for (int i = 0; i < n; ++i) { q[i] = rowTimes(z.row[i]); pq += p[i]*q[i]; }
            if (!(pq > 0)) break;
            moved += rz*rz/pq;          // what each step adds to u^T x
            for (int i = 0; i < n; ++i)
            {
                x[i] += rz/pq*p[i];
                r[i] -= rz/pq*q[i];
            }
            before = rz;
        }
        for (const int row : z.row) whole_[row] = 0;
        if (moved > slow) kept.push_back(x);
    }
    z.modes = int(kept.size());
    z.value.resize(std::size_t(n)*z.modes);
    for (int i = 0; i < n; ++i) for (int m = 0; m < z.modes; ++m) z.value[std::size_t(i)*z.modes + m] = kept[m][i];
}

namespace
{

void sortUnique(std::vector<int>& v)
{
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
}

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
    coupleThroughBodies();
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
        for (const int c : touches_[b]) seenBy_[c].push_back(b);
    }
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
    std::vector<int> seen(system_.rows(), -1), slot(system_.rows(), 0), reach;
    std::vector<double> product;
    for (int b = 0; b < int(pieces_.size()); ++b)
    {
        const int modes = pieces_[b].modes;
        reach.clear();
        const auto meet = [&](int r) { if (seen[r] != b) { seen[r] = b; slot[r] = int(reach.size()); reach.push_back(r); } };
        for (const int r : pieces_[b].row)
        {
            meet(r);
            for (int k = start_[r]; k < start_[r + 1]; ++k) meet(other_[k]);
        }
        product.assign(reach.size()*modes, 0.0);
        for (int m = 0; m < modes; ++m)
        {
            for (std::size_t i = 0; i < pieces_[b].row.size(); ++i) whole_[pieces_[b].row[i]] = pieces_[b].value[i*modes + m];
            for (std::size_t i = 0; i < reach.size(); ++i) product[i*modes + m] = rowTimes(reach[i]);
            for (const int r : pieces_[b].row) whole_[r] = 0;
        }
        for (const int c : meets_[b])
        {
            if (firstColumn_[c] > firstColumn_[b]) continue;
            const int others = pieces_[c].modes;
            std::vector<double> block(modes*others, 0.0);
            for (std::size_t i = 0; i < pieces_[c].row.size(); ++i)
            {
                const int r = pieces_[c].row[i];
                if (seen[r] != b) continue;
                for (int m = 0; m < modes; ++m)
                    for (int k = 0; k < others; ++k) block[m*others + k] += product[std::size_t(slot[r])*modes + m]*pieces_[c].value[i*others + k];
            }
            add(b, c, block);
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

void BodyDeflation::product(const double* x, double* y) const
{
    const int n = system_.rows();
    #pragma omp parallel for if (n > 2048)
    for (int i = 0; i < n; ++i)
    {
        double sum = system_.diagonal[i]*x[i];
        for (int k = start_[i]; k < start_[i + 1]; ++k) sum += coefficient_[k]*x[other_[k]];
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
    for (const BodyRows& b : system_.bodies)
    {
        double sum[6] = {};
        for (std::size_t i = 0; i < b.row.size(); ++i)
            for (int m = 0; m < b.modes; ++m) sum[m] += b.u[i*b.modes + m]*x[b.row[i]];
        for (std::size_t i = 0; i < b.row.size(); ++i)
            for (int m = 0; m < b.modes; ++m) y[b.row[i]] += b.u[i*b.modes + m]*sum[m];
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
    coarse_.solve(c);
    for (std::size_t b = 0; b < pieces_.size(); ++b)
    {
        const int modes = pieces_[b].modes;
        for (std::size_t i = 0; i < pieces_[b].row.size(); ++i)
            for (int m = 0; m < modes; ++m) z[pieces_[b].row[i]] += pieces_[b].value[i*modes + m]*c[firstColumn_[b] + m];
    }
}

} // namespace riprap

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/bodies/deflationBeyond.hpp"
#include <algorithm>
#include <numeric>

namespace riprap
{

BodyDeflation::BodyDeflation(
    const ReducedSystem& system, const DeflationControls& controls, const Ranks* ranks)
    : system_(system), ranks_(ranks)
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
    for (std::size_t f = 0; f < s.owner.size(); ++f)
    {
        ++start_[s.owner[f] + 1];
        ++start_[s.neighbour[f] + 1];
    }
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
    for (const auto& cells : there)
        for (const double c : cells) beyond_.push_back(cornerOf(s, int(c)));
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
            for (int d = 0; d < 3; ++d)
            {
                low_[b][d] = std::min(low_[b][d], x[d]);
                high_[b][d] = std::max(high_[b][d], x[d]);
            }
        }
    if (!ranks_) return;
    std::vector<int> ends;
    for (std::size_t b = 0; b < s.bodies.size(); ++b)
        for (int d = 0; d < 3; ++d) { ends.push_back(low_[b][d]); ends.push_back(-high_[b][d]); }
    ranks_->least(ends);
    for (std::size_t b = 0; b < s.bodies.size(); ++b)
        for (int d = 0; d < 3; ++d)
        {
            low_[b][d] = ends[6*b + 2*d];
            high_[b][d] = -ends[6*b + 2*d + 1];
        }
}

//- Local solutions for light bodies, and hats between those
void BodyDeflation::placeBodies(const DeflationControls& controls)
{
    const ReducedSystem& s = system_;
    // together, so that ranks wait for each other less often
    const std::size_t atOnce = ranks_ ? 64 : 1;
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
            const int wider = d < s.dimensions
                ? std::max(1, int(controls.margin*0.5*(high[d] - low[d] + 1) + 0.5))
                : 0;
            z.low[d] = std::max(0, low[d] - wider);
            z.high[d] = std::min(s.n[d] - 1, high[d] + wider);
        }
        pieces_.push_back(std::move(z));
    }
    if (lows.empty()) return;
    rowOfCell_.set(s);
    whole_.assign(s.rows() + beside_.size(), 0.0);
    for (std::size_t b = 0; b < lights.size(); b += atOnce)
        solveLocally({lights.begin() + b, lights.begin() + std::min(lights.size(), b + atOnce)},
            controls.localIterations, &pieces_[b]);
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(),
                      [](const DeflationPiece& z) { return !z.modes; }),
        pieces_.end());
    if (!(controls.hats > 0)) return;
    std::vector<int> closed(1, s.closed);
    if (ranks_) ranks_->least(closed);
    for (DeflationPiece& hat : hatsBetween(s, rowOfCell_, lows, highs,
             controls.hats*width/lows.size(), closed[0] && controls.hatsEverywhere))
        pieces_.push_back(std::move(hat));
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

//- Along the direction in which they are spread most, so that E has a narrow band
void BodyDeflation::order()
{
    const int count = int(pieces_.size());
    CellCorner least = pieces_[0].low, most = pieces_[0].low;
    for (const DeflationPiece& z : pieces_)
        for (int d = 0; d < 3; ++d)
        {
            least[d] = std::min(least[d], z.low[d]);
            most[d] = std::max(most[d], z.low[d]);
        }
    int along = 0;
    for (int d = 1; d < 3; ++d) if (most[d] - least[d] > most[along] - least[along]) along = d;
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(),
        [&](int a, int b) { return pieces_[a].low[along] < pieces_[b].low[along]; });
    firstColumn_.resize(count);
    for (const int b : order_) { firstColumn_[b] = columns_; columns_ += pieces_[b].modes; }
}

double BodyDeflation::rowTimes(int row) const
{
    double sum = system_.diagonal[row]*whole_[row];
    for (int k = start_[row]; k < start_[row + 1]; ++k) sum += coefficient_[k]*whole_[other_[k]];
    return sum;
}

//- r = u, and nothing else yet, of each mode of bodies[b] on the rows of z[b]
std::vector<BodyDeflation::LocalColumn> BodyDeflation::startLocally(
    const std::vector<const BodyRows*>& bodies, DeflationPiece* z)
{
    std::vector<LocalColumn> columns;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        const BodyRows& body = *bodies[b];
        rowOfCell_.each(
            z[b].low, z[b].high, [&](int row, const CellCorner&) { z[b].row.push_back(row); });
        findFaces(z[b]);
        const std::size_t n = z[b].row.size();
        for (int m = 0; m < body.modes; ++m)
        {
            LocalColumn c;
            c.at = &z[b];
            for (std::vector<double>* v : {&c.r, &c.p, &c.q, &c.x}) v->assign(n, 0.0);
            for (std::size_t i = 0; i < body.row.size(); ++i)
                whole_[body.row[i]] = body.u[i*body.modes + m];
            for (std::size_t i = 0; i < n; ++i) c.r[i] = whole_[z[b].row[i]];
            for (const int row : body.row) whole_[row] = 0;
            columns.push_back(std::move(c));
        }
    }
    return columns;
}

//- q = A p, and p.q of each
std::vector<double> BodyDeflation::multiplyLocally(std::vector<LocalColumn>& columns)
{
    const int rows = system_.rows();
    std::vector<const DeflationPiece*> at;
    at.reserve(columns.size());
    for (const LocalColumn& v : columns) at.push_back(v.at);
    const std::vector<std::vector<double>> there =
        beyond(at, [&](std::size_t c, std::size_t i) { return columns[c].p[i]; });
    std::vector<double> pq(columns.size(), 0.0);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
        LocalColumn& v = columns[c];
        if (v.ends) continue;
        double part = 0;
        const std::vector<int>& row = v.at->row;
        const std::vector<int>& in = v.at->in;
        for (std::size_t i = 0; i < row.size(); ++i) whole_[row[i]] = v.p[i];
        for (std::size_t f = 0; f < in.size(); ++f) whole_[rows + in[f]] = there[c][f];
        for (std::size_t i = 0; i < row.size(); ++i)
        {
            v.q[i] = rowTimes(row[i]);
            part += v.p[i]*v.q[i];
        }
        pq[c] = part;
        for (const int k : row) whole_[k] = 0;
        for (const int f : in) whole_[rows + f] = 0;
    }
    sum(pq);
    return pq;
}

void BodyDeflation::iterateLocally(std::vector<LocalColumn>& columns, int iterations)
{
    const std::vector<double>& diagonal = system_.diagonal;
    std::vector<double> rz(columns.size());
    for (int k = 0; k < iterations; ++k)
    {
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            const std::vector<double>& r = columns[c].r;
            const std::vector<int>& row = columns[c].at->row;
            double part = 0;
            for (std::size_t i = 0; i < r.size(); ++i) part += r[i]*r[i]/diagonal[row[i]];
            rz[c] = part;
        }
        sum(rz);
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            LocalColumn& v = columns[c];
            v.ends = v.ends || !(rz[c] > 0);
            if (v.ends) continue;
            const std::vector<int>& row = v.at->row;
            const double beta = k ? rz[c]/v.before : 0;
            for (std::size_t i = 0; i < row.size(); ++i)
                v.p[i] = v.r[i]/diagonal[row[i]] + beta*v.p[i];
        }
        const std::vector<double> pq = multiplyLocally(columns);
        for (std::size_t c = 0; c < columns.size(); ++c)
        {
            LocalColumn& v = columns[c];
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
}

//- Conjugate gradients with the diagonal on the rows in each body's box, for each column u of U.
//  u^T A^-1 u is by how much the body moves the eigenvalue 1 of its mode
void BodyDeflation::solveLocally(
    const std::vector<const BodyRows*>& bodies, int iterations, DeflationPiece* z)
{
    constexpr double slow = 0.1;
    std::vector<LocalColumn> columns = startLocally(bodies, z);
    iterateLocally(columns, iterations);
    std::size_t first = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        std::vector<const std::vector<double>*> kept;
        for (int m = 0; m < bodies[b]->modes; ++m, ++first)
            if (columns[first].moved > slow) kept.push_back(&columns[first].x);
        z[b].modes = int(kept.size());
        z[b].value.resize(z[b].row.size()*z[b].modes);
        for (std::size_t i = 0; i < z[b].row.size(); ++i)
            for (int m = 0; m < z[b].modes; ++m) z[b].value[i*z[b].modes + m] = (*kept[m])[i];
    }
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
            for (int m = 0; m < modes; ++m)
                c[firstColumn_[b] + m] += pieces_[b].value[i*modes + m]*r[pieces_[b].row[i]];
    }
    sum(c);
    coarse_.solve(c);
    for (std::size_t b = 0; b < pieces_.size(); ++b)
    {
        const int modes = pieces_[b].modes;
        for (std::size_t i = 0; i < pieces_[b].row.size(); ++i)
            for (int m = 0; m < modes; ++m)
                z[pieces_[b].row[i]] += pieces_[b].value[i*modes + m]*c[firstColumn_[b] + m];
    }
}

} // namespace riprap

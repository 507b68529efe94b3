/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/bodies/deflation.hpp"
#include <map>
#include <numeric>

namespace riprap
{

BodyDeflation::BodyDeflation(const ReducedSystem& system, const DeflationControls& controls)
:
    system_(system),
    whole_(system.rows(), 0.0),
    inBox_(system.rows(), 0)
{
    if (system.bodies.empty()) return;
    connect();
    placeBodies(controls.margin);
    for (std::size_t b = 0; b < system.bodies.size(); ++b) z_.push_back(solveLocally(int(b), controls.localIterations));
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

//- Boxes; and the order of the bodies along the direction in which they are spread most, so that E has a narrow band
void BodyDeflation::placeBodies(double margin)
{
    const ReducedSystem& s = system_;
    rowOfCell_.assign(std::size_t(s.n[0])*s.n[1]*s.n[2], -1);
    for (int i = 0; i < s.rows(); ++i) rowOfCell_[s.cell[i]] = i;
    const int count = int(s.bodies.size());
    low_.resize(count);
    high_.resize(count);
    Corner least{{1 << 30, 1 << 30, 1 << 30}}, most{{0, 0, 0}};
    for (int b = 0; b < count; ++b)
    {
        Corner low{{1 << 30, 1 << 30, 1 << 30}}, high{{-1, -1, -1}};
        for (const int r : s.bodies[b].row)
        {
            const int c = s.cell[r], x[3] = {c % s.n[0], c/s.n[0] % s.n[1], c/(s.n[0]*s.n[1])};
            for (int d = 0; d < 3; ++d) { low[d] = std::min(low[d], x[d]); high[d] = std::max(high[d], x[d]); }
        }
        for (int d = 0; d < 3; ++d)
        {
            if (high[d] >= 0) { least[d] = std::min(least[d], low[d]); most[d] = std::max(most[d], low[d]); }
            const int wider = d < s.dimensions ? std::max(1, int(margin*0.5*(high[d] - low[d] + 1) + 0.5)) : 0;
            low[d] = std::max(0, low[d] - wider);
            high[d] = std::min(s.n[d] - 1, high[d] + wider);
        }
        low_[b] = low;
        high_[b] = high;
    }
    int along = 0;
    for (int d = 1; d < 3; ++d) if (most[d] - least[d] > most[along] - least[along]) along = d;
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return low_[a][along] < low_[b][along]; });
    firstColumn_.resize(count);
    for (const int b : order_) { firstColumn_[b] = columns_; columns_ += s.bodies[b].modes; }
}

double BodyDeflation::rowTimes(int row) const
{
    double sum = system_.diagonal[row]*whole_[row];
    for (int k = start_[row]; k < start_[row + 1]; ++k) sum += coefficient_[k]*whole_[other_[k]];
    return sum;
}

//- Conjugate gradients with the diagonal on the rows in the body's box, for each column of U
BodyDeflation::Local BodyDeflation::solveLocally(int body, int iterations)
{
    const ReducedSystem& s = system_;
    const BodyRows& u = s.bodies[body];
    Local z;
    for (int k = low_[body][2]; k <= high_[body][2]; ++k)
        for (int j = low_[body][1]; j <= high_[body][1]; ++j)
            for (int i = low_[body][0]; i <= high_[body][0]; ++i)
            {
                const int r = rowOfCell_[i + s.n[0]*(j + s.n[1]*k)];
                if (r >= 0) z.row.push_back(r);
            }
    const int n = int(z.row.size()), modes = u.modes;
    z.value.assign(std::size_t(n)*modes, 0.0);
    std::vector<double> r(n), p(n), q(n), rhs(n);
    for (int m = 0; m < modes; ++m)
    {
        for (std::size_t i = 0; i < u.row.size(); ++i) whole_[u.row[i]] = u.u[i*modes + m];
        for (int i = 0; i < n; ++i) r[i] = whole_[z.row[i]];
        for (const int row : u.row) whole_[row] = 0;
        double before = 0;
        for (int k = 0; k < iterations; ++k)
        {
            double rz = 0, pq = 0;
            for (int i = 0; i < n; ++i) rz += r[i]*r[i]/s.diagonal[z.row[i]];
            if (!(rz > 0)) break;
            for (int i = 0; i < n; ++i) p[i] = r[i]/s.diagonal[z.row[i]] + (k ? rz/before*p[i] : 0);
            for (int i = 0; i < n; ++i) whole_[z.row[i]] = p[i];
            for (int i = 0; i < n; ++i) { q[i] = rowTimes(z.row[i]); pq += p[i]*q[i]; }
            if (!(pq > 0)) break;
            for (int i = 0; i < n; ++i)
            {
                z.value[std::size_t(i)*modes + m] += rz/pq*p[i];
                r[i] -= rz/pq*q[i];
            }
            before = rz;
        }
        for (const int row : z.row) whole_[row] = 0;
    }
    return z;
}

//- E = Z^T A Z + (U^T Z)^T (U^T Z)
void BodyDeflation::makeCoarse()
{
    const ReducedSystem& s = system_;
    const int count = int(s.bodies.size());
    // bodies beside each row: in their box, and with a surface there
    std::vector<std::vector<int>> boxesAt(s.rows()), bodiesAt(s.rows());
    for (int b = 0; b < count; ++b)
    {
        for (const int r : z_[b].row) boxesAt[r].push_back(b);
        for (const int r : s.bodies[b].row) bodiesAt[r].push_back(b);
    }
    // G = U^T Z of each column, by body; then the bodies whose columns meet
    std::vector<std::map<int, std::vector<double>>> g(columns_);
    std::vector<std::vector<int>> meets(count), seenBy(count);
    std::vector<std::map<int, double>> entries(columns_);
    for (int b = 0; b < count; ++b)
    {
        const int modes = s.bodies[b].modes;
        std::vector<int> touched;
        for (const int r : z_[b].row)
        {
            for (const int c : bodiesAt[r]) touched.push_back(c);
            for (const int c : boxesAt[r]) meets[b].push_back(c);
            for (int k = start_[r]; k < start_[r + 1]; ++k) for (const int c : boxesAt[other_[k]]) meets[b].push_back(c);
        }
        const auto unique = [](std::vector<int>& v) { std::sort(v.begin(), v.end()); v.erase(std::unique(v.begin(), v.end()), v.end()); };
        unique(touched);
        unique(meets[b]);
        for (const int c : touched) seenBy[c].push_back(b);
        for (int m = 0; m < modes; ++m)
        {
            for (std::size_t i = 0; i < z_[b].row.size(); ++i) whole_[z_[b].row[i]] = z_[b].value[i*modes + m];
            const int column = firstColumn_[b] + m;
            for (const int c : touched)
            {
                const BodyRows& u = s.bodies[c];
                std::vector<double> sum(u.modes, 0.0);
                for (std::size_t i = 0; i < u.row.size(); ++i)
                    for (int k = 0; k < u.modes; ++k) sum[k] += u.u[i*u.modes + k]*whole_[u.row[i]];
                g[column][c] = sum;
            }
            for (const int c : meets[b])
            {
                std::vector<double> sum(s.bodies[c].modes, 0.0);
                for (std::size_t i = 0; i < z_[c].row.size(); ++i)
                {
                    const double az = rowTimes(z_[c].row[i]);
                    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += z_[c].value[i*sum.size() + k]*az;
                }
                for (std::size_t k = 0; k < sum.size(); ++k) entries[column][firstColumn_[c] + int(k)] += sum[k];
            }
            for (const int r : z_[b].row) whole_[r] = 0;
        }
    }
    for (int c = 0; c < count; ++c)
        for (const int a : seenBy[c])
            for (const int b : seenBy[c])
                for (int i = 0; i < s.bodies[a].modes; ++i)
                    for (int j = 0; j < s.bodies[b].modes; ++j)
                    {
                        const std::vector<double>&x = g[firstColumn_[a] + i][c], &y = g[firstColumn_[b] + j][c];
                        double dot = 0;
                        for (std::size_t k = 0; k < x.size(); ++k) dot += x[k]*y[k];
                        entries[firstColumn_[a] + i][firstColumn_[b] + j] += dot;
                    }
    std::vector<int> first(columns_);
    for (int i = 0; i < columns_; ++i) first[i] = entries[i].empty() ? i : std::min(i, entries[i].begin()->first);
    coarse_ = Skyline(first);
    for (int i = 0; i < columns_; ++i)
        for (const auto& [j, value] : entries[i]) if (j <= i) coarse_.at(i, j) = value;
    coarse_.factorise();
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
    for (std::size_t b = 0; b < z_.size(); ++b)
    {
        const int modes = system_.bodies[b].modes;
        for (std::size_t i = 0; i < z_[b].row.size(); ++i)
            for (int m = 0; m < modes; ++m) c[firstColumn_[b] + m] += z_[b].value[i*modes + m]*r[z_[b].row[i]];
    }
    coarse_.solve(c);
    for (std::size_t b = 0; b < z_.size(); ++b)
    {
        const int modes = system_.bodies[b].modes;
        for (std::size_t i = 0; i < z_[b].row.size(); ++i)
            for (int m = 0; m < modes; ++m) z[z_[b].row[i]] += z_[b].value[i*modes + m]*c[firstColumn_[b] + m];
    }
}

} // namespace riprap

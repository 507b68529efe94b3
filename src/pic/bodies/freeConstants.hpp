/*  Water of a ReducedSystem that nothing ties to p = 0, up to a constant of its own: A + U U^T
    takes 1 over it to nothing. Residuals must sum to zero there. Round-off of b - A x does not, and
    no iteration takes that away, while Q, which is as large as hats over this water are small
    elsewhere, makes a constant of it that outgrows what is left of z in the end.

    Pockets between which bodies move water back and forth (u^T 1 is not zero over each) share one
    constant.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>
#include "api/linearSolver.hpp"

namespace riprap
{

class FreeConstants
{
public:

    //- Of a system that is not divided
    explicit FreeConstants(const ReducedSystem& s) : group_(s.rows())
    {
        // of what is summed: far above round-off, far below a tie or what a body pushes through a
        // face
        constexpr double small = 1e-9;
        std::iota(group_.begin(), group_.end(), 0);
        std::vector<double> sum(s.diagonal);
        for (std::size_t f = 0; f < s.owner.size(); ++f)
        {
            join(s.owner[f], s.neighbour[f]);
            sum[s.owner[f]] += s.offDiagonal[f];
            sum[s.neighbour[f]] += s.offDiagonal[f];
        }
        for (const BodyRows& b : s.bodies) joinThrough(b, small);
        std::vector<char> tied(s.rows(), 0);
        for (int i = 0; i < s.rows(); ++i) if (sum[i] > small*s.diagonal[i]) tied[root(i)] = 1;
        std::vector<int> number(s.rows(), -1);
        std::vector<int> of(s.rows(), -1);
        for (int i = 0; i < s.rows(); ++i)
        {
            const int r = root(i);
            if (tied[r]) continue;
            if (number[r] < 0) { number[r] = int(rows_.size()); rows_.push_back(0); }
            of[i] = number[r];
            ++rows_[of[i]];
        }
        group_ = of;
    }

    int count() const { return int(rows_.size()); }

    //- A mean of zero over each
    void takeFrom(double* r) const
    {
        if (rows_.empty()) return;
        std::vector<double> mean(rows_.size(), 0.0);
        for (std::size_t i = 0; i < group_.size(); ++i) if (group_[i] >= 0) mean[group_[i]] += r[i];
        for (std::size_t g = 0; g < rows_.size(); ++g) mean[g] /= rows_[g];
        for (std::size_t i = 0; i < group_.size(); ++i) if (group_[i] >= 0) r[i] -= mean[group_[i]];
    }

private:

    int root(int i)
    {
        while (group_[i] != i) i = group_[i] = group_[group_[i]];
        return i;
    }

    void join(int a, int b)
    {
        a = root(a);
        b = root(b);
        group_[std::max(a, b)] = std::min(a, b);
    }

    //- The pockets into which a body pushes more than it takes out
    void joinThrough(const BodyRows& b, double small)
    {
        std::map<int, std::vector<double>> pushed;
        double size = 0;
        for (std::size_t i = 0; i < b.row.size(); ++i)
        {
            std::vector<double>& sum = pushed[root(b.row[i])];
            sum.resize(b.modes, 0.0);
            for (int m = 0; m < b.modes; ++m)
            {
                sum[m] += b.u[i*b.modes + m];
                size += std::fabs(b.u[i*b.modes + m]);
            }
        }
        int first = -1;
        for (const auto& pocket : pushed)
            for (const double v : pocket.second)
            {
                if (std::fabs(v) <= small*size) continue;
                if (first < 0) first = pocket.first;
                join(first, pocket.first);
            }
    }

    std::vector<int> group_;                // which each row is of, -1: none
    std::vector<int> rows_;                 // of each
};

} // namespace riprap

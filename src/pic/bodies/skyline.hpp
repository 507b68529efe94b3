/*  Cholesky factors of a sparse symmetric positive definite matrix that is stored row by row from
    each row's first entry.

    A pivot that loses all but dropped of its diagonal belongs to a column that the earlier ones
    span: it is left out, as is one whose diagonal is zero.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <vector>

namespace riprap
{

class Skyline
{
public:

    //- first[i]: column of the first entry of row i, at most i
    explicit Skyline(const std::vector<int>& first) : first_(first), start_(first.size() + 1, 0)
    {
        for (std::size_t i = 0; i < first.size(); ++i)
            start_[i + 1] = start_[i] + (i - first[i] + 1);
        value_.assign(start_.back(), 0.0);
    }

    int size() const { return int(first_.size()); }
    int first(int i) const { return first_[i]; }
    double& at(int i, int j) { return value_[start_[i] + (j - first_[i])]; }
    std::vector<double>& values() { return value_; }
    double at(int i, int j) const { return value_[start_[i] + (j - first_[i])]; }

    void factorise()
    {
        constexpr double dropped = 1e-10;
        inverse_.assign(size(), 0.0);
        for (int i = 0; i < size(); ++i)
        {
            double* row = &at(i, first_[i]) - first_[i];
            for (int j = first_[i]; j < i; ++j)
            {
                const double* other = &at(j, first_[j]) - first_[j];
                double sum = row[j];
                for (int k = std::max(first_[i], first_[j]); k < j; ++k) sum -= row[k]*other[k];
                row[j] = sum;       // L D: divided below
            }
            double pivot = row[i];
            for (int j = first_[i]; j < i; ++j)
            {
                const double l = row[j]*inverse_[j];
                pivot -= l*row[j];
                row[j] = l;
            }
            inverse_[i] = row[i] > 0 && pivot > dropped*row[i] ? 1/pivot : 0;
        }
    }

    //- After factorise()
    void solve(std::vector<double>& x) const
    {
        for (int i = 0; i < size(); ++i)
            for (int j = first_[i]; j < i; ++j) x[i] -= at(i, j)*x[j];
        for (int i = 0; i < size(); ++i) x[i] *= inverse_[i];
        for (int i = size() - 1; i >= 0; --i)
            for (int j = first_[i]; j < i; ++j) x[j] -= at(i, j)*x[i];
    }

private:

    std::vector<int> first_;
    std::vector<std::size_t> start_;
    std::vector<double> value_, inverse_;
};

} // namespace riprap

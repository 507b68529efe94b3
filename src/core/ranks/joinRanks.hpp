/*  What all ranks make of what each of them has: rows one after the other, sums by rank. The same
    bits on all of them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>
#include "core/ranks/transport.hpp"

namespace riprap
{

//- To the bit: what two ranks have of one thing
inline bool sameBytes(const void* a, const void* b, std::size_t bytes)
{
    return std::memcmp(a, b, bytes) == 0;
}

//- The same message to each rank; from each, in their order
inline std::vector<RankBytes> toAll(Transport& ranks, const RankBytes& bytes)
{
    std::vector<RankBytes> in;
    ranks.exchange(std::vector<RankBytes>(ranks.size(), bytes), in);
    return in;
}

//- The rows of all ranks one after the other, each a message of its own
template<class T>
void join(Transport& ranks, std::vector<T>& values)
{
    RankBytes own;
    putValues(own, values.data(), values.size());
    values.clear();
    for (const RankBytes& bytes : toAll(ranks, own))
    {
        const std::size_t before = values.size();
        if (bytes.size() % sizeof(T))
            throw std::logic_error("a rank has sent a part of a row");
        values.resize(before + bytes.size()/sizeof(T));
        if (bytes.size())
            std::memcpy(static_cast<void*>(values.data() + before), bytes.data(), bytes.size());
    }
}

//- What ranks have sent in ascending rows, one after the other, becomes one row
template<class T, class Less>
void mergeRows(std::vector<T>& v, const Less& less)
{
    std::vector<std::size_t> begin(1, 0), next;
    for (std::size_t k = 1; k < v.size(); ++k) if (less(v[k], v[k - 1])) begin.push_back(k);
    begin.push_back(v.size());
    const auto at = [&](std::size_t k) { return v.begin() + std::ptrdiff_t(begin[k]); };
    while (begin.size() > 2)
    {
        next.clear();
        for (std::size_t k = 0; k + 1 < begin.size(); k += 2)
        {
            next.push_back(begin[k]);
            if (k + 2 < begin.size()) std::inplace_merge(at(k), at(k + 1), at(k + 2), less);
        }
        next.push_back(v.size());
        begin.swap(next);
    }
}

//- Entry by entry, by rank
inline void addByRank(Transport& ranks, std::vector<double>& v)
{
    RankBytes own;
    putValues(own, v.data(), v.size());
    const std::size_t n = v.size();
    std::fill(v.begin(), v.end(), 0.0);
    for (const RankBytes& bytes : toAll(ranks, own))
        for (std::size_t k = 0; k < n; ++k)
        {
            double x;
            std::memcpy(&x, bytes.data() + k*sizeof(x), sizeof(x));
            v[k] += x;
        }
}

//- The least of all ranks, row by row of `each` integers, most of which say `unset`: those that do
//  not are sent
inline void leastOfRanks(Transport& ranks, std::vector<int>& values, int each, int unset)
{
    const int rows = int(values.size())/each;
    RankBytes own;
    for (int row = 0; row < rows; ++row)
    {
        const int* from = values.data() + std::size_t(row)*each;
        if (std::all_of(from, from + each, [&](int v) { return v == unset; })) continue;
        putValues(own, &row);
        putValues(own, from, each);
    }
    for (const RankBytes& bytes : toAll(ranks, own))
        for (const unsigned char* from = bytes.data(); from < bytes.data() + bytes.size();)
        {
            int row = 0;
            takeValues(from, &row);
            for (int k = 0; k < each; ++k)
            {
                int v = 0;
                takeValues(from, &v);
                int& least = values[std::size_t(row)*each + k];
                least = std::min(least, v);
            }
        }
}

//- What is no number counts as infinite
inline double largestOfRanks(Transport& ranks, double value)
{
    std::vector<double> v(1, value == value ? value : std::numeric_limits<double>::infinity());
    ranks.largest(v);
    return v[0];
}

//- Rows of so many values as `order` says
template<class T>
void arrange(std::vector<T>& values, std::size_t each, const std::vector<std::size_t>& order)
{
    if (values.empty()) return;
    std::vector<T> arranged(values.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        std::copy_n(values.begin() + order[i]*each, each, arranged.begin() + i*each);
    values.swap(arranged);
}

template<class Less>
std::vector<std::size_t> orderBy(std::size_t n, const Less& less)
{
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), less);
    return order;
}

} // namespace riprap

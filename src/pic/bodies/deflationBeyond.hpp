/*  BodyDeflation: values of columns of Z in cells of other ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/deflation.hpp"

namespace riprap
{

template<class F>
std::vector<std::vector<double>> BodyDeflation::beyond(
    const std::vector<const DeflationPiece*>& columns, const F& value)
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

} // namespace riprap

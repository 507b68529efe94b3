/*  Which slot has the particle of an id: a table of the particles that are here, however large ids
    are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <vector>

namespace riprap
{

class IdSlots
{
public:

    //- For so many ids
    explicit IdSlots(std::size_t n)
    {
        while ((std::size_t(1) << bits_) < 2*n) ++bits_;
        entry_.assign(std::size_t(1) << bits_, Entry{0, -1});
    }

    void put(std::int32_t id, std::int32_t slot) { entry_[place(id)] = Entry{id, slot}; }

    //- -1: it is not here
    std::int32_t operator()(std::int32_t id) const { return entry_[place(id)].slot; }

private:

    struct Entry { std::int32_t id, slot; };

    //- Where the id is, or would be
    std::size_t place(std::int32_t id) const
    {
        std::size_t k = std::uint32_t(id)*2654435769u >> (32 - bits_);
        while (entry_[k].slot >= 0 && entry_[k].id != id) k = (k + 1) & (entry_.size() - 1);
        return k;
    }

    int bits_ = 1;
    std::vector<Entry> entry_;
};

} // namespace riprap

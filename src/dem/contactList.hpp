/*  Which particles may touch until the next rebuild, and what each contact remembers.

    Particle i's entries are index(i, 0 .. count[i]-1). On the GPU 32 particles share a block, entry k of all of them side by
    side; lists are full (each pair at both ends) and histories kept twice, mirrored. On the CPU a particle's entries follow one
    another; lists are half: a pair is with the particle that is sorted first, which is never the larger class's.

    An entry is the other's index; its top bit says that the pair touched in the last step, that is, that its history holds.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend.hpp"
#include "core/sort.hpp"

namespace riprap
{

struct ContactListLayout
{
    static constexpr std::uint32_t touching = 0x80000000u;
    HD static int other(std::uint32_t entry) { return int(entry & ~touching); }
};

template<class Backend, class R>
struct ContactListView : ContactListLayout
{
    static constexpr int width = Backend::gpu ? 32 : 1;

    std::uint32_t* entry;
    const int* base;            // first entry of each block of `width` particles
    const int* count;           // of each particle
    R* history;
    R* rest;                    // overlap at which a pair is at rest (after a bond), or null
    int* owner;                 // on the CPU, of each entry: its particle
    std::size_t stride;

    HD std::size_t index(int i, int k) const { return std::size_t(base[i/width]) + std::size_t(k)*width + i % width; }

    template<int H>
    HD R& remembered(std::size_t e, int c) const { return Backend::gpu ? history[c*stride + e] : history[e*historyWords(H) + c]; }

    //- Numbers kept of an entry: on the CPU in rows of four, so that rows are loaded whole
    HD static constexpr int historyWords(int H) { return Backend::gpu ? H : (H + 3)/4*4; }
};

template<class Backend, class R>
class ContactList
{
public:
    static constexpr int width = Backend::gpu ? 32 : 1;

    void allocate(Context<Backend>& context, int n)
    {
        blocks_ = (n + width - 1)/width;
        base_.allocate(context, std::size_t(blocks_) + 1);
        count_.allocate(context, std::size_t(blocks_)*width);
    }

    //- Room for so many entries
    void reserve(Context<Backend>& context, std::size_t entries, int histories, bool rests)
    {
        if (entries > entry_.size())
        {
            const std::size_t room = entries + entries/8 + 64;
            entry_.allocate(context, room);
            if (!Backend::gpu) owner_.allocate(context, room);
            const int words = ContactListView<Backend, R>::historyWords(histories);
            if (words) history_.allocate(context, room*words);
            if (rests) rest_.allocate(context, room);
        }
        entries_ = entries;
    }

    ContactListView<Backend, R> view()
    {
        ContactListView<Backend, R> v;
        v.entry = entry_.data();
        v.base = base_.data();
        v.count = count_.data();
        v.history = history_.data();
        v.rest = rest_.size() ? rest_.data() : nullptr;
        v.owner = owner_.data();
        v.stride = entry_.size();
        return v;
    }

    int* base() { return base_.data(); }
    int* count() { return count_.data(); }
    int blocks() const { return blocks_; }
    std::size_t entries() const { return entries_; }
    std::size_t bytes() const { return entry_.bytes() + base_.bytes() + count_.bytes() + history_.bytes() + rest_.bytes() + owner_.bytes(); }

    void swap(ContactList& o)
    {
        entry_.swap(o.entry_);
        base_.swap(o.base_);
        owner_.swap(o.owner_);
        count_.swap(o.count_);
        history_.swap(o.history_);
        rest_.swap(o.rest_);
        std::swap(blocks_, o.blocks_);
        std::swap(entries_, o.entries_);
    }

private:
    Array<Backend, std::uint32_t> entry_;
    Array<Backend, int> base_, count_, owner_;
    Array<Backend, R> history_, rest_;
    int blocks_ = 0;
    std::size_t entries_ = 0;
};

} // namespace riprap

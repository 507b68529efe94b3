/*  Which particles may touch until the next rebuild, and what each contact remembers.

    Particle i's entries are index(i, 0 .. count[i]-1). On the GPU 32 particles share a block, entry
    k of all of them side by side; lists are full (each pair at both ends), what touches or nearly
    so comes first, and histories are kept twice, mirrored, in words of four. On the CPU a
    particle's entries follow one another; lists are half: a pair is with the particle that is
    sorted first, which is never the larger class's.

    An entry is the other's index; its top bit says that the pair touched in the last step, that is,
    that its history holds.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/backend/snapshot.hpp"
#include "core/loops/sort.hpp"

namespace riprap
{

struct ContactListLayout
{
    static constexpr std::uint32_t touching = 0x80000000u;
    HD static int other(std::uint32_t entry) { return int(entry & ~touching); }
};

//- Numbers that are loaded at once
template<int n, class R>
struct alignas(n*sizeof(R)) HistoryWords { R c[n]; };
template<class R>
struct HistoryWords<0, R> { R c[1]; };

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

    HD std::size_t index(int i, int k) const
    {
        return std::size_t(base[i/width]) + std::size_t(k)*width + i % width;
    }

    //- Numbers that lie together: four, or less where there are no more
    HD static constexpr int wordsTogether(int H)
    {
        return Backend::gpu && H < 4 ? (H == 3 ? 4 : H) : 4;
    }

    //- Numbers kept of an entry
    HD static constexpr int historyWords(int H)
    {
        return H ? (H + wordsTogether(H) - 1)/wordsTogether(H)*wordsTogether(H) : 0;
    }

    HD std::size_t place(int H, std::size_t e, int c) const
    {
        const int together = wordsTogether(H);
        return Backend::gpu ? (std::size_t(c/together)*stride + e)*together + c % together
                            : e*historyWords(H) + c;
    }

    //- What entry e remembers, H numbers, to `to` or from there, where they lie one after the other
    HD void unload(int H, std::size_t e, R* to) const
    {
        for (int first = 0; first < H; first += wordsTogether(H))
            copyWords(wordsTogether(H), history + place(H, e, first), to + first);
    }

    HD void load(int H, std::size_t e, const R* from) const
    {
        for (int first = 0; first < H; first += wordsTogether(H))
            copyWords(wordsTogether(H), from + first, history + place(H, e, first));
    }

    template<int H>
    HD R& remembered(std::size_t e, int c) const { return history[place(H, e, c)]; }

    //- All that an entry remembers, in as few loads as there can be
    template<int H>
    HD void recall(std::size_t e, R* h) const
    {
        constexpr int together = wordsTogether(H);
        for (int first = 0; first < H; first += together)
        {
            const auto w = *reinterpret_cast<const HistoryWords<together, R>*>(
                history + place(H, e, first));
            for (int c = 0; c < together && first + c < H; ++c) h[first + c] = w.c[c];
        }
    }

    template<int H>
    HD void remember(std::size_t e, const R* h) const
    {
        constexpr int together = wordsTogether(H);
        for (int first = 0; first < H; first += together)
        {
            HistoryWords<together, R> w;
            for (int c = 0; c < together; ++c) w.c[c] = first + c < H ? h[first + c] : R(0);
            *reinterpret_cast<HistoryWords<together, R>*>(history + place(H, e, first)) = w;
        }
    }

private:

    //- In one piece where there are four
    HD static void copyWords(int together, const R* from, R* to)
    {
        if (together == 4)
            *reinterpret_cast<HistoryWords<4, R>*>(
                to) = *reinterpret_cast<const HistoryWords<4, R>*>(from);
        else for (int c = 0; c < together; ++c) to[c] = from[c];
    }
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

    //- Lists of n particles from now on, of which those behind the present ones are empty (CPU)
    void resize(Context<Backend>& context, int n)
    {
        std::vector<int> base = base_.download(), count = count_.download();
        base.resize(std::size_t(n) + 1, base.empty() ? 0 : base.back());
        count.resize(n, 0);
        base_ = Array<Backend, int>();
        count_ = Array<Backend, int>();
        base_.upload(context, base);
        count_.upload(context, count);
        blocks_ = n;
    }

    //- Room for so many entries
    void reserve(Context<Backend>& context, std::size_t entries, int histories, bool rests)
    {
        // a register that begins with the last may reach past it
        if (entries + 8 > entry_.size())
        {
            const std::size_t room = entries + entries/(Backend::gpu ? 16 : 8) + 64;
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
    std::size_t bytes() const
    {
        return entry_.bytes() + base_.bytes() + count_.bytes() + history_.bytes() + rest_.bytes()
            + owner_.bytes();
    }

    //- Which entries are one of the first n particles'; the others fill up blocks
    ReadValues<char> used(Snapshot<Backend>& now, int n) const
    {
        const auto bases = now.values(base_);
        const auto counts = now.values(count_);
        return [bases, counts, n, entries = entries_]
        {
            std::vector<char> yes(entries, 0);
            const std::vector<int> base = bases(), count = counts();
            #pragma omp parallel for schedule(static) if (n > 10000)
            for (int i = 0; i < n; ++i)
                for (int k = 0; k < count[i]; ++k)
                    yes[std::size_t(base[i/width]) + std::size_t(k)*width + i % width] = 1;
            return yes;
        };
    }

    //- Where entries are, without the entries
    void swapShape(ContactList& o)
    {
        base_.swap(o.base_);
        count_.swap(o.count_);
    }

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

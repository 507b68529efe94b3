/*  Values of the grid that ranks have for each other: after an exchange all cells, or faces, of a
    rank's part have what their owners have.

    A kernel packs the boxes that others see into one message a partner, another unpacks what comes.
    Who sends which boxes follows from the bricks, so that partners know how long messages are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <type_traits>
#include "core/ranks/joinRanks.hpp"
#include "pic/ranks/boxInArray.hpp"

namespace riprap
{

//- An array of a rank's part: of cells (direction -1), or of the faces of a direction
struct GridField
{
    //- Nodes of the grid, in the place of a direction: lower corners of cells, and the last ones
    static constexpr int nodes = -2;

    void* data;
    int bytes;                      // of a value: 1, 4 or 8
    int direction;

    template<class A>
    GridField(A& array, int d) : data(array.data()), bytes(sizeof(*array.data())), direction(d)
    {}
};

template<class Backend, int D>
class HaloExchange
{
public:

    HaloExchange(Context<Backend>& context, const GridBricks<D>& bricks)
        : context_(context), bricks_(bricks)
    {}

    const GridBricks<D>& bricks() const { return bricks_; }
    Transport& ranks() const { return bricks_.ranks(); }

    //- What others have, of all these fields, into the part around the brick
    void exchange(const std::vector<GridField>& fields);

    //- The whole block's values, on each rank
    template<class T> std::vector<T> gather(const T* part, int direction) const;
    template<class A> auto gather(A& part, int direction) const
    { return gather(part.data(), direction); }

    //- This rank's part of values of the whole block
    template<class T> std::vector<T> partOf(const std::vector<T>& whole, int direction) const;

    std::size_t bytes() const { return out_.bytes() + in_.bytes(); }

private:

    //- A box that goes to or comes from a rank, of field k, and where in the messages
    struct Piece { int rank, field; CellBox box; std::size_t at; };

    CellBox owned(int rank, int direction) const
    {
        if (direction != GridField::nodes)
            return direction < 0 ? bricks_.brick(rank) : bricks_.facesOfBrick(rank, direction);
        // as faces: the last ones are those of the block's end
        CellBox box = bricks_.brick(rank);
        for (int d = 0; d < D; ++d) if (box.high[d] == bricks_.whole().n[d]) ++box.high[d];
        return box;
    }
    CellBox part(int rank, int direction) const
    {
        if (direction != GridField::nodes)
            return direction < 0 ? bricks_.part(rank) : bricks_.facesOfPart(rank, direction);
        CellBox box = bricks_.part(rank);
        for (int d = 0; d < D; ++d) ++box.high[d];
        return box;
    }
    CellBox whole(int direction) const
    {
        CellBox box;
        for (int d = 0; d < D; ++d)
            box.high[d] = bricks_.whole().n[d]
                + (d == direction || direction == GridField::nodes ? 1 : 0);
        return box;
    }
    std::size_t pieces(const std::vector<GridField>&, bool out, std::vector<Piece>&) const;
    std::vector<RankMessage> messages(
        const std::vector<Piece>&, std::size_t bytes, unsigned char* memory) const;
    template<template<class> class Copy>
    void copy(const GridField&, const Piece&, unsigned char* memory);

    Context<Backend>& context_;
    const GridBricks<D>& bricks_;
    Array<Backend, unsigned char> out_, in_;        // messages, where the grid is
    std::vector<unsigned char> hostOut_, hostIn_;   // on a GPU: the same on the host
};

//- Partners in the order of ranks, for each the fields; each piece begins at eight bytes.
//  \return bytes of all
template<class Backend, int D>
std::size_t HaloExchange<Backend, D>::pieces(
    const std::vector<GridField>& fields, bool out, std::vector<Piece>& all) const
{
    const int own = bricks_.rank();
    std::size_t at = 0;
    for (int r = 0; r < bricks_.size(); ++r)
    {
        if (r == own) continue;
        int k = 0;
        for (const GridField& f : fields)
        {
            const CellBox box = out ? owned(own, f.direction).with(part(r, f.direction))
                                    : owned(r, f.direction).with(part(own, f.direction));
            const int count = box.count();
            if (count) all.push_back(Piece{r, k, box, at});
            at += (std::size_t(count)*f.bytes + 7)/8*8;
            ++k;
        }
    }
    return at;
}

template<class Backend, int D>
std::vector<RankMessage> HaloExchange<Backend, D>::messages(
    const std::vector<Piece>& pieces, std::size_t bytes, unsigned char* memory) const
{
    std::vector<RankMessage> all;
    for (const Piece& p : pieces)
    {
        if (!all.empty() && all.back().rank == p.rank) continue;
        if (!all.empty()) all.back().size = std::size_t(memory + p.at - all.back().bytes);
        all.push_back(RankMessage{p.rank, memory + p.at, 0});
    }
    if (!all.empty()) all.back().size = std::size_t(memory + bytes - all.back().bytes);
    return all;
}

template<class Backend, int D>
template<template<class> class Copy>
void HaloExchange<Backend, D>::copy(const GridField& f, const Piece& piece, unsigned char* memory)
{
    const BoxInArray box(piece.box, part(bricks_.rank(), f.direction));
    const auto run = [&](auto type)
    {
        using T = decltype(type);
        constexpr bool out = std::is_same<Copy<T>, PackBox<T>>::value;
        T* const field = static_cast<T*>(f.data);
        T* const message = reinterpret_cast<T*>(memory + piece.at);
        forEach(context_, piece.box.count(),
            Copy<T>{box, out ? field : message, out ? message : field});
    };
    // the types differ. NOLINTNEXTLINE(bugprone-branch-clone)
    if (f.bytes == 1) run(std::uint8_t());
    else if (f.bytes == 4) run(std::uint32_t());
    else run(std::uint64_t());
}

template<class Backend, int D>
void HaloExchange<Backend, D>::exchange(const std::vector<GridField>& fields)
{
    std::vector<Piece> out, in;
    const std::size_t outBytes = pieces(fields, true, out), inBytes = pieces(fields, false, in);
    if (out_.size() < outBytes) out_.allocate(context_, outBytes);
    if (in_.size() < inBytes) in_.allocate(context_, inBytes);
    for (const Piece& p : out) copy<PackBox>(fields[p.field], p, out_.data());
    unsigned char* from = out_.data();
    unsigned char* to = in_.data();
    if constexpr (Backend::gpu)
    {
        hostOut_.resize(outBytes);
        hostIn_.resize(inBytes);
        if (outBytes) context_.toHost(hostOut_.data(), out_.data(), outBytes);
        from = hostOut_.data();
        to = hostIn_.data();
    }
    std::vector<RankMessage> coming = messages(in, inBytes, to);
    ranks().swap(messages(out, outBytes, from), coming);
    if constexpr (Backend::gpu)
        if (inBytes) context_.toDevice(in_.data(), hostIn_.data(), inBytes);
    for (const Piece& p : in) copy<UnpackBox>(fields[p.field], p, in_.data());
}

template<class Backend, int D>
template<class T>
std::vector<T> HaloExchange<Backend, D>::gather(const T* values, int direction) const
{
    const int own = bricks_.rank();
    const CellBox mine = owned(own, direction), array = part(own, direction),
                  all = whole(direction);
    std::vector<T> here(array.count());
    context_.toHost(here.data(), values, here.size()*sizeof(T));
    const BoxInArray from(mine, array);
    std::vector<T> part(mine.count());
    for (int i = 0; i < int(part.size()); ++i) part[i] = here[from.at(i)];
    RankBytes bytes;
    putValues(bytes, part.data(), part.size());
    const std::vector<RankBytes> came = toAll(ranks(), bytes);
    std::vector<T> result(all.count());
    for (int r = 0; r < bricks_.size(); ++r)
    {
        const CellBox box = owned(r, direction);
        const BoxInArray to(box, all);
        const unsigned char* next = came[r].data();
        for (int i = 0; i < box.count(); ++i) takeValues(next, &result[to.at(i)]);
    }
    return result;
}

template<class Backend, int D>
template<class T>
std::vector<T> HaloExchange<Backend, D>::partOf(const std::vector<T>& all, int direction) const
{
    const CellBox mine = part(bricks_.rank(), direction);
    const BoxInArray from(mine, whole(direction));
    std::vector<T> result(mine.count());
    for (int i = 0; i < int(result.size()); ++i) result[i] = all[from.at(i)];
    return result;
}

} // namespace riprap

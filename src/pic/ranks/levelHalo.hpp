/*  Values of a level of the multigrid beside a rank's brick, which other ranks have: one cell deep.

    Level l has cells of 2^l of the grid's; bricks begin at multiples of eight cells, so that those
    of the first levels are whole cells of these, and red where the block's are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/ranks/joinRanks.hpp"
#include "pic/ranks/boxInArray.hpp"

namespace riprap
{

template<class Backend, int D>
class LevelHalo
{
public:

    //- stride: of the level's arrays, which begin at the first cell of the part
    LevelHalo(const GridBricks<D>& bricks, int level, const int* stride)
        : bricks_(bricks), level_(level)
    {
        const CellBox part = ofLevel(bricks.part(bricks.rank()));
        for (int d = 0; d < D; ++d) { first_[d] = part.low[d]; stride_[d] = stride[d]; }
        const int own = bricks.rank();
        for (int r = 0; r < bricks.size(); ++r)
        {
            if (r == own) continue;
            add(out_, outValues_, r, brick(own).with(beside(r)));
            add(in_, inValues_, r, brick(r).with(beside(own)));
        }
    }

    //- A rank's brick, in cells of the level
    CellBox brick(int rank) const { return ofLevel(bricks_.brick(rank)); }
    //- Where it lies in arrays of the level
    BoxInArray inArray(const CellBox& box) const { return {box, first_, stride_}; }
    //- Is a cell of the level's arrays in this rank's brick?
    CellBox brickInPart() const
    {
        CellBox b = brick(bricks_.rank());
        for (int d = 0; d < D; ++d) { b.low[d] -= first_[d]; b.high[d] -= first_[d]; }
        return b;
    }

    template<class T> void exchange(Context<Backend>& context, T* values);

private:

    struct Piece { int rank, at; CellBox box; };

    CellBox ofLevel(CellBox box) const
    {
        for (int d = 0; d < D; ++d)
        {
            box.low[d] >>= level_;
            box.high[d] = (box.high[d] + (1 << level_) - 1) >> level_;
        }
        return box;
    }
    //- A brick and one cell around it
    CellBox beside(int rank) const
    {
        CellBox box = brick(rank);
        for (int d = 0; d < D; ++d) { --box.low[d]; ++box.high[d]; }
        return box;
    }
    static void add(std::vector<Piece>& list, int& values, int rank, const CellBox& box)
    {
        if (box.empty()) return;
        list.push_back(Piece{rank, values, box});
        values += box.count();
    }
    template<class T>
    static std::vector<RankMessage> messages(const std::vector<Piece>& list, T* memory)
    {
        std::vector<RankMessage> all;
        all.reserve(list.size());
        for (const Piece& p : list)
            all.push_back(RankMessage{p.rank, reinterpret_cast<unsigned char*>(memory + p.at),
                p.box.count()*sizeof(T)});
        return all;
    }

    const GridBricks<D>& bricks_;
    int level_, first_[3] = {0, 0, 0}, stride_[3] = {1, 0, 0};
    std::vector<Piece> out_, in_;
    int outValues_ = 0, inValues_ = 0;
    Array<Backend, double> memory_;             // messages, where the grid is
    std::vector<double> host_;                  // on a GPU: the same on the host
};

template<class Backend, int D>
template<class T>
void LevelHalo<Backend, D>::exchange(Context<Backend>& context, T* values)
{
    const std::size_t room = std::size_t(outValues_) + inValues_;
    if (memory_.size() < room) memory_.allocate(context, room);
    T* const out = reinterpret_cast<T*>(memory_.data());
    T* const in = reinterpret_cast<T*>(memory_.data() + outValues_);
    for (const Piece& p : out_)
        forEach(context, p.box.count(), PackBox<T>{inArray(p.box), values, out + p.at});
    T* from = out;
    T* to = in;
    if constexpr (Backend::gpu)
    {
        host_.resize(room);
        from = reinterpret_cast<T*>(host_.data());
        to = reinterpret_cast<T*>(host_.data() + outValues_);
        if (outValues_) context.toHost(from, out, outValues_*sizeof(T));
    }
    std::vector<RankMessage> coming = messages(in_, to);
    bricks_.ranks().swap(messages(out_, from), coming);
    if constexpr (Backend::gpu) if (inValues_) context.toDevice(in, to, inValues_*sizeof(T));
    for (const Piece& p : in_)
        forEach(context, p.box.count(), UnpackBox<T>{inArray(p.box), in + p.at, values});
}

} // namespace riprap

/*  Kernels by which particles of a shared scene are counted, chosen and put in order where they are
    (slotExchange.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/deterministicAtomics.hpp"
#include "core/ranks/pieceOwners.hpp"

namespace riprap
{

//- What a piece is to this rank
struct PieceRole
{
    static constexpr int own = 1,       // its particles are this rank's
        keeps = 2,                      // another's, and those here stay as ghosts
        sends = 4;                      // those here are sent to others, all or as ghosts
};

//- A piece with particles: number of the first, and how many there are
struct OccupiedPiece
{
    std::int64_t first;
    std::int32_t piece, count, role, unused;
};

//- Pieces as kernels see them: by cell, then by piece, then those with particles
struct PieceTable
{
    int cells;
    const int* pieceOf;
    const int* firstCell;               // one more than pieces
    const int* place;                   // in `occupied`, of a piece that is there
    const OccupiedPiece* occupied;

    HD const OccupiedPiece& of(std::uint32_t cell) const { return occupied[place[pieceOf[cell]]]; }
};

//- A particle that the host looks at
struct ChosenSlot
{
    std::int64_t number;
    std::uint32_t cell;
    std::int32_t slot;
};

//- Own particles in pieces; keys are kept
struct CountPieces
{
    static constexpr const char* name = "countPieces";
    PieceTable pieces;
    const std::uint32_t* keys;
    const char* ghost;
    std::uint32_t* cell;
    int* counts;

    HD void operator()(int i) const
    {
        cell[i] = keys[i];
        if (ghost[i] || keys[i] >= std::uint32_t(pieces.cells)) return;
        [[maybe_unused]] int* const count = counts + pieces.pieceOf[keys[i]];
#ifdef __CUDA_ARCH__
        atomicAdd(count, 1);
#elif !defined(__CUDACC__)
        #pragma omp atomic
        *count += 1;
#endif
    }
};

//- 1 for pieces with particles
struct FlagOccupied
{
    static constexpr const char* name = "flagOccupied";
    const int* counts;
    int* flag;

    HD void operator()(int p) const { flag[p] = counts[p] != 0; }
};

//- flag: summed up before
struct PutOccupied
{
    static constexpr const char* name = "putOccupied";
    const int* counts;
    const int* flag;
    PieceCount* list;

    HD void operator()(int p) const { if (counts[p]) list[flag[p]] = PieceCount{p, counts[p]}; }
};

struct PlacePieces
{
    static constexpr const char* name = "placePieces";
    const OccupiedPiece* occupied;
    int* place;

    HD void operator()(int k) const { place[occupied[k].piece] = k; }
};

//- 1 for those that stay here, and for those that are sent or have left the domain
struct ChooseSlots
{
    static constexpr const char* name = "chooseSlots";
    PieceTable pieces;
    const char* ghost;
    const std::uint32_t* cell;
    int* present;
    int* chosen;

    HD void operator()(int i) const
    {
        present[i] = chosen[i] = 0;
        if (ghost[i]) return;
        if (cell[i] >= std::uint32_t(pieces.cells)) { chosen[i] = 1; return; }
        const int role = pieces.of(cell[i]).role;
        present[i] = (role & (PieceRole::own | PieceRole::keeps)) != 0;
        chosen[i] = (role & PieceRole::sends) != 0;
    }
};

//- chosen: summed up before
struct PutChosen
{
    static constexpr const char* name = "putChosen";
    const int* chosen;
    const std::int64_t* number;
    const std::uint32_t* cell;
    ChosenSlot* list;

    HD void operator()(int i) const
    {
        if (chosen[i + 1] > chosen[i]) list[chosen[i]] = ChosenSlot{number[i], cell[i], i};
    }
};

//- The first of n ascending numbers that is not below x
HD int firstFrom(const std::int64_t* numbers, int n, std::int64_t x)
{
    int from = 0;
    while (n > 0)
    {
        const int half = n/2;
        if (numbers[from + half] < x) { from += half + 1; n -= half + 1; }
        else n = half;
    }
    return from;
}

//- What is sorted: who is here, by the numbers of before, arrivals among them; then free slots.
//  present: summed up before
struct PlaceKeys
{
    static constexpr const char* name = "placeKeys";
    int residents, arrivals, stay, cells;
    const int* present;
    const std::int64_t* number;
    const ChosenSlot* arrival;          // by number, which ascends; slots follow the residents
    const std::int64_t* arrivalNumber;
    std::uint32_t* cell;
    std::uint32_t* keys;
    std::uint32_t* indices;

    HD void operator()(int i) const
    {
        int at = i;
        std::uint32_t key = std::uint32_t(cells);
        if (i >= residents + arrivals) {}
        else if (i >= residents)
        {
            const ChosenSlot& a = arrival[i - residents];
            at = i - residents + present[firstFrom(number, residents, a.number)];
            cell[i] = key = a.cell;
        }
        else if (present[i + 1] > present[i])
        {
            at = present[i] + firstFrom(arrivalNumber, arrivals, number[i]);
            key = cell[i];
        }
        else at = stay + arrivals + i - present[i];
        keys[at] = key;
        indices[at] = std::uint32_t(i);
    }
};

//- After the sort: numbers, cells, and whose they are
struct SettleSlots
{
    static constexpr const char* name = "settleSlots";
    PieceTable pieces;
    int active;
    const std::uint32_t* order;
    const int* start;
    const std::uint32_t* cellBefore;
    std::uint32_t* cell;
    std::int64_t* number;
    char* ghost;

    HD void operator()(int i) const
    {
        ghost[i] = 0;
        if (i >= active) return;
        cell[i] = cellBefore[order[i]];
        const OccupiedPiece& o = pieces.of(cell[i]);
        number[i] = o.first + (i - start[pieces.firstCell[o.piece]]);
        ghost[i] = !(o.role & PieceRole::own);
    }
};

//- Pieces are here whole or not at all, own ones are here
struct CheckPieces
{
    static constexpr const char* name = "checkPieces";
    PieceTable pieces;
    const int* start;
    int* broken;

    HD void operator()(int k) const
    {
        const OccupiedPiece& o = pieces.occupied[k];
        const int here = start[pieces.firstCell[o.piece + 1]] - start[pieces.firstCell[o.piece]];
        if (here != o.count && (here || (o.role & PieceRole::own))) raise(broken);
    }
};

//- Slots of some pieces, first and end
struct RangesOfPieces
{
    static constexpr const char* name = "rangesOfPieces";
    PieceTable pieces;
    const int* start;
    const int* wanted;
    int* range;

    HD void operator()(int k) const
    {
        range[2*k] = start[pieces.firstCell[wanted[k]]];
        range[2*k + 1] = start[pieces.firstCell[wanted[k] + 1]];
    }
};

} // namespace riprap

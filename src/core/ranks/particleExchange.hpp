/*  Which particles of a shared scene are on this rank, and what goes to and fro.

    A rank owns the particles of its brick and has copies of those of others that its own may touch:
    ghosts, which act and are not acted on. Particles are in slots 0 .. residents()-1, ghosts among
    them, in the order that one process would have: by cell, then by the order before. A particle's
    place in that order (of all particles of all ranks) is its number until the next migration.

    A migration: cells of particles are known anew. Those that came into another's brick go there,
    and ghosts are chosen; arrivals take the slots behind the residents, or the slot where the
    particle is already. The caller sorts all slots by sequence() and their cells, and settles the
    new order. Numbers of particles are compared then: one that was lost, or is there twice, is an
    exception.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <stdexcept>
#include <string>
#include "core/ranks/pieceOwners.hpp"
#include "core/ranks/slotShares.hpp"

namespace riprap
{

class ParticleExchange
{
public:

    enum Kind : char {absent, owned, ghost};

    //- imbalance: the largest rank may have so much more than the mean before bricks are cut anew.
    //  measured: of the time that particles cost; else of their numbers
    explicit ParticleExchange(Transport& transport, double imbalance = 0.1, bool measured = false)
        : transport_(transport), owners_(transport, imbalance, measured)
    {}

    Transport& transport() { return transport_; }

    //- Cells that particles are sorted into. Numbers of particles hold; owners and ghosts change
    //  with the next migration
    void setPieces(const std::vector<PieceGrid>& grids, double reach) { owners_.set(grids, reach); }

    //- All particles are on all ranks, in slots 0 .. n-1, and of nobody
    void begin(int n);

    //- cell: of each resident; at or beyond cells() it has left the domain. pack(slot, whole,
    //  bytes) appends what another rank needs of a particle that becomes its own (whole) or its
    //  ghost; unpack(slot, whole, from) reads it in the end
    template<class Pack, class Unpack>
    void migrate(const std::uint32_t* cell, const Pack& pack, const Unpack& unpack);

    //- After a migration: slots of those that are here now, in the order before
    const std::vector<int>& sequence() const { return sequence_; }
    int residents() const { return int(number_.size()); }
    Kind kind(int slot) const { return Kind(kind_[slot]); }
    std::uint32_t cell(int slot) const { return cell_[slot]; }
    std::int64_t number(int slot) const { return number_[slot]; }
    int slotOf(std::int64_t number) const;                  // -1: it is not here
    // slots of own particles that are out of the domain
    const std::vector<int>& left() const { return left_; }

    //- From the next migration on this rank has all particles; -1: each has those of its brick
    //  again
    void gatherOn(int rank) { owners_.gatherOn(rank); }

    //- order[i]: where the i-th was, of `active`
    void settle(const std::uint32_t* order, int active);

    //- Of each step: put(slot, to) writes `each` bytes of an own particle; take(slot, from) reads
    //  those of a ghost
    template<class Put, class Take>
    void share(std::size_t each, const Put& put, const Take& take);

    //- Of a cell, from the last migration on: its rank, and those besides that have its particles
    //  as ghosts. divisions() tells when these change
    int ownerOf(std::uint32_t cell) const
    {
        return owners_.owner(owners_.pieces().of(int(cell)));
    }
    const std::vector<int>& ghostsOf(std::uint32_t cell)
    {
        return owners_.needs(owners_.pieces().of(int(cell)));
    }
    std::int64_t divisions() const { return owners_.divisions(); }
    //- Steps begin, or have ended
    void work(bool on) { owners_.work(on); }
    const PieceOwners& owners() const { return owners_; }

    std::int64_t total() const { return owners_.total(); }  // of all ranks
    int ownedHere() const { return ownedHere_; }
    int ghostsHere() const { return residents() - ownedHere_; }

    //- So far: of this rank
    struct Counts
    {
        std::int64_t migrations = 0, divisions = 0, arrivals = 0, bytesMigrating = 0, shares = 0,
                     bytesShared = 0;
    };
    const Counts& counts() const { return counts_; }

private:

    struct Header { std::int64_t number; std::uint32_t cell; std::int32_t whole; };
    void countAll(const std::uint32_t* cell);
    int arrive(const Header&);
    void makeSequence(int before);
    void makeLists();

    Transport& transport_;
    PieceOwners owners_;

    std::vector<std::int64_t> number_;      // of slots
    std::vector<char> kind_;
    std::vector<std::uint32_t> cell_;
    std::vector<int> sequence_, left_;
    bool everywhere_ = false;
    int ownedHere_ = 0;

    SlotShares shares_;
    Counts counts_;
};

template<class Pack, class Unpack>
void ParticleExchange::migrate(const std::uint32_t* cell, const Pack& pack, const Unpack& unpack)
{
    const int me = transport_.rank(), before = residents();
    const RowPieces& pieces = owners_.pieces();
    countAll(cell);
    left_.clear();
    std::vector<RankBytes> out(transport_.size()), in;
    const auto send = [&](int rank, int slot, bool whole)
    {
        if (everywhere_) return;
        const Header h{number_[slot], cell[slot], whole};
        putValues(out[rank], &h);
        pack(slot, whole, out[rank]);
    };
    for (int slot = 0; slot < before; ++slot)
    {
        const bool mine = kind_[slot] == owned;
        kind_[slot] = absent;
        if (!mine) continue;
        if (cell[slot] >= std::uint32_t(pieces.cells())) { left_.push_back(slot); continue; }
        cell_[slot] = cell[slot];
        const int piece = pieces.of(int(cell[slot])), owner = owners_.owner(piece);
        if (owner == me) kind_[slot] = owned;
        else send(owner, slot, true);
        for (const int rank : owners_.needs(piece))
        {
            if (rank == me) kind_[slot] = ghost;
            else send(rank, slot, false);
        }
    }
    if (!everywhere_) transport_.exchange(out, in);
    for (int rank = 0; rank < int(in.size()); ++rank)
    {
        if (rank == me) continue;
        counts_.bytesMigrating += std::int64_t(out[rank].size());
        const unsigned char* at = in[rank].data();
        const unsigned char* const end = at + in[rank].size();
        while (at < end)
        {
            Header h;
            takeValues(at, &h);
            unpack(arrive(h), h.whole != 0, at);
            counts_.arrivals += h.whole;
        }
    }
    everywhere_ = false;
    makeSequence(before);
    ++counts_.migrations;
}

template<class Put, class Take>
void ParticleExchange::share(std::size_t each, const Put& put, const Take& take)
{
    counts_.bytesShared += shares_.share(transport_, each, put, take);
    ++counts_.shares;
}

} // namespace riprap

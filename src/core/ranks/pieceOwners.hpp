/*  Which rank has which piece of a shared scene: bricks that follow the numbers of particles, or
    what these cost, and who needs the particles of a piece as ghosts. The same on all ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/ranks/bricks.hpp"
#include "core/ranks/rankCosts.hpp"
#include "core/ranks/rowPieces.hpp"
#include "core/ranks/transport.hpp"

namespace riprap
{

//- Particles in a piece
struct PieceCount { std::int32_t piece, count; };

class PieceOwners
{
public:

    //- imbalance: the largest rank may have so much more than the mean before bricks are cut anew.
    //  measured: of the time that particles cost; else of their numbers
    PieceOwners(Transport& transport, double imbalance, bool measured,
        std::function<double()> clock = {})
        : transport_(transport), imbalance_(imbalance), costs_(transport, std::move(clock)),
          measured_(measured)
    {}

    //- Cells that particles are sorted into. Numbers of particles hold; owners change with the next
    //  count
    //  least: cells of a piece at least
    void set(const std::vector<PieceGrid>&, double reach, int least = 1);

    //- From the next count on this rank has all particles; -1: each has those of its brick again
    void gatherOn(int rank);

    //- Steps begin, or have ended
    void work(bool on) { costs_.work(on); }

    //- Particles in pieces: of this rank, of all ranks where all have the same. Owners follow
    void count(std::vector<std::int64_t> here, bool everywhere);
    //- The same of pieces with particles alone, by piece: most have none
    void count(const std::vector<PieceCount>& here, bool everywhere);

    const RowPieces& pieces() const { return pieces_; }
    int owner(int piece) const { return owner_[piece]; }
    //- Ranks besides the owner that need its particles
    const std::vector<int>& needs(int piece);
    //- Are there any? Of most pieces it is known that there are none
    bool needed(int piece) { return known_[piece] != nobody && !needs(piece).empty(); }
    std::int64_t in(int piece) const { return inPiece_[piece]; }    // of all ranks
    //- Those with particles of any rank, ascending
    const std::vector<int>& occupied() const { return occupied_; }
    std::int64_t total() const { return total_; }
    std::int64_t divisions() const { return divisions_; }   // of any kind, gathering included
    std::int64_t cuts() const { return cuts_; }             // how often bricks were made
    //- The last time: most of a rank over the mean, before and after; 0: there was no before
    double unevenBefore() const { return cutFrom_; }
    double unevenAfter() const { return cutTo_; }
    double atWork() const { return costs_.atWork(); }       // [s] of this rank

private:

    void measure(std::int64_t here);
    std::int64_t cost(int piece) const;
    void divide();
    double unevenness(const std::vector<int>& owner) const;
    bool within(int piece) const;
    void setOwners();
    std::vector<int> owners(const Bricks&) const;

    Transport& transport_;
    double imbalance_;
    RankCosts costs_;
    bool measured_;
    std::vector<float> perParticle_;        // cost, of each piece; empty: not known yet
    RowPieces pieces_;
    Bricks bricks_;
    std::vector<int> owner_;                // of each piece
    std::vector<std::vector<int>> needs_;   // where that is known
    static constexpr char nobody = 1, somebody = 2;         // 0: not known
    std::vector<char> known_;
    std::vector<std::int64_t> inPiece_;     // particles of all ranks
    std::vector<int> occupied_;
    std::int64_t total_ = 0, divisions_ = 0, cuts_ = 0;
    // most of a rank over the mean when bricks were looked for
    double unevenBefore_ = 0, cutFrom_ = 0, cutTo_ = 0;
    int since_ = 0;                         // counts since then
    int sole_ = -1;                         // the rank that has all
};

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/ranks/pieceOwners.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>
#include "core/ranks/joinRanks.hpp"

namespace riprap
{

//- What the particles of a piece cost: their number, or thousandths of it
std::int64_t PieceOwners::cost(int piece) const
{
    if (perParticle_.empty()) return inPiece_[piece];
    return std::llround(1000*double(inPiece_[piece])*double(perParticle_[piece]));
}

//- The largest cost of a rank over the mean. owner: of pieces
double PieceOwners::unevenness(const std::vector<int>& owner) const
{
    std::vector<std::int64_t> load(transport_.size(), 0);
    std::int64_t all = 0;
    for (const int p : occupied_)
    {
        const std::int64_t c = cost(p);
        load[owner[p]] += c;
        all += c;
    }
    return double(*std::max_element(load.begin(), load.end()))*transport_.size()
        /std::max(1.0, double(all));
}

//- Particles of a piece cost what those of its rank do. What was known before counts half: a piece
//  that has changed its rank is not at once like the others there
void PieceOwners::measure(std::int64_t here)
{
    if (!measured_ || !costs_.measure(here) || owner_.empty() || sole_ >= 0) return;
    perParticle_.resize(pieces_.count(), 1.0F);
    for (const int p : occupied_)
    {
        float& c = perParticle_[p];
        c = 0.5F*(c + float(costs_.perParticle()[owner_[p]]));
    }
}

void PieceOwners::set(const std::vector<PieceGrid>& grids, double reach, int least)
{
    // Ghosts come in whole pieces: as short ones as there are, as far as a sum of all numbers at
    // each rebuild is cheap
    constexpr double most = 1 << 20;
    pieces_.set(grids, reach, least, most);
    perParticle_.clear();
    setOwners();
    needs_.assign(pieces_.count(), {});
}

void PieceOwners::setOwners()
{
    if (sole_ >= 0) owner_.assign(pieces_.count(), sole_);
    else if (bricks_.ranks()) owner_ = owners(bricks_);
    known_.assign(pieces_.count(), 0);
    ++divisions_;
}

void PieceOwners::gatherOn(int rank)
{
    sole_ = rank;
    setOwners();
}

void PieceOwners::count(std::vector<std::int64_t> here, bool everywhere)
{
    inPiece_.swap(here);
    const std::int64_t own = std::accumulate(inPiece_.begin(), inPiece_.end(), std::int64_t(0));
    if (!everywhere) transport_.sum(inPiece_);
    total_ = 0;
    occupied_.clear();
    for (int p = 0; p < int(inPiece_.size()); ++p)
    {
        total_ += inPiece_[p];
        if (inPiece_[p]) occupied_.push_back(p);
    }
    if (!everywhere) measure(own);
    divide();
}

void PieceOwners::count(const std::vector<PieceCount>& here, bool everywhere)
{
    std::vector<PieceCount> all(here);
    if (!everywhere)
    {
        join(transport_, all);
        mergeRows(all, [](const PieceCount& a, const PieceCount& b) { return a.piece < b.piece; });
    }
    inPiece_.resize(pieces_.count(), 0);
    for (const int p : occupied_) if (p < pieces_.count()) inPiece_[p] = 0;
    occupied_.clear();
    occupied_.reserve(all.size());
    total_ = 0;
    for (const PieceCount& c : all)
    {
        if (occupied_.empty() || occupied_.back() != c.piece) occupied_.push_back(c.piece);
        inPiece_[c.piece] += c.count;
        total_ += c.count;
    }
    if (!everywhere)
    {
        std::int64_t own = 0;
        for (const PieceCount& c : here) own += c.count;
        measure(own);
    }
    divide();
}

std::vector<int> PieceOwners::owners(const Bricks& bricks) const
{
    std::vector<int> r(pieces_.count());
    for (int p = 0; p < pieces_.count(); ++p) r[p] = bricks.rankOf(pieces_.centre(p));
    return r;
}

//- Bricks at first, and new ones where they are much better. Where none are they are not looked for
//  again until the load has become more uneven, or for some time: particles may lie so that they
//  can be shared out better
void PieceOwners::divide()
{
    if (sole_ >= 0) return;
    constexpr int often = 16;               // counts
    const double uneven = bricks_.ranks() ? unevenness(owner_) : 0;
    if (bricks_.ranks()
        && (uneven <= 1 + imbalance_ || (uneven <= 1.05*unevenBefore_ && ++since_ < often)))
        return;
    since_ = 0;
    unevenBefore_ = uneven;
    // empty pieces are most of them, and there is nothing to share out
    std::vector<Bricks::Point> centres;
    std::vector<std::int64_t> costs;
    for (const int p : occupied_)
    {
        centres.push_back(pieces_.centre(p));
        costs.push_back(cost(p));
    }
    if (centres.empty())
    {
        centres.push_back(pieces_.centre(0));
        costs.push_back(0);
    }
    const Bricks bricks(transport_.size(), centres, costs);
    const std::vector<int> owner = owners(bricks);
    const double best = unevenness(owner);
    if (bricks_.ranks() && best > 0.95*uneven) return;
    unevenBefore_ = best;
    cutFrom_ = uneven;
    cutTo_ = best;
    bricks_ = bricks;
    owner_ = owner;
    known_.assign(pieces_.count(), 0);
    ++cuts_;
    ++divisions_;
}

//- Are all pieces near this one of one brick? Bricks are convex: they have a box whose corners they
//  have
bool PieceOwners::within(int piece) const
{
    Bricks::Point box[2];
    if (sole_ >= 0) return true;
    if (!bricks_.ranks() || !pieces_.boxAround(piece, box[0], box[1])) return false;
    for (int corner = 0; corner < 8; ++corner)
        if (bricks_.rankOf({{box[corner & 1][0], box[corner/2 & 1][1], box[corner/4][2]}})
            != owner_[piece])
            return false;
    return true;
}

const std::vector<int>& PieceOwners::needs(int piece)
{
    std::vector<int>& r = needs_[piece];
    if (known_[piece]) return r;
    known_[piece] = nobody;
    r.clear();
    if (within(piece)) return r;
    for (const int other : pieces_.near(piece))
        if (owner_[other] != owner_[piece]) r.push_back(owner_[other]);
    std::sort(r.begin(), r.end());
    r.erase(std::unique(r.begin(), r.end()), r.end());
    if (!r.empty()) known_[piece] = somebody;
    return r;
}

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/ranks/particleExchange.hpp"
#include <algorithm>

namespace riprap
{

void ParticleExchange::begin(int n)
{
    number_.resize(n);
    for (int i = 0; i < n; ++i) number_[i] = i;
    kind_.assign(n, owned);
    cell_.assign(n, 0);
    everywhere_ = true;
}

//- Particles in each piece, of all ranks
void ParticleExchange::countAll(const std::uint32_t* cell)
{
    const RowPieces& pieces = owners_.pieces();
    std::vector<std::int64_t> here(pieces.count(), 0);
    for (int slot = 0; slot < residents(); ++slot)
        if (kind_[slot] == owned && cell[slot] < std::uint32_t(pieces.cells()))
            ++here[pieces.of(int(cell[slot]))];
    owners_.count(std::move(here), everywhere_);
    counts_.divisions = owners_.cuts();
}

//- By number, which ascends in the order before
int ParticleExchange::slotOf(std::int64_t number) const
{
    const auto at = std::lower_bound(sequence_.begin(), sequence_.end(), number,
        [&](int slot, std::int64_t n) { return number_[slot] < n; });
    return at != sequence_.end() && number_[*at] == number ? *at : -1;
}

//- The slot of an arrival: where it is already, or the next
int ParticleExchange::arrive(const Header& h)
{
    int slot = slotOf(h.number);            // of the order before, still
    if (slot < 0)
    {
        slot = residents();
        number_.push_back(h.number);
        kind_.push_back(absent);
        cell_.push_back(0);
    }
    if (kind_[slot] != absent)
        throw std::logic_error("particle number " + std::to_string(h.number) + " came to rank "
            + std::to_string(transport_.rank()) + ", which has it");
    kind_[slot] = h.whole ? owned : ghost;
    cell_[slot] = h.cell;
    return slot;
}

//- Who is here, in the order before: residents are in it, arrivals are put among them
void ParticleExchange::makeSequence(int before)
{
    const auto less = [&](int a, int b) { return number_[a] < number_[b]; };
    sequence_.clear();
    for (int slot = 0; slot < before; ++slot) if (kind_[slot] != absent) sequence_.push_back(slot);
    const std::size_t old = sequence_.size();
    for (int slot = before; slot < residents(); ++slot) sequence_.push_back(slot);
    std::sort(sequence_.begin() + old, sequence_.end(), less);
    std::inplace_merge(sequence_.begin(), sequence_.begin() + old, sequence_.end(), less);
    const auto same = [&](int a, int b) { return number_[a] == number_[b]; };
    const auto twice = std::adjacent_find(sequence_.begin(), sequence_.end(), same);
    if (twice != sequence_.end())
        throw std::logic_error("particle number " + std::to_string(number_[*twice])
            + " came to rank " + std::to_string(transport_.rank()) + " twice");
}

void ParticleExchange::settle(const std::uint32_t* order, int active)
{
    const auto fail = [&](const std::string& why)
    { throw std::logic_error("rank " + std::to_string(transport_.rank()) + ": " + why); };
    if (active != int(sequence_.size())) fail("particles were lost as they were sorted");
    const RowPieces& pieces = owners_.pieces();
    std::vector<std::int64_t> first(pieces.count() + 1, 0), number(active);
    for (int p = 0; p < pieces.count(); ++p) first[p + 1] = first[p] + owners_.in(p);
    std::vector<char> kind(active);
    std::vector<std::uint32_t> cell(active);
    ownedHere_ = 0;
    int in = -1;
    std::int64_t next = 0;
    for (int i = 0; i < active; ++i)
    {
        const int from = int(order[i]);
        kind[i] = kind_[from];
        cell[i] = cell_[from];
        ownedHere_ += kind[i] == owned;
        const int piece = pieces.of(int(cell[i]));
        if (piece != in)
        {
            if (piece < in) fail("particles are not in the order of their cells");
            if (in >= 0 && next != first[in + 1]) fail("a piece is not whole");
            next = first[piece];
            in = piece;
        }
        number[i] = next++;
        if (next > first[piece + 1]) fail("a piece has more than its particles");
    }
    if (in >= 0 && next != first[in + 1]) fail("a piece is not whole");
    std::vector<std::int64_t> all(1, ownedHere_);
    transport_.sum(all);
    if (all[0] != owners_.total())
        fail(std::to_string(all[0]) + " particles have owners, and there are "
            + std::to_string(owners_.total()));
    number_.swap(number);
    kind_.swap(kind);
    cell_.swap(cell);
    sequence_.resize(active);
    for (int i = 0; i < active; ++i) sequence_[i] = i;
    makeLists();
}

//- Whose ghosts own particles are, and who owns the ghosts: both in the order of slots, which is
//  one order on all ranks
void ParticleExchange::makeLists()
{
    std::vector<std::vector<int>> to(transport_.size()), from(transport_.size());
    for (int i = 0; i < residents(); ++i)
    {
        const int piece = owners_.pieces().of(int(cell_[i]));
        if (kind_[i] == ghost) from[owners_.owner(piece)].push_back(i);
        else for (const int rank : owners_.needs(piece)) to[rank].push_back(i);
    }
    shares_.clear();
    for (int rank = 0; rank < transport_.size(); ++rank)
    {
        shares_.send(rank, std::move(to[rank]));
        shares_.receive(rank, std::move(from[rank]));
    }
}

} // namespace riprap

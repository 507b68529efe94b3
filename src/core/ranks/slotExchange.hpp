/*  ParticleExchange for fields that stay where they are, on a device or not: the host looks at
    pieces, and at those particles that are sent, arrive or leave.

    The same division, the same order of particles, the same checks. Arrivals take the slots behind
    the residents; ghosts of before are dropped first.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include "core/neighbours/cellSort.hpp"
#include "core/ranks/deviceShares.hpp"
#include "core/ranks/fieldRecords.hpp"
#include "core/ranks/joinRanks.hpp"
#include "core/containers/ghostMarks.hpp"
#include "core/ranks/pieceOwners.hpp"
#include "core/ranks/slotKernels.hpp"

namespace riprap
{

template<class Backend>
class SlotExchange
{
public:

    //- measured: bricks follow the time that particles cost. direct: GPUs that reach each other
    //  send without the host. All ranks make theirs
    SlotExchange(Context<Backend>& context, Transport& transport, double imbalance,
        bool measured = false, bool direct = true)
        : peers(context, transport, direct), context_(context), transport_(transport),
        owners_(transport, imbalance, measured)
    {}

    Transport& transport() const { return transport_; }

    //- As ParticleExchange has them
    void setPieces(const std::vector<PieceGrid>&, double reach, int least = 1);
    void begin(int n);

    //- Keys of n slots are known, of which residents() are in use: who is here from now on. In the
    //  end all slots are ready to be sorted. grow(n): memory for so many slots
    template<class Grow>
    void migrate(FieldSet<Backend>&, CellSort<Backend>&, const int& n, const Grow& grow);
    //- After the sort
    void settle(CellSort<Backend>&, int n, int active);

    int residents() const { return residents_; }
    std::int64_t total() const { return owners_.total(); }
    int ownedHere() const { return ownedHere_; }
    int ownerOf(std::uint32_t cell) const { return owners_.owner(pieceOf(cell)); }
    const std::vector<int>& ghostsOf(std::uint32_t cell) { return owners_.needs(pieceOf(cell)); }

    //- For kernels; for the host
    GhostMarks<Backend> marks() const { return {residents_ ? now_.ghost.data() : nullptr}; }
    bool ghost(int i) const;
    std::vector<std::int64_t> numbers() const;

    //- Particles that left the domain with the last migration, as records of their fields
    int left() const { return left_; }
    const unsigned char* leftRecord(int k) { return records_.record(sent_ + k); }

    //- put(slot, to), take(slot, from): functors for the device (deviceShares.hpp). each: of
    //  mostShared at most
    static constexpr std::size_t mostShared = 9*sizeof(double);
    template<class Put, class Take>
    void share(std::size_t each, const Put& put, const Take& take)
    {
        counts.bytesShared += shares_.share(context_, transport_, each, put, take);
    }

    struct Counts { std::int64_t arrivals = 0, bytesMigrating = 0, bytesShared = 0; };
    Counts counts;                          // so far, of this rank
    DevicePeers<Backend> peers;
    //- Steps begin, or have ended
    void work(bool on) { owners_.work(on); }
    const PieceOwners& owners() const { return owners_; }

private:

    struct Header { std::int64_t number; std::uint32_t cell; std::int32_t whole; };
    struct Sending { int rank, at; bool whole; };           // at: of the chosen
    struct Arrival { Header header; const unsigned char* record; };

    //- Of slots; settle() makes them anew
    struct Slots
    {
        Array<Backend, std::int64_t> number;
        Array<Backend, std::uint32_t> cell;
        Array<Backend, char> ghost;

        void allocate(Context<Backend>& context, std::size_t n)
        {
            number.allocate(context, n);
            cell.allocate(context, n);
            ghost.allocate(context, n);
        }
    };

    //- What kernels see of pieces
    struct Pieces
    {
        Array<Backend, int> pieceOf, firstCell, place;
        Array<Backend, OccupiedPiece> occupied;
    };

    //- Of one migration; kept, since to give memory of a device back waits for it
    struct Scratch
    {
        Array<Backend, int> present, chosen, perPiece, flag, broken, wanted, range;
        Array<Backend, PieceCount> counts;
        Array<Backend, ChosenSlot> list, arrival;
        Array<Backend, std::int64_t> arrivalNumber;
    };

    int pieceOf(std::uint32_t cell) const { return owners_.pieces().of(int(cell)); }
    PieceTable table() const;
    std::vector<PieceCount> count(CellSort<Backend>&);
    void setRoles(const std::vector<PieceCount>& here);
    std::vector<ChosenSlot> choose(CellSort<Backend>&);
    std::vector<Sending> decide(const std::vector<ChosenSlot>&, std::vector<int>& slots);
    std::vector<Arrival> takeAll(const std::vector<RankBytes>& in, std::size_t each);
    void enlarge(int n);
    void shareSlots(CellSort<Backend>&);
    template<class T> std::vector<T> fetch(const T* from, std::size_t n) const;
    [[noreturn]] void fail(const std::string& why) const
    { throw std::logic_error("rank " + std::to_string(transport_.rank()) + ": " + why); }

    Context<Backend>& context_;
    Transport& transport_;
    PieceOwners owners_;
    Pieces pieces_;
    Slots now_, next_;
    Scratch scratch_;
    FieldRecords<Backend> records_;
    DeviceShares<Backend> shares_;
    std::vector<int> foreign_, shared_;     // pieces with ghosts here; own ones, elsewhere
    mutable std::vector<char> ghosts_;      // what the host has seen of the marks
    bool everywhere_ = false;
    int residents_ = 0, ownedHere_ = 0, stay_ = 0, arrived_ = 0, sent_ = 0, left_ = 0;
};

template<class Backend>
template<class T>
std::vector<T> SlotExchange<Backend>::fetch(const T* from, std::size_t n) const
{
    std::vector<T> values(n);
    if (n) context_.toHost(values.data(), from, n*sizeof(T));
    return values;
}

template<class Backend>
void SlotExchange<Backend>::setPieces(
    const std::vector<PieceGrid>& grids, double reach, int least)
{
    owners_.set(grids, reach, least);
    const RowPieces& pieces = owners_.pieces();
    std::vector<int> of(pieces.cells()), firstCell(1, 0);
    for (int c = 0; c < pieces.cells(); ++c)
    {
        of[c] = pieces.of(c);
        if (c && of[c] != of[c - 1]) firstCell.push_back(c);
    }
    firstCell.push_back(pieces.cells());
    if (int(firstCell.size()) != pieces.count() + 1) fail("pieces are not rows of cells");
    pieces_.pieceOf.upload(context_, of);
    pieces_.firstCell.upload(context_, firstCell);
    pieces_.place.allocate(context_, pieces.count());
}

template<class Backend>
void SlotExchange<Backend>::begin(int n)
{
    std::vector<std::int64_t> number(n);
    std::iota(number.begin(), number.end(), std::int64_t(0));
    now_ = Slots();
    now_.number.upload(context_, number);
    now_.ghost.upload(context_, std::vector<char>(n, 0));
    now_.cell.allocate(context_, n);
    ghosts_.clear();
    residents_ = n;
    everywhere_ = true;
}

template<class Backend>
PieceTable SlotExchange<Backend>::table() const
{
    return {owners_.pieces().cells(), pieces_.pieceOf.data(), pieces_.firstCell.data(),
        pieces_.place.data(), pieces_.occupied.data()};
}

//- Own particles in pieces, by piece
template<class Backend>
std::vector<PieceCount> SlotExchange<Backend>::count(CellSort<Backend>& sort)
{
    const int pieces = owners_.pieces().count();
    Scratch& s = scratch_;
    s.perPiece.allocate(context_, pieces);
    s.flag.allocate(context_, pieces + 1);
    context_.zero(s.perPiece.data(), pieces*sizeof(int));
    context_.zero(s.flag.data() + pieces, sizeof(int));
    forEach(context_, residents_,
        CountPieces{table(), sort.keys(), now_.ghost.data(), now_.cell.data(),
            s.perPiece.data()});
    forEach(context_, pieces, FlagOccupied{s.perPiece.data(), s.flag.data()});
    sort.scan(context_, s.flag.data(), pieces + 1);
    const int occupied = fetch(s.flag.data() + pieces, 1)[0];
    s.counts.allocate(context_, occupied);
    forEach(context_, pieces, PutOccupied{s.perPiece.data(), s.flag.data(), s.counts.data()});
    return fetch(s.counts.data(), occupied);
}

//- here: own particles in pieces, before they are sent
template<class Backend>
void SlotExchange<Backend>::setRoles(const std::vector<PieceCount>& here)
{
    const int me = transport_.rank();
    std::vector<OccupiedPiece> occupied;
    std::int64_t first = 0;
    auto own = here.begin();
    occupied.reserve(owners_.occupied().size());
    foreign_.clear();
    shared_.clear();
    ownedHere_ = 0;
    for (const int p : owners_.occupied())
    {
        const int count = int(owners_.in(p));
        const bool mine = owners_.owner(p) == me, any = own != here.end() && own->piece == p;
        OccupiedPiece o{first, p, count, mine ? PieceRole::own : 0, 0};
        first += count;
        const bool needed = (mine || any) && owners_.needed(p);
        if (mine) ownedHere_ += count;
        if (mine && needed) shared_.push_back(p);
        if (any)
        {
            ++own;
            if (!everywhere_ && (!mine || needed)) o.role |= PieceRole::sends;
            const std::vector<int>& needs = owners_.needs(p);
            if (!mine && needed && std::binary_search(needs.begin(), needs.end(), me))
            {
                o.role |= PieceRole::keeps;
                foreign_.push_back(p);
            }
        }
        occupied.push_back(o);
    }
    pieces_.occupied.upload(context_, occupied);
    forEach(context_, int(occupied.size()),
        PlacePieces{pieces_.occupied.data(), pieces_.place.data()});
}

//- Those that are sent or have left the domain, in the order of slots
template<class Backend>
std::vector<ChosenSlot> SlotExchange<Backend>::choose(CellSort<Backend>& sort)
{
    Scratch& s = scratch_;
    for (auto* a : {&s.present, &s.chosen})
    {
        a->allocate(context_, residents_ + 1);
        context_.zero(a->data() + residents_, sizeof(int));
    }
    forEach(context_, residents_,
        ChooseSlots{table(), now_.ghost.data(), now_.cell.data(), s.present.data(),
            s.chosen.data()});
    sort.scan(context_, s.present.data(), residents_ + 1);
    sort.scan(context_, s.chosen.data(), residents_ + 1);
    stay_ = fetch(s.present.data() + residents_, 1)[0];
    const int n = fetch(s.chosen.data() + residents_, 1)[0];
    s.list.allocate(context_, n);
    if (n)
        forEach(context_, residents_,
            PutChosen{s.chosen.data(), now_.number.data(), now_.cell.data(), s.list.data()});
    return fetch(s.list.data(), n);
}

//- To whom they go. slots: whose records are wanted, those that left last
template<class Backend>
std::vector<typename SlotExchange<Backend>::Sending> SlotExchange<Backend>::decide(
    const std::vector<ChosenSlot>& chosen, std::vector<int>& slots)
{
    const int me = transport_.rank();
    std::vector<Sending> sending;
    std::vector<int> left;
    for (int k = 0; k < int(chosen.size()); ++k)
    {
        const ChosenSlot& c = chosen[k];
        if (c.cell >= std::uint32_t(owners_.pieces().cells())) { left.push_back(c.slot); continue; }
        const int piece = pieceOf(c.cell), owner = owners_.owner(piece);
        if (owner != me) sending.push_back(Sending{owner, k, true});
        if (!owners_.needed(piece)) continue;
        for (const int rank : owners_.needs(piece))
            if (rank != me) sending.push_back(Sending{rank, k, false});
    }
    for (const Sending& s : sending) slots.push_back(chosen[s.at].slot);
    slots.insert(slots.end(), left.begin(), left.end());
    sent_ = int(sending.size());
    left_ = int(left.size());
    return sending;
}

//- By number
template<class Backend>
std::vector<typename SlotExchange<Backend>::Arrival> SlotExchange<Backend>::takeAll(
    const std::vector<RankBytes>& in, std::size_t each)
{
    std::vector<Arrival> arrivals;
    for (int rank = 0; rank < int(in.size()); ++rank)
    {
        if (rank == transport_.rank()) continue;
        const unsigned char* at = in[rank].data();
        const unsigned char* const end = at + in[rank].size();
        for (; at < end; at += each)
        {
            Header h;
            takeValues(at, &h);
            arrivals.push_back(Arrival{h, at});
            counts.arrivals += h.whole;
            if (!h.whole) foreign_.push_back(pieceOf(h.cell));
        }
    }
    mergeRows(arrivals, [](const Arrival& a, const Arrival& b)
    { return a.header.number < b.header.number; });
    for (std::size_t k = 1; k < arrivals.size(); ++k)
        if (arrivals[k].header.number == arrivals[k - 1].header.number)
            fail("particle number " + std::to_string(arrivals[k].header.number) + " came twice");
    return arrivals;
}

//- Room for n slots; what is known of the residents stays
template<class Backend>
void SlotExchange<Backend>::enlarge(int n)
{
    const auto more = [&](auto& array)
    {
        if (array.size() >= std::size_t(n)) return;
        std::decay_t<decltype(array)> larger;
        larger.allocate(context_, n);
        copyOnDevice(
            context_, larger.data(), array.data(), residents_*sizeof(*array.data()));
        context_.synchronise();
        array.swap(larger);
    };
    more(now_.number);
    more(now_.cell);
    more(now_.ghost);
}

template<class Backend>
template<class Grow>
void SlotExchange<Backend>::migrate(
    FieldSet<Backend>& fields, CellSort<Backend>& sort, const int& n, const Grow& grow)
{
    const std::vector<PieceCount> here = count(sort);
    peers.noticeWaiting();
    owners_.count(here, everywhere_);
    setRoles(here);
    const std::vector<ChosenSlot> chosen = choose(sort);
    std::vector<int> slots;
    const std::vector<Sending> sending = decide(chosen, slots);
    records_.gather(context_, fields, slots);
    const std::size_t each = records_.each();
    std::vector<RankBytes> out(transport_.size()), in;
    std::vector<std::size_t> count(transport_.size(), 0);
    for (const Sending& s : sending) ++count[s.rank];
    for (int r = 0; r < transport_.size(); ++r)
        out[r].reserve(count[r]*(sizeof(Header) + each));
    for (const Sending& s : sending)
    {
        const Header h{chosen[s.at].number, chosen[s.at].cell, s.whole};
        putValues(out[s.rank], &h);
        putValues(out[s.rank], records_.next(), each);
    }
    if (!everywhere_) transport_.exchange(out, in);
    for (const RankBytes& bytes : out) counts.bytesMigrating += std::int64_t(bytes.size());
    everywhere_ = false;

    const std::vector<Arrival> arrivals = takeAll(in, each);
    arrived_ = int(arrivals.size());
    const int used = residents_ + arrived_;
    if (used > n) grow(std::max(used, n + n/4) + 64);
    enlarge(n);
    std::vector<ChosenSlot> arrival;
    std::vector<std::int64_t> number;
    std::vector<unsigned char> bytes;
    slots.clear();
    slots.reserve(arrivals.size());
    arrival.reserve(arrivals.size());
    number.reserve(arrivals.size());
    bytes.reserve(arrivals.size()*each);
    for (const Arrival& a : arrivals)
    {
        slots.push_back(residents_ + int(slots.size()));
        arrival.push_back(ChosenSlot{a.header.number, a.header.cell, slots.back()});
        number.push_back(a.header.number);
        bytes.insert(bytes.end(), a.record, a.record + each);
    }
    // the records of those that left stay as they are
    records_.scatter(context_, fields, slots, bytes);
    scratch_.arrival.upload(context_, arrival);
    scratch_.arrivalNumber.upload(context_, number);
    forEach(context_, n,
        PlaceKeys{residents_, arrived_, stay_, owners_.pieces().cells(), scratch_.present.data(),
            now_.number.data(), scratch_.arrival.data(), scratch_.arrivalNumber.data(),
            now_.cell.data(), sort.keys(), sort.indices()});
}

template<class Backend>
void SlotExchange<Backend>::settle(CellSort<Backend>& sort, int n, int active)
{
    if (active != stay_ + arrived_) fail("particles were lost as they were sorted");
    next_.allocate(context_, n);
    forEach(context_, n,
        SettleSlots{table(), active, sort.order(), sort.start(), now_.cell.data(),
            next_.cell.data(), next_.number.data(), next_.ghost.data()});
    std::swap(now_, next_);
    residents_ = active;
    ghosts_.clear();
    scratch_.broken.allocate(context_, 1);
    int* const broken = scratch_.broken.data();
    context_.zero(broken, sizeof(int));
    forEach(context_, int(owners_.occupied().size()), CheckPieces{table(), sort.start(), broken});
    if (fetch(broken, 1)[0]) fail("a piece is not whole, or has more than its particles");
    shareSlots(sort);
}

//- Whose ghosts own particles are, and who owns the ghosts: both in the order of slots, which is
//  one order on all ranks
template<class Backend>
void SlotExchange<Backend>::shareSlots(CellSort<Backend>& sort)
{
    std::sort(foreign_.begin(), foreign_.end());
    foreign_.erase(std::unique(foreign_.begin(), foreign_.end()), foreign_.end());
    std::vector<int> wanted(shared_);
    const std::size_t own = wanted.size();
    wanted.insert(wanted.end(), foreign_.begin(), foreign_.end());
    scratch_.wanted.upload(context_, wanted);
    scratch_.range.allocate(context_, 2*wanted.size());
    forEach(context_, int(wanted.size()),
        RangesOfPieces{table(), sort.start(), scratch_.wanted.data(), scratch_.range.data()});
    const std::vector<int> ranges = fetch(scratch_.range.data(), 2*wanted.size());

    std::vector<std::vector<int>> to(transport_.size()), from(transport_.size());
    const auto add = [&](std::vector<int>& slots, std::size_t k)
    {
        const std::size_t before = slots.size();
        slots.resize(before + ranges[2*k + 1] - ranges[2*k]);
        std::iota(slots.begin() + std::ptrdiff_t(before), slots.end(), ranges[2*k]);
    };
    for (std::size_t k = 0; k < wanted.size(); ++k)
    {
        if (k >= own) add(from[owners_.owner(wanted[k])], k);
        else for (const int rank : owners_.needs(wanted[k])) add(to[rank], k);
    }
    SlotShares shares;
    for (int rank = 0; rank < transport_.size(); ++rank)
    {
        shares.send(rank, std::move(to[rank]));
        shares.receive(rank, std::move(from[rank]));
    }
    shares_.set(context_, transport_, peers, shares, mostShared);
}

//- The host's copy is brought over when somebody asks
template<class Backend>
bool SlotExchange<Backend>::ghost(int i) const
{
    if (ghosts_.empty()) ghosts_ = fetch(now_.ghost.data(), residents_);
    return i < int(ghosts_.size()) && ghosts_[i];
}

template<class Backend>
std::vector<std::int64_t> SlotExchange<Backend>::numbers() const
{
    return fetch(now_.number.data(), residents_);
}

} // namespace riprap

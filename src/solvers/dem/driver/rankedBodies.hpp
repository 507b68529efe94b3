/*  Rigid bodies of several particles on several ranks (CPU). Members may be anywhere: a rank has
    the state of each body of which it owns a member. In a step ranks that share a body send each
    other where their members are and what acts on these. Each adds it up in the order of one
    process and moves the body by itself, so that all have the same bits. A body that is whole on
    one rank costs no message.

    At a rebuild the state goes with the members. Who has which of them is asked of one rank, which
    follows from the body's number. Of a body with a ghost alone a rank knows how many members are
    touched, which dashpots need.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <set>
#include "core/ranks/idSlots.hpp"
#include "core/ranks/joinRanks.hpp"
#include "core/ranks/particleExchange.hpp"
#include "solvers/dem/parts/demParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class RankedBodies
{
public:

    using real = typename P::real;

    explicit RankedBodies(DemParts<Backend, D, P>& parts) : p_(parts) {}

    //- Every rank has all particles, and so all bodies
    void begin();

    //- A member that goes to another rank, as its own (whole) or its ghost, and the body
    void pack(int slot, bool whole, RankBytes& to);
    void unpack(int slot, bool whole, const unsigned char*& from);

    //- In a rebuild: which bodies have left the domain; then, when particles are in their places,
    //  which are here from now on
    void agreeOnLeavers();
    void settle(const ParticleExchange&);

    //- Memory is for n particles from now on, whose keys are their slots
    void rekey(int residents, int n);

    //- Of a step, for copies of a member
    int touching(int slot) const;
    void setTouching(int slot, int touching);
    real massInContacts(int slot, real own) const;

    //- All of them on each rank; a call of all
    std::vector<ClumpData> all();

    //- Memory for all on each rank. rows: of each key
    void collect(const std::vector<std::int32_t>& rows);
    std::int32_t row(int slot);

private:

    struct Member { std::int32_t body, row; int slot; };
    struct Holder { std::int32_t body, row, rank; };
    struct Numbered { std::int32_t number; ClumpData state; };
    //- Bodies with a member here: those that are whole, those that are not, and members of both
    struct Own
    {
        std::vector<std::int32_t> whole, split;
        std::vector<Member> ofWhole, ofSplit;
    };

    Transport& ranks() { return *p_.set.config.ranks; }
    int members(int body) const { return share_.first[body + 1] - share_.first[body]; }
    static bool same(const ClumpData& a, const ClumpData& b)
    { return sameBytes(&a, &b, sizeof(a)); }
    void noteLeft(const std::vector<std::int32_t>& numbers);
    void keepLeft();
    Own own(const ParticleExchange&);
    std::vector<std::int32_t> ofGhosts(const ParticleExchange&, const Own&);
    std::vector<Holder> holdersOf(const std::vector<Member>& some);
    std::vector<Holder> answers(const std::vector<RankBytes>& asked);
    void requireAll(const std::vector<Holder>& ofBodies, std::size_t from, std::size_t end) const;
    std::vector<ClumpData> statesOf(const std::vector<std::int32_t>& numbers);
    void shareMembers(const std::vector<Holder>&, const std::vector<Member>& some);
    void moveHere(const Own&, const std::vector<Holder>&, const std::vector<ClumpData>& states);
    void placeSlots(int residents);

    DemParts<Backend, D, P>& p_;
    SharedClumps<D, P>& share_ = p_.clumps.share;
    std::map<std::int32_t, ClumpData> arrived_;
    // bodies whose state was sent at this rebuild, and in which message
    std::set<std::pair<const RankBytes*, std::int32_t>> sent_;
};

template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::begin()
{
    if (!p_.clumps.any()) return;
    const SolidFields<D, P> f = p_.particles.view();
    std::vector<int> next(share_.first.begin(), share_.first.end() - 1);
    share_.row.assign(p_.particles.n, -1);
    for (int i = 0; i < p_.particles.n; ++i)
        if (f.clump[i] >= 0) share_.row[i] = next[f.clump[i]]++;
}

template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::pack(int slot, bool whole, RankBytes& to)
{
    const SolidFields<D, P> f = p_.particles.view();
    if (!f.clump || f.clump[slot] < 0) return;
    const std::int32_t body = f.clump[slot];
    if (whole)
    {
        putValues(to, &share_.row[f.id[slot]]);
        putValues(to, p_.clumps.offset().data() + 3*std::size_t(f.id[slot]), 3);
    }
    const char first = sent_.emplace(&to, body).second;
    putValues(to, &first);
    if (first) putValues(to, p_.clumps.data() + share_.place[slot]);
}

//- Those that have moved a body have the same bits of it
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::unpack(int slot, bool whole, const unsigned char*& from)
{
    const SolidFields<D, P> f = p_.particles.view();
    if (!f.clump) return;
    // of the particle that had the key before
    std::int32_t& row = share_.row[f.id[slot]];
    double* offset = p_.clumps.offset().data() + 3*std::size_t(f.id[slot]);
    row = -1;
    std::fill_n(offset, 3, 0.0);
    if (f.clump[slot] < 0) return;
    if (whole)
    {
        takeValues(from, &row);
        takeValues(from, offset, 3);
    }
    char first;
    takeValues(from, &first);
    if (!first) return;
    ClumpData state;
    takeValues(from, &state);
    const auto put = arrived_.emplace(f.clump[slot], state);
    if (!same(put.first->second, state))
        throw std::logic_error("rigid body " + std::to_string(f.clump[slot])
            + " is not the same on two ranks");
}

//- A member has left on one rank: the body has on all
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::agreeOnLeavers()
{
    arrived_.clear();
    sent_.clear();
    if (!p_.clumps.any() || !share_.some) return;
    std::vector<std::int32_t> numbers;
    for (int k = 0; k < p_.clumps.count(); ++k)
        if (p_.clumps.data()[k].left) numbers.push_back(share_.number[k]);
    if (largestOfRanks(ranks(), double(numbers.size())) == 0) return;
    join(ranks(), numbers);
    std::sort(numbers.begin(), numbers.end());
    noteLeft(numbers);
}

//- numbers: ascending. What they end with is kept by all ranks
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::noteLeft(const std::vector<std::int32_t>& numbers)
{
    std::vector<Numbered> last;
    for (std::size_t k = 0; k < share_.number.size(); ++k)
    {
        const std::int32_t body = share_.number[k];
        if (!std::binary_search(numbers.begin(), numbers.end(), body)) continue;
        p_.clumps.data()[k].left = 1;
        if (int(k) < p_.clumps.count() && share_.counts[k])
            last.push_back(Numbered{body, p_.clumps.data()[k]});
    }
    join(ranks(), last);
    for (const Numbered& one : last) share_.left[one.number] = one.state;
    share_.leftActed = true;
}

template<class Backend, int D, class P>
typename RankedBodies<Backend, D, P>::Own RankedBodies<Backend, D, P>::own(
    const ParticleExchange& others)
{
    const SolidFields<D, P> f = p_.particles.view();
    std::vector<Member> all;
    for (int i = 0; i < others.residents(); ++i)
        if (f.clump[i] >= 0 && others.kind(i) == ParticleExchange::owned)
            all.push_back(Member{f.clump[i], share_.row[f.id[i]], i});
    std::sort(
        all.begin(), all.end(), [](const Member& a, const Member& b) { return a.row < b.row; });
    Own own;
    for (std::size_t from = 0, end; from < all.size(); from = end)
    {
        const std::int32_t body = all[from].body;
        for (end = from; end < all.size() && all[end].body == body; ++end) {}
        const bool whole = int(end - from) == members(body);
        (whole ? own.whole : own.split).push_back(body);
        auto& to = whole ? own.ofWhole : own.ofSplit;
        to.insert(to.end(), all.begin() + from, all.begin() + end);
    }
    return own;
}

//- And of nothing else
template<class Backend, int D, class P>
std::vector<std::int32_t> RankedBodies<Backend, D, P>::ofGhosts(
    const ParticleExchange& others, const Own& own)
{
    const std::int32_t* clump = p_.particles.view().clump;
    std::vector<std::int32_t> bodies;
    for (int i = 0; i < others.residents(); ++i)
    {
        if (clump[i] < 0 || others.kind(i) == ParticleExchange::owned) continue;
        if (!std::binary_search(own.whole.begin(), own.whole.end(), clump[i])
            && !std::binary_search(own.split.begin(), own.split.end(), clump[i]))
            bodies.push_back(clump[i]);
    }
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return bodies;
}

//- from .. end: of one body, in order. Has each member one owner?
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::requireAll(
    const std::vector<Holder>& of, std::size_t from, std::size_t end) const
{
    const int body = of[from].body;
    bool fits = int(end - from) == members(body);
    for (std::size_t k = from; k < end && fits; ++k)
        fits = of[k].row == share_.first[body] + int(k - from);
    if (!fits)
        throw std::logic_error("of the " + std::to_string(members(body))
            + " particles of rigid body " + std::to_string(body) + " "
            + std::to_string(end - from) + " have owners");
}

//- To each rank that has members of a body: who has the others
template<class Backend, int D, class P>
std::vector<typename RankedBodies<Backend, D, P>::Holder>
RankedBodies<Backend, D, P>::answers(const std::vector<RankBytes>& asked)
{
    std::vector<Holder> all;
    for (const RankBytes& bytes : asked)
    {
        const std::size_t before = all.size();
        all.resize(before + bytes.size()/sizeof(Holder));
        if (bytes.size())
            std::memcpy(static_cast<void*>(all.data() + before), bytes.data(), bytes.size());
    }
    const auto less = [](const Holder& a, const Holder& b) { return a.row < b.row; };
    std::sort(all.begin(), all.end(), less);
    std::vector<RankBytes> out(ranks().size()), in;
    for (std::size_t from = 0, end; from < all.size(); from = end)
    {
        std::set<int> holders;
        for (end = from; end < all.size() && all[end].body == all[from].body; ++end)
            holders.insert(all[end].rank);
        requireAll(all, from, end);
        for (const int rank : holders) putValues(out[rank], &all[from], end - from);
    }
    ranks().exchange(out, in);
    std::vector<Holder> here;
    for (const RankBytes& bytes : in)
    {
        const std::size_t before = here.size();
        here.resize(before + bytes.size()/sizeof(Holder));
        if (bytes.size())
            std::memcpy(static_cast<void*>(here.data() + before), bytes.data(), bytes.size());
    }
    std::sort(here.begin(), here.end(), less);
    return here;
}

//- Of bodies that are not whole here: who has which members, in their order
template<class Backend, int D, class P>
std::vector<typename RankedBodies<Backend, D, P>::Holder>
RankedBodies<Backend, D, P>::holdersOf(const std::vector<Member>& some)
{
    std::vector<RankBytes> out(ranks().size()), in;
    for (const Member& m : some)
    {
        const Holder h{m.body, m.row, ranks().rank()};
        putValues(out[m.body % ranks().size()], &h);
    }
    ranks().exchange(out, in);
    return answers(in);
}

//- As they were here, or as they came with their members
template<class Backend, int D, class P>
std::vector<ClumpData> RankedBodies<Backend, D, P>::statesOf(
    const std::vector<std::int32_t>& numbers)
{
    IdSlots before(p_.clumps.count());
    for (int k = 0; k < p_.clumps.count(); ++k) before.put(share_.some ? share_.number[k] : k, k);
    std::vector<ClumpData> states;
    for (const std::int32_t body : numbers)
    {
        const int was = before(body);
        const auto came = arrived_.find(body);
        if (was < 0 && came == arrived_.end())
            throw std::logic_error("rank " + std::to_string(ranks().rank())
                + " has not got the state of rigid body " + std::to_string(body));
        if (was >= 0 && came != arrived_.end() && !same(p_.clumps.data()[was], came->second))
            throw std::logic_error(
                "rigid body " + std::to_string(body) + " is not the same on two ranks");
        states.push_back(was >= 0 ? p_.clumps.data()[was] : came->second);
    }
    return states;
}

//- Which members are sent, and where they are put. some: those that this rank has
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::shareMembers(
    const std::vector<Holder>& holders, const std::vector<Member>& some)
{
    const int me = ranks().rank(), size = ranks().size();
    share_.members.allocate(int(holders.size()));
    std::vector<std::vector<int>> to(size), from(size);
    std::size_t next = 0;
    for (std::size_t begin = 0, end; begin < holders.size(); begin = end)
    {
        std::set<int> ranksOf;
        for (end = begin; end < holders.size() && holders[end].body == holders[begin].body; ++end)
            ranksOf.insert(holders[end].rank);
        for (std::size_t k = begin; k < end; ++k)
        {
            if (holders[k].rank != me)
            {
                from[holders[k].rank].push_back(int(k));
                continue;
            }
            const int slot = some[next++].slot;
            share_.members.own.emplace_back(slot, int(k));
            for (const int rank : ranksOf) if (rank != me) to[rank].push_back(slot);
        }
    }
    for (int rank = 0; rank < size; ++rank)
    {
        share_.members.shares.send(rank, std::move(to[rank]));
        share_.members.shares.receive(rank, std::move(from[rank]));
    }
}

//- What is moved here, and what adds up to forces on it
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::moveHere(
    const Own& own, const std::vector<Holder>& holders, const std::vector<ClumpData>& states)
{
    const std::int32_t* key = p_.particles.view().id;
    std::vector<int> first(1, 0), member;
    for (const Member& m : own.ofWhole) member.push_back(key[m.slot]);
    for (std::size_t k = 0; k < holders.size(); ++k) member.push_back(int(k));
    share_.counts.assign(own.whole.size(), 1);
    std::size_t at = 0;
    for (const std::int32_t body : own.whole) first.push_back(first.back() + members(body));
    for (const std::int32_t body : own.split)
    {
        first.push_back(first.back() + members(body));
        share_.counts.push_back(at < holders.size() && holders[at].rank == ranks().rank());
        at += members(body);
    }
    if (at != holders.size() || first.back() != int(member.size()))
        throw std::logic_error("members of rigid bodies were lost as they were shared");
    share_.whole = int(own.whole.size());
    share_.some = true;
    p_.clumps.setHere(states, int(own.whole.size() + own.split.size()), first, member);
}

//- Which body is whose
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::placeSlots(int residents)
{
    const std::int32_t* clump = p_.particles.view().clump;
    IdSlots here(share_.number.size());
    for (std::size_t k = 0; k < share_.number.size(); ++k)
        here.put(share_.number[k], std::int32_t(k));
    share_.place.assign(p_.particles.n, -1);
    for (int i = 0; i < residents; ++i) if (clump[i] >= 0) share_.place[i] = here(clump[i]);
}

//- Every rank knows all of them still
template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::keepLeft()
{
    for (int k = 0; k < p_.clumps.total(); ++k)
    {
        if (!p_.clumps.data()[k].left) continue;
        share_.left[k] = p_.clumps.data()[k];
        share_.leftActed = true;
    }
}

template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::settle(const ParticleExchange& others)
{
    if (!p_.clumps.any()) return;
    if (!share_.some) keepLeft();
    const Own here = own(others);
    const std::vector<Holder> holders = holdersOf(here.ofSplit);
    shareMembers(holders, here.ofSplit);
    std::vector<std::int32_t> number(here.whole);
    const std::vector<std::int32_t> near = ofGhosts(others, here);
    for (const auto* more : {&here.split, &near})
        number.insert(number.end(), more->begin(), more->end());
    const std::vector<ClumpData> states = statesOf(number);
    share_.number.swap(number);
    moveHere(here, holders, states);
    placeSlots(others.residents());
}

template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::rekey(int residents, int n)
{
    if (!p_.clumps.any()) return;
    const std::int32_t* key = p_.particles.view().id;
    std::vector<double> offset(3*std::size_t(n), 0.0);
    std::vector<std::int32_t> row(n, -1);
    for (int i = 0; i < residents; ++i)
    {
        row[i] = share_.row[key[i]];
        std::copy_n(
            p_.clumps.offset().data() + 3*std::size_t(key[i]), 3, &offset[3*std::size_t(i)]);
    }
    share_.row.swap(row);
    if (share_.some) share_.place.resize(n, -1);
    Array<Backend, double> fresh;
    fresh.upload(p_.set.context, offset);
    p_.clumps.offset().swap(fresh);
}

template<class Backend, int D, class P>
int RankedBodies<Backend, D, P>::touching(int slot) const
{
    const int k = share_.place[slot];
    return k < 0 ? 0 : p_.clumps.data()[k].touching;
}

template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::setTouching(int slot, int touching)
{
    const int k = share_.place[slot];
    if (k >= 0) p_.clumps.data()[k].touching = touching;
}

template<class Backend, int D, class P>
typename P::real RankedBodies<Backend, D, P>::massInContacts(int slot, real own) const
{
    const int k = share_.place[slot];
    return k >= 0 && p_.sharesMass() ? real(contactMass(p_.clumps.data()[k])) : own;
}

template<class Backend, int D, class P>
std::vector<ClumpData> RankedBodies<Backend, D, P>::all()
{
    std::vector<ClumpData> bodies = p_.clumps.known();
    if (!share_.some) return bodies;
    std::vector<Numbered> rows;
    for (int k = 0; k < p_.clumps.count(); ++k)
        if (share_.counts[k]) rows.push_back(Numbered{share_.number[k], p_.clumps.data()[k]});
    join(ranks(), rows);
    for (const Numbered& one : rows) bodies[one.number] = one.state;
    if (rows.size() + share_.left.size() != bodies.size())
        throw std::logic_error("of " + std::to_string(bodies.size()) + " rigid bodies "
            + std::to_string(rows.size() + share_.left.size()) + " are known");
    return bodies;
}

template<class Backend, int D, class P>
std::int32_t RankedBodies<Backend, D, P>::row(int slot)
{ return p_.clumps.any() ? share_.row[p_.particles.view().id[slot]] : -1; }

template<class Backend, int D, class P>
void RankedBodies<Backend, D, P>::collect(const std::vector<std::int32_t>& rows)
{
    if (!p_.clumps.any()) return;
    share_.row = rows;
    p_.clumps.holdAll();
}

} // namespace riprap

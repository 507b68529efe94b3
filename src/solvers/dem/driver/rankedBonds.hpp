/*  Bonds on several ranks (CPU). As with contacts no force returns: each rank has the bonds of its
    own particles and works them out, those across a border as well, whose other end is a ghost.
    Both ranks remember the same bits, and a bond goes where its particles go.

    A bond may be longer than contacts reach. Ghosts come from as far as the longest one is at a
    rebuild, which ranks agree on then; until the next they stay. Of a broken bond the other end may
    be anywhere.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include "core/ranks/idSlots.hpp"
#include "core/ranks/joinRanks.hpp"
#include "core/ranks/particleExchange.hpp"
#include "solvers/dem/parts/demParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class RankedBonds
{
public:

    using real = typename P::real;
    using Record = BondRecord<D, P>;

    explicit RankedBonds(DemParts<Backend, D, P>& parts) : p_(parts) {}

    //- Every rank has all particles, and so all bonds
    void begin();

    //- Beyond contact [m]: that far ghosts must come from. \return whether it has changed
    bool adaptReach();
    double reach() const { return reach_; }

    //- Bonds of a particle that goes to another rank
    void pack(int slot, RankBytes& to);
    void unpack(const unsigned char*& from);

    //- In a rebuild: particles of this rank that have left the domain; then, when all are in their
    //  places, which bonds are here from now on
    void noteLeavers(const std::vector<std::int32_t>& ids, bool any);
    void settle(const ParticleExchange&);

    //- Memory is for n particles from now on, whose keys are their slots
    void rekey(int residents, int n);

    //- Has one broken, then all ranks rebuild
    void agree();

    std::size_t broken();
    DemBondState state();

    //- All bonds on each rank; keys are places among the ids, which ascend
    void collect();

private:

    Transport& ranks() { return *p_.set.config.ranks; }
    double longestHere();
    void takeArrivals();
    std::vector<char> loseLeft();
    void findEnds(const IdSlots&);

    DemParts<Backend, D, P>& p_;
    std::vector<Record> arrived_;
    // ids of particles that left at this rebuild: of this rank, of all
    std::vector<std::int32_t> leftHere_, left_;
    double reach_ = 0;
};

template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::begin()
{
    const int n = p_.particles.n;
    p_.order.slotOf.allocate(p_.set.context, std::size_t(n) + 1);
    for (int i = 0; i < n; ++i) p_.order.slotOf.data()[i] = i;
    p_.order.slotOf.data()[n] = -1;
    SharedBonds& s = p_.bonds.share;
    const int count = p_.bonds.count();
    s.gone.assign(count, 0);
    s.counts.assign(count, 0);
    for (int k = 0; k < count; ++k)
    {
        s.number.push_back(k);
        for (int e = 0; e < 2; ++e)
            s.id[e].push_back(p_.particles.ids[p_.bonds.ends(e)[k]]);
    }
}

//- Of whole bonds here, beyond contact
template<class Backend, int D, class P>
double RankedBonds<Backend, D, P>::longestHere()
{
    double longest = 0;
    const BondFields<D, P> b = p_.bonds.view(p_.order.slotOf.data());
    const SolidFields<D, P> f = p_.particles.view();
    for (int k = 0; k < b.n; ++k)
    {
        if (b.broken[k]) continue;
        const int i = b.slotOf[b.ids[0][k]], j = b.slotOf[b.ids[1][k]];
        const double gap = gapBetween(p_.set.box, f.position(i), f.position(j),
            double(f.radius[i]), double(f.radius[j]));
        // what is no number is as far as can be
        if (!(gap <= longest)) longest = gap == gap ? gap : 1e300;
    }
    return longest;
}

//- In steps, since other ghosts must be chosen then
template<class Backend, int D, class P>
bool RankedBonds<Backend, D, P>::adaptReach()
{
    if (!p_.bonds.any()) return false;
    std::vector<double> v(1, longestHere());
    ranks().largest(v);
    double all = 0;
    for (int d = 0; d < D; ++d) all += p_.set.box.length[d];
    const double longest = std::min(v[0], all), least = p_.reach.reach;
    if (longest <= std::max(reach_, least) && (reach_ <= least || longest >= 0.5*reach_))
        return false;
    const double before = reach_;
    reach_ = longest <= least ? 0 : 1.1*longest;
    return reach_ != before;
}

template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::pack(int slot, RankBytes& to)
{
    if (!p_.bonds.any()) return;
    const int key = p_.particles.view().id[slot];
    const int* first = p_.bonds.first();
    const std::int32_t count = first ? first[key + 1] - first[key] : 0;
    putValues(to, &count);
    for (int r = first ? first[key] : 0, last = r + count; r < last; ++r)
    {
        const Record one = p_.bonds.record(p_.bonds.references()[r] >> 1);
        putValues(to, &one);
    }
}

template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::unpack(const unsigned char*& from)
{
    if (!p_.bonds.any()) return;
    std::int32_t count;
    takeValues(from, &count);
    arrived_.resize(arrived_.size() + count);
    takeValues(from, arrived_.data() + arrived_.size() - count, count);
}

//- any: from any rank
template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::noteLeavers(const std::vector<std::int32_t>& ids, bool any)
{
    if (!p_.bonds.any()) return;
    leftHere_ = left_ = ids;
    if (any) join(ranks(), left_);
    for (auto* v : {&leftHere_, &left_}) std::sort(v->begin(), v->end());
}

//- Among those that are here, in order. Of one that is here already both ranks remember the same
template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::takeArrivals()
{
    if (arrived_.empty()) return;
    std::vector<Record> all;
    all.swap(arrived_);
    for (int k = 0; k < p_.bonds.count(); ++k) all.push_back(p_.bonds.record(k));
    std::stable_sort(all.begin(), all.end(),
        [](const Record& a, const Record& b) { return a.number < b.number; });
    const auto same = [](const Record& a, const Record& b)
    {
        if (a.number != b.number) return false;
        if (a.broken != b.broken || a.gone != b.gone
            || !sameBytes(a.history, b.history, sizeof(a.history))
            || !sameBytes(&a.force, &b.force, sizeof(a.force)))
            throw std::logic_error(
                "bond " + std::to_string(a.number) + " is not the same on two ranks");
        return true;
    };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    p_.bonds.setRecords(all);
}

//- Bonds of particles that left are lost. \return of those that have lost both ends: was this rank
//  the last to have one?
template<class Backend, int D, class P>
std::vector<char> RankedBonds<Backend, D, P>::loseLeft()
{
    SharedBonds& s = p_.bonds.share;
    std::int32_t* broken = p_.bonds.view(nullptr).broken;
    std::vector<char> last(p_.bonds.count(), 0);
    const auto in = [](const std::vector<std::int32_t>& ids, std::int32_t id)
    { return std::binary_search(ids.begin(), ids.end(), id); };
    for (int k = 0; k < p_.bonds.count(); ++k)
    {
        const char before = s.gone[k];
        for (int e = 0; e < 2 && !left_.empty(); ++e)
            if (in(left_, s.id[e][k])) s.gone[k] |= char(1 << e);
        if (s.gone[k] && !broken[k]) broken[k] = int(BondBreak::lost);
        last[k] = before == 3 || in(leftHere_, s.id[0][k])
            || ((before & 1) && in(leftHere_, s.id[1][k]));
    }
    return last;
}

template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::settle(const ParticleExchange& others)
{
    if (!p_.bonds.any()) return;
    takeArrivals();
    const std::vector<char> last = loseLeft();
    const std::int32_t* key = p_.particles.view().id;
    IdSlots slotOf(others.residents());
    for (int i = 0; i < others.residents(); ++i) slotOf.put(p_.particles.ids[key[i]], i);
    const auto own = [&](std::int32_t id)
    {
        const int slot = slotOf(id);
        return slot >= 0 && others.kind(slot) == ParticleExchange::owned;
    };
    SharedBonds& s = p_.bonds.share;
    std::vector<char> stays(p_.bonds.count());
    bool all = true;
    for (int k = 0; k < p_.bonds.count(); ++k)
    {
        stays[k] = own(s.id[0][k]) || own(s.id[1][k]) || (s.gone[k] == 3 && last[k]);
        all = all && stays[k];
    }
    if (!all)
    {
        std::vector<Record> left;
        for (int k = 0; k < p_.bonds.count(); ++k)
            if (stays[k]) left.push_back(p_.bonds.record(k));
        p_.bonds.setRecords(left);
    }
    // reported by the rank of the first end, or of the second where that has left
    for (int k = 0; k < p_.bonds.count(); ++k)
        s.counts[k] = s.gone[k] == 3 || own(s.id[s.gone[k] & 1][k]);
    findEnds(slotOf);
}

//- Keys of the ends. Of a whole bond both are here
template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::findEnds(const IdSlots& slotOf)
{
    const std::int32_t* key = p_.particles.view().id;
    const std::int32_t* broken = p_.bonds.view(nullptr).broken;
    std::vector<std::int32_t> ends[2];
    for (int e = 0; e < 2; ++e)
        for (int k = 0; k < p_.bonds.count(); ++k)
        {
            const int slot = slotOf(p_.bonds.share.id[e][k]);
            if (slot < 0 && !broken[k])
                throw std::logic_error("rank " + std::to_string(ranks().rank())
                    + " has not got particle " + std::to_string(p_.bonds.share.id[e][k])
                    + ", an end of bond " + std::to_string(p_.bonds.share.number[k]));
            ends[e].push_back(slot < 0 ? p_.particles.n : key[slot]);
        }
    p_.bonds.setEnds(ends, p_.particles.n);
}

template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::rekey(int residents, int n)
{
    const BondFields<D, P> b = p_.bonds.view(p_.order.slotOf.data());
    std::vector<std::int32_t> ends[2];
    for (int e = 0; e < 2; ++e)
        for (int k = 0; k < b.n; ++k)
        {
            const int slot = b.slotOf[b.ids[e][k]];
            ends[e].push_back(slot < 0 || slot >= residents ? n : slot);
        }
    p_.bonds.setEnds(ends, n);
    p_.order.slotOf = Array<Backend, int>();
    p_.order.slotOf.allocate(p_.set.context, std::size_t(n) + 1);
    for (int i = 0; i <= n; ++i) p_.order.slotOf.data()[i] = i < residents ? i : -1;
}

template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::agree()
{
    if (!p_.bonds.any() || !p_.bonds.canBreak()) return;
    DemClockData& c = *p_.clock.data();
    std::vector<double> rebuild(1, double(c.needRebuild));
    ranks().largest(rebuild);
    c.needRebuild = int(rebuild[0]);
}

template<class Backend, int D, class P>
std::size_t RankedBonds<Backend, D, P>::broken()
{
    if (!p_.bonds.any()) return 0;
    std::vector<std::int64_t> all(1, std::int64_t(p_.bonds.broken()));
    ranks().sum(all);
    return std::size_t(all[0]);
}

//- Of a broken bond the other end may be on another rank, which says where it is
template<class Backend, int D, class P>
DemBondState RankedBonds<Backend, D, P>::state()
{
    if (!p_.bonds.any()) return DemBondState();
    struct End { std::int32_t number; Vec<D, std::int64_t> x; real radius; };
    const SolidFields<D, P> f = p_.particles.view();
    const BondFields<D, P> b = p_.bonds.view(p_.order.slotOf.data());
    const SharedBonds& s = p_.bonds.share;
    std::vector<End> ends;
    for (int k = 0; k < b.n; ++k)
    {
        if (!b.broken[k] || s.gone[k] || s.counts[k]) continue;
        const int j = b.slotOf[b.ids[1][k]];
        End end{};
        end.number = s.number[k];
        end.x = f.position(j);
        end.radius = f.radius[j];
        ends.push_back(end);
    }
    join(ranks(), ends);
    std::map<std::int32_t, const End*> endOf;
    for (const End& end : ends) endOf[end.number] = &end;
    DemBondState state = p_.bonds.state(p_.order.slotOf);
    std::size_t row = 0;
    for (int k = 0; k < b.n; ++k)
    {
        if (!s.counts[k]) continue;
        const auto end = endOf.find(s.number[k]);
        const int i = b.slotOf[b.ids[0][k]];
        if (end != endOf.end())
            state.gap[row] = gapBetween(p_.set.box, f.position(i), end->second->x,
                double(f.radius[i]), double(end->second->radius));
        ++row;
    }
    return state;
}

template<class Backend, int D, class P>
void RankedBonds<Backend, D, P>::collect()
{
    if (!p_.bonds.any()) return;
    std::vector<Record> all;
    for (int k = 0; k < p_.bonds.count(); ++k)
        if (p_.bonds.share.counts[k]) all.push_back(p_.bonds.record(k));
    join(ranks(), all);
    std::sort(all.begin(), all.end(),
        [](const Record& a, const Record& b) { return a.number < b.number; });
    p_.bonds.setRecords(all);
    IdSlots keyOf(p_.particles.ids.size());
    for (std::size_t i = 0; i < p_.particles.ids.size(); ++i)
        keyOf.put(p_.particles.ids[i], std::int32_t(i));
    std::vector<std::int32_t> ends[2];
    for (int e = 0; e < 2; ++e)
        for (const Record& r : all)
        {
            const int key = keyOf(r.id[e]);
            ends[e].push_back(key < 0 ? p_.particles.n : key);
        }
    p_.bonds.setEnds(ends, p_.particles.n);
}

} // namespace riprap

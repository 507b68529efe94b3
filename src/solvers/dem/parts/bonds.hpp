/*  Bonds between particles: who is bonded, what bonds remember, the forces that they carry.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/bond/bondPass.hpp"
#include "dem/lists/listBuild.hpp"
#include "solvers/dem/parts/particleFields.hpp"

namespace riprap
{

//- Between the surfaces of two particles [m]
template<int D, class P>
double gapBetween(const Box<D, P>& box, const Vec<D, std::int64_t>& a,
    const Vec<D, std::int64_t>& b, double radiusA, double radiusB)
{
    double d2 = 0;
    for (int d = 0; d < D; ++d)
    {
        const double s = double(std::int64_t(std::uint64_t(b.c[d]) - std::uint64_t(a.c[d])))
            *box.unit[d];
        d2 += s*s;
    }
    return std::sqrt(d2) - radiusA - radiusB;
}

//- What several ranks know of each bond besides; empty: one process has all of them
struct SharedBonds
{
    std::vector<std::int32_t> number;       // among those that the scene was given, ascending
    std::vector<std::int32_t> id[2];        // of the ends
    std::vector<char> gone;                 // ends that have left the scene: 1, 2, 3 for both
    std::vector<char> counts;               // of all ranks that have it one reports it
};

//- A bond with all that it remembers, on its way to another rank
template<int D, class P>
struct BondRecord
{
    std::int32_t number, id[2], type, broken, gone;
    double rest;
    typename P::real history[bondHistory<D>];
    BondForce<D, typename P::real> force;
};

//- slots, slotOf: where the particle of a key is; -1: it has left, or is not on this rank. As many
//  as keys, and one more on several ranks: the key of a particle that is not here
template<class Backend, int D, class P>
class Bonds
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    Bonds(DemSetting<Backend, D, P>& set, ParticleFields<Backend, D, P>& particles)
        : set_(set), particles_(particles)
    {}

    SharedBonds share;

    void set(const DemBonds&, const DemParticles&);

    int count() const { return count_; }        // here
    bool any() const { return total_ > 0; }     // on any rank
    bool canBreak() const { return canBreak_; }

    //- Ends by their keys, of so many
    void setEnds(const std::vector<std::int32_t> (&)[2], int keys);
    const std::int32_t* ends(int e) const { return ends_[e].data(); }
    const int* references() const { return reference_.data(); }

    //- On several ranks (CPU): those that are here, in order. Ends are set next
    BondRecord<D, P> record(int k) const;
    void setRecords(const std::vector<BondRecord<D, P>>&);

    BondFields<D, P> view(const int* slotOf);
    BondTable table();
    const int* first() const { return count_ ? first_.data() : nullptr; }      // bonds of each key
    const BondForce<D, real>* force() const { return force_.data(); }

    //- Bonds with both ends in the scene, in order: a scene of those that stayed has them too
    std::vector<int> kept(Array<Backend, int>& slots);

    //- f(array, numbers a bond) for what bonds remember
    template<class F> void forEachMemory(const std::vector<int>& kept, F f);

    //- For the host
    std::size_t broken();
    // of the first n particles
    std::vector<std::int32_t> brokenAt(Array<Backend, int>& slots, int n);
    DemBondState state(Array<Backend, int>& slots);
    double energy(Array<Backend, int>& slots);
    std::size_t bytes() const;

private:

    //- Where the ends are, for the host
    struct Places
    {
        std::vector<std::int32_t> key[2];
        std::vector<int> slotOf;
        std::vector<real> radius;
        std::vector<std::int64_t> x[D];

        int slot(int k, int e) const { return slotOf[key[e][k]]; }
        bool both(int k) const { return slot(k, 0) >= 0 && slot(k, 1) >= 0; }
    };
    Places places(Array<Backend, int>& slots);
    double gap(const Places&, int k) const;
    bool counts(int k) const { return share.counts.empty() || share.counts[k]; }

    DemSetting<Backend, D, P>& set_;
    ParticleFields<Backend, D, P>& particles_;
    int count_ = 0;
    std::size_t total_ = 0;
    bool canBreak_ = false;
    Array<Backend, std::int32_t> ends_[2], type_, broken_;
    Array<Backend, double> rest_;
    Array<Backend, real> history_;
    Array<Backend, BondForce<D, real>> force_;
    Array<Backend, BondParameters<real>> types_;
    Array<Backend, int> first_, reference_;
};

template<class Backend, int D, class P>
void Bonds<Backend, D, P>::set(const DemBonds& in, const DemParticles& q)
{
    count_ = int(in.size());
    total_ = in.size();
    if (!count_) return;
    std::vector<int> keyOf;
    for (int i = 0; i < particles_.n; ++i)
    {
        if (std::size_t(particles_.ids[i]) >= keyOf.size())
            keyOf.resize(std::size_t(particles_.ids[i]) + 1, -1);
        keyOf[particles_.ids[i]] = i;
    }
    std::vector<std::int32_t> end[2], type(in.type);
    std::vector<double> rest(in.gap);
    type.resize(count_, 0);
    for (int k = 0; k < count_; ++k)
    {
        const int a = keyOf[in.a[k]], b = keyOf[in.b[k]];
        end[0].push_back(a);
        end[1].push_back(b);
        if (!in.gap.empty()) continue;
        Vec<D, std::int64_t> xa, xb;
        for (int d = 0; d < D; ++d)
        {
            const int axis = set_.config.axes[d];
            xa.c[d] = set_.box.toFixed(d, q.position[3*std::size_t(a) + axis]);
            xb.c[d] = set_.box.toFixed(d, q.position[3*std::size_t(b) + axis]);
        }
        rest.push_back(gapBetween(
            set_.box, xa, xb, double(real(q.radius[a])), double(real(q.radius[b]))));
    }
    std::vector<BondParameters<real>> types;
    for (const DemBondType& t : set_.input.bondTypes)
    {
        static constexpr double most = 1e30;
        const auto strength = [](double s) { return real(std::min(s, most)); };
        canBreak_ = canBreak_ || t.tensileStrength < most || t.shearStrength < most;
        types.push_back(BondParameters<real>{real(t.normalStiffness), real(t.shearStiffness),
            strength(t.tensileStrength), strength(t.shearStrength), real(2*t.dampingRatio),
            real(t.radiusFactor), bondRadiusChoice(t.radiusKind), D == 3 || t.cylinder});
    }
    setEnds(end, particles_.n);
    type_.upload(set_.context, type);
    rest_.upload(set_.context, rest);
    types_.upload(set_.context, types);
    broken_.upload(set_.context, std::vector<std::int32_t>(count_, 0));
    history_.upload(set_.context, std::vector<real>(std::size_t(count_)*bondHistory<D>, real(0)));
    force_.allocate(set_.context, count_);
}

//- And the bonds of each key in order, which is the order in which its forces are added up
template<class Backend, int D, class P>
void Bonds<Backend, D, P>::setEnds(const std::vector<std::int32_t> (&end)[2], int keys)
{
    std::vector<int> first(std::size_t(keys) + 1, 0);
    for (const auto& ends : end) for (const int key : ends) if (key < keys) ++first[key + 1];
    for (int i = 0; i < keys; ++i) first[i + 1] += first[i];
    std::vector<int> next(first.begin(), first.end() - 1), reference(first.back());
    for (int k = 0; k < count_; ++k)
        for (int e = 0; e < 2; ++e)
            if (end[e][k] < keys) reference[next[end[e][k]]++] = 2*k + e;
    for (int e = 0; e < 2; ++e) ends_[e].upload(set_.context, end[e]);
    first_.upload(set_.context, first);
    reference_.upload(set_.context, reference);
}

template<class Backend, int D, class P>
BondRecord<D, P> Bonds<Backend, D, P>::record(int k) const
{
    BondRecord<D, P> r{};
    r.number = share.number[k];
    for (int e = 0; e < 2; ++e) r.id[e] = share.id[e][k];
    r.type = type_.data()[k];
    r.broken = broken_.data()[k];
    r.gone = static_cast<unsigned char>(share.gone[k]);
    r.rest = rest_.data()[k];
    std::copy_n(history_.data() + std::size_t(k)*bondHistory<D>, bondHistory<D>, r.history);
    r.force = force_.data()[k];
    return r;
}

template<class Backend, int D, class P>
void Bonds<Backend, D, P>::setRecords(const std::vector<BondRecord<D, P>>& all)
{
    count_ = int(all.size());
    share = SharedBonds();
    share.counts.assign(count_, 0);
    std::vector<std::int32_t> type, broken;
    std::vector<double> rest;
    std::vector<real> history;
    std::vector<BondForce<D, real>> force;
    for (const BondRecord<D, P>& r : all)
    {
        share.number.push_back(r.number);
        for (int e = 0; e < 2; ++e) share.id[e].push_back(r.id[e]);
        share.gone.push_back(char(r.gone));
        type.push_back(r.type);
        broken.push_back(r.broken);
        rest.push_back(r.rest);
        history.insert(history.end(), r.history, r.history + bondHistory<D>);
        force.push_back(r.force);
    }
    replaceBy(set_.context, type_, type);
    replaceBy(set_.context, broken_, broken);
    replaceBy(set_.context, rest_, rest);
    replaceBy(set_.context, history_, history);
    replaceBy(set_.context, force_, force);
}

template<class Backend, int D, class P>
BondFields<D, P> Bonds<Backend, D, P>::view(const int* slotOf)
{
    return BondFields<D, P>
    {
        count_, {ends_[0].data(), ends_[1].data()}, type_.data(), rest_.data(), history_.data(),
        broken_.data(), force_.data(), types_.data(), slotOf
    };
}

template<class Backend, int D, class P>
BondTable Bonds<Backend, D, P>::table()
{
    if (!count_) return BondTable{};
    return BondTable
    {
        first_.data(), reference_.data(), {ends_[0].data(), ends_[1].data()}, broken_.data(),
        set_.config.contactWithinBonds
    };
}

template<class Backend, int D, class P>
std::vector<int> Bonds<Backend, D, P>::kept(Array<Backend, int>& slots)
{
    std::vector<int> kept;
    if (!count_) return kept;
    const auto slotOf = slots.download(), a = ends_[0].download(), b = ends_[1].download();
    for (int k = 0; k < count_; ++k) if (slotOf[a[k]] >= 0 && slotOf[b[k]] >= 0) kept.push_back(k);
    return kept;
}

template<class Backend, int D, class P>
template<class F>
void Bonds<Backend, D, P>::forEachMemory(const std::vector<int>& kept, F f)
{
    if (kept.empty()) return;
    f(rest_, 1);
    f(broken_, 1);
    f(history_, bondHistory<D>);
    f(force_, 1);
}

template<class Backend, int D, class P>
std::size_t Bonds<Backend, D, P>::broken()
{
    std::size_t count = 0;
    if (!count_) return count;
    const auto broken = broken_.download();
    for (int k = 0; k < count_; ++k) count += broken[k] && counts(k);
    return count;
}

template<class Backend, int D, class P>
std::vector<std::int32_t> Bonds<Backend, D, P>::brokenAt(Array<Backend, int>& slots, int n)
{
    std::vector<std::int32_t> at(n, 0);
    if (!count_) return at;
    const auto slotOf = slots.download();
    const auto a = ends_[0].download(), b = ends_[1].download(), broken = broken_.download();
    for (int k = 0; k < count_; ++k)
        if (broken[k]) for (const int key : {a[k], b[k]}) if (slotOf[key] >= 0) ++at[slotOf[key]];
    return at;
}

template<class Backend, int D, class P>
typename Bonds<Backend, D, P>::Places Bonds<Backend, D, P>::places(Array<Backend, int>& slots)
{
    Places p;
    for (int e = 0; e < 2; ++e) p.key[e] = ends_[e].download();
    p.slotOf = slots.download();
    p.radius = particles_.template field<real>(particles_.at.radius);
    for (int d = 0; d < D; ++d)
        p.x[d] = particles_.template field<std::int64_t>(particles_.at.x + d);
    return p;
}

//- Between the surfaces of both ends [m]; 0: one is not there
template<class Backend, int D, class P>
double Bonds<Backend, D, P>::gap(const Places& p, int k) const
{
    if (!p.both(k)) return 0;
    const int i = p.slot(k, 0), j = p.slot(k, 1);
    Vec<D, std::int64_t> xi, xj;
    for (int d = 0; d < D; ++d) { xi.c[d] = p.x[d][i]; xj.c[d] = p.x[d][j]; }
    return gapBetween(set_.box, xi, xj, double(p.radius[i]), double(p.radius[j]));
}

template<class Backend, int D, class P>
DemBondState Bonds<Backend, D, P>::state(Array<Backend, int>& slots)
{
    DemBondState s;
    if (!count_) return s;
    const Places p = places(slots);
    const auto type = type_.download(), broken = broken_.download();
    const auto rest = rest_.download();
    const auto force = force_.download();
    for (int k = 0; k < count_; ++k)
    {
        if (!counts(k)) continue;
        const bool all = share.number.empty();
        s.number.push_back(all ? k : share.number[k]);
        s.a.push_back(all ? particles_.ids[p.key[0][k]] : share.id[0][k]);
        s.b.push_back(all ? particles_.ids[p.key[1][k]] : share.id[1][k]);
        s.type.push_back(type[k]);
        s.broken.push_back(broken[k]);
        s.restGap.push_back(rest[k]);
        s.gap.push_back(gap(p, k));
        const std::size_t at = s.force.size();
        s.force.resize(at + 3, 0.0);
        s.moment.resize(at + 3, 0.0);
        for (int d = 0; d < D; ++d)
            s.force[at + set_.config.axes[d]] = double(force[k].force.c[d]);
        for (int c = 0; c < S; ++c)
            s.moment[at + (D == 2 ? set_.config.axes[2] : c)] = (D == 2 ? set_.spinSign() : 1)
                *double(force[k].bending.c[c]);
    }
    return s;
}

//- Of those that this rank reports
template<class Backend, int D, class P>
double Bonds<Backend, D, P>::energy(Array<Backend, int>& slots)
{
    double sum = 0;
    if (!count_) return sum;
    const Places p = places(slots);
    const auto broken = broken_.download(), type = type_.download();
    const auto rest = rest_.download();
    const auto history = history_.download();
    const auto types = types_.download();
    for (int k = 0; k < count_; ++k)
    {
        if (broken[k] || !counts(k)) continue;
        sum += double(bondEnergy<D, real>(types[type[k]], p.radius[p.slot(k, 0)],
            p.radius[p.slot(k, 1)], real(gap(p, k) - rest[k]),
            &history[std::size_t(k)*bondHistory<D>]));
    }
    return sum;
}

template<class Backend, int D, class P>
std::size_t Bonds<Backend, D, P>::bytes() const
{
    return ends_[0].bytes() + ends_[1].bytes() + type_.bytes() + broken_.bytes() + rest_.bytes()
        + history_.bytes() + force_.bytes() + first_.bytes() + reference_.bytes();
}

} // namespace riprap

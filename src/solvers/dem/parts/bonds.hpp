/*  Bonds between particles: who is bonded, what bonds remember, the forces that they carry.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/bond/bondPass.hpp"
#include "dem/lists/listBuild.hpp"
#include "solvers/dem/parts/particleFields.hpp"

namespace riprap
{

//- slots, slotOf: where the particle of a key is; -1: it has left
template<class Backend, int D, class P>
class Bonds
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    Bonds(DemSetting<Backend, D, P>& set, ParticleFields<Backend, D, P>& particles)
        : set_(set), particles_(particles)
    {}

    void set(const DemBonds&, const DemParticles&);

    int count() const { return count_; }
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

    DemSetting<Backend, D, P>& set_;
    ParticleFields<Backend, D, P>& particles_;
    int count_ = 0;
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
    std::vector<int> first(particles_.n + 1, 0);
    type.resize(count_, 0);
    for (int k = 0; k < count_; ++k)
    {
        const int a = keyOf[in.a[k]], b = keyOf[in.b[k]];
        end[0].push_back(a);
        end[1].push_back(b);
        ++first[a + 1];
        ++first[b + 1];
        if (!in.gap.empty()) continue;
        double d2 = 0;
        for (int d = 0; d < D; ++d)
        {
            const int axis = set_.config.axes[d];
            const std::int64_t xa = set_.box.toFixed(d, q.position[3*std::size_t(a) + axis]),
                               xb = set_.box.toFixed(d, q.position[3*std::size_t(b) + axis]);
            const double s = double(std::int64_t(std::uint64_t(xb) - std::uint64_t(xa)))
                *set_.box.unit[d];
            d2 += s*s;
        }
        rest.push_back(std::sqrt(d2) - double(real(q.radius[a])) - double(real(q.radius[b])));
    }
    for (int i = 0; i < particles_.n; ++i) first[i + 1] += first[i];
    std::vector<int> next(first.begin(), first.end() - 1), reference(2*std::size_t(count_));
    for (int k = 0; k < count_; ++k)
        for (int e = 0; e < 2; ++e) reference[next[end[e][k]]++] = 2*k + e;
    std::vector<BondParameters<real>> types;
    for (const DemBondType& t : set_.input.bondTypes)
    {
        const auto strength = [](double s) { return real(std::min(s, 1e30)); };
        types.push_back(BondParameters<real>{real(t.normalStiffness), real(t.shearStiffness),
            strength(t.tensileStrength), strength(t.shearStrength), real(2*t.dampingRatio),
            real(t.radiusFactor), t.radiusKind == BondRadiusKind::harmonic, D == 3 || t.cylinder});
    }
    for (int e = 0; e < 2; ++e) ends_[e].upload(set_.context, end[e]);
    type_.upload(set_.context, type);
    rest_.upload(set_.context, rest);
    types_.upload(set_.context, types);
    broken_.upload(set_.context, std::vector<std::int32_t>(count_, 0));
    history_.upload(set_.context, std::vector<real>(std::size_t(count_)*bondHistory<D>, real(0)));
    force_.allocate(set_.context, count_);
    first_.upload(set_.context, first);
    reference_.upload(set_.context, reference);
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
    if (count_) for (const std::int32_t b : broken_.download()) count += b != 0;
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
DemBondState Bonds<Backend, D, P>::state(Array<Backend, int>& slots)
{
    DemBondState s;
    if (!count_) return s;
    const auto a = ends_[0].download(), b = ends_[1].download();
    s.type = type_.download();
    s.broken = broken_.download();
    s.restGap = rest_.download();
    const auto force = force_.download();
    const auto slotOf = slots.download();
    const auto radius = particles_.template field<real>(particles_.at.radius);
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d) x[d] = particles_.template field<std::int64_t>(particles_.at.x + d);
    s.force.assign(3*std::size_t(count_), 0.0);
    s.moment = s.force;
    for (int k = 0; k < count_; ++k)
    {
        s.a.push_back(particles_.ids[a[k]]);
        s.b.push_back(particles_.ids[b[k]]);
        double d2 = 0;
        const int i = slotOf[a[k]], j = slotOf[b[k]];
        for (int d = 0; d < D; ++d)
        {
            s.force[3*std::size_t(k) + set_.config.axes[d]] = double(force[k].force.c[d]);
            if (i < 0 || j < 0) continue;
            const double r = double(std::int64_t(std::uint64_t(x[d][j]) - std::uint64_t(x[d][i])))
                *set_.box.unit[d];
            d2 += r*r;
        }
        for (int c = 0; c < S; ++c)
            s.moment[3*std::size_t(k) + (D == 2 ? set_.config.axes[2] : c)] =
                (D == 2 ? set_.spinSign() : 1)*double(force[k].bending.c[c]);
        s.gap.push_back(i < 0 || j < 0 ? 0 : std::sqrt(d2) - double(radius[i]) - double(radius[j]));
    }
    return s;
}

template<class Backend, int D, class P>
double Bonds<Backend, D, P>::energy(Array<Backend, int>& slots)
{
    double sum = 0;
    if (!count_) return sum;
    const DemBondState b = state(slots);
    const auto radius = particles_.template field<real>(particles_.at.radius);
    const auto history = history_.download();
    const auto types = types_.download();
    const auto slotOf = slots.download();
    const auto ends = std::array<std::vector<std::int32_t>, 2>{
        ends_[0].download(), ends_[1].download()};
    for (int k = 0; k < count_; ++k)
    {
        if (b.broken[k]) continue;
        sum += double(bondEnergy<D, real>(types[b.type[k]], radius[slotOf[ends[0][k]]],
            radius[slotOf[ends[1][k]]], real(b.gap[k] - b.restGap[k]),
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

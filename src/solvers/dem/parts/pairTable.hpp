/*  Numbers of contact laws for each pair of materials, on the device.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cstring>
#include "dem/passes/pairModel.hpp"
#include "solvers/dem/demFamilies.hpp"
#include "solvers/dem/parts/demSetting.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class PairTable
{
public:

    using real = typename P::real;

    explicit PairTable(DemSetting<Backend, D, P>& set) : set_(set) {}

    //- Of the laws that the setting chooses, for these particles
    void set(const DemParticles&);

    //- What a pass over contacts reads, without and with the law's numbers
    void give(PairSetting<Backend, D, P>&) const;
    template<class Law> void giveNumbers(PairModel<Backend, D, P, Law>&) const;
    template<class Law>
    const typename Law::template Parameters<real>* parameters() const
    { return reinterpret_cast<const typename Law::template Parameters<real>*>(parameters_.data()); }
    const real* gaps() const { return gaps_.data(); }
    int materials() const { return int(set_.input.materials.size()); }

    //- Likewise of two materials, for the host
    real gap(int a, int b) const { return gapOf_[std::size_t(a)*materials() + b]; }
    real reach(int a, int b) const { return reachOf_[std::size_t(a)*materials() + b]; }

    double largestGap() const { return largestGap_; }
    int histories() const { return histories_; }            // numbers that a contact remembers

private:

    //- \return how many numbers a pair has
    int chooseLaw();
    //- The material of all particles; -1: they are of several
    static int materialOfAll(const std::vector<std::int32_t>& of);

    DemSetting<Backend, D, P>& set_;
    Array<Backend, real> parameters_, gaps_;
    std::vector<real> gapOf_;   // the same
    std::vector<real> reachOf_; // what of the gaps is the law's reach
    // the pair of the one material that all particles are of; -1: there are several
    int alone_ = -1;
    std::vector<real> singlePair_;    // its numbers (else of the first pair), its gap behind them
    double largestGap_ = 0;
    int histories_ = 0;
    void (*make_)(const PairProperties&, real* numbers) = nullptr;     // of the law
};

template<class Backend, int D, class P>
int PairTable<Backend, D, P>::materialOfAll(const std::vector<std::int32_t>& of)
{
    if (of.empty()) return 0;
    return std::all_of(of.begin(), of.end(), [&](std::int32_t m) { return m == of[0]; }) ? of[0]
                                                                                         : -1;
}

template<class Backend, int D, class P>
void PairTable<Backend, D, P>::set(const DemParticles& particles)
{
    const int m = int(set_.input.materials.size());
    std::vector<real> gaps(std::size_t(m)*m, real(0));
    std::vector<PairProperties> pairs(std::size_t(m)*m);
    std::vector<char> given(std::size_t(m)*m, 0);
    const std::vector<double>& radius = particles.radius;
    const double largestRadius = *std::max_element(radius.begin(), radius.end());
    reachOf_.assign(std::size_t(m)*m, real(0));
    for (DemPair& p : set_.input.pairs)
        for (const bool turned : {false, true})
        {
            const int a = turned ? p.b : p.a, b = turned ? p.a : p.b;
            PairProperties q = p.properties;
            q.largestRadius = largestRadius;
            q.youngA = set_.input.materials[a].young;
            q.youngB = set_.input.materials[b].young;
            q.poissonA = set_.input.materials[a].poisson;
            q.poissonB = set_.input.materials[b].poisson;
            const std::size_t k = std::size_t(a)*m + b;
            pairs[k] = q;
            given[k] = 1;
            NormalLaws::at(set_.laws.normal, [&](auto law)
            {
                using Normal = typename decltype(law)::type;
                // beside a wall R* is the particle's radius
                const double reach = Normal::reach(q, largestRadius);
                reachOf_[k] = real(reach);
                gaps[k] = real(q.gap + reach);
                largestGap_ = std::max(largestGap_, q.gap + reach);
            });
        }
    gaps_.upload(set_.context, gaps);
    gapOf_ = gaps;
    const int numbers = chooseLaw();
    std::vector<real> all(numbers*pairs.size(), real(0));
    // a pair that cannot meet was not given: its numbers are never used
    for (std::size_t k = 0; k < pairs.size(); ++k)
        if (given[k]) make_(pairs[k], &all[k*numbers]);
    parameters_.upload(set_.context, all);
    alone_ = materialOfAll(particles.material)*(m + 1);
    // what touches is what is nearer than the largest gap there is
    if (alone_ < 0 || gaps[alone_] != real(largestGap_)) alone_ = -1;
    const int first = std::max(alone_, 0);
    singlePair_.assign(all.begin() + first*numbers, all.begin() + (first + 1)*numbers);
    singlePair_.push_back(gaps[first]);
}

template<class Backend, int D, class P>
int PairTable<Backend, D, P>::chooseLaw()
{
    int numbers = 0;
    withLaw(set_.laws, [&](auto law)
    {
        using Law = decltype(law);
        using Parameters = typename Law::template Parameters<real>;
        numbers = sizeof(Parameters)/sizeof(real);
        make_ = [](const PairProperties& p, real* to)
        {
            const Parameters one = Law::template make<real>(p);
            std::memcpy(to, &one, sizeof(one));
        };
        histories_ = Law::template history<D>;
    });
    return numbers;
}

template<class Backend, int D, class P>
void PairTable<Backend, D, P>::give(PairSetting<Backend, D, P>& m) const
{
    m.gap = gaps();
    m.materials = materials();
    m.alone = alone_;
    m.singlePairGap = singlePair_.back();
}

template<class Backend, int D, class P>
template<class Law>
void PairTable<Backend, D, P>::giveNumbers(PairModel<Backend, D, P, Law>& m) const
{
    m.parameters = parameters<Law>();
    std::memcpy(&m.singlePair, singlePair_.data(), sizeof(m.singlePair));
}

} // namespace riprap

/*  What is done to each group of particles, on the device.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/state/solidFields.hpp"
#include "solvers/dem/parts/demSetting.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SolidGroups
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    explicit SolidGroups(DemSetting<Backend, D, P>&);

    GroupData<D, real> of(const DemGroup&) const;
    const GroupData<D, real>* data() const { return groups_.data(); }
    int motions() const;        // that groups are moved by
    bool damped() const;        // is any?

private:

    DemSetting<Backend, D, P>& set_;
    Array<Backend, GroupData<D, real>> groups_;
};

template<class Backend, int D, class P>
SolidGroups<Backend, D, P>::SolidGroups(DemSetting<Backend, D, P>& set)
:
    set_(set)
{
    std::vector<GroupData<D, real>> groups;
    for (const DemGroup& g : set_.input.groups) groups.push_back(of(g));
    groups_.upload(set_.context, groups);
}

template<class Backend, int D, class P>
GroupData<D, typename P::real> SolidGroups<Backend, D, P>::of(const DemGroup& g) const
{
    GroupData<D, real> r{};
    for (int d = 0; d < D; ++d)
    {
        r.free[d] = real(!g.held[set_.config.axes[d]]);
        r.force[d] = real(g.force[set_.config.axes[d]]);
    }
    for (int c = 0; c < S; ++c)
        r.moment[c] = real(D == 2 ? set_.spinSign()*g.moment[set_.config.axes[2]] : g.moment[c]);
    r.freeSpin = real(!g.heldSpin);
    r.gravity = real(g.gravity);
    r.localDamping = real(g.localDamping);
    r.viscous = real(g.viscousDamping);
    r.viscousSpin = real(g.viscousSpinDamping);
    r.damped = g.localDamping > 0 || g.viscousDamping > 0 || g.viscousSpinDamping > 0;
    r.motion = g.motion;
    return r;
}

template<class Backend, int D, class P>
int SolidGroups<Backend, D, P>::motions() const
{
    int count = 0;
    for (const DemGroup& g : set_.input.groups) count = std::max(count, g.motion + 1);
    return count;
}

template<class Backend, int D, class P>
bool SolidGroups<Backend, D, P>::damped() const
{
    for (const DemGroup& g : set_.input.groups) if (of(g).damped) return true;
    return false;
}

} // namespace riprap

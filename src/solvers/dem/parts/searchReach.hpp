/*  How far neighbours are sought, in which cells, and where particles leave the domain.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "dem/lists/sizeClasses.hpp"
#include "solvers/dem/parts/pairTable.hpp"

namespace riprap
{

//- Of a saved state: in which cells particles were sought, and where
struct DemSearchState
{
    // within which walls are listed where steps are fused
    static constexpr double wallSkins = 5;

    RadiusClasses radii;
    double skin = 0;                        // [m]
    double lower[3] = {}, length[3] = {};   // of the box [m]
};

template<class Backend, int D, class P>
class SearchReach
{
public:

    using real = typename P::real;

    // within which walls are listed where steps are fused
    static constexpr double wallSkins = 5;

    RadiusClasses radii;
    SizeClasses<D, P> classes;
    std::int64_t domainMin[D], domainMax[D];    // in the box's units
    real halfSkin = 0;                          // lists hold until a particle has gone so far
    // what a fluid's blow may add to a particle's way at once
    real suddenDisplacement = 0;
    double skin = 0, reach = 0;                 // beyond contact, between surfaces [m]
    // by a fluid, whose coupling chooses steps by the skin
    bool driven = false;
    std::int64_t searchedAt = 0;                // step of the last search

    SearchReach(DemSetting<Backend, D, P>& set, const PairTable<Backend, D, P>& pairs)
        : set_(set), pairs_(pairs)
    {}

    //- For particles of these radii: the least skin, and a box about the domain
    void setBox(const std::vector<double>& radius);
    void set(double skin);
    void setDomain();

    double leastSkin() const;
    double mostSkin(bool surfaces) const;
    double wallCell() const;

    //- To be saved and loaded
    DemSearchState state() const;

private:

    DemSetting<Backend, D, P>& set_;
    const PairTable<Backend, D, P>& pairs_;
};

//- What the search adds to contact unless fast particles need more [m]
template<class Backend, int D, class P>
double SearchReach<Backend, D, P>::leastSkin() const
{
    return (set_.config.skin >= 0 ? set_.config.skin : (Backend::gpu ? 0.1 : 0.15))*2
        *radii.smallest;
}

//- How far the search looks
template<class Backend, int D, class P>
void SearchReach<Backend, D, P>::set(double length)
{
    skin = length;
    halfSkin = real(0.5*length);
    reach = length + pairs_.largestGap();
}

template<class Backend, int D, class P>
void SearchReach<Backend, D, P>::setBox(const std::vector<double>& radius)
{
    const DemConfig& c = set_.config;
    radii = RadiusClasses::of(radius);
    set(leastSkin());
    const double margin = 2*radii.largest + reach;
    for (int d = 0; d < D; ++d)
    {
        const int axis = c.axes[d];
        const double lo = c.domainMin[axis], hi = c.domainMax[axis];
        if (c.periodic[axis] && hi - lo < 3.001*margin)
            throw std::invalid_argument("the periodic domain is " + std::to_string(hi - lo)
                + " m long; it must be at least three times the reach of the largest particles, "
                + std::to_string(3.001*margin) + " m");
        // a margin, so that fixed-point differences across it are never mistaken for near ones
        if (c.periodic[axis]) set_.box.set(d, lo, hi - lo, true);
        else set_.box.set(d, lo - margin, hi - lo + 2*margin, false);
    }
    setDomain();
}

//- Where particles leave, in the box's units, and the cells
template<class Backend, int D, class P>
void SearchReach<Backend, D, P>::setDomain()
{
    for (int d = 0; d < D; ++d)
    {
        const int axis = set_.config.axes[d];
        const bool periodic = set_.config.periodic[axis];
        const double below = set_.config.walled[axis][0]*radii.smallest,
                     above = set_.config.walled[axis][1]*radii.smallest;
        domainMin[d] = periodic ? std::numeric_limits<std::int64_t>::min()
                                : set_.box.toFixed(d, set_.config.domainMin[axis] - below);
        domainMax[d] = periodic ? std::numeric_limits<std::int64_t>::max()
                                : set_.box.toFixed(d, set_.config.domainMax[axis] + above);
    }
    classes.set(set_.box, radii, reach, Backend::gpu);
}

//- Half a diameter; where the domain is periodic what a third of it leaves, and no more than walls
//  there have been repeated for
template<class Backend, int D, class P>
double SearchReach<Backend, D, P>::mostSkin(bool surfaces) const
{
    double most = radii.smallest;
    for (int d = 0; d < D; ++d)
    {
        if (!set_.box.periodic[d]) continue;
        if (surfaces) return leastSkin();
        most = std::min(most, set_.box.length[d]/3.001 - 2*radii.largest - pairs_.largestGap());
    }
    return std::max(most, leastSkin());
}

//- Cells of walls are made once
template<class Backend, int D, class P>
double SearchReach<Backend, D, P>::wallCell() const
{ return radii.largest + leastSkin() + pairs_.largestGap(); }

template<class Backend, int D, class P>
DemSearchState SearchReach<Backend, D, P>::state() const
{
    DemSearchState s;
    s.radii = radii;
    s.skin = skin;
    for (int d = 0; d < D; ++d)
    {
        s.lower[d] = set_.box.lower[d];
        s.length[d] = set_.box.length[d];
    }
    return s;
}

} // namespace riprap

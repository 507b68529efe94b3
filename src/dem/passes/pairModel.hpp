/*  What the passes over contacts share: positions, records, and the parameters of each pair of
    materials.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/state/clock.hpp"
#include "dem/lists/contactList.hpp"
#include "dem/state/solidFields.hpp"
#include "dem/lists/solidRecords.hpp"

namespace riprap
{

//- Without the law's numbers
template<class Backend, int D, class P>
struct PairSetting
{
    using real = typename P::real;

    Box<D, P> box;
    SolidRecords<D, P> solids;
    ContactListView<Backend, real> list;
    const real* gap;                    // of materials a, b: [a*materials + b]
    int materials;
    // the pair of the one material that all particles are of, whatever walls are of; -1: there are
    // several
    int alone;
    real singlePairGap;
    ForceClock clock;
    const int* active;

    HD int pairOf(int a, int b) const { return a*materials + b; }

    //- From i to j, nearest image
    HD Vec<D, real> line(const Vec<D, typename P::position>& xi, const SolidA<D, P>& j) const
    {
        Vec<D, real> dx;
        for (int d = 0; d < D; ++d) dx.c[d] = -box.template separation<real>(d, xi.c[d], j.x[d]);
        return dx;
    }
};

template<class Backend, int D, class P, class Law>
struct PairModel : PairSetting<Backend, D, P>
{
    using Parameters = typename Law::template Parameters<typename P::real>;
    static constexpr int histories = Law::template history<D>;

    const Parameters* parameters;       // as gaps
    Parameters singlePair;              // of `alone`: a kernel's own arguments cost no loads
};

} // namespace riprap

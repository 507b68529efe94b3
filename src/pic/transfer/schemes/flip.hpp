/*  FLIP: particles keep their velocity and take what the step has changed of the grid's (Brackbill
    & Ruppel 1986, J. Comput. Phys. 65):

        v = v + sum W du

    The share of PIC in flipPic.hpp is 0.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/schemes/flipPic.hpp"

namespace riprap
{

struct Flip : SchemeCard
{
    static constexpr const char* word = "flip";
    static constexpr const char* text = "change of the grid's velocity";
    static constexpr TransferEntry entries[] = {transferEntry::affine};

    template<class R> using Formula = Blend<R>;
    template<class R> static Formula<R> make(const TransferProperties&, double)
    {
        return FlipPic::of(R(0));
    }
};

} // namespace riprap

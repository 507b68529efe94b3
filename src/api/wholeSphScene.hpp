/*  An SPH scene on several processes, seen as one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphScene.hpp"

namespace riprap
{

class Transport;

//- What is read back is of all processes, in the order of ids, and there on each of them. Sums are
//  added up by process; a saved state is there on the first, and is that of one process. All make
//  the same calls. part: what this one has (SphConfig::ranks), which outlives the result
std::unique_ptr<SphScene> wholeSphScene(SphScene& part, Transport&);

} // namespace riprap

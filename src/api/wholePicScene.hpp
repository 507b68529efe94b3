/*  A scene of water in cells on several processes, seen as one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/picScene.hpp"

namespace riprap
{

class Transport;

//- What is read back is of all processes, particles in the order of ids, and there on each of them;
//  each may sample points of its own. A saved state is there on the first, and is that of one
//  process. All make the same calls. part: what this one has (PicConfig::ranks), which outlives the
//  result
std::unique_ptr<PicScene> wholePicScene(PicScene& part, Transport&);

} // namespace riprap

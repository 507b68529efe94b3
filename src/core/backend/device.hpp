/*  Which devices there are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include "core/backend/backend.hpp"

namespace riprap
{

//- Number of usable GPUs (0 without CUDA), and why there is none
int gpuCount(std::string& why);

std::string deviceLabel(Cpu);
std::string deviceLabel(Gpu);

} // namespace riprap

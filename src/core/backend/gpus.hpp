/*  GPUs of this machine by number, and which of them is used: one a process.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include <vector>

namespace riprap
{

struct GpuInfo
{
    int number = 0;
    std::string name;
    double memory = 0, free = 0;        // [bytes]; free is known of the GPU in use
};

//- All that can be used, by number; empty: why there is none
std::vector<GpuInfo> gpus(std::string& why);

//- What is wrong with this number, nothing where that GPU is there
std::string gpuFault(int number, const std::vector<GpuInfo>& there, const std::string& why);

//- Scenes that are made after this are on that GPU. For the thread that calls, which makes and
//  moves them
void useGpu(int number);

//- Its memory now. \throw std::runtime_error where there is none
GpuInfo gpuInUse();

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/device.hpp"

#include <fstream>
#include <omp.h>

namespace riprap
{

std::string deviceLabel(Cpu)
{
    std::ifstream info("/proc/cpuinfo");
    std::string line, model = "CPU";
    while (std::getline(info, line))
        if (line.rfind("model name", 0) == 0) { model = line.substr(line.find(':') + 2); break; }
    return model + ", " + std::to_string(omp_get_max_threads()) + " threads";
}

#ifndef RIPRAP_CUDA
int gpuCount(std::string& why)
{
    why = "riprap was built without CUDA";
    return 0;
}
#endif

} // namespace riprap

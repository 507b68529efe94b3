// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/backend/device.hpp"
#include "core/backend/gpus.hpp"

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

std::string gpuFault(int number, const std::vector<GpuInfo>& there, const std::string& why)
{
    for (const GpuInfo& gpu : there) if (gpu.number == number) return "";
    std::string text = "is " + std::to_string(number) + ", and ";
    if (there.empty()) return text + why;
    text += "the GPUs of this machine are";
    const char* separator = " ";
    for (const GpuInfo& gpu : there)
    {
        text += separator + std::to_string(gpu.number) + " (" + gpu.name + ")";
        separator = ", ";
    }
    return text;
}

#ifndef RIPRAP_CUDA
std::vector<GpuInfo> gpus(std::string& why)
{
    gpuCount(why);
    return {};
}

void useGpu(int) {}

GpuInfo gpuInUse()
{
    std::string why;
    gpuCount(why);
    throw std::runtime_error(why);
}

int gpuCount(std::string& why)
{
    why = "riprap was built without CUDA";
    return 0;
}
#endif

} // namespace riprap

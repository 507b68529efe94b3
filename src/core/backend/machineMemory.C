// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/backend/machineMemory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace riprap
{

namespace
{

constexpr double unknown = std::numeric_limits<double>::infinity();

double numberIn(const char* file)
{
    std::ifstream in(file);
    double value = unknown;
    return in >> value ? value : unknown;       // the word max: no limit
}

double ofSystem(const std::string& wanted)
{
    std::ifstream in("/proc/meminfo");
    for (std::string name, line; in >> name; std::getline(in, line))
    {
        double kilobytes = 0;
        if (name == wanted && in >> kilobytes) return 1024*kilobytes;
    }
    return unknown;
}

} // namespace

double freeMemory()
{
    const double limit = numberIn("/sys/fs/cgroup/memory.max"),
                 used = numberIn("/sys/fs/cgroup/memory.current");
    const double inContainer = limit < unknown && used < unknown ? std::max(limit - used, 0.0)
                                                                 : unknown;
    return std::min(ofSystem("MemAvailable:"), inContainer);
}

double machineMemory()
{
    return std::min(ofSystem("MemTotal:"), numberIn("/sys/fs/cgroup/memory.max"));
}

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/backend/machineMemory.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

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

void touchMemory(void* memory, std::size_t bytes)
{
    constexpr std::size_t few = std::size_t(1) << 22;
    if (bytes < few) return;
    const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
    char* const first = static_cast<char*>(memory);
    char* const aligned = first + (page - reinterpret_cast<std::uintptr_t>(first) % page) % page;
    const std::ptrdiff_t pages = (first + bytes - aligned)/std::ptrdiff_t(page);
    // a wish: without it pages are as small as ever
    (void)madvise(aligned, pages*page, MADV_HUGEPAGE);
    #pragma omp parallel for schedule(static)
    for (std::ptrdiff_t k = 0; k < pages; ++k) aligned[k*page] = 0;
}

} // namespace riprap

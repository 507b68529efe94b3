/*  Stable sort of (key, index) pairs and exclusive scans: CUB on the GPU, a parallel LSD radix sort
    on the CPU. Stable and free of atomics, hence deterministic.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/backend/backend.hpp"
#include "core/backend/launch.hpp"
#ifdef __CUDACC__
    #include <cub/device/device_radix_sort.cuh>
    #include <cub/device/device_scan.cuh>
#endif

namespace riprap
{

//- Scratch of sortPairs and exclusiveScan, kept between calls so that graphs can replay them
template<class Backend>
struct SortScratch
{
    Array<Backend, std::uint32_t> keys[2];
    Array<Backend, std::uint32_t> values[2];
    Array<Backend, unsigned char> temporary;
};

#ifdef __CUDACC__

//- Sorts keys[0], values[0] by the low `bits` of the key into keys[1], values[1]; keys[0],
//  values[0] are lost
inline void sortPairs(Context<Gpu>& context, SortScratch<Gpu>& s, int n, int bits)
{
    cub::DoubleBuffer<std::uint32_t> keys(s.keys[0].data(), s.keys[1].data());
    cub::DoubleBuffer<std::uint32_t> values(s.values[0].data(), s.values[1].data());
    std::size_t bytes = 0;
    checkCuda(
        cub::DeviceRadixSort::SortPairs(nullptr, bytes, keys, values, n, 0, bits, context.stream),
        "sort size");
    if (bytes > s.temporary.size()) s.temporary.allocate(context, bytes);
    profiled(context, "sort",
        [&]
        {
            checkCuda(cub::DeviceRadixSort::SortPairs(
                          s.temporary.data(), bytes, keys, values, n, 0, bits, context.stream),
                "sort");
        });
    if (keys.Current() == s.keys[0].data())
    {
        s.keys[0].swap(s.keys[1]);
        s.values[0].swap(s.values[1]);
    }
}

//- data[i] becomes the sum of data[0 .. i-1], n entries
inline void exclusiveScan(Context<Gpu>& context, SortScratch<Gpu>& s, int* data, int n)
{
    std::size_t bytes = 0;
    checkCuda(
        cub::DeviceScan::ExclusiveSum(nullptr, bytes, data, data, n, context.stream), "scan size");
    if (bytes > s.temporary.size()) s.temporary.allocate(context, bytes);
    profiled(context, "scan",
        [&]
        {
            checkCuda(cub::DeviceScan::ExclusiveSum(
                          s.temporary.data(), bytes, data, data, n, context.stream),
                "scan");
        });
}

#else

inline void sortPairs(Context<Cpu>& context, SortScratch<Cpu>& s, int n, int bits)
{
    constexpr int digitBits = 11, radix = 1 << digitBits;
    profiled(context, "sort", [&]
    {
        const int passes = std::max(1, (bits + digitBits - 1)/digitBits);
        const int threads = n < 20000 ? 1 : omp_get_max_threads();
        std::vector<int> offsets(std::size_t(threads)*radix);
        for (int pass = 0; pass < passes; ++pass)
        {
            const std::uint32_t* key = s.keys[0].data();
            const std::uint32_t* value = s.values[0].data();
            std::uint32_t* keyOut = s.keys[1].data();
            std::uint32_t* valueOut = s.values[1].data();
            const int shift = pass*digitBits;
            const auto begin = [&](int t) { return int((long long)n*t/threads); };
            #pragma omp parallel for num_threads(threads) schedule(static, 1)
            for (int t = 0; t < threads; ++t)
            {
                int* count = &offsets[std::size_t(t)*radix];
                std::fill(count, count + radix, 0);
                for (int i = begin(t); i < begin(t + 1); ++i)
                    ++count[(key[i] >> shift) & (radix - 1)];
            }
            int total = 0;
            for (int digit = 0; digit < radix; ++digit)
                for (int t = 0; t < threads; ++t)
                {
                    int& entry = offsets[std::size_t(t)*radix + digit];
                    const int count = entry;
                    entry = total;
                    total += count;
                }
            #pragma omp parallel for num_threads(threads) schedule(static, 1)
            for (int t = 0; t < threads; ++t)
            {
                int* next = &offsets[std::size_t(t)*radix];
                for (int i = begin(t); i < begin(t + 1); ++i)
                {
                    const int to = next[(key[i] >> shift) & (radix - 1)]++;
                    keyOut[to] = key[i];
                    valueOut[to] = value[i];
                }
            }
            if (pass + 1 < passes)
            {
                s.keys[0].swap(s.keys[1]);
                s.values[0].swap(s.values[1]);
            }
        }
    });
}

inline void exclusiveScan(Context<Cpu>& context, SortScratch<Cpu>&, int* data, int n)
{
    profiled(context, "scan", [&]
    {
        int total = 0;
        for (int i = 0; i < n; ++i) { const int count = data[i]; data[i] = total; total += count; }
    });
}

#endif

} // namespace riprap

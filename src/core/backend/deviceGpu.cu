// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/backend/device.hpp"
#include "core/backend/gpus.hpp"

namespace riprap
{

int gpuCount(std::string& why)
{
    int count = 0;
    const cudaError_t e = cudaGetDeviceCount(&count);
    if (e != cudaSuccess)
    {
        why = std::string("there is no usable GPU (") + cudaGetErrorString(e) + ")";
        cudaGetLastError();
        return 0;
    }
    if (!count) why = "there is no GPU";
    return count;
}

std::string deviceLabel(Gpu)
{
    int device = 0;
    cudaDeviceProp p;
    checkCuda(cudaGetDevice(&device), "device");
    checkCuda(cudaGetDeviceProperties(&p, device), "device");
    return std::string(p.name);
}

std::vector<GpuInfo> gpus(std::string& why)
{
    std::vector<GpuInfo> there(gpuCount(why));
    for (int k = 0; k < int(there.size()); ++k)
    {
        cudaDeviceProp p;
        checkCuda(cudaGetDeviceProperties(&p, k), "device");
        there[k].number = k;
        there[k].name = p.name;
        there[k].memory = double(p.totalGlobalMem);
    }
    return there;
}

void useGpu(int number) { checkCuda(cudaSetDevice(number), "device"); }

GpuInfo gpuInUse()
{
    GpuInfo gpu;
    std::size_t free = 0, memory = 0;
    checkCuda(cudaGetDevice(&gpu.number), "device");
    checkCuda(cudaMemGetInfo(&free, &memory), "memory");
    gpu.name = deviceLabel(Gpu());
    gpu.memory = double(memory);
    gpu.free = double(free);
    return gpu;
}

} // namespace riprap

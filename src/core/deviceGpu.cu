// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/device.hpp"

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

} // namespace riprap

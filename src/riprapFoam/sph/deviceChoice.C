/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "deviceChoice.H"
#include "moduleLog.H"
#include "sphNames.H"
#include "core/backend/gpus.hpp"
#include "core/backend/machineMemory.hpp"
#include "api/sphScene.hpp"
#include <cmath>
#include <omp.h>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void useNamedGpu(riprap::DeviceKind asked, const dictionary& dict)
{
    if (!dict.found("gpu")) return;

    if (asked == riprap::DeviceKind::cpu)
    {
        FatalIOErrorInFunction(dict)
            << "Entry gpu names a GPU, and device is cpu: leave gpu out, or"
            << " take auto or gpu for device" << exit(FatalIOError);
    }

    const label number = dict.get<label>("gpu");
    std::string why;
    const std::vector<riprap::GpuInfo> there(riprap::gpus(why));
    const std::string fault(riprap::gpuFault(number, there, why));
    if (!fault.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry gpu " << fault.c_str() << exit(FatalIOError);
    }
    riprap::useGpu(number);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

riprap::DeviceKind readDevice
(
    checkedDictionary& dict,
    riprap::DeviceKind otherwise
)
{
    const label most = 1023;
    dict.whole("gpu", 0, 0, most);
    return dict.choice("device", sphNames::device, otherwise);
}


void useDevice
(
    riprap::DeviceKind asked,
    int dimensions,
    const dictionary& dict
)
{
    try
    {
        riprap::chooseDevice(asked, 1, dimensions);
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(dict)
            << "Entry device: " << e.what() << exit(FatalIOError);
    }
    useNamedGpu(asked, dict);
}


void logDevice
(
    const std::string& name,
    const std::string& reason,
    riprap::DeviceKind taken,
    const std::vector<riprap::ArrayInfo>& arrays
)
{
    scalar memory = riprap::machineMemory(), free = riprap::freeMemory();
    logItem("device");
    if (taken == riprap::DeviceKind::gpu)
    {
        const riprap::GpuInfo gpu(riprap::gpuInUse());
        memory = gpu.memory;
        free = gpu.free;
        Info<< "GPU " << gpu.number << ": ";
    }
    Info<< name.c_str() << " (" << reason.c_str() << ')' << nl;

    logItem("threads") << omp_get_max_threads() << " of the CPU ("
        << (
               std::getenv("OMP_NUM_THREADS")
             ? "OMP_NUM_THREADS"
             : "one a core: OMP_NUM_THREADS is not set"
           )
        << ')' << nl;

    scalar taking = 0;
    for (const riprap::ArrayInfo& array : arrays)
    {
        taking += array.bytes;
    }
    logItem("memory") << bytesText(taking).c_str() << " for the case's arrays";
    if (std::isfinite(memory) && std::isfinite(free))
    {
        Info<< "; the device has " << bytesText(memory).c_str() << ", "
            << bytesText(free).c_str() << " still free";
    }
    Info<< nl;
}

} // End namespace Foam


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "deviceChoice.H"
#include "allRanks.H"
#include "moduleLog.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "sphNames.H"
#include "timeWriter.H"
#include "core/backend/gpus.hpp"
#include "core/backend/machineMemory.hpp"
#include "api/sphScene.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <omp.h>

namespace Foam
{

//- Cores that threads of loops leave to writing
static int leftToWriting = 0;

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


//- Several processes: those of a machine take its GPUs in turn, or all of them
//  the one that is named. A process without one ends them all
static void useGpusInTurn(const dictionary& dict)
{
    const label me = Pstream::myProcNo();
    const std::vector<std::string> hosts(textsOfRanks(hostName()));
    const label before = std::count(hosts.begin(), hosts.begin() + me, hosts[me]);

    std::string why, fault;
    const std::vector<riprap::GpuInfo> there(riprap::gpus(why));
    label number = 0;
    if (dict.found("gpu"))
    {
        number = dict.get<label>("gpu");
        fault = riprap::gpuFault(number, there, why);
        if (!fault.empty()) fault = "Entry gpu " + fault;
    }
    else if (there.empty())
    {
        fault = "Entry device is gpu, but " + why;
    }
    else
    {
        number = there[before % there.size()].number;
    }
    if (!fault.empty())
    {
        fault += ": process " + std::to_string(me) + " on " + hosts[me];
    }
    const std::string first(firstTextOfRanks(fault));
    if (!first.empty())
    {
        FatalIOErrorInFunction(dict) << first.c_str() << exit(FatalIOError);
    }
    riprap::useGpu(number);
}


//- Which processes have which GPU
static void logGpusOfRanks()
{
    if (!Pstream::parRun()) return;

    const riprap::GpuInfo gpu(riprap::gpuInUse());
    std::map<std::string, std::string> sharers;
    label process = 0;
    for
    (
        const std::string& text
      : textsOfRanks
        (
            hostName() + ", GPU " + std::to_string(gpu.number) + " (" + gpu.name + ")"
        )
    )
    {
        sharers[text] += ' ' + std::to_string(process++);
    }
    logItem("GPUs");
    const char* separator = "";
    for (const auto& gpuOf : sharers)
    {
        Info<< separator << gpuOf.first.c_str() << ": processes"
            << gpuOf.second.c_str();
        separator = "; ";
    }
    Info<< nl;
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
    if (Pstream::parRun() && asked == riprap::DeviceKind::gpu)
    {
        return useGpusInTurn(dict);
    }
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


void leaveCoresToWriting(riprap::DeviceKind taken)
{
    if (taken != riprap::DeviceKind::gpu || Pstream::parRun() || std::getenv("OMP_NUM_THREADS"))
    {
        return;
    }
    leftToWriting = timeWriter::threadsBeside;
    omp_set_num_threads(max(1, omp_get_num_procs() - leftToWriting));
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
    if (taken == riprap::DeviceKind::gpu) logGpusOfRanks();

    logItem("threads") << omp_get_max_threads() << " of the CPU ("
        << (
               std::getenv("OMP_NUM_THREADS")
             ? "OMP_NUM_THREADS"
             : leftToWriting
             ? "a quarter of the cores is left to writing: OMP_NUM_THREADS is not set"
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "checkControlDict.H"
#include "scratchCase.hpp"
#include "editedFiles.H"
#include "boxMesh.hpp"
#include "buildInfo.H"
#include "documentation.H"
#include "foamVersions/foamVersions.H"
#include "scriptedModule.hpp"
#include "stopSignals.H"
#include "StringStream.H"
#include "OSspecific.H"
#include "runForecast.H"
#include "scalarField.H"
#include "testTime.H"
#include "timeWriter.H"
#include "runningFluid.hpp"
#include "commandLine.hpp"
#include "postProcessTimes.H"
#include "timeManifest.H"
#include "timePlan.H"
#include <chrono>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>
#include <sys/stat.h>
#include <thread>
namespace controlDictTests
{
#include "controlDict.C"
}
namespace editedFilesTests
{
#include "editedFiles.C"
}
namespace endingsTests
{
#include "endings.C"
}
namespace forecastTests
{
#include "forecast.C"
}
namespace foretellRunTests
{
#include "foretellRun.C"
}
namespace postProcessTimesTests
{
#include "postProcessTimes.C"
}
namespace timePlanTests
{
#include "timePlan.C"
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "checkedDictionary.H"
#include "dimensionSets.H"
#include "scratchCase.hpp"
#include "singleValues.H"
#include "didYouMean.H"
#include "error.H"
#include "testTime.H"
#include "wordList.H"
#include "inputFile.H"
#include "OSspecific.H"
#include "IFstream.H"
#include "macroUse.H"
#include "requireMemory.H"
#include "remedies.H"
#include "solidRemedies.H"
#include "logPrecision.H"
#include "moduleLog.H"
#include "progressClock.H"
#include "sceneNeeds.H"
#include "StringStream.H"
#include "allRanks.H"
#include "boxMesh.hpp"
#include "dividedCloud.H"
#include "pstreamTransport.H"
#include "wholeBoundary.H"
#include "restartRecord.H"
#include "sceneState.H"
#include "timeWriter.H"
#include "checkControlDict.H"
#include "editedFiles.H"
#include "buildInfo.H"
#include "documentation.H"
#include "foamVersions/foamVersions.H"
#include "scriptedModule.hpp"
#include "stopSignals.H"
#include "runForecast.H"
#include "scalarField.H"
#include "runningFluid.hpp"
#include "commandLine.hpp"
#include "postProcessTimes.H"
#include "timeManifest.H"
#include "timePlan.H"
#include "IOField.H"
#include "labelField.H"
#include "labelIOList.H"
#include "vectorField.H"
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <sys/stat.h>
#include <thread>
namespace dictionary_checkedDictionaryTests
{
#include "dictionary/checkedDictionary.C"
}
namespace dictionary_didYouMeanTests
{
#include "dictionary/didYouMean.C"
}
namespace dictionary_inputFileTests
{
#include "dictionary/inputFile.C"
}
namespace dictionary_macrosTests
{
#include "dictionary/macros.C"
}
namespace dictionary_memoryTests
{
#include "dictionary/memory.C"
}
namespace log_remediesTests
{
#include "log/remedies.C"
}
namespace log_sceneNeedsTests
{
#include "log/sceneNeeds.C"
}
namespace ranks_allRanksTests
{
#include "ranks/allRanks.C"
}
namespace restart_restartRecordTests
{
#include "restart/restartRecord.C"
}
namespace restart_sceneStateTests
{
#include "restart/sceneState.C"
}
namespace run_controlDictTests
{
#include "run/controlDict.C"
}
namespace run_editedFilesTests
{
#include "run/editedFiles.C"
}
namespace run_endingsTests
{
#include "run/endings.C"
}
namespace run_forecastTests
{
#include "run/forecast.C"
}
namespace run_foretellRunTests
{
#include "run/foretellRun.C"
}
namespace run_postProcessTimesTests
{
#include "run/postProcessTimes.C"
}
namespace run_timePlanTests
{
#include "run/timePlan.C"
}
namespace writing_manifestTests
{
#include "writing/manifest.C"
}
namespace writing_writingTests
{
#include "writing/writing.C"
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
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
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
namespace checkedDictionaryTests
{
#include "checkedDictionary.C"
}
namespace didYouMeanTests
{
#include "didYouMean.C"
}
namespace inputFileTests
{
#include "inputFile.C"
}
namespace macrosTests
{
#include "macros.C"
}
namespace memoryTests
{
#include "memory.C"
}

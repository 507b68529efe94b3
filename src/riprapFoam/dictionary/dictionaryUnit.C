// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "checkedDictionary.C"
#include "checkedNumbers.C"
#include "didYouMean.C"
#include "inputFile.C"
#include "missingFunction.C"
#include "requireMemory.C"
#include "singleValues.C"

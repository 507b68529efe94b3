// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "caseTime.C"
#include "cellLattice.C"
#include "dividedCloud.C"
#include "lineSeries.C"
#include "locateParticles.C"
#include "particleCloudIO.C"
#include "particleCloudRead.C"
#include "particlePositions.C"
#include "pictures.C"
#include "polyDataWriter.C"
#include "sceneCloud.C"
#include "toStdVector.C"

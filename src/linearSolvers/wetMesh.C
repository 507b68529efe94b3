/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "wetMesh.H"

namespace
{

Foam::labelList labels(const std::vector<int>& from)
{
    Foam::labelList to(Foam::label(from.size()));
    std::copy(from.begin(), from.end(), to.begin());
    return to;
}

}

Foam::wetMesh::wetMesh(const Time& time, const riprap::ReducedSystem& system, labelList&& lower, labelList&& upper)
:
    objectRegistry(IOobject("wetCells", time.timeName(), time, IOobject::NO_READ, IOobject::NO_WRITE)),
    lduPrimitiveMesh(system.rows(), lower, upper, UPstream::worldComm, true),
    system_(system)
{}


Foam::wetMesh::wetMesh(const Time& time, const riprap::ReducedSystem& system)
:
    wetMesh(time, system, labels(system.owner), labels(system.neighbour))
{}


Foam::wetMesh::~wetMesh()
{
    // what solvers have left here may look at the mesh as it goes
    objectRegistry::clear();
}

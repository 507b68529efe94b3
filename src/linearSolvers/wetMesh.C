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

Foam::wetMesh::wetMesh(
    const Time& time, const riprap::ReducedSystem& system, labelList&& lower, labelList&& upper)
    : objectRegistry(
        IOobject("wetCells", time.timeName(), time, IOobject::NO_READ, IOobject::NO_WRITE)),
      lduPrimitiveMesh(system.rows(), lower, upper, UPstream::worldComm, true), system_(system),
      borderFields_(system.borders.size()), borderCoeffs_(system.borders.size()),
      fieldList_(system.borders.size())
{
    if (system.divided) addBorders();
}


void Foam::wetMesh::addBorders()
{
    lduInterfacePtrsList list(system_.borders.size());
    forAll(list, b)
    {
        const riprap::RankBorder& border = system_.borders[b];
        const labelList rows(labels(border.row));
        auto* interface = new processorGAMGInterface(b, rawInterfaces(), rows, labelList(), comm(),
            UPstream::myProcNo(comm()), border.rank, tensorField(), UPstream::msgType());
        list.set(b, interface);
        borderFields_.set(b, new processorGAMGInterfaceField(*interface, false, 0));
        fieldList_.set(b, &borderFields_[b]);
        scalarField* coeffs = new scalarField(rows.size());
        std::transform(border.offDiagonal.begin(), border.offDiagonal.end(), coeffs->begin(),
            [](double a) { return -a; });
        borderCoeffs_.set(b, coeffs);
    }
    // which become the mesh's own
    addInterfaces(list, nonBlockingSchedule<processorGAMGInterface>(list));
}


Foam::wetMesh::wetMesh(const Time& time, const riprap::ReducedSystem& system)
:
    wetMesh(time, system, labels(system.owner), labels(system.neighbour))
{}


Foam::wetMesh::~wetMesh()
{
    // what solvers have left here may look at the mesh as it goes
    objectRegistry::clear();
}

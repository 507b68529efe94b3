// SPDX-License-Identifier: GPL-3.0-or-later

#include "particlePositions.H"
#include "barycentric.H"
#include "tetIndices.H"

#include <cstring>

namespace Foam
{

// nScalars doubles and nLabels labels, in ascii or in one binary block of any label and scalar size
template<std::size_t nScalars, std::size_t nLabels>
static void readEntry(Istream& is, scalar (&s)[nScalars], label (&l)[nLabels])
{
    if (is.format() == IOstream::ASCII)
    {
        is.readBegin("particle");
        for (scalar& value : s) is >> value;
        is.readEnd("particle");
        for (label& value : l) is >> value;
    }
    else if (is.checkLabelSize<label>() && is.checkScalarSize<scalar>())
    {
        char block[sizeof(s) + sizeof(l)];
        is.read(block, sizeof(block));
        std::memcpy(s, block, sizeof(s));
        std::memcpy(l, block + sizeof(s), sizeof(l));
    }
    else
    {
        is.beginRawRead();
        readRawScalar(is, s, nScalars);
        readRawLabel(is, l, nLabels);
        is.endRawRead();
    }
    is.fatalCheck(FUNCTION_NAME);
}


static void checkCell(const polyMesh& mesh, const Istream& is, label i, label celli)
{
    if (celli < 0 || celli >= mesh.nCells())
    {
        FatalIOErrorInFunction(is)
            << "particle " << i << " is in cell " << celli << " of a mesh of " << mesh.nCells()
            << " cells" << exit(FatalIOError);
    }
}


void readPositions(const polyMesh* mesh, Istream& is, particleCloud& c)
{
    forAll(c.position, i)
    {
        scalar x[3];
        label celli[1];
        readEntry(is, x, celli);
        // -1: the cell was not looked for, as in what reconstructPar of v2512 writes
        if (mesh && celli[0] != -1) checkCell(*mesh, is, i, celli[0]);
        c.position[i] = point(x[0], x[1], x[2]);
        c.cell[i] = celli[0];
    }
}


void readCoordinates(const polyMesh& mesh, Istream& is, particleCloud& c)
{
    forAll(c.position, i)
    {
        scalar b[4];
        label tet[3];
        readEntry(is, b, tet);
        checkCell(mesh, is, i, tet[0]);
        c.position[i] =
            tetIndices(tet[0], tet[1], tet[2]).tet(mesh)
           .barycentricToPoint(barycentric(b[0], b[1], b[2], b[3]));
        c.cell[i] = tet[0];
    }
}

} // namespace Foam

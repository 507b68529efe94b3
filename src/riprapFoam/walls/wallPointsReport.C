// SPDX-License-Identifier: GPL-3.0-or-later
/*  Choice of wall patches and geometry, report and output of wall points */

#include "wallPoints.H"
#include "allRanks.H"
#include "pointGrid.H"
#include "coupledPolyPatch.H"
#include "emptyPolyPatch.H"
#include "inputFile.H"
#include "IOdictionary.H"
#include "didYouMean.H"
#include "OSspecific.H"
#include "particleCloudIO.H"
#include "wallPolyPatch.H"

namespace Foam
{

static bool canBeWall(const polyPatch& patch)
{
    return !isA<emptyPolyPatch>(patch) && !isA<coupledPolyPatch>(patch);
}

} // namespace Foam


Foam::labelList Foam::wallPatches(const polyMesh& mesh)
{
    DynamicList<label> ids;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch)) ids.append(patch.index());
    }
    return labelList(ids);
}


Foam::labelList Foam::wallPatches
(
    const polyMesh& mesh,
    const wordRes& names,
    const dictionary& dict
)
{
    wordList valid;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (canBeWall(patch)) valid.append(patch.name());
    }
    for (const wordRe& name : names)
    {
        bool found = false;
        for (const word& patch : valid) found = found || name.match(patch);
        if (!found)
        {
            FatalIOErrorInFunction(dict)
                << "Entry patches: no patch " << name << " that can be a wall; valid ones are "
                << listedFor(name, valid).c_str() << exit(FatalIOError);
        }
    }

    DynamicList<label> ids;
    for (const word& patch : valid)
    {
        if (names.match(patch)) ids.append(mesh.boundaryMesh().findPatchID(patch));
    }
    return labelList(ids);
}


Foam::autoPtr<Foam::geometryWalls> Foam::wallGeometry(const Time& time)
{
    IOobject io(
        "geometry", constantOfCase(time), time, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    if (!isFile(io.objectPath())) return nullptr;
    checkInputFile(io.objectPath(), largestNumber);

    // Passed over, it would leave walls out
    if (!io.typeHeaderOk<IOdictionary>(true, true, false))
    {
        FatalIOErrorInFunction(io.objectPath())
            << "The file does not begin as a dictionary does, with FoamFile { version 2.0; format "
               "ascii; class dictionary;"
            << " object geometry; } after nothing but comments (an #include of a file that is not "
               "there, or a byte-order"
            << " mark, is in the way, too)" << exit(FatalIOError);
    }

    const IOdictionary dict(io);
    try
    {
        return autoPtr<geometryWalls>::New(time, dict);
    }
    catch (const IOerror&)
    {
        throw;
    }
    // OpenFOAM's surfaces do not say in which file they are
    catch (const error& e)
    {
        FatalIOErrorInFunction(dict) << e.message().c_str() << exit(FatalIOError);
    }
    return nullptr;
}


void Foam::reportWallPoints(const wallPoints& w, Ostream& os)
{
    const pointGrid grid(1.5*w.spacing, w.position);
    labelList count(w.names.size(), Zero);
    scalarField least(w.names.size(), GREAT);
    forAll(w.position, i)
    {
        const label s = w.source[i];
        ++count[s];
        least[s] = min(least[s], grid.nearest(w.position[i], i));
    }

    const int precision = os.precision(5);
    os  << "Walls: " << w.size() << " points, spacing " << w.spacing << " m, " << w.layers
       << " layers" << nl;
    forAll(w.names, s)
    {
        os  << "    " << w.names[s] << ": " << count[s] << " points";
        if (count[s]) os << ", nearest two " << least[s]/w.spacing << " spacings apart";
        os  << nl;
    }
    for (const string& note : w.notes) os << "    " << note.c_str() << nl;
    os.precision(precision);
}


void Foam::writeWallPoints(const wallPoints& w, const fileName& file)
{
    HashTable<labelField> labels;
    HashTable<vectorField> vectors;
    labels.set("source", labelField(w.source));
    vectors.set("normal", w.normal);
    writePolyData(file, w.position, labels, HashTable<scalarField>(), vectors);
}

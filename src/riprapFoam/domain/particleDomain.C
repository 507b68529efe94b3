/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleDomain.H"
#include "allRanks.H"
#include "checkedDictionary.H"
#include "cyclicPolyPatch.H"
#include "inputFile.H"
#include "SubField.H"
#include "emptyPolyPatch.H"
#include "IFstream.H"
#include "wallPolyPatch.H"
#include "uniformDimensionedFields.H"
#include "Time.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void readDimensions(const polyMesh& mesh, particleDomain& config)
{
    const Vector<label>& solved = mesh.solutionD();

    int nSolved = 0;
    int empty = 2;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (solved[d] == 1)
        {
            ++nSolved;
        }
        else
        {
            empty = d;
        }
    }

    if (nSolved < 2)
    {
        FatalErrorInFunction
            << "The mesh has " << nSolved << " directions that are not empty: "
            << "particles need two or three" << exit(FatalError);
    }

    config.dimensions = nSolved;
    config.axes[0] = (empty == 0 ? 1 : 0);
    config.axes[1] = (empty == 2 ? 1 : 2);
    config.axes[2] = empty;
}


//- The axis along which this cyclic patch is a copy of its neighbour
static direction periodicAxis
(
    const cyclicPolyPatch& patch,
    const boundBox& bounds
)
{
    const scalar tolerance = 1e-4*bounds.mag();

    // Face-wise, since separation() is empty where OpenFOAM found none
    const vectorField apart
    (
        patch.neighbPatch().faceCentres() - patch.faceCentres()
    );
    const vector mean(average(apart));

    direction axis = 0;
    for (direction d = 1; d < vector::nComponents; ++d)
    {
        if (mag(mean[d]) > mag(mean[axis]))
        {
            axis = d;
        }
    }

    vector along(Zero);
    along[axis] = sign(mean[axis])*bounds.span()[axis];

    if (!patch.parallel() || max(mag(apart - along)) > tolerance)
    {
        FatalErrorInFunction
            << "Patch " << patch.name() << " of type " << patch.type()
            << " cannot be used: particles need periodic patches that are"
            << " moved copies of each other along x, y or z, from one end of"
            << " the mesh to the other" << exit(FatalError);
    }

    return axis;
}


static void checkPatch(const polyPatch& patch)
{
    const bool usable =
    (
        patch.type() == polyPatch::typeName
     || isA<emptyPolyPatch>(patch)
     || isA<wallPolyPatch>(patch)
     || isA<cyclicPolyPatch>(patch)
    );

    if (!usable)
    {
        FatalErrorInFunction
            << "Patch " << patch.name() << " has the type " << patch.type()
            << ", which particles cannot use; valid are wall, patch (open),"
            << " empty and cyclic (constant/polyMesh/boundary). For a symmetry"
            << " plane take a wall with slip freeSlip" << exit(FatalError);
    }
}


static void readGravity(const polyMesh& mesh, particleDomain& config)
{
    const IOobject io
    (
        "g",
        constantOfCase(mesh.time()),
        mesh.time(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    checkInputFile(io.objectPath(), largestNumber);
    IFstream file(io.objectPath());
    if (file.good())
    {
        // v2512 aborts where a dictionary is in their place
        const dictionary entries(file);
        checkedDictionary checked(entries);
        for (const char* name : {"dimensions", "value"}) checked.found(name);
    }
    const uniformDimensionedVectorField g(io);

    if (g.dimensions() != dimAcceleration)
    {
        FatalErrorInFunction
            << "constant/g: entry dimensions is " << g.dimensions()
            << ": it must be " << dimAcceleration << exit(FatalError);
    }

    for (direction d = 0; d < vector::nComponents; ++d)
    {
        config.gravity[d] = g.value()[d];
        // The fastest centrifuges
        if (!(mag(config.gravity[d]) <= 1e7))
        {
            FatalErrorInFunction
                << "constant/g: entry value is " << g.value()
                << ": it must be an acceleration in m/s2, at most 1e7" << exit(FatalError);
        }
    }

    const int empty = config.axes[2];
    if (config.dimensions == 2 && config.gravity[empty] != 0)
    {
        WarningInFunction
            << "constant/g has a component along the empty direction "
            << vector::componentNames[empty] << ", which is ignored" << endl;
        config.gravity[empty] = 0;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

particleDomain readParticleDomain(const polyMesh& mesh)
{
    particleDomain config;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        checkPatch(patch);
    }

    readDimensions(mesh, config);

    for (direction d = 0; d < vector::nComponents; ++d)
    {
        config.domainMin[d] = mesh.bounds().min()[d];
        config.domainMax[d] = mesh.bounds().max()[d];
        config.periodic[d] = false;
    }

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(patch);
        if (cyclic && patch.size())
        {
            config.periodic[periodicAxis(*cyclic, mesh.bounds())] = true;
        }
    }

    readGravity(mesh, config);
    return config;
}


IOdictionary readConstant(const word& file, const Time& time)
{
    const IOobject io
    (
        file,
        constantOfCase(time),
        time,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    checkInputFile(io.objectPath(), largestNumber);
    return IOdictionary(io);
}

} // End namespace Foam


// ************************************************************************* //

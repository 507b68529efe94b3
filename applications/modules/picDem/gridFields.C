/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    p, U and alpha.water on the mesh. U is the mean of a cell's faces; p and U
    are 0 where there is no water. On walls p is that of the cell and what its
    water weighs down to there, so that forces on patches are of second order;
    on patches that are open to the atmosphere it is 0.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "calculatedFvPatchFields.H"
#include "emptyPolyPatch.H"
#include "wallPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

template<class Type>
static void make
(
    autoPtr<GeometricField<Type, fvPatchField, volMesh>>& field,
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions,
    const word& patchType
)
{
    if (field.valid())
    {
        return;
    }
    field.reset
    (
        new GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject
            (
                name,
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            mesh,
            dimensioned<Type>(dimensions, Zero),
            patchType
        )
    );
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::picDem::makeFields()
{
    // What is calculated is written with its values, too
    make
    (
        p_, "p", mesh_, dimPressure,
        calculatedFvPatchField<scalar>::typeName
    );
    make
    (
        U_, "U", mesh_, dimVelocity,
        zeroGradientFvPatchField<vector>::typeName
    );
    make
    (
        alpha_, "alpha.water", mesh_, dimless,
        zeroGradientFvPatchField<scalar>::typeName
    );
}


void Foam::solverModules::picDem::setWallPressure()
{
    const riprap::PicConfig& c = settings_.config;
    const vector weight
    (
        c.density*vector(c.gravity[0], c.gravity[1], c.gravity[2])
    );

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled() || isA<emptyPolyPatch>(patch.patch()))
        {
            continue;
        }
        const scalarField inside(p_->boundaryField()[patchi].patchInternalField());
        const vectorField down(patch.Cf() - patch.Cn());
        scalarField wall(patch.size(), Zero);
        bool opening = false;
        for (const riprap::PicOpening& o : c.openings)
        {
            opening = opening || o.name == patch.name();
        }
        if (opening || isA<wallPolyPatch>(patch.patch()))
        {
            forAll(wall, i)
            {
                // Of a dry cell p is 0
                wall[i] = inside[i] != 0 ? inside[i] + (weight & down[i]) : 0;
            }
        }
        p_->boundaryFieldRef()[patchi] = wall;
    }
}


void Foam::solverModules::picDem::updateFields()
{
    const wallTimes::part timed("fields");
    const riprap::PicGridState state(scene_->grid());
    const labelList& cell = grid_.gridCell();

    forAll(cell, i)
    {
        const label c = cell[i];
        const double* u = &state.velocity[3*c];
        (*p_)[i] = state.pressure[c];
        (*U_)[i] = vector(u[0], u[1], u[2]);
        (*alpha_)[i] = state.water[c];
    }

    p_->correctBoundaryConditions();
    setWallPressure();
    U_->correctBoundaryConditions();
    alpha_->correctBoundaryConditions();
}


// ************************************************************************* //

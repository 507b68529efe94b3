/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    p, U and alpha.water on the mesh. U is the mean of a cell's faces; p and U
    are 0 where there is no water.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
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
    const dimensionSet& dimensions
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
            zeroGradientFvPatchField<Type>::typeName
        )
    );
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::picDem::makeFields()
{
    make(p_, "p", mesh_, dimPressure);
    make(U_, "U", mesh_, dimVelocity);
    make(alpha_, "alpha.water", mesh_, dimless);
}


void Foam::solverModules::picDem::setFields()
{
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
    U_->correctBoundaryConditions();
    alpha_->correctBoundaryConditions();
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gridFields.H"
#include "calculatedFvPatchFields.H"
#include "emptyPolyPatch.H"
#include "foamVersions/foamVersions.H"
#include "timeWriter.H"
#include "wallPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Is written while the run goes on
template<class Type>
class gridField
:
    public writesItself<GeometricField<Type, fvPatchField, volMesh>>
{
    using base = writesItself<GeometricField<Type, fvPatchField, volMesh>>;

protected:

    bool writeAs(const IOstreamOption& how, bool) const override
    {
        const_cast<gridField&>(*this).instance() = this->time().timeName();
        const Field<Type>& values = this->primitiveField();
        const bool listed = values.size() && !values.uniform();

        writtenFile file(*this, this->type(), how.format(), how.compression());
        file.addWritten([&](Ostream& os)
        {
            os.writeEntry("dimensions", this->dimensions());
            this->oriented().writeEntry(os);
            os << nl << nl;
            if (!listed)
            {
                values.writeEntry("internalField", os);
                return;
            }
            os.writeKeyword("internalField") << word("nonuniform") << token::SPACE
                << word("List<" + word(pTraits<Type>::typeName) + '>', false)
                << token::SPACE;
        });
        if (listed)
        {
            file.add(listBody(Field<Type>(values)));
            file.add(";\n");
        }
        file.addWritten([&](Ostream& os)
        {
            os << nl;
            this->boundaryField().writeEntry("boundaryField", os);
        });
        timeWriter::ofRun().put(std::move(file));
        return true;
    }

public:

    using base::base;
};


template<class Type>
static autoPtr<GeometricField<Type, fvPatchField, volMesh>> make
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions,
    const word& patchType
)
{
    return autoPtr<GeometricField<Type, fvPatchField, volMesh>>
    (
        new gridField<Type>
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

void Foam::gridFields::setWallPressure(const riprap::PicConfig& c)
{
    const vector weight
    (
        c.density*vector(c.gravity[0], c.gravity[1], c.gravity[2])
    );

    const fvMesh& mesh = p_->mesh();
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

// What is calculated is written with its values, too
Foam::gridFields::gridFields(const fvMesh& mesh)
:
    p_
    (
        make<scalar>
        (
            "p", mesh, dimPressure,
            calculatedFvPatchField<scalar>::typeName
        )
    ),
    U_
    (
        make<vector>
        (
            "U", mesh, dimVelocity,
            zeroGradientFvPatchField<vector>::typeName
        )
    ),
    alpha_
    (
        make<scalar>
        (
            "alpha.water", mesh, dimless,
            zeroGradientFvPatchField<scalar>::typeName
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::gridFields::update
(
    riprap::PicScene& scene,
    const labelList& cell,
    const riprap::PicConfig& config
)
{
    scene.cellFields
    (
        cell.cdata(),
        cell.size(),
        {
            p_->primitiveFieldRef().data(),
            reinterpret_cast<scalar*>(U_->primitiveFieldRef().data()),
            alpha_->primitiveFieldRef().data()
        }
    );

    p_->correctBoundaryConditions();
    setWallPressure(config);
    U_->correctBoundaryConditions();
    alpha_->correctBoundaryConditions();
}


void Foam::gridFields::write() const
{
    p_->write();
    U_->write();
    alpha_->write();
}


// ************************************************************************* //

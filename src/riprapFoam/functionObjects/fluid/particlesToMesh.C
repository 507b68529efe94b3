/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particlesToMesh.H"
#include "timeWriter.H"
#include "zeroGradientFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(particlesToMesh, 0);
    addToRunTimeSelectionTable(functionObject, particlesToMesh, dictionary);
}
}


namespace
{
    const Foam::wordList validFields({"p", "U", "alpha.water"});
}


// * * * * * * * * * * * * * * *  Constructors * * * * * * * * * * * * * * * //

Foam::functionObjects::particlesToMesh::particlesToMesh
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fluidFunctionObject(name, runTime, dict)
{
    read(dict);
    execute();
    writeFields(true);
}


// * * * * * * * * * * * * * * * *  Fields * * * * * * * * * * * * * * * * * //

template<class Type>
void Foam::functionObjects::particlesToMesh::makeField
(
    autoPtr<GeometricField<Type, fvPatchField, volMesh>>& field,
    const word& name,
    const dimensionSet& dimensions,
    const wordList& asked
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    if (!asked.found(name))
    {
        field.clear();
    }
    else if (!field.valid())
    {
        if (mesh_.foundObject<regIOobject>(name))
        {
            FatalIOErrorInFunction(dict_)
                << "Function object " << this->name() << " of type " << type()
                << ": the mesh has a field " << name << " of another owner"
                << " already. Leave it out of entry fields"
                << exit(FatalIOError);
        }

        field.reset
        (
            new fieldType
            (
                IOobject
                (
                    name,
                    time_.timeName(),
                    mesh_,
                    IOobject::NO_READ,
                    IOobject::NO_WRITE
                ),
                mesh_,
                dimensioned<Type>(dimensions, Zero),
                zeroGradientFvPatchField<Type>::typeName
            )
        );
    }
}


void Foam::functionObjects::particlesToMesh::writeFields(const bool onlyMissing)
{
    if (timeWriter::ofRun().onTrial()) return;

    regIOobject* fields[] = {p_.get(), U_.get(), alpha_.get()};

    for (regIOobject* field : fields)
    {
        if (!field)
        {
            continue;
        }

        const fileName file(time_.timePath()/field->name());

        if (!onlyMissing || !(isFile(file) || isFile(file + ".gz")))
        {
            field->instance() = time_.timeName();
            field->write();
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

bool Foam::functionObjects::particlesToMesh::read(const dictionary& dict)
{
    fluidFunctionObject::read(dict);

    minVolumeFraction_ = fraction(dict, "minVolumeFraction", 0.01);
    ownWriteControl_ = dict.found("writeControl") || dict.found("outputControl");

    const wordList asked(fieldNames(dict, validFields, validFields));

    if (onGrid())
    {
        Info<< type() << ' ' << name() << ": the fields are the solver's own,"
            << " there is nothing to do" << nl << endl;
        return true;
    }
    sph();

    walls_.reset(false);

    makeField(p_, "p", dimPressure, asked);
    makeField(U_, "U", dimVelocity, asked);
    makeField(alpha_, "alpha.water", dimless, asked);

    return true;
}


bool Foam::functionObjects::particlesToMesh::executeSample()
{
    if (onGrid())
    {
        return true;
    }

    const pointField& centres = mesh_.C();
    const riprap::SampleResult all(sample(centres));

    walls_.update(sph(), centres);

    forAll(centres, c)
    {
        const scalar f = all.volumeFraction[c]/walls_.share(c);
        const bool wet = f > minVolumeFraction_;

        if (p_.valid())
        {
            (*p_)[c] =
                wet
              ? all.pressure[c] + walls_.pressure(sph().config(), c)
              : 0;
        }
        if (U_.valid())
        {
            const double* U = &all.velocity[3*c];
            (*U_)[c] = wet ? vector(U[0], U[1], U[2]) : vector(Zero);
        }
        if (alpha_.valid())
        {
            (*alpha_)[c] = min(max(f, scalar(0)), scalar(1));
        }
    }

    if (p_.valid()) p_->correctBoundaryConditions();
    if (U_.valid()) U_->correctBoundaryConditions();
    if (alpha_.valid()) alpha_->correctBoundaryConditions();

    return true;
}


bool Foam::functionObjects::particlesToMesh::writeSample()
{
    if (postProcess || ownWriteControl_ || time_.writeTime())
    {
        writeFields(false);
    }

    return true;
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packedFields.H"
#include "Time.H"
#include <cmath>

namespace Foam
{

void requireCloud(const polyMesh& mesh, const word& cloud)
{
    const Time& time = mesh.time();
    if (!hasParticleCloud(mesh, cloud))
    {
        FatalErrorInFunction
            << "There are no particles at time " << time.timeName() << ": "
            << time.timePath()/"lagrangian"/cloud
            << " has no positions. Has setParticles been run?"
            << exit(FatalError);
    }
}


void requireFinite(const word& cloud, const word& field, label i, scalar value)
{
    if (!std::isfinite(value))
    {
        FatalErrorInFunction
            << "lagrangian/" << cloud << '/' << field << " has the value "
            << value << " at entry " << i << exit(FatalError);
    }
}


void requirePositive(const word& cloud, const word& field, label i, scalar value)
{
    requireFinite(cloud, field, i, value);
    if (!(value > 0))
    {
        FatalErrorInFunction
            << "lagrangian/" << cloud << '/' << field << " has the value "
            << value << " at entry " << i << ": it must be positive"
            << exit(FatalError);
    }
}


std::vector<double> packed
(
    const word& cloud,
    const word& name,
    const vectorField& field
)
{
    std::vector<double> xyz(3*field.size());
    forAll(field, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            requireFinite(cloud, name, i, field[i][d]);
            xyz[3*i + d] = field[i][d];
        }
    }
    return xyz;
}


std::vector<double> packed
(
    const word& cloud,
    const word& name,
    const scalarField& field
)
{
    forAll(field, i)
    {
        requireFinite(cloud, name, i, field[i]);
    }
    return std::vector<double>(field.begin(), field.end());
}


std::vector<double> packedPositive
(
    const word& cloud,
    const word& name,
    const scalarField& field
)
{
    forAll(field, i)
    {
        requirePositive(cloud, name, i, field[i]);
    }
    return std::vector<double>(field.begin(), field.end());
}


std::vector<std::int32_t> uniqueIds
(
    const word& cloud,
    const word& field,
    const labelField& id
)
{
    const labelHashSet seen(id);
    if (seen.size() != id.size() || (id.size() && min(id) < 0))
    {
        FatalErrorInFunction
            << "lagrangian/" << cloud << '/' << field << ": "
            << id.size() - seen.size()
            << " ids occur more than once, the smallest is " << min(id)
            << ": ids must be unique and not negative" << exit(FatalError);
    }
    return std::vector<std::int32_t>(id.begin(), id.end());
}

} // End namespace Foam


// ************************************************************************* //

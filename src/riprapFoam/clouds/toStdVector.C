/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "toStdVector.H"
#include "Time.H"
#include <algorithm>
#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The first of n that is not good(i), n: all are
template<class Good>
static label firstFault(label n, const Good& good)
{
    label first = n;
    #pragma omp parallel for schedule(static) reduction(min : first) if (n > 10000)
    for (label i = 0; i < n; ++i)
    {
        if (!good(i)) first = min(first, i);
    }
    return first;
}


static std::vector<double> copyOf(const scalarField& field)
{
    return std::vector<double>(field.begin(), field.end());
}


//- How many occur more than once
static label repeated(const labelField& id)
{
    const label n = id.size();
    const label most = n ? max(id) : -1;

    // Mostly numbers from 0, of which few are missing
    if (most <= 4*int64_t(n) + 1024)
    {
        label twice = 0;
        std::vector<bool> seen(most + 1, false);
        for (const label i : id)
        {
            if (seen[i]) ++twice;
            seen[i] = true;
        }
        return twice;
    }
    std::vector<label> sorted(id.begin(), id.end());
    std::sort(sorted.begin(), sorted.end());
    return n - label(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void requireCloud(const polyMesh& mesh, const word& cloud)
{
    const Time& time = mesh.time();
    if (!hasParticleCloud(mesh, cloud))
    {
        FatalErrorInFunction
            << "There are no particles at time " << time.timeName() << ": "
            << time.timePath()/"lagrangian"/cloud
            << " has no positions. "
            << (
                   Pstream::parRun()
                 ? "Have setParticles and then decomposePar been run?"
                 : "Has setParticles been run?"
               )
            << " Entries startFrom and startTime of system/controlDict choose the time."
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


std::vector<double> toStdVector
(
    const word& cloud,
    const word& name,
    const vectorField& field
)
{
    const label n = field.size();
    const label fault = firstFault
    (
        n,
        [&](label i)
        {
            const vector& v = field[i];
            return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
        }
    );
    for (direction d = 0; fault < n && d < vector::nComponents; ++d)
    {
        requireFinite(cloud, name, fault, field[fault][d]);
    }

    const scalar* from = reinterpret_cast<const scalar*>(field.cdata());
    return std::vector<double>(from, from + 3*std::size_t(n));
}


std::vector<double> toStdVector
(
    const word& cloud,
    const word& name,
    const scalarField& field
)
{
    const label fault = firstFault
    (
        field.size(), [&](label i) { return std::isfinite(field[i]); }
    );
    if (fault < field.size()) requireFinite(cloud, name, fault, field[fault]);
    return copyOf(field);
}


std::vector<double> toStdVectorPositive
(
    const word& cloud,
    const word& name,
    const scalarField& field
)
{
    const label fault = firstFault
    (
        field.size(),
        [&](label i) { return std::isfinite(field[i]) && field[i] > 0; }
    );
    if (fault < field.size()) requirePositive(cloud, name, fault, field[fault]);
    return copyOf(field);
}


std::vector<std::int32_t> uniqueIds
(
    const word& cloud,
    const word& field,
    const labelField& id
)
{
    const label least = id.size() ? min(id) : 0;
    const label twice = least < 0 ? 0 : repeated(id);
    if (twice || least < 0)
    {
        FatalErrorInFunction
            << "lagrangian/" << cloud << '/' << field << ": " << twice
            << " ids occur more than once, the smallest is " << least
            << ": ids must be unique and not negative" << exit(FatalError);
    }
    return std::vector<std::int32_t>(id.begin(), id.end());
}

} // End namespace Foam


// ************************************************************************* //

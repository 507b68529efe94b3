/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidFunctionObject.H"
#include "dividedCloud.H"
#include "gravityMeshObject.H"
#include "wallPoints.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(fluidFunctionObject, 0);
}
}


// * * * * * * * * * * * * * * * *  The scene  * * * * * * * * * * * * * * * //

bool Foam::functionObjects::fluidFunctionObject::hasScene() const
{
    return onGrid() || mesh_.foundObject<sphSceneObject>(sphSceneObject::typeName);
}


bool Foam::functionObjects::fluidFunctionObject::onGrid() const
{
    return mesh_.foundObject<picSceneObject>(picSceneObject::typeName);
}


void Foam::functionObjects::fluidFunctionObject::noScene
(
    const word& needed,
    const char* solvers
) const
{
    FatalIOErrorInFunction(dict_)
        << "Function object " << name() << " of type " << type()
        << " needs a running particle scene, and there is no "
        << needed << " on mesh " << mesh_.name() << "."
        << nl << "    riprapFoam with " << solvers << " has one, as has its"
        << " option -postProcess; other solvers and the utility postProcess"
        << " have none."
        << exit(FatalIOError);
}


const Foam::sphSceneObject&
Foam::functionObjects::fluidFunctionObject::sph() const
{
    const auto* scene =
        mesh_.cfindObject<sphSceneObject>(sphSceneObject::typeName);

    if (!scene)
    {
        noScene(sphSceneObject::typeName, "solver sphDem");
    }

    return *scene;
}


const Foam::fluidSceneObject&
Foam::functionObjects::fluidFunctionObject::fluid() const
{
    if (onGrid())
    {
        return mesh_.lookupObject<picSceneObject>(picSceneObject::typeName);
    }
    return sph();
}


riprap::SampleResult Foam::functionObjects::fluidFunctionObject::sample
(
    const pointField& points
) const
{
    return fluid().fluidScene().sample(flatPoints(points));
}


riprap::SampleResult Foam::functionObjects::fluidFunctionObject::sample
(
    const pointField& points,
    const riprap::SightPlanes& planes
) const
{
    return fluid().fluidScene().sample(flatPoints(points), planes);
}


Foam::boundBox Foam::functionObjects::fluidFunctionObject::reach() const
{
    boundBox bounds(mesh_.bounds());
    bounds.inflate(fluid().fluidConfig().spacing/bounds.mag());

    if (mesh_.nGeometricD() == 2)
    {
        const label empty = fluid().fluidConfig().axes[2];
        bounds.min()[empty] = -GREAT;
        bounds.max()[empty] = GREAT;
    }

    return bounds;
}


Foam::scalar Foam::functionObjects::fluidFunctionObject::dropThickness() const
{
    return 3*fluid().fluidConfig().spacing;
}


std::vector<bool> Foam::functionObjects::fluidFunctionObject::inSolid
(
    const pointField& points
) const
{
    // Gauges on walls, and in 2D on the front of the mesh, are meant to be inside
    const scalar inwards = 1e-3*fluid().fluidConfig().spacing;
    const point& middle = mesh_.bounds().centre();

    pointField inside(points);
    for (point& x : inside)
    {
        for (Foam::direction d = 0; d < vector::nComponents; ++d)
        {
            x[d] += x[d] < middle[d] ? inwards : -inwards;
            if (mesh_.geometricD()[d] < 0) x[d] = middle[d];
        }
    }

    std::vector<bool> solid(inside.size(), false);
    const boolList fluid(inAnyCell(mesh_, inside));
    forAll(fluid, i)
    {
        solid[i] = !fluid[i];
    }

    const autoPtr<geometryWalls> geometry(wallGeometry(time_));
    for (label body = 0; geometry.valid() && body < geometry->size(); ++body)
    {
        const boolList in(geometry->inSolid(body, inside));
        forAll(in, i)
        {
            if (in[i]) solid[i] = true;
        }
    }
    return solid;
}


// * * * * * * * * * * * * * * * *  Entries * * * * * * * * * * * * * * * * //

Foam::vector Foam::functionObjects::fluidFunctionObject::upDirection
(
    const dictionary& dict
) const
{
    const vector g
    (
        hasScene()
      ? toVector(fluid().fluidConfig().gravity)
      : vector(meshObjects::gravity::New(time_).value())
    );

    // no zero with a sign, which a message would show
    return direction(dict, "up", mag(g) < VSMALL ? vector(0, 1, 0) : vector(Zero) - g);
}


Foam::pointField Foam::functionObjects::fluidFunctionObject::points
(
    const dictionary& dict,
    const word& key
) const
{
    const pointField list(dict.get<pointField>(key));

    if (list.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of function object " << name()
            << " is empty: it is a list of points" << exit(FatalIOError);
    }

    return list;
}


// * * * * * * * * * * * * * * * *  Conversions  * * * * * * * * * * * * * * //

std::vector<double> Foam::functionObjects::flatPoints(const pointField& points)
{
    std::vector<double> flat;
    flat.reserve(3*points.size());

    for (const point& p : points)
    {
        flat.insert(flat.end(), {p.x(), p.y(), p.z()});
    }

    return flat;
}

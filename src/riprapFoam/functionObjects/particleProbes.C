/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleProbes.H"
#include "sphDictionaries.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(particleProbes, 0);
    addToRunTimeSelectionTable(functionObject, particleProbes, dictionary);
}
}


namespace
{
    const Foam::wordList validFields({"p", "U", "rho", "volumeFraction"});

    // Nearer to a wall than this centroid's distance, in spacings, a probe counts as on it
    constexpr double onWall = 0.1;
}


// * * * * * * * * * * * * * * *  Constructors * * * * * * * * * * * * * * * //

Foam::functionObjects::particleProbes::particleProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    sphFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


// * * * * * * * * * * * * * * * *  Entries  * * * * * * * * * * * * * * * * //

bool Foam::functionObjects::particleProbes::read(const dictionary& dict)
{
    sphFunctionObject::read(dict);
    sph();

    locations_ = points(dict, "probeLocations");
    fields_ = fieldNames(dict, wordList({"p", "U"}), validFields);
    minVolumeFraction_ = notNegative(dict, "minVolumeFraction", 0.05);
    correct_ = dict.lookupOrDefault("wallCorrection", true);
    correctSurface_ = dict.lookupOrDefault("surfaceCorrection", false);

    forAll(locations_, i)
    {
        if (!reach().contains(locations_[i]))
        {
            FatalIOErrorInFunction(dict)
                << "Entry probeLocations of function object " << this->name()
                << ": probe " << i << " at " << locations_[i]
                << " is outside of the mesh, which spans "
                << mesh_.bounds().min() << " to " << mesh_.bounds().max()
                << exit(FatalIOError);
        }
    }

    makeSensors(dict);

    return true;
}


Foam::vector Foam::functionObjects::particleProbes::sensorNormal
(
    const dictionary& dict,
    const label i
) const
{
    const vector given(dict.lookupOrDefault("sensorNormal", vector(Zero)));
    vector normal(mag(given) > 0 ? given : walls_.offset(i));

    if (mag(given) == 0 && mag(normal) < onWall*sph().config().spacing)
    {
        FatalIOErrorInFunction(dict)
            << "Entry sensorNormal of function object " << name()
            << " is missing: probe " << i << " at " << locations_[i]
            << " has a sensorRadius and is on no wall" << exit(FatalIOError);
    }

    if (mesh_.nGeometricD() == 2)
    {
        normal[sph().config().axes[2]] = 0;
    }
    if (mag(normal) < 0.1*mag(given))
    {
        FatalIOErrorInFunction(dict)
            << "Entry sensorNormal of function object " << name() << ": "
            << given << " is across the plane of the 2D mesh"
            << exit(FatalIOError);
    }

    return normal/mag(normal);
}


void Foam::functionObjects::particleProbes::makeSensors(const dictionary& dict)
{
    const scalar radius = notNegative(dict, "sensorRadius", 0);
    vector empty(Zero);

    if (mesh_.nGeometricD() == 2)
    {
        empty[sph().config().axes[2]] = 1;
    }

    sensors_.resize(locations_.size());
    walls_.reset(mesh_);
    walls_.update(sph(), locations_);
    points_.clear();

    forAll(locations_, i)
    {
        sensors_[i] =
            radius > 0
          ? makeSensorDisc(locations_[i], sensorNormal(dict, i), empty, radius)
          : sensorDisc{pointField(1, locations_[i]), scalarField(1, 1.0)};

        points_.append(sensors_[i].points);
    }

    walls_.reset(mesh_);
}


// * * * * * * * * * * * * * * * *  Values * * * * * * * * * * * * * * * * * //

Foam::scalar Foam::functionObjects::particleProbes::toPoint
(
    const riprap::SampleResult& all,
    const label point
) const
{
    const riprap::SphConfig& config = sph().config();

    if (correctSurface_)
    {
        scalar gd = 0;
        for (Foam::direction d = 0; d < vector::nComponents; ++d)
        {
            gd += config.gravity[d]*all.centroid[3*point + d];
        }
        return -config.density*gd;
    }

    return correct_ ? walls_.pressure(config, point) : 0;
}


Foam::List<Foam::functionObjects::particleProbes::reading>
Foam::functionObjects::particleProbes::readings()
{
    const riprap::SphConfig& config = sph().config();
    const riprap::SampleResult all(sample(points_));

    if (correct_)
    {
        walls_.update(sph(), points_);
    }

    List<reading> result(sensors_.size());
    label point = 0;

    forAll(sensors_, i)
    {
        reading& r = result[i];
        scalar wet = 0;

        for (const scalar weight : sensors_[i].weights)
        {
            const scalar f = all.volumeFraction[point];
            r.volumeFraction += weight*(correct_ ? f/walls_.share(point) : f);

            if (f >= minVolumeFraction_)
            {
                const double* U = &all.velocity[3*point];
                const scalar p = all.pressure[point] + toPoint(all, point);

                wet += weight;
                r.p += weight*p;
                r.rho += weight*densityOfPressure(config, p);
                r.U += weight*vector(U[0], U[1], U[2]);
            }
            ++point;
        }

        if (wet > 0)
        {
            r.rho /= wet;
            r.U /= wet;
        }
    }

    return result;
}


void Foam::functionObjects::particleProbes::writeTable
(
    const word& field,
    const List<reading>& probes
)
{
    wordList columns;
    List<string> comments(locations_.size());
    forAll(locations_, i)
    {
        const word n(Foam::name(i));
        if (field == "U")
        {
            columns.append(wordList({"Ux" + n, "Uy" + n, "Uz" + n}));
        }
        else
        {
            columns.append((field == "volumeFraction" ? "f" : field) + n);
        }

        OStringStream os;
        os  << "Probe " << i << ' ' << locations_[i];
        comments[i] = os.str();
    }

    OFstream& os = row(field, columns, comments);
    for (const reading& r : probes)
    {
        if (field == "p") add(os, r.p);
        if (field == "rho") add(os, r.rho);
        if (field == "volumeFraction") add(os, r.volumeFraction);
        if (field == "U")
        {
            add(os, r.U.x());
            add(os, r.U.y());
            add(os, r.U.z());
        }
    }
    os  << endl;
}


bool Foam::functionObjects::particleProbes::write()
{
    const List<reading> probes(readings());

    for (const word& field : fields_)
    {
        writeTable(field, probes);
    }

    return true;
}

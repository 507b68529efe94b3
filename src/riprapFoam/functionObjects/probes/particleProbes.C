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
    const Foam::wordList probeFields({"p", "U", "rho", "volumeFraction"});
}


// * * * * * * * * * * * * * * *  Constructors * * * * * * * * * * * * * * * //

Foam::functionObjects::particleProbes::particleProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fluidFunctionObject(name, runTime, dict),
    body_(mesh_)
{
    read(dict);
    writeAtStart();
}


// * * * * * * * * * * * * * * * *  Entries  * * * * * * * * * * * * * * * * //

bool Foam::functionObjects::particleProbes::read(const dictionary& dict)
{
    fluidFunctionObject::read(dict);
    fluid();

    locations_ = points(dict, "probeLocations");
    fields_ = fieldNames(dict, wordList({"p", "U"}), probeFields);
    minVolumeFraction_ = fraction(dict, "minVolumeFraction", 0.05);
    // A grid's pressure needs neither: it is that of the point
    correct_ = dict.lookupOrDefault("wallCorrection", true) && !onGrid();
    correctSurface_ =
        dict.lookupOrDefault("surfaceCorrection", false) && !onGrid();

    readBody(dict);
    requireInside(dict);
    makeSensors(dict);
    readAverage(dict);

    return true;
}


// * * * * * * * * * * * * * * * *  Values * * * * * * * * * * * * * * * * * //

Foam::scalar Foam::functionObjects::particleProbes::toPoint
(
    const riprap::SampleResult& all,
    const label point
) const
{
    if (correctSurface_)
    {
        const riprap::FluidConfig& config = fluid().fluidConfig();
        scalar gd = 0;
        for (Foam::direction d = 0; d < vector::nComponents; ++d)
        {
            gd += config.gravity[d]*all.centroid[3*point + d];
        }
        return -config.density*gd;
    }

    return correct_ ? walls_.pressure(sph().config(), point) : 0;
}


Foam::List<Foam::functionObjects::particleProbes::reading>
Foam::functionObjects::particleProbes::readings()
{
    const riprap::WallPose pose(body_.pose());
    const pointField points(placed(pose, points_));

    if (!onGrid())
    {
        walls_.update(sph(), points, turned(pose, normals_));
    }
    const riprap::SampleResult all
    (
        onGrid() ? sample(points) : sample(points, walls_.planes())
    );

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
                r.rho +=
                    weight
                   *(
                        onGrid()
                      ? fluid().fluidConfig().density
                      : densityOfPressure(sph().config(), p)
                    );
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
    const word& table,
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
        if (body_.there()) os << " on " << body_.name();
        comments[i] = os.str();
    }

    OFstream& os = row(table, columns, comments);
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


bool Foam::functionObjects::particleProbes::writeSample()
{
    const List<reading>& probes = now();

    for (const word& field : fields_)
    {
        writeTable(field, field, probes);
        if (mean_.on())
        {
            writeTable(field, field + "Mean", asReadings(mean_.mean()));
        }
    }

    return true;
}

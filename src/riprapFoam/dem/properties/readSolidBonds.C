/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/solidProperties: kinds of bonds. Which particles they join,
    setParticles decides.

        bonds
        {
            cement
            {
                calibration     moduli;     // direct | moduli | planeStrain
                E               10e6;
                G               4e6;
                radiusFactor    1;
                tensileStrength 1e5;        // none: it never breaks
                shearStrength   1e5;
            }
        }
\*---------------------------------------------------------------------------*/

#include "readSolidProperties.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void readStrength(checkedDictionary& dict, const word& entry, double& strength)
{
    if (!dict.found(entry)) return;

    const token first(dict.dict().lookup(entry));
    if (first.isWord())
    {
        const word typed(dict.dict().get<word>(entry));
        if (typed != "none")
        {
            dict.unknownWord(entry, typed, {"none", "<number>"});
        }
        return;
    }
    strength = dict.positive(entry);
}


static demBondType readBondType(const word& name, const dictionary& entries)
{
    checkedDictionary dict(entries);
    demBondType bond;
    riprap::DemBondType& type = bond.type;

    bond.name = name;
    bond.calibration = dict.choice
    (
        "calibration",
        demNames::calibration,
        calibrationKind::direct
    );
    if (bond.calibration == calibrationKind::direct)
    {
        type.normalStiffness = dict.positive("normalStiffness");
        type.shearStiffness = dict.positive("shearStiffness");
    }
    else
    {
        readCalibration
        (
            dict,
            bond.calibration,
            type.normalStiffness,
            type.shearStiffness
        );
    }

    type.radiusFactor = dict.positive("radiusFactor", type.radiusFactor);
    type.radiusKind =
        dict.choice("radius", demNames::bondRadius, type.radiusKind);
    type.cylinder = dict.either("section", "round", "plate", type.cylinder);
    readStrength(dict, "tensileStrength", type.tensileStrength);
    readStrength(dict, "shearStrength", type.shearStrength);
    type.dampingRatio = dict.notNegative("dampingRatio", type.dampingRatio);
    dict.end();
    return bond;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readSolidBonds(checkedDictionary& solids, demSettings& settings)
{
    const dictionary& all = solids.subDict("bonds");
    for (const entry& e : all)
    {
        settings.bondTypes.append
        (
            readBondType(e.keyword(), namedDict(all, e))
        );
    }
}


// ************************************************************************* //

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
#include "modelReader.H"
#include "dem/bond/bondRadius.hpp"

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
    bond.calibration = modelWord
    (
        dict,
        "calibration",
        riprap::wordsOf(riprap::calibrations()),
        bond.calibration
    );
    const riprap::BondStiffness k =
        readCalibration(dict, riprap::calibrationOf(bond.calibration));
    type.normalStiffness = k.normal;
    type.shearStiffness = k.shear;

    type.radiusFactor = dict.positive("radiusFactor", type.radiusFactor);
    type.radiusKind =
        modelWord(dict, "radius", riprap::wordsOf<riprap::BondRadii>(), type.radiusKind);
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

// SPDX-License-Identifier: GPL-3.0-or-later

#include "rigidEntries.H"
#include "ITstream.H"
#include "principalAxes.H"

namespace Foam
{

static void readMass(checkedDictionary& dict, bool whole, rigidEntries& r)
{
    if (dict.found("density")) r.density = dict.positive("density");
    if (!dict.found("mass")) return;

    const token first(dict.dict().lookup("mass"));
    if (whole && first.isWord())
    {
        if (dict.dict().get<word>("mass") == "cell") return;
        FatalIOErrorInFunction(dict.dict())
            << "Entry mass is " << first.wordToken()
            << ", but the body is rigid: it has the mass of its region. Leave the entry out, or"
            << " give a number [kg] or a density [kg/m3]" << exit(FatalIOError);
    }
    r.mass = dict.positive("mass");
    if (r.density > 0)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entries mass and density are both there: one of them says what the body weighs"
            << exit(FatalIOError);
    }
}


// Of a body: positive, and none larger than the other two together
static void requirePossible(const dictionary& dict, const vector& moments)
{
    const scalar sum = cmptSum(moments);
    if (cmptMin(moments) > 0 && cmptMax(moments) <= (0.5 + 1e-6)*sum) return;
    FatalIOErrorInFunction(dict)
        << "Entry inertia: its principal moments are " << moments
        << "; those of a body are positive, and none is larger than the other"
        << " two together" << exit(FatalIOError);
}


static tensor readTensor(checkedDictionary& dict)
{
    const scalarList I(dict.dict().get<scalarList>("inertia"));
    if (I.size() != 3 && I.size() != 6)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry inertia has " << I.size()
            << " values; valid are (Ixx Iyy Izz) and (Ixx Ixy Ixz Iyy Iyz Izz)"
            << exit(FatalIOError);
    }
    const tensor J(I.size() == 3 ? tensor(I[0], 0, 0, 0, I[1], 0, 0, 0, I[2])
                                 : tensor(I[0], I[1], I[2], I[1], I[3], I[4], I[2], I[4], I[5]));
    tensor axes;
    requirePossible(dict.dict(), principalMoments(J, axes));
    return J;
}

} // namespace Foam


Foam::rigidEntries Foam::readRigid(checkedDictionary& dict, bool planar, bool whole)
{
    rigidEntries r;
    readMass(dict, whole, r);
    r.centred = dict.found("centreOfMass");
    if (r.centred) r.centre = dict.dict().get<point>("centreOfMass");
    r.turned = dict.found("inertia");
    if (r.turned && planar) r.planarInertia = dict.positive("inertia");
    else if (r.turned) r.inertia = readTensor(dict);
    return r;
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "groupMotion.H"
#include "addToRunTimeSelectionTable.H"
#include "boundBox.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(groupMotion, 0);
    addToRunTimeSelectionTable(functionObject, groupMotion, dictionary);
}
}


namespace
{
    using Foam::vector;

    struct Motion
    {
        double particles = 0, mass = 0;
        vector centre = Foam::Zero, velocity = Foam::Zero;
        Foam::boundBox extents = Foam::boundBox(vector::zero, vector::zero);
    };

    Motion motionOf(const riprap::DemState& now, const int group)
    {
        Motion m;
        for (std::size_t i = 0; i < now.id.size(); ++i)
        {
            if (now.group[i] != group) continue;

            const vector x(now.position[3*i], now.position[3*i + 1], now.position[3*i + 2]);
            const vector u(now.velocity[3*i], now.velocity[3*i + 1], now.velocity[3*i + 2]);
            const vector reach(now.radius[i]*vector::one);
            if (m.particles == 0)
            {
                m.extents = Foam::boundBox(x - reach, x + reach);
            }
            m.extents.min() = Foam::min(m.extents.min(), x - reach);
            m.extents.max() = Foam::max(m.extents.max(), x + reach);
            m.particles += 1;
            m.mass += now.mass[i];
            m.centre += now.mass[i]*x;
            m.velocity += now.mass[i]*u;
        }
        if (m.mass > 0)
        {
            m.centre /= m.mass;
            m.velocity /= m.mass;
        }
        return m;
    }
}


Foam::functionObjects::groupMotion::groupMotion
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    demFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


bool Foam::functionObjects::groupMotion::read(const dictionary& dict)
{
    demFunctionObject::read(dict);
    groups_ = groups(dict);
    return true;
}


bool Foam::functionObjects::groupMotion::write()
{
    const riprap::DemState now(dem().scene().particles());
    const wordList names(dem().settings().groupNames());

    wordList columns;
    DynamicList<scalar> values;
    for (const label group : groups_)
    {
        const Motion m(motionOf(now, group));
        const word& name = names[group];
        columns.append
        (
            wordList
            ({
                name + "Particles", name + "CentreX", name + "CentreY", name + "CentreZ", name + "MinX",
                name + "MinY", name + "MinZ", name + "MaxX", name + "MaxY", name + "MaxZ", name + "Ux",
                name + "Uy", name + "Uz", name + "Mass"
            })
        );
        values.append(m.particles);
        for (const vector& v : {m.centre, m.extents.min(), m.extents.max(), m.velocity})
        {
            for (int d = 0; d < vector::nComponents; ++d) values.append(v[d]);
        }
        values.append(m.mass);
    }

    OFstream& os = row(typeName, columns);
    for (const scalar value : values)
    {
        add(os, value);
    }
    os  << endl;
    return true;
}

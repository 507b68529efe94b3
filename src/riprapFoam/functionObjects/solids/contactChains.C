/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactChains.H"
#include "idIndex.H"
#include "addToRunTimeSelectionTable.H"
#include "lineSeries.H"
#include "nearestImage.H"
#include "sceneCloud.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(contactChains, 0);
    addToRunTimeSelectionTable(functionObject, contactChains, dictionary);
}
}


Foam::functionObjects::contactChains::contactChains
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


void Foam::functionObjects::contactChains::writeLines(const riprap::DemContacts& contacts) const
{
    const riprap::DemState& now = dem().motion();
    const idIndex entryOfId(now.id);
    DynamicList<point> points(2*label(now.id.size()));
    for (std::size_t i = 0; i < now.id.size(); ++i)
    {
        points.append(point(now.position[3*i], now.position[3*i + 1], now.position[3*i + 2]));
    }

    const riprap::DemConfig& config = dem().settings().config;
    const label n = contacts.a.size();
    edgeList lines(n);
    lineFields fields;
    labelField wall(n);
    scalarField normal(n);
    const vectorField force(toVectors(contacts.force)), at(toVectors(contacts.point));
    forAll(lines, i)
    {
        wall[i] = contacts.b[i] < 0;
        const label a = entryOfId(contacts.a[i]);
        const label b = wall[i] ? points.size() : entryOfId(contacts.b[i]);
        if (wall[i]) points.append(at[i]);
        const vector way(nearestImage(config, points[b] - points[a]));
        lines[i] = edge(a, endOfLine(points, a, b, way));
        normal[i] = -(force[i] & vector(normalised(way)));
    }
    fields.labels.set("wall", wall);
    fields.scalars.set("normalForce", normal);
    fields.scalars.set("overlap", toField<scalar>(contacts.overlap));
    fields.vectors.set("force", force);
    writeLineSeries(time_, name(), pointField(points), lines, fields);
}


bool Foam::functionObjects::contactChains::writeSample()
{
    const riprap::DemContacts contacts(dem().scene().contacts());
    writeLines(contacts);

    const vectorField force(toVectors(contacts.force));
    label walls = 0;
    scalar deepest = 0;
    forAll(force, i)
    {
        walls += contacts.b[i] < 0;
        deepest = max(deepest, scalar(contacts.overlap[i]));
    }
    const bool any = force.size();

    OFstream& os = row(
        typeName, {"contacts", "wallContacts", "maxForce", "meanForce", "maxOverlap"});
    add(os, force.size());
    add(os, walls);
    add(os, any ? max(mag(force)) : 0);
    add(os, any ? average(mag(force)) : 0);
    add(os, deepest);
    os  << endl;
    return true;
}

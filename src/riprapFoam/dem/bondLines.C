/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Bonds for ParaView: a line each with force, moment, tension (along the
    line, positive when pulled), gap beyond its unstressed one, type, broken.
\*---------------------------------------------------------------------------*/

#include "solidCloud.H"
#include "idIndex.H"
#include "lineSeries.H"
#include "nearestImage.H"
#include "Time.H"

void Foam::writeBondLines
(
    const Time& time,
    const riprap::DemConfig& config,
    const riprap::DemState& particles,
    const riprap::DemBondState& bonds
)
{
    const idIndex entryOfId(particles.id);

    DynamicList<point> position(toVectors(particles.position));
    const vectorField force(toVectors(bonds.force));
    const vectorField moment(toVectors(bonds.moment));

    DynamicList<label> drawn;
    DynamicList<edge> lines;
    DynamicList<vector> ways;
    forAll(force, i)
    {
        // One whose particle has left the scene has no line
        const label a = entryOfId(bonds.a[i]);
        const label b = entryOfId(bonds.b[i]);
        if (a >= 0 && b >= 0)
        {
            drawn.append(i);
            ways.append(nearestImage(config, position[b] - position[a]));
            lines.append(edge(a, endOfLine(position, a, b, ways.last())));
        }
    }

    lineFields fields;
    scalarField tension(drawn.size());
    scalarField stretch(drawn.size());
    forAll(drawn, k)
    {
        const label i = drawn[k];
        // The force on a, which is pulled towards b
        tension[k] = force[i] & vector(normalised(ways[k]));
        stretch[k] = bonds.gap[i] - bonds.restGap[i];
    }
    fields.scalars.set("tension", tension);
    fields.scalars.set("stretch", stretch);
    fields.vectors.set("force", vectorField(force, drawn));
    fields.vectors.set("moment", vectorField(moment, drawn));
    fields.labels.set("type", labelField(toField<label>(bonds.type), drawn));
    fields.labels.set("broken", labelField(toField<label>(bonds.broken), drawn));

    writeLineSeries(time, "bonds", pointField(position), edgeList(lines), fields);
}


// ************************************************************************* //

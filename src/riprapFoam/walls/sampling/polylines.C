// SPDX-License-Identifier: GPL-3.0-or-later

#include "polylines.H"
#include "Map.H"
#include "bitSet.H"

Foam::List<Foam::polyline> Foam::linkEdges
(
    const UList<edge>& edges,
    const std::function<bool(label, label, label)>& isEnd
)
{
    Map<DynamicList<label>> edgesAt;
    forAll(edges, e)
    {
        for (const label p : {edges[e].start(), edges[e].end()}) edgesAt(p).append(e);
    }
    // The edge that continues e at p, or -1
    auto next = [&](label p, label e)
    {
        const auto& here = edgesAt[p];
        if (here.size() != 2) return label(-1);
        const label other = here[0] == e ? here[1] : here[0];
        return isEnd(p, e, other) ? label(-1) : other;
    };

    DynamicList<polyline> lines;
    bitSet used(edges.size());
    auto walk = [&](label p, label e)
    {
        polyline line;
        line.points.append(p);
        while (e >= 0 && !used.test(e))
        {
            used.set(e);
            p = edges[e].otherVertex(p);
            line.edges.append(e);
            line.points.append(p);
            e = next(p, e);
        }
        line.closed = (e >= 0);
        lines.append(line);
    };

    forAll(edges, e)
    {
        for (const label p : {edges[e].start(), edges[e].end()})
        {
            if (!used.test(e) && next(p, e) < 0) walk(p, e);
        }
    }
    forAll(edges, e)
    {
        if (!used.test(e)) walk(edges[e].start(), e);
    }
    return List<polyline>(std::move(lines));
}


Foam::List<Foam::Tuple2<Foam::label, Foam::scalar>> Foam::divideEvenly
(
    const scalarField& lengths,
    scalar spacing
)
{
    const scalar total = sum(lengths);
    const label n = label(total/spacing + 0.5);

    List<Tuple2<label, scalar>> parts(n);
    label segment = 0;
    scalar before = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar at = (i + 0.5)*total/n;
        while (segment + 1 < lengths.size() && before + lengths[segment] < at)
        {
            before += lengths[segment++];
        }
        const scalar fraction = (at - before)/max(lengths[segment], VSMALL);
        parts[i] = Tuple2<label, scalar>(segment, min(max(fraction, scalar(0)), scalar(1)));
    }
    return parts;
}

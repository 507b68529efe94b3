// SPDX-License-Identifier: GPL-3.0-or-later
/*  Generation of wall points: every connected part of the walls is laid by the builder that fits it, then
    points in the fluid, beyond the middle of thin solids, or too near to others are dropped.
*/

#include "wallPoints.H"
#include "pointGrid.H"
#include "wallSurface.H"
#include "particleCloudIO.H"
#include "SortableList.H"

#include <cmath>

namespace Foam
{

class wallGenerator
{
    const wallSpace space_;
    const wallPointsControls& controls_;
    const geometryWalls* bodies_;

    wallCandidates all_;
    DynamicList<label> part_;               // of each candidate: lattices >= 0, own number; others -1
    DynamicList<scalar> rank_;              // of each candidate: the lower stays
    label nParts_ = 0;
    DynamicList<string> notes_;
    labelList first_, lost_;                // by source: points of the first layer, and dropped ones

    bool isFirst(scalar depth) const { return depth < space_.firstOffset + 0.5*space_.spacing; }

    //- Keep what is behind this surface: true distance as laid (thin solids are split in the middle), and
    //  on the solid's side. bodyi < 0: patches
    void drop(const wallSurface&, wallCandidates&, bool lattice, label bodyi);

    scalarField rank(const wallCandidates&, label bodyi) const;

    void dropNear();

public:

    wallGenerator
    (
        const polyMesh& mesh,
        const wallPointsControls& controls,
        const geometryWalls* bodies,
        label nSources
    )
    :
        space_(mesh, controls),
        controls_(controls),
        bodies_(bodies),
        first_(nSources, Zero),
        lost_(nSources, Zero)
    {}

    const wallSpace& space() const { return space_; }

    //- Lay points behind all parts of these elements
    void lay(const wallElements&, label layers, label bodyi, const string& what);

    wallPoints finish(const wordList& names);
};


void wallGenerator::drop(const wallSurface& wall, wallCandidates& c, bool lattice, label bodyi)
{
    boolList keep(c.size(), true);
    if (!lattice)
    {
        const scalarField distance(wall.distance(pointField(c.position)));
        forAll(keep, i) keep[i] = distance[i] > c.depth[i] - 0.25*space_.spacing;
        c.keep(keep);
        keep.setSize(c.size());
        keep = true;
    }

    const bool plate =
        bodyi >= 0 && bodies_->side(bodyi) == geometryWalls::solidSide::both;
    if (bodyi < 0)
    {
        const labelList cell(locateParticles(space_.mesh, pointField(c.position), labelList(), false));
        forAll(keep, i) keep[i] = cell[i] < 0;
    }
    else if (!plate)
    {
        keep = bodies_->inSolid(bodyi, pointField(c.position));
    }

    forAll(keep, i)
    {
        if (plate) c.normal[i] = -c.normal[i];      // away from the middle of the plate
        if (!isFirst(c.depth[i])) continue;
        ++first_[c.source[i]];
        if (!keep[i]) ++lost_[c.source[i]];
    }
    c.keep(keep);
}


// Nothing may take the machine down by a slip in the spacing
static void checkCount(const wallSpace& space, const wallSurface& wall, const string& what)
{
    const scalar n = wall.layers*sum(mag(wall.surface.faceAreas()))/sqr(space.spacing);
    if (n > 1e9)
    {
        FatalErrorInFunction
            << "walls (" << what.c_str() << ") would have about " << n << " points at a spacing of "
            << space.spacing << " m: is it meant?" << exit(FatalError);
    }
}


void wallGenerator::lay(const wallElements& elements, label layers, label bodyi, const string& what)
{
    for (const wallElements& part : connectedParts(elements))
    {
        const wallSurface wall(space_, part, layers);
        checkCount(space_, wall, what);
        wallCandidates c;
        const label nNotes = notes_.size();
        const bool lattice = layLattice(space_, wall, c, notes_);
        for (label i = nNotes; i < notes_.size(); ++i) notes_[i] = what + ": " + notes_[i];
        if (!lattice)
        {
            space_.planar ? layCurves(space_, wall, c) : laySheets(space_, wall, c);
        }
        drop(wall, c, lattice, bodyi);

        all_.position.append(c.position);
        all_.normal.append(c.normal);
        all_.source.append(c.source);
        all_.depth.append(c.depth);
        part_.append(labelList(c.size(), lattice ? nParts_ : -1));
        rank_.append(rank(c, bodyi));
        ++nParts_;
    }
}


// First layers win over deeper ones. Where a body sticks out of the mesh, the patches' own points win.
scalarField wallGenerator::rank(const wallCandidates& c, label bodyi) const
{
    scalarField r(c.depth);
    if (bodyi >= 0)
    {
        const labelList cell(locateParticles(space_.mesh, pointField(c.position), labelList(), false));
        forAll(r, i) if (cell[i] < 0) r[i] += 2*controls_.layers*space_.spacing;
    }
    return r;
}


// Lattices keep their own cells
void wallGenerator::dropNear()
{
    const SortableList<scalar> order(rank_);
    pointGrid taken(controls_.minDistance*space_.spacing);
    boolList keep(all_.size(), true);
    for (const label i : order.indices())
    {
        taken.near
        (
            all_.position[i],
            [&](label other, const vector&, scalar)
            {
                if (part_[i] < 0 || part_[i] != part_[other]) keep[i] = false;
            }
        );
        if (keep[i]) taken.insert(all_.position[i], i);
    }
    all_.keep(keep);
}


wallPoints wallGenerator::finish(const wordList& names)
{
    dropNear();

    forAll(names, i)
    {
        if (lost_[i] <= 0.02*first_[i]) continue;
        OStringStream text;
        text<< names[i] << ": " << lost_[i] << " of " << first_[i] << " points of the first layer would be"
            << " in the fluid and were dropped: the solid there is thinner than the spacing, or it is a"
            << " baffle (make it a plate in constant/geometry)";
        notes_.append(text.str());
    }

    wallPoints w;
    w.position = pointField(all_.position);
    w.normal = vectorField(all_.normal);
    w.source = labelList(all_.source);
    w.names = names;
    w.spacing = controls_.spacing;
    w.layers = controls_.layers;
    w.notes = List<string>(notes_);
    return w;
}

} // namespace Foam


Foam::label Foam::wallPointsControls::layersFor(scalar support, scalar spacing)
{
    // A whole number of spacings must not become one more by round-off
    return max(label(1), label(std::ceil(support/spacing - 1e-6)));
}


Foam::wallPoints Foam::generateWallPoints
(
    const polyMesh& mesh,
    const labelList& patchIDs,
    const geometryWalls* bodies,
    const wallPointsControls& controls
)
{
    if (!(controls.spacing > 0) || controls.layers < 1)
    {
        FatalErrorInFunction
            << "walls need a spacing and layers above zero, not " << controls.spacing << " and "
            << controls.layers << exit(FatalError);
    }
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "wall points are generated on the undecomposed mesh" << exit(FatalError);
    }

    DynamicList<word> names;
    for (const label patchi : patchIDs) names.append(mesh.boundaryMesh()[patchi].name());
    if (bodies) names.append(bodies->names());

    wallGenerator generator(mesh, controls, bodies, names.size());
    const wallSpace& space = generator.space();

    generator.lay(patchElements(space, patchIDs), controls.layers, -1, "patches");
    for (label i = 0; bodies && i < bodies->size(); ++i)
    {
        wallElements elements(bodyElements(space, *bodies, i, patchIDs.size() + i));
        if (bodies->side(i) == geometryWalls::solidSide::both)
        {
            const label half = (controls.layers + 1)/2;
            generator.lay(elements, half, i, bodies->names()[i]);
            elements.flip();
            generator.lay(elements, half, i, bodies->names()[i]);
        }
        else
        {
            generator.lay(elements, controls.layers, i, bodies->names()[i]);
        }
    }
    return generator.finish(wordList(names));
}

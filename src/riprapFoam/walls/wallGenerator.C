// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallGenerator.H"
#include "dividedCloud.H"
#include "pointGrid.H"
#include "requireMemory.H"
#include "SortableList.H"

namespace Foam
{


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
        const boolList fluid(inAnyCell(mesh_, pointField(c.position)));
        forAll(keep, i) keep[i] = !fluid[i];
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
static void checkCount(
    const wallSpace& space, const wallSurface& wall, const string& what, const dictionary& where)
{
    const scalar n = wall.layers*sum(mag(wall.surface.faceAreas()))/sqr(space.spacing);
    // Of the dense set from which a layer of points is chosen
    const scalar bytes = 1000;
    OStringStream walls;
    walls << "Walls (" << what.c_str() << ") would have at " << space.spacing
          << " m (walls/spacing of constant/sphProperties, or else spacing of "
             "system/setParticlesDict)";
    requireMemory(where, walls.str(), n, "points", bytes, "spacing");
}


void wallGenerator::lay(const wallElements& elements, label layers, label bodyi, const string& what)
{
    for (const wallElements& part : connectedParts(elements))
    {
        const wallSurface wall(space_, part, layers);
        checkCount(space_, wall, what, bodyi < 0 ? controls_.where : bodies_->dict(bodyi));
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


// First layers win over deeper ones. Where a body sticks out of the mesh, the patches' own points
// win.
scalarField wallGenerator::rank(const wallCandidates& c, label bodyi) const
{
    scalarField r(c.depth);
    if (bodyi >= 0)
    {
        const boolList fluid(inAnyCell(mesh_, pointField(c.position)));
        forAll(r, i) if (!fluid[i]) r[i] += 2*controls_.layers*space_.spacing;
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
        text<< names[i] << ": " << lost_[i] << " of " << first_[i]
            << " points of the first layer would be"
            << " in the fluid and were dropped: the solid there is thinner than the spacing, or "
                "it is a"
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

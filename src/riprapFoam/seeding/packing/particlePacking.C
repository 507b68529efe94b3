// SPDX-License-Identifier: GPL-3.0-or-later

#include "particlePacking.H"
#include "latticeRows.H"

const Foam::Enum<Foam::particlePacking::kind> Foam::particlePacking::names
({
    {kind::square, "square"},
    {kind::hexagonal, "hexagonal"}
});


Foam::particlePacking::particlePacking
(
    const polyMesh& mesh,
    kind packing,
    scalar spacing,
    const vector& gravity
)
:
    kind_(packing),
    spacing_(spacing),
    planar_(mesh.nGeometricD() == 2),
    axes_{0, 1, 2},
    middle_(0)
{
    DynamicList<direction> solved;
    direction empty = 2;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (mesh.geometricD()[d] > 0) solved.append(d); else empty = d;
    }
    if (solved.size() < 2)
    {
        FatalErrorInFunction << "the mesh has " << solved.size()
                            << " directions that are not empty: particles need 2 or 3"
                            << exit(FatalError);
    }

    // The axis nearest to gravity is stacked last
    direction up = solved.last();
    for (const direction d : solved)
    {
        if (mag(gravity[d]) > mag(gravity[up]) + SMALL) up = d;
    }
    label n = 0;
    for (const direction d : solved) if (d != up) axes_[n++] = d;
    axes_[n++] = up;
    if (planar_)
    {
        axes_[2] = empty;
        middle_ = mesh.bounds().midpoint()[empty];
    }
}


Foam::scalar Foam::particlePacking::estimate(const boundBox& box, const boundBox& limits) const
{
    scalar n = 1, longest = 0;
    for (label i = 0; i < (planar_ ? 2 : 3); ++i)
    {
        const direction axis = axes_[i];
        const scalar low = max(box.min()[axis], limits.min()[axis]),
                     high = min(box.max()[axis], limits.max()[axis]);
        n *= max(high - low, scalar(0))/spacing_;
        // Counted from the box's corner, which may be far outside the limits
        longest = max(longest, (high - box.min()[axis])/spacing_);
    }
    return max(n, longest);
}


Foam::pointField Foam::particlePacking::fill(const boundBox& box, const boundBox& limits) const
{
    return latticeRows(*this, box, limits).points();
}

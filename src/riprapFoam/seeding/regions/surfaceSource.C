// SPDX-License-Identifier: GPL-3.0-or-later
/*  source surface;  file "drop.stl"; // closed, in constant/triSurface; optional: scale 0.001; */

#include "addToRunTimeSelectionTable.H"
#include "closedSurface.H"
#include "particleSource.H"
#include "triSurfaceSearch.H"

namespace Foam
{

class surfaceSource
:
    public volumeSource
{
    std::shared_ptr<const triSurface> surface_;
    autoPtr<triSurfaceSearch> search_;
    dictionary entries_;

public:

    TypeName("surface");

    surfaceSource(checkedDictionary& dict, const Time& time)
    {
        surface_.reset(readClosedSurface(dict, time).ptr());
        search_.reset(new triSurfaceSearch(*surface_));
        entries_ = shapeEntries(dict.dict());
    }

    boundBox bounds() const override { return boundBox(surface_->points(), false); }

    boolList inside(const pointField& points) const override
    {
        return search_->calcInside(points);
    }

    clumpShape shape(const particlePacking& frame) const override
    {
        return closedShape(surface_, frame);
    }

    dictionary surfaceEntries(const particlePacking& frame) const override
    {
        return frame.planar() ? dictionary() : entries_;
    }
};

defineTypeNameAndDebug(surfaceSource, 0);
addToRunTimeSelectionTable(particleSource, surfaceSource, dictionary);

} // namespace Foam

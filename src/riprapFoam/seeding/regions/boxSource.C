// SPDX-License-Identifier: GPL-3.0-or-later
/*  source box;  box (0 0 -1) (0.146 0.292 1);      // two opposite corners */

#include "addToRunTimeSelectionTable.H"
#include "exactShapes.H"
#include "particleSource.H"

namespace Foam
{

class boxSource
:
    public volumeSource
{
    boundBox box_;
    dictionary where_;

public:

    TypeName("box");

    boxSource(checkedDictionary& dict, const Time&)
    :
        box_(boxOf(dict)),
        where_(dict.dict())
    {
        if (cmptMin(box_.span()) <= 0)
        {
            FatalIOErrorInFunction(dict.dict())
                << "Entry box has no volume: its corners are " << box_.min() << " and "
                << box_.max() << exit(FatalIOError);
        }
    }

    boundBox bounds() const override { return box_; }

    boolList inside(const pointField& points) const override
    {
        return boolList(points.size(), true);
    }

    clumpShape shape(const particlePacking& frame) const override
    {
        return boxShape(box_, frame);
    }

    dictionary surfaceEntries(const particlePacking& frame) const override
    {
        if (!frame.planar()) return shapeEntries(where_, {"source", "box"});
        const direction x = frame.axis(0), y = frame.axis(1);
        pointField corners(4, box_.min());
        corners[1][x] = corners[2][x] = box_.max()[x];
        corners[2][y] = corners[3][y] = box_.max()[y];
        dictionary entries;
        entries.add("outline", corners);
        return entries;
    }

    bool straight() const override { return true; }
};

defineTypeNameAndDebug(boxSource, 0);
addToRunTimeSelectionTable(particleSource, boxSource, dictionary);

} // namespace Foam

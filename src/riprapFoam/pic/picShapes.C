/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picShapes.H"
#include "clumpShape.H"
#include "particleCloudIO.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static riprap::PicShape sampled
(
    const word& name,
    const clumpShape& shape,
    const riprap::PicConfig& config,
    scalar cellSize
)
{
    // In cells: distances beyond are needed only to see that nothing is near
    const scalar margin = 2*cellSize;
    const label finest = 100;
    // Less loses of a box of 15 x 7 x 5 cells a hundredth at its edges
    const scalar pointsOfCell = 4;

    // About the principal axes; in 2D about those of the plane
    const pointField corners(shape.box.points());
    boundBox own;
    for (const point& p : corners)
    {
        own.add(shape.axes.T() & (p - shape.middle));
    }

    riprap::PicShape s;
    s.name = name;
    s.step =
        max(cellSize/pointsOfCell, cmptMax(own.span())/finest);
    label points = 1;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        const bool empty = config.dimensions == 2 && d == config.axes[2];
        s.n[d] = empty ? 1 : label((own.span()[d] + 2*margin)/s.step) + 2;
        s.lower[d] =
            empty ? 0 : own.midpoint()[d] - 0.5*(s.n[d] - 1)*s.step;
        points *= s.n[d];
    }

    pointField at(points);
    forAll(at, i)
    {
        const label j = i/s.n[0], k = j/s.n[1];
        const vector y
        (
            s.lower[0] + s.step*(i % s.n[0]),
            s.lower[1] + s.step*(j % s.n[1]),
            s.lower[2] + s.step*k
        );
        at[i] = shape.middle + (shape.axes & y);
    }
    const scalarField distance(shape.distance(at));
    s.distance.assign(distance.begin(), distance.end());
    s.volume = shape.volume;
    return s;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<riprap::PicShape> Foam::picShapes
(
    const Time& time,
    const riprap::PicConfig& config,
    scalar cellSize
)
{
    const dictionary properties(readCloudProperties(time, "solids"));
    const dictionary shapes(properties.subOrEmptyDict("shapes"));
    std::vector<riprap::PicShape> all;
    for (const entry& e : shapes)
    {
        const clumpShape shape
        (
            keptShape(e.dict(), time, config.dimensions, config.axes)
        );
        all.push_back(sampled(e.keyword(), shape, config, cellSize));
    }
    return all;
}


// ************************************************************************* //

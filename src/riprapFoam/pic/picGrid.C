/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picGrid.H"
#include "allRanks.H"
#include "emptyPolyPatch.H"
#include "sceneState.H"
#include "StringStream.H"
#include "SubField.H"
#include "wallPoints.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // In cells: how far a mesh's points may be from those of the grid
    constexpr Foam::scalar tolerance = 1e-3;

    constexpr const char* rule =
        "PIC needs a mesh that is one block of equal squares (2D) or cubes"
        " (3D) along the axes, without grading";

    //- Its number among the openings, -1: it is none
    int openingOf(const Foam::polyPatch& patch, const riprap::PicConfig& config)
    {
        int number = -1;
        for (std::size_t k = 0; k < config.openings.size(); ++k)
        {
            if (config.openings[k].name == patch.name())
            {
                number = int(k);
            }
        }
        return number;
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::label Foam::picGrid::place(const point& middle) const
{
    int index[3] = {0, 0, 0};
    bool fits = true;
    for (int d = 0; d < dimensions_; ++d)
    {
        const int axis = axes_[d];
        const scalar x = (middle[axis] - corner_[axis])/size_;
        index[d] = int(floor(x));
        fits =
            fits && mag(x - index[d] - 0.5) < tolerance
         && index[d] >= 0 && index[d] < cells_[d];
    }
    return fits
      ? index[0] + cells_[0]*(index[1] + cells_[1]*index[2]) : -1;
}


riprap::UniformGrid<3>::Index Foam::picGrid::faceAt
(
    int d,
    const point& middle
) const
{
    riprap::UniformGrid<3>::Index f{{0, 0, 0}};
    for (int e = 0; e < dimensions_; ++e)
    {
        const int axis = axes_[e];
        const scalar x = (middle[axis] - corner_[axis])/size_;
        const int at = int(e == d ? round(x) : floor(x));
        f.c[e] = min(max(at, 0), cells_[e] - (e == d ? 0 : 1));
    }
    return f;
}


std::string Foam::picGrid::differences(const polyMesh& mesh, const vector& edge) const
{
    for (int d = 0; d < dimensions_; ++d)
    {
        if (mag(edge[axes_[d]] - edge[axes_[0]]) > tolerance*edge[axes_[0]])
        {
            OStringStream text;
            text<< "Cell 0 at " << mesh.cellCentres()[0] << " is " << edge[axes_[0]]
                << " m long along " << vector::componentNames[axes_[0]]
                << " and " << edge[axes_[d]] << " m along "
                << vector::componentNames[axes_[d]] << ": " << rule;
            return text.str();
        }
    }
    return std::string();
}


void Foam::picGrid::setSize(const polyMesh& mesh)
{
    // Of the first cell, which owns all its faces; all others must be like it.
    // Processes may have none
    std::string wrong, first;
    if (mesh.nCells())
    {
        DynamicList<label> corners(24);
        for (label f = 0; f < mesh.nFaces(); ++f)
        {
            if (mesh.faceOwner()[f] == 0)
            {
                corners.append(mesh.faces()[f]);
            }
        }
        const vector edge(boundBox(mesh.points(), corners, false).span());
        wrong = differences(mesh, edge);
        first = exact(edge[axes_[0]]);
    }
    stopIfAny(wrong);
    size_ = std::stod(firstTextOfRanks(first));

    // The mean over the mesh has fewer rounding errors than one cell
    const scalar span = mesh.bounds().span()[axes_[0]];
    size_ = span/round(span/size_);

    for (int d = 0; d < 3; ++d)
    {
        cells_[d] = 1;
    }
    for (int d = 0; d < dimensions_; ++d)
    {
        const scalar length = mesh.bounds().span()[axes_[d]];
        cells_[d] = int(round(length/size_));
        if (mag(length - cells_[d]*size_) > tolerance*size_)
        {
            FatalErrorInFunction
                << "The mesh is " << length << " m long along "
                << vector::componentNames[axes_[d]] << ", which is "
                << length/size_ << " cells of " << size_ << " m: " << rule
                << exit(FatalError);
        }
    }
}


void Foam::picGrid::numberCells(const polyMesh& mesh)
{
    gridCell_.resize(mesh.nCells());
    labelList meshCell(cells_[0]*cells_[1]*cells_[2], -1);

    const scalar thickness =
        dimensions_ == 2 ? mesh.bounds().span()[axes_[2]] : size_;
    const scalar volume = sqr(size_)*thickness;

    const vectorField& middles = mesh.cellCentres();
    const scalarField& volumes = mesh.cellVolumes();
    #pragma omp parallel for schedule(static)
    for (label celli = 0; celli < gridCell_.size(); ++celli)
    {
        const bool fits = mag(volumes[celli] - volume) < 10*tolerance*volume;
        gridCell_[celli] = fits ? place(middles[celli]) : -1;
    }

    std::string wrong;
    forAll(gridCell_, celli)
    {
        const label i = gridCell_[celli];
        if (i < 0 || meshCell[i] >= 0)
        {
            OStringStream text;
            text<< "Cell " << celli << " at " << mesh.cellCentres()[celli]
                << ", volume " << mesh.cellVolumes()[celli] << " m3, is not one"
                << " of " << cells_[0] << " x " << cells_[1] << " x "
                << cells_[2] << " equal ones of " << volume << " m3: " << rule;
            wrong = text.str();
            break;
        }
        meshCell[i] = celli;
    }
    stopIfAny(wrong);

    const int64_t all = sumOfRanks(mesh.nCells());
    if (all != meshCell.size())
    {
        FatalErrorInFunction
            << "The mesh has " << all << " cells, and the box around"
            << " it " << meshCell.size() << ": " << rule << exit(FatalError);
    }
}


//- Walls are numbered in the order of wallPatches
void Foam::picGrid::openSides
(
    const polyMesh& mesh,
    const riprap::PicConfig& config
)
{
    riprap::UniformGrid<3> grid;
    for (int d = 0; d < 3; ++d)
    {
        grid.n[d] = cells_[d];
    }
    for (int d = 0; d < dimensions_; ++d)
    {
        openInside(d, grid, !config.openings.empty());
    }

    const labelList walls(wallPatches(mesh));
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(patch))
        {
            setPatch
            (
                patch,
                grid,
                walls.find(patch.index()),
                openingOf(patch, config)
            );
        }
    }
}


void Foam::picGrid::openInside
(
    int d,
    const riprap::UniformGrid<3>& grid,
    bool openings
)
{
    std::vector<double>& open = walls_.aperture[d];
    int last[3] = {cells_[0] - 1, cells_[1] - 1, cells_[2] - 1};
    last[d] += 1;
    open.assign((last[0] + 1)*(last[1] + 1)*(last[2] + 1), 1.0);

    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < open.size(); ++i)
    {
        const int layer = grid.faceIndex(d, int(i)).c[d];
        if (layer == 0 || layer == cells_[d])
        {
            open[i] = 0;
        }
    }
    if (openings)
    {
        walls_.opening[d].assign(open.size(), -1);
    }
    walls_.part[d].assign(open.size(), -1);
}


void Foam::picGrid::setPatch
(
    const polyPatch& patch,
    const riprap::UniformGrid<3>& grid,
    int wall,
    int opening
)
{
    forAll(patch, facei)
    {
        const vector& area = patch.faceAreas()[facei];
        for (int d = 0; d < dimensions_; ++d)
        {
            const scalar along = area[axes_[d]];
            if (mag(along) < 0.5*mag(area))
            {
                continue;
            }
            const int face = grid.face(d, faceAt(d, patch.faceCentres()[facei]));
            if (wall >= 0)
            {
                walls_.part[d][face] = wall;
                continue;
            }
            walls_.aperture[d][face] = 1;
            if (opening >= 0)
            {
                walls_.opening[d][face] = opening;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::picGrid::picGrid(const polyMesh& mesh, const riprap::PicConfig& config)
:
    dimensions_(config.dimensions),
    corner_(mesh.bounds().min())
{
    for (int d = 0; d < 3; ++d)
    {
        axes_[d] = config.axes[d];
    }

    setSize(mesh);
    numberCells(mesh);
    openSides(wholeBoundary(mesh), config);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::picGrid::set(riprap::PicConfig& config) const
{
    config.cellSize = size_;
    for (int d = 0; d < 3; ++d)
    {
        config.cells[axes_[d]] = cells_[d];
    }
}


// ************************************************************************* //

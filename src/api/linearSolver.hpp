/*  Who solves the pressure equation: on the host whoever implements solve(), on the device our
    multigrid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>

namespace riprap
{

//- What fvSolution and the log call our multigrid-preconditioned conjugate gradients, on the CPU
//  too
constexpr const char* ownSolver = "cudaPCG";

struct MultigridControls
{
    double tolerance = 1e-8, relTol = 0;    // of OpenFOAM's residual
    // of the first of a step's two solutions (solvers/pic/driver/projection.hpp); 0: tolerance
    double reflectionTolerance = 0;
    int maxIter = 1000, minIter = 0;
    int sweeps = 2;                         // before and after each correction
};

//- How the solution went, as OpenFOAM prints it
struct PressureReport
{
    double initialResidual = 0, finalResidual = 0;
    int iterations = 0;
    int wetCells = 0;
    bool converged = true;
    const char* solver = "";
};

//- What a free body adds to the matrix: U U^T, with a column of U for each of its ways to move
struct BodyRows
{
    int modes = 0;
    // so much lighter than what it moves that it is worth a deflation (pic/bodies/deflation.hpp)
    bool light = true;
    std::vector<int> row;                   // rows beside it, ascending
    std::vector<double> u;                  // modes values a row
};

//- Faces between wet cells of this rank and of another, in the same order on both
struct RankBorder
{
    int rank = 0;                           // the other: each is in one border at most
    std::vector<int> row;                   // on this side
    std::vector<double> offDiagonal;
};

//- The equations of the wet cells alone: (A + sum of U U^T) x = rhs, A symmetric positive
//  (semi-)definite
struct ReducedSystem
{
    int dimensions = 2;
    int n[3] = {1, 1, 1};                   // the grid,
    bool periodic[3] = {false, false, false};
    std::vector<int> cell;                  // and each row's cell in it, ascending
    // rows of each face between two wet cells: ascending owner, then ascending neighbour
    std::vector<int> owner, neighbour;
    std::vector<double> diagonal, offDiagonal, rhs, x;      // of A alone
    std::vector<BodyRows> bodies;
    // nowhere p = 0: the diagonals of pockets that have been tied leave no trace here
    bool closed = false;
    // a part of a system that all ranks solve together: rows are this rank's own, all bodies (with
    // what rows they have here) are on each
    bool divided = false;
    std::vector<RankBorder> borders;        // if divided

    int rows() const { return int(cell.size()); }
};

class LinearSolver
{
public:
    virtual ~LinearSolver() = default;

    //- Not null: to be solved where the grid is, with these controls
    virtual const MultigridControls* onDevice() const { return nullptr; }

    //- x from a first guess in x
    virtual PressureReport solve(ReducedSystem& system) = 0;

    //- Told after each solution, wherever it was found
    virtual void report(const PressureReport&) {}
};

} // namespace riprap

/*  Deflation of the slow modes that free bodies bring into the pressure equation.

    With Atilde = A + U U^T: Z spans about A^-1 U, found for each body on a box about it (p = 0 beyond) by a few steps of conjugate gradients, and
    Q = Z E^-1 Z^T with E = Z^T Atilde Z. Adapted deflation (A-DEF2; Tang et al. 2009, J. Sci. Comput. 39, 340) preconditions by
    z = w + Q (r - Atilde w), w = B r, and starts from x + Q (b - Atilde x). E is sparse: only bodies whose boxes or neighbours meet share entries. Bodies that are
    not light bring no slow modes and are left out of Z.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "pic/bodies/skyline.hpp"
#include "pic/pressure/linearSolver.hpp"

namespace riprap
{

struct DeflationControls
{
    int localIterations = 8;
    double margin = 0.6;            // of the box about a body, in its own half width
};

class BodyDeflation
{
public:

    BodyDeflation(const ReducedSystem& system, const DeflationControls& controls);

    //- y += U U^T x
    void addBodies(const double* x, double* y) const;

    //- y = (A + U U^T) x
    void product(const double* x, double* y) const;

    //- Of A
    double rowSum(int row) const;

    //- z += Q r
    void correct(const double* r, double* z) const;

    int columns() const { return columns_; }

private:

    using Corner = std::array<int, 3>;

    //- A piece of a vector: rows and their values
    struct Local
    {
        std::vector<int> row;
        std::vector<double> value;          // modes a row
    };

    void connect();
    void placeBodies(double margin);
    Local solveLocally(int body, int iterations);
    void makeCoarse();
    void findMeetings();
    void multiplyPieces();
    void coupleThroughBodies();
    void add(int a, int b, const std::vector<double>& block);

    //- A times a piece, where the piece is (whole_ is zero outside of it): sum over the row
    double rowTimes(int row) const;

    const ReducedSystem& system_;
    std::vector<int> start_, other_;        // neighbours of each row
    std::vector<double> coefficient_;
    std::vector<int> light_;                // bodies in Z; what follows is of these, unless it says body
    std::vector<Corner> low_, high_;        // boxes, cells
    std::vector<int> rowOfCell_;
    std::vector<int> order_, firstColumn_;  // columns of a body stand together
    std::vector<Local> z_;
    std::vector<std::vector<int>> meets_, touches_, seenBy_;    // boxes that meet; bodies that a box touches; of each body, the boxes that do
    int columns_ = 0;
    Skyline coarse_{std::vector<int>()};
    std::vector<double> whole_;             // a row each, zero between uses
};

} // namespace riprap

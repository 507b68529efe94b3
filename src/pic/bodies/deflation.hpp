/*  Deflation of the slow modes that free bodies bring into the pressure equation.

    With Atilde = A + U U^T: Z spans about A^-1 U, found for each body on a box about it (p = 0
    beyond) by a few steps of conjugate gradients, and Q = Z E^-1 Z^T with E = Z^T Atilde Z; between
    bodies that crowd Z has smooth columns as well (hats.hpp). Adapted deflation (A-DEF2; Tang et
    al. 2009, J. Sci. Comput. 39, 340) preconditions by z = w + Q (r - Atilde w), w = B r, and
    starts from x + Q (b - Atilde x). E is sparse: only boxes that meet share entries. Bodies that
    are not light, and motions that hardly move water (a ball's spin), bring no slow modes and are
    left out of Z.

    Of a system that is divided over ranks each has its rows of Z; local solutions go on across
    borders, and E is that of all rows, on each rank: Z and E are those of the undivided system but
    for round-off.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/hats.hpp"
#include "pic/bodies/skyline.hpp"
#include "api/ranks.hpp"

namespace riprap
{

//- Chosen by the iterations of crowds (docs/pressure.md): in 2D what a body does reaches farther
struct DeflationControls
{
    int localIterations = 0;        // 0: 12 in 2D, 8 in 3D
    // of the box about a body, in its own half width; below 0: 1 in 2D, 0.6 in 3D
    double margin = -1;
    double hats = 1.5;              // their spacing in mean widths of the bodies; 0: none
    // between heavy bodies too: for preconditioners that are weak on what is smooth over many
    // bodies. In 2D alone: in 3D they cost more than they save
    bool heavyHats = false;
    bool hatsEverywhere = true;     // in closed water: not only between bodies

    DeflationControls in(int dimensions) const
    {
        DeflationControls c(*this);
        if (c.localIterations == 0) c.localIterations = dimensions == 2 ? 12 : 8;
        if (c.margin < 0) c.margin = dimensions == 2 ? 1 : 0.6;
        // our V-cycle takes as many iterations without them in 3D
        c.hatsEverywhere = hatsEverywhere && (heavyHats || dimensions == 2);
        c.heavyHats = heavyHats && dimensions == 2;
        return c;
    }
};

class BodyDeflation
{
public:

    //- ranks: of a divided system
    BodyDeflation(const ReducedSystem& system, const DeflationControls& controls,
        const Ranks* ranks = nullptr);

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

    void connect();
    void findBoxes();
    void placeBodies(const DeflationControls& controls);
    void findFaces(DeflationPiece& z) const;

    //- Conjugate gradients on the rows of a piece
    struct LocalColumn
    {
        const DeflationPiece* at = nullptr;
        std::vector<double> r, p, q, x;
        double before = 0, moved = 0;
        bool ends = false;
    };
    std::vector<LocalColumn> startLocally(
        const std::vector<const BodyRows*>& bodies, DeflationPiece* z);
    std::vector<double> multiplyLocally(std::vector<LocalColumn>&);
    void iterateLocally(std::vector<LocalColumn>&, int iterations);
    void solveLocally(
        const std::vector<const BodyRows*>& bodies, int iterations, DeflationPiece* z);
    void dropEmpty();
    void order();
    void makeCoarse();
    void findMeetings();
    void uniteTouches();
    std::vector<std::vector<double>> columnsBeyond();
    void findReach(int b, std::vector<int>& seen, std::vector<int>& reach) const;
    void multiplyPieces();
    void coupleThroughBodies();
    void leaveOutConstants();
    void addDividedBodies(const double* x, double* y) const;
    void add(int a, int b, const std::vector<double>& block);

    //- A times a piece, where the piece is (whole_ is zero outside of it): sum over the row
    double rowTimes(int row) const;

    //- Values of columns in the cells beyond the borders, in the order of each piece's `in`.
    //  value(c, i): of column c in the i-th row of its piece
    template<class F>
    std::vector<std::vector<double>> beyond(
        const std::vector<const DeflationPiece*>& columns, const F& value);

    void sum(std::vector<double>& values) const { if (ranks_) ranks_->sum(values); }

    const ReducedSystem& system_;
    const Ranks* ranks_;
    // neighbours of each row; after the rows the cells beyond the borders are counted
    std::vector<int> start_, other_;
    std::vector<double> coefficient_;
    // of each face to another rank: its border, and the row on this side
    std::vector<int> border_, beside_;
    std::vector<CellCorner> beyond_;        // and its cell on the other
    RowsOfCells rowOfCell_;
    std::vector<CellCorner> low_, high_;    // cells beside each body, on all ranks
    std::vector<DeflationPiece> pieces_;    // of light bodies, then hats
    std::vector<int> order_, firstColumn_;  // columns of a piece stand together
    // pieces that meet; bodies that a piece touches; of each body, the pieces that do
    std::vector<std::vector<int>> meets_, touches_, seenBy_;
    int columns_ = 0;
    Skyline coarse_{std::vector<int>()};
    std::vector<double> whole_;             // a row or cell beyond each, zero between uses
};

} // namespace riprap

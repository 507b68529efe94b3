/*  Bodies in the grid, where the grid is: distances, apertures, wall velocities and J, of the
    bodies' blocks alone. What bodies have changed of the grid is put back before they change it
    anew.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "core/loops/sort.hpp"
#include "pic/bodies/bodyRows.hpp"
#include "pic/bodies/placedBodies.hpp"
#include "pic/bodies/wetShares.hpp"

namespace riprap
{

//- The grid that bodies cut: with them, and of walls alone
template<int D, class R>
struct CutFields
{
    R* aperture[D];
    R* wallVelocity[D];
    const R* baseAperture[D];
    const R* baseVelocity[D];       // nullptr: walls rest
    double* distance;               // nodes
    const double* baseDistance;
    double band;                    // that distances are told in [m]
};

//- Of a grid that is a part of the whole block: cells and faces that count in sums over bodies,
//  numbered as in the block
struct CountedOfBodies
{
    CellBox cells, upFaces;         // faces: those across which volumes are measured

    static CountedOfBodies all()
    {
        CountedOfBodies a;
        for (int d = 0; d < 3; ++d)
            a.cells.high[d] = a.upFaces.high[d] = std::numeric_limits<int>::max();
        return a;
    }
};

template<class Backend, int D>
class BodyCut
{
public:

    static constexpr int modes = bodyModes<D>, lanes = rowLanes<Backend>;

    //- The grid as it is without the bodies of the last cut
    template<class R>
    void restore(Context<Backend>& context, const CutFields<D, R>& f)
    {
        RestoreFaces<D, R> faces{sorted(), {}, {}, {}, {}};
        for (int d = 0; d < D; ++d)
        {
            faces.base[d] = f.baseAperture[d];
            faces.baseVelocity[d] = f.baseVelocity[d];
            faces.aperture[d] = f.aperture[d];
            faces.wallVelocity[d] = f.wallVelocity[d];
        }
        forEach(context, shareCount_, faces);
        forEach(context, lanes*rows(),
            RestoreDistances<D, lanes>{blocks(), f.baseDistance, f.distance});
    }

    //- Where bodies are: shape, centre and reach of each. f: of walls alone. up: the direction
    //  across which volumes are measured
    template<class Bodies, class R>
    void cut(Context<Backend>& context, const UniformGrid<D>& grid, const Bodies& bodies, int up,
        const CutFields<D, R>& f, const CountedOfBodies& counted = CountedOfBodies::all());

    //- Where the surface is, shares of what is under water: of bodies with a shape of their own.
    //  \return is there any? Wall velocities are to be set anew then
    template<class R>
    bool cutToWater(Context<Backend>& context, const R* phi, const CutFields<D, R>& f);

    //- Shares as the cut has made them
    template<class R>
    void forgetWater(Context<Backend>& context, const CutFields<D, R>& f)
    {
        if (cutToWater_) forEach(context, shareCount_, keepShares(f, true));
        cutToWater_ = false;
    }

    //- Wall velocities of bodies that move like that: modes values a body
    template<class R>
    void setVelocities(
        Context<Backend>& context, const std::vector<double>& velocity, const CutFields<D, R>& f)
    {
        velocity_.upload(context, velocity);
        BodyFaceVelocities<D, R> v{sorted(), {}, {}, {}, share_.data(), arm_.data(),
            bodyOfShare_.data(), velocity_.data(), {}};
        for (int d = 0; d < D; ++d)
        {
            v.base[d] = f.baseAperture[d];
            v.baseVelocity[d] = f.baseVelocity[d];
            v.aperture[d] = f.aperture[d];
            v.wallVelocity[d] = f.wallVelocity[d];
        }
        forEach(context, shareCount_, v);
    }

    //- f(cell) over the cells about the bodies
    template<class F> void eachCell(Context<Backend>& context, const F& f)
    {
        forEach(context, lanes*rows(), OverBlockCells<D, lanes, F>{blocks(), f});
    }

    //- J^T p of each body, modes values each; of a part of the block its own share
    std::vector<double> gather(Context<Backend>& context, const double* p)
    {
        forEach(context, rows(),
            SumRowsOfBodies<modes>{cellFirst_.data(), cell_.data(), j_.data(), p, ofRow_.data()});
        return sumBodies(context, modes);
    }

    const std::vector<double>& volumes() const { return volume_; }
    //- In place of this part's share: of the whole block
    void setVolumes(const std::vector<double>& all) { volume_ = all; }

    //- What bodies have of the faces of a direction
    std::vector<double> shareOfFaces(int d) const;

    //- For solvers on the host; without masses and velocities
    std::vector<BodyTerm> terms() const;

    BodyBlocks<D> blocks() const { return placed_.blocks(); }
    int bodies() const { return placed_.count(); }
    std::int64_t blockNodes() const { return placed_.nodes(); }
    int rows() const { return placed_.rows(); }
    int entries() const { return entryCount_; }
    const int* firstRow() const { return placed_.firstRow().data(); }
    const int* first() const { return cellFirst_.data(); }
    const int* cell() const { return cell_.data(); }
    const double* j() const { return j_.data(); }

private:

    void measure(Context<Backend>& context);
    void fillRows(Context<Backend>& context, int up);
    void fillCells(Context<Backend>& context);
    template<class R> CloseByBodies<D, R> closeByBodies(const CutFields<D, R>& f);
    template<class R> KeepShares<D, R> keepShares(const CutFields<D, R>& f, bool back);

    ShareRows<D> shares() const
    {
        return {shareFirst_.data(), shareX_.data(), share_.data(), arm_.data()};
    }
    SortedShares<D> sorted() const
    {
        return {FaceKeys<D>(placed_.grid()), shareCount_, scratch_.keys[1].data(),
            scratch_.values[1].data()};
    }

    //- counts[0 .. n - 1] become their sums before each, counts[n] that of all. \return it
    int sumUp(Context<Backend>& context, Array<Backend, int>& counts, int n)
    {
        int all = 0;
        exclusiveScan(context, scratch_, counts.data(), n + 1);
        context.toHost(&all, counts.data() + n, sizeof(int));
        return all;
    }

    std::vector<double> sumBodies(Context<Backend>& context, int values)
    {
        allocateWithRoom(context, ofBody_, std::size_t(bodies())*values);
        forEach(context, bodies()*values,
            SumBodies{values, placed_.firstRow().data(), ofRow_.data(), ofBody_.data()});
        return ofBody_.download();
    }

    PlacedBodies<Backend, D> placed_;
    int shareCount_ = 0, entryCount_ = 0;
    std::vector<double> volume_;
    Array<Backend, int> shareFirst_, shareX_, bodyOfShare_;     // of rows of faces; of shares
    Array<Backend, double> share_;
    Array<Backend, Vec<D, double>> arm_;
    // as the cut has made them, while shares are cut to the water
    Array<Backend, double> keptShare_, keptAperture_;
    Array<Backend, Vec<D, double>> keptArm_;
    bool cutToWater_ = false;
    CountedOfBodies counted_ = CountedOfBodies::all();
    Array<Backend, int> cellFirst_, cellX_, cell_;              // of rows of cells; of entries
    Array<Backend, double> j_, velocity_, ofRow_, ofBody_;
    // keys[1], values[1]: shares by faces
    SortScratch<Backend> scratch_;
};

template<class Backend, int D>
template<class Bodies, class R>
void BodyCut<Backend, D>::cut(Context<Backend>& context, const UniformGrid<D>& grid,
    const Bodies& bodies, int up, const CutFields<D, R>& f, const CountedOfBodies& counted)
{
    counted_ = counted;
    placed_.place(context, grid, bodies);
    measure(context);
    cutToWater_ = false;
    forEach(context, lanes*rows(), LowerDistances<D, lanes>{blocks(), f.band, f.distance});
    forEach(context, shareCount_, closeByBodies(f));
    LeaveSidesAlone<D, R> leave{blocks(), shareFirst_.data(), shareX_.data(), {}, share_.data()};
    for (int d = 0; d < D; ++d) leave.base[d] = f.baseAperture[d];
    forEach(context, D*rows(), leave);
    fillRows(context, up);
}

template<class Backend, int D>
template<class R>
CloseByBodies<D, R> BodyCut<Backend, D>::closeByBodies(const CutFields<D, R>& f)
{
    CloseByBodies<D, R> close{
        sorted(), {}, {}, share_.data(), arm_.data(), blocks(), bodyOfShare_.data(), f.distance};
    for (int d = 0; d < D; ++d)
    {
        close.base[d] = f.baseAperture[d];
        close.aperture[d] = f.aperture[d];
    }
    return close;
}

template<class Backend, int D>
template<class R>
KeepShares<D, R> BodyCut<Backend, D>::keepShares(const CutFields<D, R>& f, bool back)
{
    KeepShares<D, R> keep{sorted(), {}, share_.data(), arm_.data(), keptAperture_.data(),
        keptShare_.data(), keptArm_.data(), back};
    for (int d = 0; d < D; ++d) keep.aperture[d] = f.aperture[d];
    return keep;
}

template<class Backend, int D>
template<class R>
bool BodyCut<Backend, D>::cutToWater(
    Context<Backend>& context, const R* phi, const CutFields<D, R>& f)
{
    forgetWater(context, f);
    if (!placed_.sampled() || !shareCount_) return false;
    allocateWithRoom(context, keptAperture_, shareCount_);
    allocateWithRoom(context, keptShare_, shareCount_);
    allocateWithRoom(context, keptArm_, shareCount_);
    forEach(context, shareCount_, keepShares(f, false));
    forEach(context, shareCount_, CutToWater<D, R>{closeByBodies(f), phi});
    fillCells(context);
    return cutToWater_ = true;
}

//- Shares, sorted by faces
template<class Backend, int D>
void BodyCut<Backend, D>::measure(Context<Backend>& context)
{
    const FaceKeys<D> faces(placed_.grid());
    const int faceRows = D*rows();
    for (auto* a : {&shareFirst_, &shareX_}) allocateWithRoom(context, *a, faceRows + 1);
    forEach(context, faceRows + 1, FindShares<D>{blocks(), shareFirst_.data(), shareX_.data()});
    shareCount_ = sumUp(context, shareFirst_, faceRows);
    allocateWithRoom(context, share_, shareCount_);
    allocateWithRoom(context, arm_, shareCount_);
    allocateWithRoom(context, bodyOfShare_, shareCount_);
    for (int k = 0; k < 2; ++k)
    {
        allocateWithRoom(context, scratch_.keys[k], shareCount_);
        allocateWithRoom(context, scratch_.values[k], shareCount_);
    }
    forEach(context, lanes*faceRows,
        MeasureShares<D, lanes>{blocks(), faces, shareFirst_.data(), shareX_.data(), share_.data(),
            arm_.data(), bodyOfShare_.data(), scratch_.keys[0].data(), scratch_.values[0].data()});
    int bits = 1;
    while ((std::uint64_t(1) << bits) <= faces.none()) ++bits;
    if (shareCount_) sortPairs(context, scratch_, shareCount_, bits);
}

template<class Backend, int D>
void BodyCut<Backend, D>::fillRows(Context<Backend>& context, int up)
{
    allocateWithRoom(context, ofRow_, std::size_t(rows())*modes);
    forEach(context, rows(),
        VolumesOfRows<D>{blocks(), shares(), up, counted_.upFaces, ofRow_.data()});
    volume_ = sumBodies(context, 1);
    for (auto* a : {&cellFirst_, &cellX_}) allocateWithRoom(context, *a, rows() + 1);
    forEach(context, rows() + 1,
        FindBodyCells<D>{blocks(), shares(), cellFirst_.data(), cellX_.data()});
    entryCount_ = sumUp(context, cellFirst_, rows());
    allocateWithRoom(context, cell_, entryCount_);
    allocateWithRoom(context, j_, std::size_t(entryCount_)*modes);
    fillCells(context);
}

template<class Backend, int D>
void BodyCut<Backend, D>::fillCells(Context<Backend>& context)
{
    forEach(context, lanes*rows(),
        FillBodyCells<D, lanes>{
            blocks(), shares(), cellFirst_.data(), cellX_.data(), counted_.cells, cell_.data(),
            j_.data()});
}

template<class Backend, int D>
std::vector<double> BodyCut<Backend, D>::shareOfFaces(int d) const
{
    const FaceKeys<D> faces(placed_.grid());
    const std::vector<std::uint32_t> key = scratch_.keys[1].download(),
                                     number = scratch_.values[1].download();
    const std::vector<double> share = share_.download();
    std::vector<double> sum(placed_.grid().faces(d), 0.0);
    for (int q = 0; q < shareCount_; ++q)
        if (key[q] >= faces.first[d] && key[q] < faces.first[d + 1])
            sum[key[q] - faces.first[d]] += share[number[q]];
    return sum;
}

template<class Backend, int D>
std::vector<BodyTerm> BodyCut<Backend, D>::terms() const
{
    const std::vector<int> firstRow = placed_.firstRow().download(), first = cellFirst_.download(),
                           cell = cell_.download();
    const std::vector<double> j = j_.download();
    std::vector<BodyTerm> all(bodies());
    for (int b = 0; b < bodies(); ++b)
    {
        BodyTerm& t = all[b];
        t.modes = modes;
        t.volume = volume_[b];
        for (int i = first[firstRow[b]]; i < first[firstRow[b + 1]]; ++i)
        {
            bool any = false;
            for (int m = 0; m < modes; ++m) any = any || j[std::size_t(i)*modes + m] != 0;
            if (!any) continue;             // within the body, or beside its box
            t.cell.push_back(cell[i]);
            t.j.insert(t.j.end(), &j[std::size_t(i)*modes], &j[std::size_t(i)*modes] + modes);
        }
    }
    return all;
}

} // namespace riprap

/*  Bodies in the grid, where the grid is: distances, apertures, wall velocities and J, of the
    bodies' blocks alone. What bodies have changed of the grid is put back before they change it
    anew.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include "core/loops/sort.hpp"
#include "pic/bodies/bodyRows.hpp"
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
        forEach(context, lanes*rowCount_,
            RestoreDistances<D, lanes>{blocks(), f.baseDistance, f.distance});
    }

    //- Where bodies are: shape, centre and reach of each. f: of walls alone. up: the direction
    //  across which volumes are measured
    template<class Bodies, class R>
    void cut(Context<Backend>& context, const UniformGrid<D>& grid, const Bodies& bodies, int up,
        const CutFields<D, R>& f);

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
        forEach(context, lanes*rowCount_, OverBlockCells<D, lanes, F>{blocks(), f});
    }

    //- J^T p of each body, modes values each
    std::vector<double> gather(Context<Backend>& context, const double* p)
    {
        forEach(context, rowCount_,
            SumRowsOfBodies<modes>{cellFirst_.data(), cell_.data(), j_.data(), p, ofRow_.data()});
        return sumBodies(context, modes);
    }

    const std::vector<double>& volumes() const { return volume_; }

    //- What bodies have of the faces of a direction
    std::vector<double> shareOfFaces(int d) const;

    //- For solvers on the host; without masses and velocities
    std::vector<BodyTerm> terms() const;

    BodyBlocks<D> blocks() const
    {
        return {grid_, bodyCount_, body_.data(), firstRow_.data(), bodyOfRow_.data(), ball_.data(),
            sampled_.data()};
    }
    int bodies() const { return bodyCount_; }

    //- Nodes of all blocks: of bodies near each other some are counted twice
    std::int64_t blockNodes() const { return blockNodes_; }

    int rows() const { return rowCount_; }
    int entries() const { return entryCount_; }
    const int* firstRow() const { return firstRow_.data(); }
    const int* first() const { return cellFirst_.data(); }
    const int* cell() const { return cell_.data(); }
    const double* j() const { return j_.data(); }

private:

    template<class Bodies> void keepLattices(Context<Backend>& context, const Bodies& bodies);
    template<class Bodies>
    void place(Context<Backend>& context, const UniformGrid<D>& grid, const Bodies& bodies);
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
        return {
            FaceKeys<D>(grid_), shareCount_, scratch_.keys[1].data(), scratch_.values[1].data()};
    }

    //- Numbers differ from step to step: some room to spare, since memory is given and taken back
    //  slowly
    template<class T>
    static void makeRoom(Context<Backend>& context, Array<Backend, T>& a, std::size_t n)
    {
        constexpr int share = 8;
        if (a.bytes() < n*sizeof(T)) a.allocate(context, n + n/share + 1);
        a.allocate(context, n);
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
        makeRoom(context, ofBody_, std::size_t(bodyCount_)*values);
        forEach(context, bodyCount_*values,
            SumBodies{values, firstRow_.data(), ofRow_.data(), ofBody_.data()});
        return ofBody_.download();
    }

    UniformGrid<D> grid_{};
    int bodyCount_ = 0, rowCount_ = 0, shareCount_ = 0, entryCount_ = 0;
    std::int64_t blockNodes_ = 0;
    std::vector<double> volume_;
    Array<Backend, PlacedBody<D>> body_;
    Array<Backend, Ball<D>> ball_;
    Array<Backend, SampledShape<D>> sampled_;
    Array<Backend, double> latticeDistance_;                    // of shapes, one after the other
    std::map<const double*, std::size_t> latticeAt_;            // where those of the host are in it
    Array<Backend, int> firstRow_, bodyOfRow_;                  // of bodies; of rows
    Array<Backend, int> shareFirst_, shareX_, bodyOfShare_;     // of rows of faces; of shares
    Array<Backend, double> share_;
    Array<Backend, Vec<D, double>> arm_;
    // as the cut has made them, while shares are cut to the water
    Array<Backend, double> keptShare_, keptAperture_;
    Array<Backend, Vec<D, double>> keptArm_;
    bool cutToWater_ = false;
    Array<Backend, int> cellFirst_, cellX_, cell_;              // of rows of cells; of entries
    Array<Backend, double> j_, velocity_, ofRow_, ofBody_;
    // keys[1], values[1]: shares by faces
    SortScratch<Backend> scratch_;
};

template<class Backend, int D>
template<class Bodies, class R>
void BodyCut<Backend, D>::cut(Context<Backend>& context, const UniformGrid<D>& grid,
    const Bodies& bodies, int up, const CutFields<D, R>& f)
{
    place(context, grid, bodies);
    measure(context);
    cutToWater_ = false;
    forEach(context, lanes*rowCount_, LowerDistances<D, lanes>{blocks(), f.band, f.distance});
    forEach(context, shareCount_, closeByBodies(f));
    LeaveSidesAlone<D, R> leave{blocks(), shareFirst_.data(), shareX_.data(), {}, share_.data()};
    for (int d = 0; d < D; ++d) leave.base[d] = f.baseAperture[d];
    forEach(context, D*rowCount_, leave);
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
    if (!sampled_.size() || !shareCount_) return false;
    makeRoom(context, keptAperture_, shareCount_);
    makeRoom(context, keptShare_, shareCount_);
    makeRoom(context, keptArm_, shareCount_);
    forEach(context, shareCount_, keepShares(f, false));
    forEach(context, shareCount_, CutToWater<D, R>{closeByBodies(f), phi});
    fillCells(context);
    return cutToWater_ = true;
}

//- Lattices of shapes are copied once: they stay where they are on the host
template<class Backend, int D>
template<class Bodies>
void BodyCut<Backend, D>::keepLattices(Context<Backend>& context, const Bodies& bodies)
{
    std::vector<double> all;
    for (const auto& b : bodies)
    {
        const ShapeLattice<D>& l = b.shape.sampled.lattice;
        if (!l.distance || latticeAt_.count(l.distance)) continue;
        if (all.empty()) all = latticeDistance_.download();
        latticeAt_[l.distance] = all.size();
        all.insert(all.end(), l.distance, l.distance + l.points());
    }
    if (!all.empty()) latticeDistance_.upload(context, all);
}

template<class Backend, int D>
template<class Bodies>
void BodyCut<Backend, D>::place(
    Context<Backend>& context, const UniformGrid<D>& grid, const Bodies& bodies)
{
    std::vector<PlacedBody<D>> placed(bodies.size());
    std::vector<Ball<D>> balls;
    std::vector<SampledShape<D>> sampled;
    std::vector<int> firstRow(1, 0);
    keepLattices(context, bodies);
    blockNodes_ = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        PlacedBody<D>& p = placed[b];
        p.centre = bodies[b].centre;
        p.firstBall = int(balls.size());
        const auto& own = bodies[b].shape.balls.balls;
        p.balls = int(own.size());
        balls.insert(balls.end(), own.begin(), own.end());
        p.sampled = bodies[b].shape.hasOwn() ? int(sampled.size()) : -1;
        if (p.sampled >= 0)
        {
            sampled.push_back(bodies[b].shape.sampled);
            const double*& distance = sampled.back().lattice.distance;
            distance = latticeDistance_.data() + latticeAt_[distance];
        }
        p.setBlock(grid, bodies[b].reach);
        firstRow.push_back(firstRow.back() + p.rows());
        blockNodes_ += std::int64_t(p.size[0])*p.rows();
    }
    grid_ = grid;
    bodyCount_ = int(bodies.size());
    rowCount_ = firstRow.back();
    body_.upload(context, placed);
    ball_.upload(context, balls);
    sampled_.upload(context, sampled);
    firstRow_.upload(context, firstRow);
    makeRoom(context, bodyOfRow_, rowCount_);
    forEach(context, rowCount_, BodiesOfRows{bodyCount_, firstRow_.data(), bodyOfRow_.data()});
}

//- Shares, sorted by faces
template<class Backend, int D>
void BodyCut<Backend, D>::measure(Context<Backend>& context)
{
    const FaceKeys<D> faces(grid_);
    const int rows = D*rowCount_;
    for (auto* a : {&shareFirst_, &shareX_}) makeRoom(context, *a, rows + 1);
    forEach(context, rows + 1, FindShares<D>{blocks(), shareFirst_.data(), shareX_.data()});
    shareCount_ = sumUp(context, shareFirst_, rows);
    makeRoom(context, share_, shareCount_);
    makeRoom(context, arm_, shareCount_);
    makeRoom(context, bodyOfShare_, shareCount_);
    for (int k = 0; k < 2; ++k)
    {
        makeRoom(context, scratch_.keys[k], shareCount_);
        makeRoom(context, scratch_.values[k], shareCount_);
    }
    forEach(context, lanes*rows,
        MeasureShares<D, lanes>{blocks(), faces, shareFirst_.data(), shareX_.data(), share_.data(),
            arm_.data(), bodyOfShare_.data(), scratch_.keys[0].data(), scratch_.values[0].data()});
    int bits = 1;
    while ((std::uint64_t(1) << bits) <= faces.none()) ++bits;
    if (shareCount_) sortPairs(context, scratch_, shareCount_, bits);
}

template<class Backend, int D>
void BodyCut<Backend, D>::fillRows(Context<Backend>& context, int up)
{
    makeRoom(context, ofRow_, std::size_t(rowCount_)*modes);
    forEach(context, rowCount_, VolumesOfRows<D>{blocks(), shares(), up, ofRow_.data()});
    volume_ = sumBodies(context, 1);
    for (auto* a : {&cellFirst_, &cellX_}) makeRoom(context, *a, rowCount_ + 1);
    forEach(context, rowCount_ + 1,
        FindBodyCells<D>{blocks(), shares(), cellFirst_.data(), cellX_.data()});
    entryCount_ = sumUp(context, cellFirst_, rowCount_);
    makeRoom(context, cell_, entryCount_);
    makeRoom(context, j_, std::size_t(entryCount_)*modes);
    fillCells(context);
}

template<class Backend, int D>
void BodyCut<Backend, D>::fillCells(Context<Backend>& context)
{
    forEach(context, lanes*rowCount_,
        FillBodyCells<D, lanes>{
            blocks(), shares(), cellFirst_.data(), cellX_.data(), cell_.data(), j_.data()});
}

template<class Backend, int D>
std::vector<double> BodyCut<Backend, D>::shareOfFaces(int d) const
{
    const FaceKeys<D> faces(grid_);
    const std::vector<std::uint32_t> key = scratch_.keys[1].download(),
                                     number = scratch_.values[1].download();
    const std::vector<double> share = share_.download();
    std::vector<double> sum(grid_.faces(d), 0.0);
    for (int q = 0; q < shareCount_; ++q)
        if (key[q] >= faces.first[d] && key[q] < faces.first[d + 1])
            sum[key[q] - faces.first[d]] += share[number[q]];
    return sum;
}

template<class Backend, int D>
std::vector<BodyTerm> BodyCut<Backend, D>::terms() const
{
    const std::vector<int> firstRow = firstRow_.download(), first = cellFirst_.download(),
                           cell = cell_.download();
    const std::vector<double> j = j_.download();
    std::vector<BodyTerm> all(bodyCount_);
    for (int b = 0; b < bodyCount_; ++b)
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

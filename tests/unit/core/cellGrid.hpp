/*  CellGrid and CellSort: every neighbour within the radius is visited exactly once, whatever the
    grid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "core/neighbours/cellSort.hpp"

namespace riprap
{
namespace
{

template<class C>
struct GridKeys
{
    static constexpr const char* name = "gridKeys";
    static constexpr int D = C::D;
    CellGrid<D, typename C::P> grid;
    const Vec<D, typename C::real>* x;
    std::uint32_t* keys;
    std::uint32_t* indices;

    HD void operator()(int i) const
    {
        keys[i] = std::uint32_t(grid.cellOf(x[i]));
        indices[i] = std::uint32_t(i);
    }
};

//- visits[n i + j]: how often a search around i came by j
template<class C>
struct CountVisits
{
    static constexpr const char* name = "countVisits";
    static constexpr int D = C::D;
    CellGrid<D, typename C::P> grid;
    const Vec<D, typename C::real>* x;
    const int* start;
    const std::uint32_t* order;
    int* visits;
    int n;

    struct Mark
    {
        const std::uint32_t* order;
        int* row;
        HD void operator()(int begin, int end) const
        {
            for (int j = begin; j < end; ++j) row[order[j]] += 1;
        }
    };

    HD void operator()(int i) const
    {
        grid.forEachRange(x[i], start, Mark{order, visits + std::size_t(n)*i});
    }
};

struct GridSetting
{
    bool periodic[3];
    int reach;
    double cellsPerRadius, maxCells, radius;
    const char* what;
};

template<class C> class CellGridTest : public BackendCase<C> { };
TYPED_TEST_SUITE(CellGridTest, AllCases, CaseNames);

TYPED_TEST(CellGridTest, EveryNeighbourOnce)
{
    constexpr int D = TypeParam::D;
    using P = typename TypeParam::P;
    using real = typename TypeParam::real;
    const double length[3] = {1.0, 0.7, 0.9};
    const int n = 700;
    // 0.23: three radii are the shortest period that scenes allow (0.69 < 0.7)
    const GridSetting settings[] = {{{false, false, false}, 1, 6, 1e6, 0.1, "open, reach 1"},
        {{false, false, false}, 2, 6, 1e6, 0.1, "open, reach 2"},
        {{true, true, true}, 1, 6, 1e6, 0.1, "periodic, reach 1"},
        {{true, true, true}, 2, 6, 1e6, 0.1, "periodic, reach 2"},
        {{true, true, true}, 1, 6, 1e6, 0.23, "shortest period, reach 1"},
        {{true, true, true}, 2, 6, 1e6, 0.23, "shortest period, reach 2"},
        {{true, false, false}, 1, 1, 1e6, 0.1, "coarse rows"},
        {{false, true, true}, 2, 6, 400, 0.1, "few cells allowed"},
        {{true, true, false}, 1, 6, 60, 0.2, "hardly any cells allowed"},
        {{true, true, true}, 1, 6, 1, 0.2, "no cells allowed"},
        {{false, false, true}, 1, 6, 1e6, 2.0, "radius beyond the box"}};
    for (const GridSetting& s : settings)
    {
        if (s.radius > 1 && s.periodic[2] && D == 3) continue;      // scenes refuse such periods
        SCOPED_TRACE(s.what);
        Context<Backend> context;
        Box<D, P> box;
        for (int d = 0; d < D; ++d) box.set(d, 0, length[d], s.periodic[d]);
        CellGrid<D, P> grid;
        grid.set(box, s.radius, s.reach, s.cellsPerRadius, s.maxCells);
        ASSERT_EQ(grid.cells, grid.n[0]*grid.n[1]*grid.n[2]);

        // random places, and the box's corners and edges, where rounding could put a particle into
        // no cell; the second half stand just within the radius of the first, mostly beside them,
        // where rows are trimmed
        Random random(11);
        std::vector<Vec<D, real>> x(n);
        for (int i = 0; i < n; ++i)
        {
            double direction[3] = {random(-1, 1) < 0 ? -1.0 : 1.0, random(-0.5, 0.5),
                random(-0.5, 0.5)},
                   length2 = 0;
            for (int d = 0; d < D; ++d) length2 += direction[d]*direction[d];
            for (int d = 0; d < D; ++d)
            {
                const real edge[3] = {
                    real(0), real(length[d]), std::nextafter(real(length[d]), real(0))};
                const bool onEdge = i < 60 && random(0, 1) < 0.5;
                double p = length[d]*random(0, 1);
                if (i >= n/2)
                {
                    p = x[i - n/2].c[d] + 0.9999*s.radius*direction[d]/std::sqrt(length2);
                    if (s.periodic[d]) p -= length[d]*std::floor(p/length[d]);
                    p = std::min(std::max(p, 0.0), length[d]);
                }
                x[i].c[d] = onEdge ? edge[random.bits() % 3] : real(p);
            }
        }

        CellSort<Backend> sort;
        sort.allocate(context, n, grid.cells);
        Array<Backend, Vec<D, real>> positions;
        positions.upload(context, x);
        runEach(
            context, n, GridKeys<TypeParam>{grid, positions.data(), sort.keys(), sort.indices()});
        sort.sort(context, n);
        Array<Backend, int> visits;
        visits.allocate(context, std::size_t(n)*n);
        runEach(context, n,
            CountVisits<TypeParam>{
                grid, positions.data(), sort.start(), sort.order(), visits.data(), n});
        const auto count = visits.download();

        int missed = 0, twice = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
            {
                double r2 = 0;
                for (int d = 0; d < D; ++d)
                {
                    double dx = double(x[i].c[d]) - x[j].c[d];
                    if (s.periodic[d]) dx -= length[d]*std::round(dx/length[d]);
                    r2 += dx*dx;
                }
                const int c = count[std::size_t(n)*i + j];
                // a float in the box is off by 6e-8 of its length at most: nearer the radius either
                // answer is right
                if (r2 < s.radius*s.radius*(1 - 1e-5) && c == 0) ++missed;
                if (c > 1) ++twice;
            }
        EXPECT_EQ(missed, 0);
        EXPECT_EQ(twice, 0);
    }
}

TYPED_TEST(CellGridTest, CellsOfAllPositionsExist)
{
    constexpr int D = TypeParam::D;
    using P = typename TypeParam::P;
    using real = typename TypeParam::real;
    Box<D, P> box;
    for (int d = 0; d < D; ++d) box.set(d, -5, 1.1, d == 0);
    CellGrid<D, P> grid;
    grid.set(box, 0.13, 1, 6, 1e6);
    for (int k = 0; k <= 1000; ++k)
    {
        // below, in, and beyond the box: clamped
        const int cell = grid.cellOf(filled<D>(real(-0.2 + 1.5*k/1000)));
        ASSERT_GE(cell, 0);
        ASSERT_LT(cell, grid.cells);
    }
    EXPECT_EQ(grid.cellOf(filled<D>(real(0))), 0);
    EXPECT_EQ(grid.cellOf(filled<D>(real(1.1))), grid.cells - 1);
    EXPECT_GE(grid.size[1], real(0.13)) << "with reach 1, a row is no narrower than the radius";
}

} // namespace
} // namespace riprap

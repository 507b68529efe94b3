/*  Ranges of neighbours that are kept: those of a search of the grid, whatever the number of
    particles and threads (Cpu only: the Gpu has lists).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "core/containers/records.hpp"
#include "core/neighbours/cellSort.hpp"
#include "core/neighbours/foundRanges.hpp"

namespace riprap
{
namespace
{

//- Particles at random in a box of 1 x 0.7 x 0.9, x periodic, sorted into cells
template<class C>
struct SortedParticles
{
    static constexpr int D = C::D;
    using P = typename C::P;

    Context<Cpu> context;
    Box<D, P> box;
    CellGrid<D, P> grid;
    CellSort<Cpu> sort;
    Records<Cpu, D, P> records;
    const int n;

    explicit SortedParticles(int count) : n(count)
    {
        const double length[3] = {1.0, 0.7, 0.9};
        for (int d = 0; d < D; ++d) box.set(d, 0, length[d], d == 0);
        grid.set(box, 0.06, 1, 6, 1e6);
        Random random(3);
        std::vector<Vec<D, typename P::position>> x(n);
        for (auto& at : x)
            for (int d = 0; d < D; ++d)
                at.c[d] = box.pairPosition(d, box.toFixedInside(d, length[d]*random(0, 1)));
        sort.allocate(context, n, grid.cells);
        for (int i = 0; i < n; ++i)
        {
            sort.keys()[i] = std::uint32_t(grid.cellOf(relative(x[i])));
            sort.indices()[i] = std::uint32_t(i);
        }
        sort.sort(context, n);
        records.allocate(context, n, false);
        for (int i = 0; i < n; ++i) records.view().storePosition(i, x[sort.order()[i]]);
    }

    Vec<D, typename P::real> relative(const Vec<D, typename P::position>& x) const
    {
        Vec<D, typename P::real> r;
        for (int d = 0; d < D; ++d) r.c[d] = box.pairRelative(d, x.c[d]);
        return r;
    }

    std::vector<int> sought(int i)
    {
        std::vector<int> ends;
        grid.forEachRange(relative(records.view().loadPosition(i)), sort.start(),
            [&](int begin, int end) { ends.insert(ends.end(), {begin, end}); });
        return ends;
    }

    void find(FoundRanges& ranges, int targets, const GhostMarks<Cpu>& ghosts = {})
    {
        ranges.find(context, box, grid, records.view(), targets, sort.start(), ghosts);
    }
};

std::vector<int> kept(const RangesView& ranges, int i)
{
    std::vector<int> ends;
    ranges.forEach(i, [&](int begin, int end) { ends.insert(ends.end(), {begin, end}); });
    EXPECT_EQ(ranges.none(i), ends.empty());
    return ends;
}

template<class C> class FoundRangesTest : public BackendCase<C> { };
TYPED_TEST_SUITE(FoundRangesTest, AllCases, CaseNames);

TYPED_TEST(FoundRangesTest, AreThoseOfTheSearch)
{
    SortedParticles<TypeParam> particles(2*RangesView::inBlock + 300);
    FoundRanges ranges;
    EXPECT_FALSE(RangesView());
    // all, fewer than before, a block and no more, few, none
    for (const int n : {particles.n, 1500, RangesView::inBlock, 3, 0})
    {
        particles.find(ranges, n);
        EXPECT_TRUE(ranges.view());
        for (int i = 0; i < n; ++i) ASSERT_EQ(kept(ranges.view(), i), particles.sought(i)) << i;
    }
}

TYPED_TEST(FoundRangesTest, GhostsSeekNobody)
{
    SortedParticles<TypeParam> particles(1200);
    std::vector<char> marks(particles.n, 0);
    for (int i = 0; i < particles.n; i += 7) marks[i] = 1;
    GhostMemory<Cpu> ghosts;
    ghosts.set(particles.context, marks);
    FoundRanges ranges;
    particles.find(ranges, particles.n, ghosts.view());
    for (int i = 0; i < particles.n; ++i)
        ASSERT_EQ(kept(ranges.view(), i), i % 7 ? particles.sought(i) : std::vector<int>()) << i;
}

} // namespace
} // namespace riprap

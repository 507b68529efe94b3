/*  Bodies that cut the grid where it is, against the same on the host, face by face; and their part
    of the pressure equation.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include "backendTest.hpp"
#include "bodyReference.hpp"
#include "cutFields.hpp"
#include "pic/bodies/contactArea.hpp"
#include "pic/cutCells/obstacleDistance.hpp"
#include "pic/projection/pressureStep.hpp"

namespace riprap
{
namespace
{

template<class C> struct BodyCutCase : BackendTest {};
#ifdef __CUDACC__
template<class C> struct GpuBodyCut : BodyCutCase<C> {};
#define BODY_TEST(name) TYPED_TEST(GpuBodyCut, name)
TYPED_TEST_SUITE(GpuBodyCut, AllCases, CaseNames);
#else
template<class C> struct CpuBodyCut : BodyCutCase<C> {};
#define BODY_TEST(name) TYPED_TEST(CpuBodyCut, name)
TYPED_TEST_SUITE(CpuBodyCut, AllCases, CaseNames);
#endif

//- A closed box with bodies in it: two that share faces, a clump of three balls, one that a side
//  clips, one whose shape is a lattice of distances
template<class C>
struct CutBox
{
    static constexpr int D = C::D, modes = bodyModes<D>;
    using R = typename C::real;

    Context<Backend> context;
    UniformGrid<D> grid{};
    std::vector<FreeBody<D, BodyShape<D>>> bodies;
    BodyGrid<D> reference;
    std::vector<double> walls[D], baseDistance, lattice;
    Array<Backend, R> aperture[D], wallVelocity[D], base[D];
    Array<Backend, double> distance, of;
    BodyCut<Backend, D> cut;

    explicit CutBox(double shift = 0)
    {
        grid.h = 0.1;
        for (int d = 0; d < D; ++d) { grid.n[d] = 30 - 2*d; grid.origin[d] = 0.3*d - 1; }
        for (int d = 0; d < D; ++d)
        {
            for (int f = 0; f < grid.faces(d); ++f)
            {
                const int layer = grid.faceIndex(d, f).c[d];
                walls[d].push_back(layer == 0 || layer == grid.n[d] ? 0 : 1);
            }
            base[d].upload(context, std::vector<R>(walls[d].begin(), walls[d].end()));
            aperture[d].upload(context, std::vector<R>(walls[d].begin(), walls[d].end()));
            wallVelocity[d].upload(context, std::vector<R>(grid.faces(d), R(0)));
        }
        baseDistance.assign(NodeGrid<D>{grid}.count(), bandNodes*grid.h);
        distance.upload(context, baseDistance);
        of.upload(context, baseDistance);
        place(shift);
    }

    void place(double shift)
    {
        bodies.clear();
        add({{{{0.8 + shift, 1.1, 0.9}}, 0.25}});
        add({{{{1.33 + shift, 1.2, 0.95}}, 0.26}});          // less than a cell from the first
        add({{{{2.03, 0.72 + shift, 1.41}}, 0.2}, {{{2.23, 0.92 + shift, 1.51}}, 0.2},
            {{{2.1, 1.21 + shift, 1.31}}, 0.22}});
        add({{{{0.63, 0.11, 1.72}}, 0.3}});                  // the floor clips it
        add({{{{1.5, 2.2 - shift, 1.2}}, 0.1}});
        giveShape(bodies.back());
    }

    void add(const std::vector<std::pair<Vec<3, double>, double>>& balls)
    {
        FreeBody<D, BodyShape<D>> b;
        b.centre = filled<D>(0.0);
        for (const auto& [at, radius] : balls)
        {
            Ball<D> ball;
            for (int d = 0; d < D; ++d) ball.centre[d] = grid.origin[d] + at[d];
            ball.radius = radius;
            b.shape.balls.balls.push_back(ball);
            b.centre = b.centre + (1.0/balls.size())*ball.centre;
        }
        b.reach = b.shape.balls.reach(b.centre);
        for (int m = 0; m < modes; ++m)
            b.velocity.push_back(0.1*(1 + m) - 0.07*double(bodies.size()));
        bodies.push_back(b);
    }

    //- An octahedron (a square on its edge), turned a little
    void giveShape(FreeBody<D, BodyShape<D>>& b)
    {
        constexpr double half = 0.3, step = 0.05;
        constexpr int n = 17;
        SampledShape<D>& s = b.shape.sampled;
        s.lattice.step = step;
        s.centre = b.centre;
        std::size_t points = 1;
        for (int d = 0; d < D; ++d)
        {
            s.lattice.lower[d] = -0.5*step*(n - 1);
            s.lattice.n[d] = n;
            points *= n;
            for (int k = 0; k < D; ++k) s.axis[d][k] = d == k;
        }
        s.axis[0][0] = s.axis[1][1] = 0.8;
        s.axis[1][0] = 0.6;
        s.axis[0][1] = -0.6;
        lattice.clear();
        for (std::size_t i = 0; i < points; ++i)
        {
            double sum = 0;
            std::size_t rest = i;
            for (int d = 0; d < D; ++d, rest /= n)
                sum += std::abs(s.lattice.lower[d] + step*double(rest % n));
            lattice.push_back((sum - half)/std::sqrt(double(D)));
        }
        s.lattice.distance = lattice.data();
        b.reach = s.reach();
    }

    CutFields<D, R> fields()
    {
        return cutFieldsOf(grid, aperture, wallVelocity, base, distance, of);
    }

    void cutNow()
    {
        cut.cut(context, grid, bodies, 1, fields());
        std::vector<double> v;
        for (const auto& b : bodies) v.insert(v.end(), b.velocity.begin(), b.velocity.end());
        cut.setVelocities(context, v, fields());
        reference = BodyGrid<D>();
        for (int d = 0; d < D; ++d) reference.aperture[d] = walls[d];
        cutBodies(grid, bodies, 1, reference);
    }

    //- All that the host finds, to the precision of the fields; least: where that is not reached
    void expectReference(double least = 1e-13)
    {
        const double eps = std::is_same<R, float>::value ? 1e-6 : least;
        for (int d = 0; d < D; ++d)
        {
            const std::vector<R> a = aperture[d].download(), w = wallVelocity[d].download();
            int closed = 0;
            for (int f = 0; f < grid.faces(d); ++f)
            {
                ASSERT_NEAR(a[f], reference.aperture[d][f], eps) << d << " " << f;
                // (1 - a) w is what flows
                ASSERT_NEAR((1 - double(a[f]))*w[f],
                    (1 - reference.aperture[d][f])*reference.wallVelocity[d][f], eps)
                    << d << " " << f;
                closed += walls[d][f] > 0 && !(a[f] > 0);
            }
            EXPECT_GT(closed, 10);
        }
        const std::vector<BodyTerm> terms = cut.terms();
        ASSERT_EQ(terms.size(), bodies.size());
        for (std::size_t b = 0; b < terms.size(); ++b)
        {
            EXPECT_NEAR(terms[b].volume, reference.terms[b].volume, 10*least);
            std::vector<double> j(std::size_t(grid.cells())*modes, 0.0), expected(j);
            for (std::size_t i = 0; i < terms[b].cell.size(); ++i)
                for (int m = 0; m < modes; ++m)
                    j[terms[b].cell[i]*modes + m] += terms[b].j[i*modes + m];
            for (std::size_t i = 0; i < reference.terms[b].cell.size(); ++i)
                for (int m = 0; m < modes; ++m)
                    expected[reference.terms[b].cell[i]*modes + m] +=
                        reference.terms[b].j[i*modes + m];
            for (std::size_t i = 0; i < j.size(); ++i)
                ASSERT_NEAR(j[i], expected[i], least) << b << " " << i;
        }
        const NodeGrid<D> nodes{grid};
        const std::vector<double> nodeDistance = distance.download();
        for (int n = 0; n < nodes.count(); ++n)
        {
            double nearest = baseDistance[n];
            for (const auto& b : bodies)
                nearest = std::min(nearest, b.shape.distance(nodes.position(n)));
            ASSERT_NEAR(nodeDistance[n], nearest, 1e-14);
        }
    }
};

BODY_TEST(IsThatOfTheHost)
{
    CutBox<TypeParam> box;
    box.cutNow();
    box.expectReference();
}

//- A ball whose surface touches lines of the grid: half a chord is the root of r^2 - x^2, and that
//  difference is rounding alone, on either side another
BODY_TEST(TouchesLinesToTheRootOfRounding)
{
    CutBox<TypeParam> box;
    box.bodies.clear();
    box.add({{{{0.6, 0.1, 1.7}}, 0.3}});
    box.cutNow();
    box.expectReference(1e-8);
}

//- Bodies that have moved leave nothing behind, and without any the grid is what it was
BODY_TEST(LeavesNothingBehind)
{
    constexpr int D = TypeParam::D;
    CutBox<TypeParam> box;
    box.cutNow();
    box.cut.restore(box.context, box.fields());
    box.place(0.237);
    box.cutNow();
    box.expectReference();
    box.cut.restore(box.context, box.fields());
    EXPECT_EQ(box.distance.download(), box.baseDistance);
    for (int d = 0; d < D; ++d)
    {
        EXPECT_EQ(box.aperture[d].download(), box.base[d].download());
        for (const auto w : box.wallVelocity[d].download()) ASSERT_EQ(w, 0);
    }
    box.bodies.clear();
    box.cutNow();
    for (int d = 0; d < D; ++d) EXPECT_EQ(box.aperture[d].download(), box.base[d].download());
}

//- Nothing of a body goes through the walls of a closed box, whichever way it moves, though one is
//  clipped by the floor: water that fills the box can give way to it
BODY_TEST(GoesThroughNoWall)
{
    CutBox<TypeParam> box;
    for (const double shift : {0.0, 0.031})
    {
        box.place(shift);
        box.cutNow();
        for (const double sum : box.cut.gather(box.context, nullptr)) EXPECT_NEAR(sum, 0, 1e-14);
        box.cut.restore(box.context, box.fields());
    }
}

//- Nor does it push anything into cells that it fills, which have no equation: over the others a
//  body's motion sums to zero, its spin as well. Else the pressure of closed water would not be
//  free up to a constant, but all but free, and solvers would look for that constant
BODY_TEST(PushesNothingIntoItself)
{
    constexpr int D = TypeParam::D, modes = bodyModes<D>;
    using R = typename TypeParam::real;
    CutBox<TypeParam> box;
    int scaled = 0;
    for (int k = 0; k < 12; ++k)
    {
        box.bodies.clear();
        box.add({{{{1.3 + 0.0137*k, 1.2 + 0.0071*k, 1.1}}, 0.55 + 0.003*k}});
        box.cutNow();
        box.expectReference();
        const BodyTerm t = box.cut.terms()[0];
        std::vector<R> a[D];
        for (int d = 0; d < D; ++d)
        {
            a[d] = box.aperture[d].download();
            for (int f = 0; f < box.grid.faces(d); ++f)
            {
                const auto x = box.grid.faceIndex(d, f);
                const NodeGrid<D> nodes{box.grid};
                const double share =
                    inBody(box.bodies[0].shape, nodes.position(nodes.node(x)), d, box.grid.h).share;
                scaled += share < 1 && share > 1 - smallestAperture;
            }
        }
        double sum[modes] = {}, all = 0;
        for (std::size_t i = 0; i < t.cell.size(); ++i)
        {
            const auto x = box.grid.cellIndex(t.cell[i]);
            bool open = false;
            for (int d = 0; d < D; ++d)
                for (int side = 0; side < 2; ++side)
                    open = open || a[d][box.grid.faceOf(d, x, side)] > R(0);
            for (int m = 0; m < modes && open; ++m)
            {
                sum[m] += t.j[i*modes + m];
                all += std::abs(t.j[i*modes + m]);
            }
        }
        for (int m = 0; m < modes; ++m) EXPECT_LT(std::abs(sum[m]), 1e-14*all) << k << " " << m;
        box.cut.restore(box.context, box.fields());
    }
    EXPECT_GT(scaled, 0);
}

//- What a ball and an obstacle leave of a face by a slit is closed where they fill a cell beside it
//  together; not where the cell has an open corner, nor for wider openings
BODY_TEST(ClosesSlitsOfCellsThatSolidsFill)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    const auto leftOpen = [](double gap, bool full)
    {
        CutBox<TypeParam> box;
        const UniformGrid<D>& grid = box.grid;
        const NodeGrid<D> nodes{grid};
        box.bodies.clear();
        box.add({{{{1.3, 1.2, 1.1}}, 0.55}});
        box.cutNow();
        const std::vector<R> a = box.aperture[0].download();
        int face = -1;
        for (int f = 0; f < grid.faces(0) && face < 0; ++f)
            if (a[f] > R(0.3) && a[f] < R(0.7) && box.walls[0][f] == 1) face = f;
        const double base = 1 - double(a[face]) + gap;
        box.cut.restore(box.context, box.fields());
        // the obstacle has what the ball leaves of the cell above the face, but for a corner
        const auto cell = grid.cellIndex(grid.cellOf(0, grid.faceIndex(0, face), 1));
        bool left = !full;
        for (int corner = 0; corner < (1 << D); ++corner)
        {
            int node = nodes.node(cell);
            for (int d = 0; d < D; ++d) node += (corner >> d & 1)*nodes.stride(d);
            const bool free = box.bodies[0].shape.distance(nodes.position(node)) > 0;
            if (free && !left) box.baseDistance[node] = -0.01;
            left = left && !free;
        }
        for (auto* x : {&box.distance, &box.of}) x->upload(box.context, box.baseDistance);
        box.walls[0][face] = base;
        for (auto* x : {&box.base[0], &box.aperture[0]})
            x->upload(box.context, std::vector<R>(box.walls[0].begin(), box.walls[0].end()));
        box.cut.cut(box.context, grid, box.bodies, 1, box.fields());
        const double share = box.cut.shareOfFaces(0)[face], open = box.aperture[0].download()[face];
        EXPECT_NEAR(share + open, base, 1e-6);
        return open;
    };
    EXPECT_EQ(leftOpen(0.03, true), 0);
    EXPECT_NEAR(leftOpen(0.03, false), 0.03, 1e-6);
    EXPECT_NEAR(leftOpen(0.1, true), 0.1, 1e-6);
}

//- Heavy bodies that fall in a pool: their equation solved where the grid is, and on the host
BODY_TEST(MovesThemAsTheHostDoes)
{
    constexpr int D = TypeParam::D, modes = bodyModes<D>;
    using R = typename TypeParam::real;
    CutBox<TypeParam> box;
    box.cutNow();
    const UniformGrid<D>& grid = box.grid;
    const double dt = 1e-3, g = 9.81, density = 1000, level = 1.83;
    std::vector<R> phi(grid.cells());
    for (int i = 0; i < grid.cells(); ++i)
        phi[i] = R((grid.cellIndex(i).c[1] + 0.5)*grid.h - level);
    Array<Backend, R> surface, u[D];
    surface.upload(box.context, phi);
    std::vector<BodyTerm> terms = box.cut.terms();
    std::vector<double> roots(terms.size()*modes*modes, 0.0);
    for (std::size_t b = 0; b < terms.size(); ++b)
    {
        BodyTerm& t = terms[b];
        const double mass = (2.5 + b)*density*t.volume;
        t.velocity = box.bodies[b].velocity;
        t.inverseMass.assign(modes*modes, 0.0);
        for (int m = 0; m < modes; ++m) t.inverseMass[m*modes + m] = 1/(m < D ? mass : mass*0.03);
        rootOfInverseMass(modes, t.inverseMass.data(), &roots[b*modes*modes]);
    }
    PressureStep<Backend, D, R> step;
    step.allocate(box.context, grid);
    MultigridLinear solver;
    solver.controls.tolerance = 1e-9;
    const BodiesOnGrid<Backend, D> onGrid{box.cut, roots};
    std::vector<double> p[3];
    int iterations[3];
    for (int k = 0; k < 3; ++k)
    {
        Array<Backend, double> pressure;
        pressure.upload(box.context, std::vector<double>(grid.cells(), 100.0));
        PressureFields<D, R> f{};
        f.grid = grid;
        f.phi = surface.data();
        for (int d = 0; d < D; ++d)
        {
            u[d].upload(box.context, std::vector<R>(grid.faces(d), d == 1 ? R(-g*dt) : R(0)));
            f.aperture[d] = box.aperture[d].data();
            f.wallVelocity[d] = box.wallVelocity[d].data();
            f.u[d] = u[d].data();
        }
        f.p = pressure.data();
        f.timeStep = dt;
        f.density = density;
        const PressureReport r = k
            ? step.project(box.context, f, solver, nullptr, false, nullptr, &onGrid)
            : step.project(box.context, f, solver, &terms);
        EXPECT_TRUE(r.converged);
        iterations[k] = r.iterations;
        p[k] = pressure.download();
        const std::vector<double> against = box.cut.gather(box.context, pressure.data());
        for (std::size_t b = 0; b < terms.size() && k == 1; ++b)
            for (int m = 0; m < modes; ++m)
            {
                double v = box.bodies[b].velocity[m];
                for (int e = 0; e < modes; ++e)
                    v -= dt*terms[b].inverseMass[m*modes + e]*against[b*modes + e];
                EXPECT_NEAR(v, terms[b].velocity[m], 1e-6) << b << " " << m;
            }
    }
    double largest = 0;
    for (const double v : p[0]) largest = std::max(largest, std::abs(v));
    EXPECT_GT(largest, 100);
    for (std::size_t i = 0; i < p[0].size(); ++i) ASSERT_NEAR(p[1][i], p[0][i], 1e-6*largest) << i;
    EXPECT_LE(iterations[1], 2*iterations[0]);          // the host deflates
    EXPECT_EQ(p[1], p[2]);      // repeats to the bit
}

//- Particles here and there, against every contact: those that none reaches keep their velocity
BODY_TEST(SlowsWhereContactsReach)
{
    constexpr int D = TypeParam::D, n = 2000, contacts = 12;
    using R = typename TypeParam::real;
    Context<Backend> context;
    UniformGrid<D> grid{};
    grid.h = 0.1;
    for (int d = 0; d < D; ++d) grid.n[d] = 20;
    const ContactBoxes<D> boxes(grid);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> in(0, 2);
    std::vector<std::pair<int, ContactArea<D>>> areas;
    for (int k = 0; k < contacts; ++k)
    {
        ContactArea<D> a;
        for (int d = 0; d < D; ++d) { a.point[d] = in(random); a.normal[d] = d == k % D; }
        if (k == 0) a.point[0] = -0.05;         // a wall's
        areas.emplace_back(boxes.number(a.point), a);
    }
    std::sort(
        areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<int> box;
    std::vector<ContactArea<D>> sorted;
    for (const auto& [b, a] : areas) { box.push_back(b); sorted.push_back(a); }
    Array<Backend, int> boxOf;
    Array<Backend, ContactArea<D>> area;
    boxOf.upload(context, box);
    area.upload(context, sorted);
    Array<Backend, double> x[D];
    Array<Backend, R> v[D], u[D];
    std::vector<double> at[D];
    SlowBetweenSolids<D, R> slow{grid, {}, boxes, contacts, boxOf.data(), area.data(), 0.25, 1, {}};
    for (int d = 0; d < D; ++d)
    {
        for (int i = 0; i < n; ++i) at[d].push_back(in(random));
        x[d].upload(context, at[d]);
        v[d].upload(context, std::vector<R>(n, R(7)));
        u[d].upload(context, std::vector<R>(grid.faces(d), R(2)));      // the grid's, everywhere
        slow.particles.x[d] = x[d].data();
        slow.particles.v[d] = v[d].data();
        slow.u[d] = u[d].data();
    }
    int slowed = 0, taken = 0;
    for (const double times : {1.0, 0.5, 3.0})          // of those that beta is meant for
    for (int d = 0; d < D; ++d)
    {
        slow.times = times;
        forEach(context, n, slow);
        const std::vector<R> after = v[d].download();
        for (int i = 0; i < n; ++i)
        {
            double factor = 1;
            bool near = false;
            for (const ContactArea<D>& a : sorted)
            {
                double across = 0, r2 = 0;
                for (int e = 0; e < D; ++e)
                {
                    const double r = at[e][i] - a.point[e];
                    r2 += r*r;
                    across += r*a.normal[e];
                }
                const double along = std::sqrt(std::max(0.0, r2 - across*across))/grid.h,
                             beside = std::abs(across)/grid.h;
                if (along < 3.5 && beside <= 3) near = true;
                if (along < 2 && beside <= 1.5) factor = std::min(factor, 0.25 + 0.75*along/2);
            }
            slowed += factor < 1;
            taken += near;
            // beside a side the grid's velocity across it is another
            const double wall = std::min(at[d][i], 2 - at[d][i]);
            if (!near || wall > 2*grid.h)
            {
                ASSERT_NEAR(after[i], near ? 2*std::pow(factor, times) : 7, 1e-5) << i;
            }
        }
    }
    EXPECT_GT(slowed, 20);
    EXPECT_GT(taken, slowed);
}

} // namespace
} // namespace riprap

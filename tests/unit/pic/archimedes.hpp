/*  Bodies that are held in water at rest: J^T p is the weight that they displace (Archimedes), and
    its moment, wherever they lie in the grid. p is that of water at rest, rho g times the depth,
    which is what the pressure equation has for its solution under a flat surface.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include "backendTest.hpp"
#include "cutFields.hpp"
#include "pic/bodies/bodyCut.hpp"
#include "pic/bodies/freeBody.hpp"
#include "pic/cutCells/obstacleDistance.hpp"
#include "pic/shapes/latticeVolume.hpp"

namespace riprap
{
namespace
{

#ifdef __CUDACC__
#define ARCHIMEDES_TEST(name) TYPED_TEST(GpuArchimedes, name)
template<class C> struct GpuArchimedes : BackendTest {};
TYPED_TEST_SUITE(GpuArchimedes, AllCases, CaseNames);
#else
#define ARCHIMEDES_TEST(name) TYPED_TEST(CpuArchimedes, name)
template<class C> struct CpuArchimedes : BackendTest {};
TYPED_TEST_SUITE(CpuArchimedes, AllCases, CaseNames);
#endif

using Point = Vec<2, double>;

//- Area of a polygon, and its first moments
struct Area { double area = 0, x = 0, y = 0; };

inline Area areaOf(const std::vector<Point>& p)
{
    Area a;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const Point &u = p[i], &v = p[(i + 1) % p.size()];
        const double cross = u[0]*v[1] - u[1]*v[0];
        a.area += cross/2;
        a.x += cross*(u[0] + v[0])/6;
        a.y += cross*(u[1] + v[1])/6;
    }
    return a;
}

//- What lies below a level
inline std::vector<Point> below(const std::vector<Point>& p, double level)
{
    std::vector<Point> out;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const Point &u = p[i], &v = p[(i + 1) % p.size()];
        if (u[1] <= level) out.push_back(u);
        if ((u[1] <= level) != (v[1] <= level))
            out.push_back(u + (level - u[1])/(v[1] - u[1])*(v - u));
    }
    return out;
}

inline double distanceToOutline(const std::vector<Point>& p, const Point& x)
{
    double nearest2 = 1e300;
    bool in = false;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const Point &u = p[i], &v = p[(i + 1) % p.size()], s = v - u;
        const double t = std::max(0.0, std::min(1.0, dot(x - u, s)/squaredNorm(s)));
        nearest2 = std::min(nearest2, squaredNorm(x - u - t*s));
        if ((u[1] <= x[1]) != (v[1] <= x[1]) && x[0] < u[0] + (x[1] - u[1])/(v[1] - u[1])*s[0])
            in = !in;
    }
    return (in ? -1 : 1)*std::sqrt(nearest2);
}

//- A prism along the third axis, in cells; about its centre of mass
struct Prism
{
    std::vector<Point> outline;
    double length = 0;          // 2D: 1

    static Prism box(double width, double height)
    {
        return {{{{-width/2, -height/2}}, {{width/2, -height/2}}, {{width/2, height/2}},
            {{-width/2, height/2}}}};
    }

    //- A box with a slot from below, half as high
    static Prism caisson(double width, double height, double slot)
    {
        const double w = width/2, h = height/2, s = slot/2;
        return {{{{-w, -h}}, {{-s, -h}}, {{-s, 0}}, {{s, 0}}, {{s, -h}}, {{w, -h}}, {{w, h}},
            {{-w, h}}}};
    }

    static Prism cylinder(double radius)
    {
        Prism p;
        constexpr int n = 256;
        for (int i = 0; i < n; ++i)
            p.outline.push_back(
                {{radius*std::cos(2*M_PI*i/n), radius*std::sin(2*M_PI*i/n)}});
        return p;
    }

    double distance(const Vec<2, double>& x) const { return distanceToOutline(outline, x); }
    double distance(const Vec<3, double>& x) const
    {
        const double plane = distanceToOutline(outline, {{x[0], x[1]}}),
                     along = std::abs(x[2]) - length/2;
        return plane > 0 && along > 0 ? std::hypot(plane, along) : std::max(plane, along);
    }
};

//- Cells of edge 1, closed sides, water up to a level
template<class C>
struct StillWater
{
    static constexpr int D = C::D, modes = bodyModes<D>, side = 24, depth = 12;
    using R = typename C::real;

    double level;
    Context<Backend> context;
    UniformGrid<D> grid{};
    Array<Backend, R> aperture[D], wallVelocity[D], base[D], phi;
    Array<Backend, double> distance, baseDistance, pressure;
    BodyCut<Backend, D> cut;
    std::vector<FreeBody<D, BodyShape<D>>> bodies;
    std::vector<std::vector<double>> lattices;

    explicit StillWater(double fraction) : level(15 + fraction)
    {
        grid.h = 1;
        for (int d = 0; d < D; ++d) grid.n[d] = d == 2 ? depth : side;
        for (int d = 0; d < D; ++d)
        {
            std::vector<R> walls(grid.faces(d), R(1));
            for (int f = 0; f < grid.faces(d); ++f)
            {
                const int layer = grid.faceIndex(d, f).c[d];
                if (layer == 0 || layer == grid.n[d]) walls[f] = 0;
            }
            for (auto* a : {&base[d], &aperture[d]}) a->upload(context, walls);
            wallVelocity[d].upload(context, std::vector<R>(grid.faces(d), R(0)));
        }
        const std::vector<double> far(NodeGrid<D>{grid}.count(), bandNodes*grid.h);
        for (auto* a : {&distance, &baseDistance}) a->upload(context, far);
        std::vector<R> height(grid.cells());
        std::vector<double> p(grid.cells());
        for (int i = 0; i < grid.cells(); ++i)
        {
            const double above = grid.cellIndex(i).c[1] + 0.5 - level;
            height[i] = R(above);
            p[i] = above < -wetDepth ? -above : 0;          // rho g is 1
        }
        phi.upload(context, height);
        pressure.upload(context, p);
    }

    void add(const FreeBody<D, BodyShape<D>>& b)
    {
        bodies.push_back(b);
        bodies.back().velocity.assign(modes, 0.0);
    }

    void add(Prism prism, const Vec<D, double>& centre, double turn = 0)
    {
        constexpr double step = 0.25, margin = 2;
        FreeBody<D, BodyShape<D>> b;
        b.centre = centre;
        SampledShape<D>& s = b.shape.sampled;
        s.centre = centre;
        s.lattice.step = step;
        double half[3] = {0, 0, prism.length/2};
        for (const Point& p : prism.outline)
            for (int d = 0; d < 2; ++d) half[d] = std::max(half[d], std::abs(p[d]));
        std::size_t points = 1;
        for (int d = 0; d < D; ++d)
        {
            s.lattice.n[d] = int(2*(half[d] + margin)/step) + 2;
            s.lattice.lower[d] = -0.5*step*(s.lattice.n[d] - 1);
            points *= s.lattice.n[d];
            for (int k = 0; k < D; ++k) s.axis[d][k] = d == k;
        }
        s.axis[0][0] = s.axis[1][1] = std::cos(turn);
        s.axis[1][0] = std::sin(turn);
        s.axis[0][1] = -std::sin(turn);
        std::vector<double> all;
        for (std::size_t i = 0; i < points; ++i)
        {
            Vec<D, double> y;
            std::size_t rest = i;
            for (int d = 0; d < D; ++d, rest /= s.lattice.n[d - 1])
                y[d] = s.lattice.lower[d] + step*double(rest % s.lattice.n[d]);
            all.push_back(prism.distance(y));
        }
        s.lattice.distance = all.data();
        const double outward = outwardToVolume(
            s.lattice, areaOf(prism.outline).area*(D == 3 ? prism.length : 1));
        for (double& value : all) value -= outward;
        lattices.push_back(std::move(all));
        s.lattice.distance = lattices.back().data();
        b.reach = s.reach();
        add(b);
    }

    //- Of the same shapes: no new lattices
    void move(std::size_t body, const Vec<D, double>& by)
    {
        bodies[body].centre = bodies[body].centre + by;
        bodies[body].shape.sampled.centre = bodies[body].centre;
        for (auto& ball : bodies[body].shape.balls.balls) ball.centre = ball.centre + by;
    }

    CutFields<D, R> fields()
    {
        return cutFieldsOf(grid, aperture, wallVelocity, base, distance, baseDistance);
    }

    //- Forces and moments of the water: modes a body
    std::vector<double> forces()
    {
        cut.restore(context, fields());
        cut.cut(context, grid, bodies, 1, fields());
        cut.cutToWater(context, phi.data(), fields());
        std::vector<double> f = cut.gather(context, pressure.data());
        for (double& value : f) value = -value;
        return f;
    }
};

//- Moves the first body of the water down by two cells in forty steps. What it should bear is
//  compared in parts of what it displaces at five cells of draught
template<class C, class Exact>
void throughTwoCells(StillWater<C>& water, const std::string& name, double width,
    const Exact& exact, double bound = 0.01, double jump = 0.005)
{
    constexpr int D = C::D, heights = 40;
    double before = 0;
    for (int k = 0; k < heights; ++k)
    {
        const std::vector<double> f = water.forces();
        const Area a = exact(water.bodies[0].centre);
        const double error = (f[1] - a.area)/std::max(a.area, 1.0)*std::min(1.0, a.area/(5*width));
        EXPECT_LT(std::abs(error), bound) << name << ' ' << k;
        if (k) { EXPECT_LT(std::abs(error - before), jump) << name << ' ' << k; }
        before = error;
        EXPECT_NEAR(f[D == 2 ? 2 : 5], a.x - water.bodies[0].centre[0]*a.area,
            bound*5*width*width/2)
            << name << ' ' << k;
        for (int d = 0; d < D; ++d)
            if (d != 1) { EXPECT_NEAR(f[d], 0, 1e-9*5*width) << name << ' ' << k; }
        Vec<D, double> down = filled<D>(0.0);
        down[1] = -2.0/heights;
        water.move(0, down);
    }
}

template<class C>
void heldPrism(const std::string& name, Prism prism, double draught, double fraction, double aside,
    double turn = 0)
{
    constexpr int D = C::D;
    StillWater<C> water(fraction);
    prism.length = D == 3 ? 5 : 0;
    double lowest = 0, width = 0;
    std::vector<Point> turned = prism.outline;
    for (Point& p : turned)
    {
        p = {{p[0]*std::cos(turn) - p[1]*std::sin(turn),
            p[0]*std::sin(turn) + p[1]*std::cos(turn)}};
        lowest = std::min(lowest, p[1]);
        width = std::max(width, 2*std::abs(p[0]));
    }
    Vec<D, double> centre = filled<D>(0.5*water.depth + 0.37*aside);
    centre[0] = 0.5*water.side + aside;
    centre[1] = water.level - draught - lowest;
    water.add(prism, centre, turn);
    const double length = D == 3 ? prism.length : 1;
    throughTwoCells(water, name + ' ' + std::to_string(fraction), width*length,
        [&](const Vec<D, double>& at)
        {
            std::vector<Point> there = turned;
            for (Point& p : there)
            {
                p[0] += at[0];
                p[1] += at[1];
            }
            const Area a = areaOf(below(there, water.level));
            return Area{a.area*length, a.x*length, a.y*length};
        });
}

//- With a draught of five cells to seven
ARCHIMEDES_TEST(APrismBearsWhatItDisplaces)
{
    const double tilt = M_PI/180;
    for (const double fraction : {0.02, 0.3, 0.75})
    {
        const double aside = 0.9*fraction;
        heldPrism<TypeParam>("box", Prism::box(10, 10), 5, fraction, aside);
        heldPrism<TypeParam>("caisson", Prism::caisson(10, 10, 3), 5, fraction, aside);
        heldPrism<TypeParam>("tilted box", Prism::box(10, 8), 5, fraction, aside, 10*tilt);
        heldPrism<TypeParam>("box on an edge", Prism::box(8, 8), 5, fraction, aside, 35*tilt);
        heldPrism<TypeParam>("cylinder", Prism::cylinder(5), 5, fraction, aside);
        if (TypeParam::D == 3) break;
    }
}

//- Cells that are wet in part: a deck that water comes over, the roof of a slot, a bottom that dips
//  in
ARCHIMEDES_TEST(FlatSidesAtTheSurfaceBearWhatIsUnderWater)
{
    for (const double fraction : {0.02, 0.3, 0.75})
    {
        heldPrism<TypeParam>("deck", Prism::box(10, 6), 5, fraction, 0.4);
        heldPrism<TypeParam>("barge", Prism::box(12, 5), 4.2, fraction, 0.4);
        heldPrism<TypeParam>("bottom", Prism::box(10, 6), -0.7, fraction, 0.4);
        heldPrism<TypeParam>("roof", Prism::caisson(10, 10, 3), 4, fraction, 0.4);
        if (TypeParam::D == 3) break;
    }
}

//- A ball of the dem library, half and wholly under water
ARCHIMEDES_TEST(ABallBearsWhatItDisplaces)
{
    constexpr int D = TypeParam::D;
    for (const double R : {4.0, 5.0})
        for (const double top : {R, 0.6*R, -1.1})        // above the surface
        {
            StillWater<TypeParam> water(0.3);
            Ball<D> ball;
            ball.centre = filled<D>(0.5*water.depth + 0.21);
            ball.centre[1] = water.level + top - R;
            ball.radius = R;
            FreeBody<D, BodyShape<D>> b{{}, ball.centre, R, {}};
            b.shape.balls.balls = {ball};
            water.add(b);
            const double width = D == 2 ? 2*R : M_PI*R*R;
            throughTwoCells(water, "ball " + std::to_string(top), width,
                [&](const Vec<D, double>& at)
                {
                    const double t = std::min(R, water.level - at[1]);
                    const double v = D == 2
                        ? R*R*(M_PI/2 + std::asin(t/R))
                            + t*std::sqrt(std::max(0.0, R*R - t*t))
                        : M_PI*(2*R*R*R/3 + R*R*t - t*t*t/3);
                    return Area{v, v*at[0], 0};
                });
        }
}

//- Two boxes that share cells and faces, side by side or one on the other: what they bear together
ARCHIMEDES_TEST(TwoBoxesInOneCellBearWhatTheyDisplace)
{
    constexpr int D = TypeParam::D;
    const double length = D == 3 ? 5 : 1;
    for (const double gap : {0.0, 0.2, 0.6})
        for (const bool above : {false, true})
            for (int k = 0; k < 8; ++k)
            {
                StillWater<TypeParam> water(0.3);
                Prism prism = Prism::box(above ? 10 : 5, 5);
                prism.length = D == 3 ? 5 : 0;
                Vec<D, double> centre = filled<D>(6.1);
                centre[0] = 9.3;
                centre[1] = water.level - (above ? 5.3 : 2.7) - 0.25*k;
                water.add(prism, centre);
                centre[above ? 1 : 0] += 5 + gap;
                water.add(prism, centre);
                double area = 0;
                for (const auto& b : water.bodies)
                    area += (above ? 10 : 5)*length
                        *std::max(0.0, std::min(5.0, water.level - b.centre[1] + 2.5));
                const std::vector<double> f = water.forces();
                // a face that two bodies close stays open by contactLeak
                const double leak = above && gap < contactLeak ? contactLeak*10*length : 0;
                EXPECT_NEAR(f[1] + f[water.modes + 1], area, 0.01*area + leak)
                    << gap << ' ' << above << ' ' << k;
            }
}

//- What the surface cuts is put back to the bit
ARCHIMEDES_TEST(ForgetsTheWater)
{
    constexpr int D = TypeParam::D;
    StillWater<TypeParam> water(0.3);
    Prism prism = Prism::box(7.3, 4);
    prism.length = D == 3 ? 5 : 0;
    Vec<D, double> centre = filled<D>(6.2);
    centre[1] = water.level - 1.9;
    water.add(prism, centre, 0.1);
    water.cut.cut(water.context, water.grid, water.bodies, 1, water.fields());
    std::vector<std::vector<typename TypeParam::real>> before;
    for (auto& a : water.aperture) before.push_back(a.download());
    const std::vector<BodyTerm> terms = water.cut.terms();
    EXPECT_TRUE(water.cut.cutToWater(water.context, water.phi.data(), water.fields()));
    int changed = 0;
    const std::vector<typename TypeParam::real> cut = water.aperture[1].download();
    for (std::size_t f = 0; f < cut.size(); ++f) changed += cut[f] != before[1][f];
    EXPECT_GT(changed, 5);
    water.cut.forgetWater(water.context, water.fields());
    for (int d = 0; d < D; ++d) EXPECT_EQ(water.aperture[d].download(), before[d]);
    EXPECT_EQ(water.cut.terms()[0].volume, terms[0].volume);
}

} // namespace
} // namespace riprap

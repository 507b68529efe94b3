/*  Cut cells: shares and centroids of planes (exact), areas and volumes of round bodies (second
    order), water at rest on an oblique floor, and the added mass of round bodies in round tanks,
    from one projection.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/cutCells/apertures.hpp"
#include "pic/shapes/shapes.hpp"
#include "pic/pressure/pressureBlock.hpp"

namespace riprap
{
namespace
{

template<class C> struct CutCellCase : BackendTest {};
#ifdef __CUDACC__
template<class C> struct GpuCutCells : CutCellCase<C> {};
#define CUT_TEST(name) TYPED_TEST(GpuCutCells, name)
TYPED_TEST_SUITE(GpuCutCells, AllCases, CaseNames);
#else
template<class C> struct CpuCutCells : CutCellCase<C> {};
#define CUT_TEST(name) TYPED_TEST(CpuCutCells, name)
TYPED_TEST_SUITE(CpuCutCells, AllCases, CaseNames);

TEST(CutCells, PlanesCutExactly)
{
    Random random(3);
    for (int k = 0; k < 200; ++k)
    {
        // a plane a x + b y = c below which is solid: its share of the unit square and centroid by
        // fine midpoint sums
        const double a = random(-1, 1), b = random(-1, 1), c = random(-0.5, 0.5) + 0.5*(a + b);
        const auto f = [&](double x, double y) { return a*x + b*y - c; };
        const SolidPart<3> part = solidOfSquare(f(0, 0), f(1, 0), f(0, 1), f(1, 1));
        double share = 0, mx = 0, my = 0;
        const int n = 300;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
            {
                const double x = (i + 0.5)/n, y = (j + 0.5)/n;
                if (f(x, y) < 0) { share += 1.0/(n*n); mx += x/(n*n); my += y/(n*n); }
            }
        const double sums = 2.0/n;          // cells of the sums that the line crosses
        EXPECT_NEAR(part.share, share, sums);
        EXPECT_NEAR(part.moment[0], mx, sums);
        EXPECT_NEAR(part.moment[1], my, sums);
        // and what is solid of a plane is open of its reverse
        const SolidPart<3> reverse = solidOfSquare(-f(0, 0), -f(1, 0), -f(0, 1), -f(1, 1));
        EXPECT_NEAR(part.share + reverse.share, 1, 1e-14);
        EXPECT_NEAR(part.moment[0] + reverse.moment[0], 0.5, 1e-14);
    }
    const SolidPart<2> edge = solidOfEdge(-1, 3);
    EXPECT_DOUBLE_EQ(edge.share, 0.25);
    EXPECT_DOUBLE_EQ(edge.moment[0], 0.25*0.125);
    EXPECT_DOUBLE_EQ(solidOfEdge(3, -1).moment[0], 0.25*0.875);
    EXPECT_EQ(solidOfEdge(0, 0).share, 0);
}

TEST(CutCells, CubesCutByPlanes)
{
    const auto cube = [](double a, double b, double c, double offset)
    {
        double d[8];
        for (int k = 0; k < 8; ++k) d[k] = a*(k & 1) + b*(k >> 1 & 1) + c*(k >> 2) - offset;
        return solidOfCube(d);
    };
    EXPECT_NEAR(cube(1, 0, 0, 0.3), 0.3, 1e-14);
    EXPECT_NEAR(cube(0, 0, -1, -0.3), 0.7, 1e-14);
    EXPECT_NEAR(cube(1, 1, 0, 0.5), 0.125, 1e-14);          // prism
    EXPECT_NEAR(cube(1, 1, 1, 0.5), 0.125/6, 1e-14);        // corner: edge^3/6
    EXPECT_NEAR(cube(1, 1, 1, 1.5), 0.5, 1e-14);
    EXPECT_NEAR(cube(1, 2, 4, 3.5), 0.5, 1e-14);
    EXPECT_NEAR(cube(1, 2, 4, 1), 1.0/6/8, 1e-14);          // legs 1, 1/2, 1/4
}
#endif

template<int D, class Shape>
struct CutDistances
{
    Context<Backend> context;
    Array<Backend, double> nodes;
    NodeGrid<D> grid;

    CutDistances(const UniformGrid<D>& g) : grid{g}
    {
        nodes.upload(context, std::vector<double>(grid.count(), 1e30));
    }

    void add(const Shape& s)
    {
        forEach(context, grid.count(), NodeDistances<D, Shape>{grid, s, nodes.data()});
    }
};

template<int D>
Vec<D, double> point(double x, double y, double z)
{
    const double all[3] = {x, y, z};
    Vec<D, double> p;
    for (int d = 0; d < D; ++d) p[d] = all[d];
    return p;
}

//- Closes the faces of a block, and returns the open volume of its cells in all
template<int D, class R, class Shape>
double cut(Block<D, R>& b, const Shape& shape)
{
    CutDistances<D, Shape> distances(b.grid);
    distances.add(shape);
    for (int d = 0; d < D; ++d)
    {
        Array<Backend, R> aperture;
        aperture.upload(distances.context, b.aperture[d]);
        forEach(distances.context, b.grid.faces(d),
            CloseFaces<D, R>{distances.grid, d, distances.nodes.data(), aperture.data()});
        b.aperture[d] = aperture.download();
    }
    Array<Backend, R> open;
    open.allocate(distances.context, b.grid.cells());
    forEach(distances.context, b.grid.cells(),
        OpenVolumes<D, R>{distances.grid, distances.nodes.data(), open.data()});
    double sum = 0;
    for (const R v : open.download()) sum += double(v)*b.grid.volume();
    return sum;
}

CUT_TEST(VolumeOfABallIsOfSecondOrder)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    const double exact = D == 2 ? M_PI*0.09 : 4*M_PI*0.027/3;
    double error[2];
    for (int k = 0; k < 2; ++k)
    {
        const int n = 10 << (2*k);
        Block<D, R> b({n, n, n}, 1.0/n);
        const double solid = 1 - cut(b, Ball<D>{point<D>(0.51, 0.477, 0.52), 0.3});
        error[k] = std::fabs(solid - exact)/exact;
    }
    EXPECT_LT(error[0], 0.06);
    EXPECT_LT(error[1], error[0]/10);       // order 1.7 at least between 3 and 12 cells a radius
}

//- Water over a floor that falls aside, in a box: gravity for a moment, and nothing may move
CUT_TEST(WaterRestsOnAnObliqueFloor)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    const double h = 0.04, g = 9.81;
    Block<D, R> b({25, 25, 7}, h);
    const double slope = std::atan(0.37);
    const Vec<D, double> normal = point<D>(-std::sin(slope), std::cos(slope), 0);
    cut(b, HalfSpace<D>{point<D>(0, 0.213, 0), normal});
    for (int i = 0; i < b.grid.cells(); ++i) b.phi[i] = R(b.centre(i)[1] - 0.7331);
    for (R& u : b.u[1]) u = R(-g*b.timeStep);
    auto solver = tight(1e-14);
    b.project(solver);
    EXPECT_TRUE(b.report.converged);
    EXPECT_LT(b.report.iterations, 30);
    EXPECT_LT(b.largestSpeed(), 1e-11 + 20*TypeParam::epsilon*g*b.timeStep);
}

//- Added mass of a ball in the middle of a round tank, relative to theory; at some offset of the
//  grid
template<class C>
double addedMassErrorAt(double cellsARadius, double x, double y)
{
    constexpr int D = C::D;
    using R = typename C::real;
    const double a = 1, tank = 2, h = a/cellsARadius;
    const int n = int(std::ceil(2*tank/h)) + 5;
    Block<D, R> b({n, n, n}, h);
    const double c = 0.5*n*h;
    const Ball<D> ball{point<D>(c + x*h, c + y*h, c + (x - y)*h), a};
    cut(b, Complement<Ball<D>>{{ball.centre, tank}});
    Block<D, R> within = b;
    cut(b, ball);
    // what the ball closes moves with it along the first axis, at 1 m/s
    const double speed = 1;
    for (std::size_t f = 0; f < b.aperture[0].size(); ++f)
        if (b.aperture[0][f] < within.aperture[0][f])
            b.wall[0][f] = R(
                speed*(within.aperture[0][f] - b.aperture[0][f])/(1 - b.aperture[0][f]));
    auto solver = tight(1e-11);
    b.project(solver);
    EXPECT_TRUE(b.report.converged) << b.report.finalResidual;
    double force = 0;
    for (int i = 0; i < b.grid.cells(); ++i)
        for (int side = 0; side < 2; ++side)
        {
            const int f = b.grid.faceOf(0, b.grid.cellIndex(i), side);
            force += (side ? 1 : -1)*b.p[i]*(within.aperture[0][f] - b.aperture[0][f])
                *b.grid.area();
        }
    const double mass = -force*b.timeStep/speed/b.density;
    const double ratio = D == 2
        ? (tank*tank + a*a)/(tank*tank - a*a)
        : 0.5*(std::pow(tank, 3) + 2*std::pow(a, 3))/(std::pow(tank, 3) - std::pow(a, 3));
    const double volume = D == 2 ? M_PI*a*a : 4*M_PI*a*a*a/3;
    return mass/(ratio*volume) - 1;
}

//- Root mean square over several places of the grid: the error of one has the sign that chance
//  gives it
template<class C>
double addedMassError(double cellsARadius)
{
    Random random(9);
    double sum = 0;
    const int places = C::D == 2 ? 8 : 3;
    for (int k = 0; k < places; ++k)
        sum += std::pow(addedMassErrorAt<C>(cellsARadius, random(-0.5, 0.5), random(-0.5, 0.5)), 2)
            /places;
    return std::sqrt(sum);
}

CUT_TEST(AddedMassInARoundTank)
{
    const bool flat = TypeParam::D == 2;
    const double coarse = addedMassError<TypeParam>(flat ? 10 : 5),
                 fine = addedMassError<TypeParam>(flat ? 40 : 10);
    EXPECT_LT(flat ? coarse : fine, 0.01);
    // 1.5 to 1.7 from 5 to 80 cells a radius: the flux of a cut face is taken at its middle, not at
    // that of its open part
    EXPECT_GT(std::log2(coarse/fine)/(flat ? 2 : 1), 1.5) << "from " << coarse << " to " << fine;
}

//- A cell that is almost closed: its water moves with its neighbours', and takes no part in any
//  limit of the step
CUT_TEST(SliversFollow)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    Block<D, R> b({20, 20, 6}, 0.05);
    cut(b, HalfSpace<D>{point<D>(0, 0.25 - 0.05*0.995, 0), point<D>(0, 1, 0)});
    for (int i = 0; i < b.grid.cells(); ++i) b.phi[i] = R(b.centre(i)[1] - 0.7);
    for (R& u : b.u[0]) u = R(std::sin(0.3*(&u - b.u[0].data())));
    auto solver = tight(1e-13);
    b.project(solver);
    EXPECT_TRUE(b.report.converged);
    EXPECT_LT(b.report.iterations, 30);
    EXPECT_LT(b.largestSpeed(), 5);
    EXPECT_LT(b.largestImbalance(), 1e-9 + 100*TypeParam::epsilon);
}

} // namespace
} // namespace riprap

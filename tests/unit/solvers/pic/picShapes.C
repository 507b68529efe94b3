/*  Rigid bodies whose shape is a lattice of distances: against balls, and an ellipse's added mass.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/bodyReference.hpp"
#include "picShapeScene.hpp"
#include "pic/bodies/bodyShape.hpp"

namespace riprap
{
namespace
{

PicShape ballShape(int dimensions, double radius, double step)
{
    return shapeOf(dimensions, {{radius, radius, radius}}, step, 4*step,
        [&](double x, double y, double z) { return std::sqrt(x*x + y*y + z*z) - radius; });
}

template<int D>
SampledShape<D> turnedShape(const PicShape& shape, const Vec<D, double>& centre, double angle)
{
    SampledShape<D> s{};
    s.lattice.step = shape.step;
    s.lattice.distance = shape.distance.data();
    s.centre = centre;
    for (int d = 0; d < D; ++d)
    {
        s.lattice.lower[d] = shape.lower[d];
        s.lattice.n[d] = shape.n[d];
        for (int k = 0; k < D; ++k) s.axis[d][k] = d == k ? 1 : 0;
    }
    s.axis[0][0] = s.axis[1][1] = std::cos(angle);
    s.axis[1][0] = std::sin(angle);
    s.axis[0][1] = -std::sin(angle);
    return s;
}

//- There a shape has its part of a volume, a disk the mean over eight planes, and a ball none:
//  volumes alone are compared, in 3D with the true one
template<int D>
bool hasPole(const SampledShape<D>& s, const UniformGrid<D>& grid, int d, int f)
{
    const NodeGrid<D> nodes{grid};
    return inPole(s, middleOfFace(nodes.position(grid.faceIndex(d, f)), d, grid.h), d, grid.h) > 0;
}

//- As of the ball itself, wherever it lies and however it is turned. Distances err by step^2/8R at
//  most; where a face's plane nearly touches the ball its share errs by more, as the chord does:
//  the mean is compared
template<int D>
void latticeIsBall(double step, double bound, double ofVolume)
{
    constexpr double R = 5;
    const PicShape lattice = ballShape(D, R, step);
    UniformGrid<D> grid{};
    grid.h = 1;
    for (int d = 0; d < D; ++d) grid.n[d] = 16;
    const auto cut = [&](const BodyShape<D>& shape, const Vec<D, double>& centre)
    {
        FreeBody<D, BodyShape<D>> body{shape, centre, R + 1, std::vector<double>(6, 0.0)};
        BodyGrid<D> out;
        for (int d = 0; d < D; ++d) out.aperture[d].assign(grid.faces(d), 1.0);
        cutBodies(grid, std::vector<FreeBody<D, BodyShape<D>>>{body}, 1, out);
        return out;
    };
    for (int k = 0; k < 5; ++k)
    {
        Ball<D> ball;
        for (int d = 0; d < D; ++d) ball.centre[d] = 7.5 + std::fmod((k + 1)*(0.618 + 0.137*d), 1);
        ball.radius = R;
        BodyShape<D> balls, sampled;
        balls.balls.balls = {ball};
        sampled.sampled = turnedShape(lattice, ball.centre, 0.7*k);
        const BodyGrid<D> a = cut(balls, ball.centre), b = cut(sampled, ball.centre);
        double differ = 0, faces = 0;
        for (int d = 0; d < D; ++d)
            for (int f = 0; f < grid.faces(d); ++f)
            {
                if (hasPole(sampled.sampled, grid, d, f)) continue;
                const double p = a.aperture[d][f], q = b.aperture[d][f];
                differ += std::abs(p - q);
                faces += (p > 0 && p < 1) || (q > 0 && q < 1);
            }
        EXPECT_LT(differ, bound*faces) << k;
        const double volume = D == 2 ? a.terms[0].volume : 4*M_PI/3*R*R*R;
        EXPECT_NEAR(b.terms[0].volume, volume, ofVolume*volume);
        // farther out than the lattice: between the distance to its box and the truth and that
        Vec<D, double> far = ball.centre;
        far[0] += 14;
        far[1] += 9;
        EXPECT_GT(sampled.distance(far), 0.8*ball.distance(far));
        EXPECT_LT(sampled.distance(far), 1.2*ball.distance(far));
        EXPECT_GE(turnedShape(lattice, ball.centre, 0).reach(), R);
    }
}

TEST(PicShapes, ALatticeOfABallCutsAsTheBall)
{
    latticeIsBall<2>(0.5, 0.01, 0.005);
    latticeIsBall<2>(0.25, 0.0025, 0.00125);
    // the mean error of linear distances, step^2/12 times twice the curvature, is 0.5 % of the
    // volume
    latticeIsBall<3>(0.5, 0.02, 0.0075);
}

RIPRAP_ALL_SETUPS(PicShapeScene);

//- Signed distance to the ellipse of these half axes, by its points
double toEllipse(double a, double b, double x, double y)
{
    constexpr int n = 720;
    double nearest = 1e300;
    for (int i = 0; i < n; ++i)
        nearest = std::min(nearest,
            std::hypot(x - a*std::cos(2*M_PI*i/n), y - b*std::sin(2*M_PI*i/n)));
    return (x*x/(a*a) + y*y/(b*b) < 1 ? -1 : 1)*nearest;
}

PicObstacle ellipticTank(double a, double b)
{
    PicObstacle o;
    o.name = "tank";
    o.solidOutside = true;
    const int n = 400;
    for (int i = 0; i < n; ++i)
    {
        o.vertices.insert(o.vertices.end(),
            {0.5 + a*std::cos(2*M_PI*i/n), 0.5 + b*std::sin(2*M_PI*i/n), 0});
        o.elements.insert(o.elements.end(), {i, (i + 1) % n});
    }
    return o;
}

//- An ellipse in a confocal tank, in elliptic coordinates x = c cosh(s) cos(t), y = c sinh(s)
//  sin(t): the flow of a body with velocity V along y is phi = -V a cosh(s - s1)/sinh(s1 - s0)
//  sin(t), so that its added mass is rho pi a^2 coth(s1 - s0), a its half axis across the motion (b
//  if it stands)
TEST_P(PicShapeScene, AnEllipseStartsAgainstItsAddedMass)
{
    if (D() == 3) GTEST_SKIP() << "plane";
    const double a = 0.25, b = 0.15, A = 0.45, B = std::sqrt(A*A - (a*a - b*b)), dt = 1e-3,
                 g = 9.81;
    const double coth = 1/std::tanh(std::atanh(B/A) - std::atanh(b/a));
    PicConfig c = config(60);
    c.seedsPerDirection = 1;
    c.adjustTimeStep = false;
    c.fixedTimeStep = dt;
    const FluidInput water = box(c, {{0, 0, 0}}, {{1, 1, 1}}, [](double, double) { return true; });
    const PicShape shape = shapeOf(2, {{a, b, 0}}, 0.5*c.cellSize, 2*c.cellSize,
        [&](double x, double y, double) { return toEllipse(a, b, x, y); });
    for (const bool stands : {false, true})
        for (const double ratio : {0.1, 2.7})
        {
            PicInside inside;
            inside.obstacles.push_back(stands ? ellipticTank(B, A) : ellipticTank(A, B));
            const double area = M_PI*a*b, across = stands ? b : a;
            inside.solids = body(c, {{0.5, 0.5, 0.5}}, shape, 1000*ratio*area,
                1000*ratio*area*(a*a + b*b)/4, stands ? M_PI/2 : 0);
            const auto s = createPicScene(c, water, PicWalls(), &solver, std::move(inside));
            s->advance(dt);
            const double theory = (ratio - 1)/(ratio + across*across/(a*b)*coth)*g;
            EXPECT_NEAR(
                g - s->coupling().force[1]/(1000*ratio*area), theory, 0.01*std::abs(theory))
                << stands << ' ' << ratio;
        }
}

//- A ball by its lattice, against the theory of the ball
TEST_P(PicShapeScene, ABallStartsAgainstItsAddedMass)
{
    const double R = 0.45, a = 0.2, dt = 1e-3, g = 9.81, ratio = 2.7;
    const double C = D() == 2 ? (R*R + a*a)/(R*R - a*a) : 0.5*(R*R*R + 2*a*a*a)/(R*R*R - a*a*a);
    PicConfig c = config(D() == 2 ? 60 : 28);
    c.seedsPerDirection = 1;
    c.adjustTimeStep = false;
    c.fixedTimeStep = dt;
    const FluidInput water = box(c, {{0, 0, 0}}, {{1, 1, 1}}, [](double, double) { return true; });
    const double mass = 1000*ratio*(D() == 2 ? M_PI*a*a : 4*M_PI/3*a*a*a);
    PicInside inside;
    inside.obstacles.push_back(roundTank(D(), R));
    inside.solids = body(c, {{0.5, 0.5, 0.5}}, ballShape(D(), a, 0.5*c.cellSize), mass,
        (D() == 2 ? 0.5 : 0.4)*mass*a*a);
    const auto s = createPicScene(c, water, PicWalls(), &solver, std::move(inside));
    s->advance(dt);
    EXPECT_NEAR(g - s->coupling().force[1]/mass, (ratio - 1)/(ratio + C)*g,
        (D() == 2 ? 0.005 : 0.02)*g*(ratio - 1)/(ratio + C));
}

//- Half as heavy as water and half under it: a square floats however it is turned
TEST_P(PicShapeScene, ASquareFloatsOnItsVolume)
{
    if (D() == 3) GTEST_SKIP() << "plane";
    const double half = 0.15, dt = 1e-3;
    PicConfig c = config(40);
    c.adjustTimeStep = false;
    c.fixedTimeStep = dt;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.5, 1}}, [](double, double) { return true; });
    const PicShape shape = shapeOf(2, {{half, half, 0}}, 0.5*c.cellSize, 2*c.cellSize,
        [&](double x, double y, double) {
            return AxisBox<2>{{{-half, -half}}, {{half, half}}}.distance({{x, y}});
        });
    const double mass = 500*4*half*half;
    for (const double turn : {0.0, M_PI/6, M_PI/4})
    {
        PicInside inside;
        inside.solids = body(c, {{0.5, 0.5, 0.5}}, shape, mass, mass*half*half*2/3, turn);
        const auto s = createPicScene(c, water, PicWalls(), &solver, std::move(inside));
        s->advance(dt);
        EXPECT_NEAR(s->coupling().force[1]/mass, 9.81, 0.02*9.81) << turn;
    }
}

TEST_P(PicShapeScene, RefusesWhatIsNoShape)
{
    if (D() == 3) GTEST_SKIP() << "the same";
    PicConfig c = config(32);
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.5, 1}}, [](double, double) { return true; });
    const auto refused = [&](const std::function<void(PicSolids&)>& change)
    {
        auto s = body(c, {{0.5, 0.5, 0.5}}, ballShape(2, 0.1, 0.5*c.cellSize), 1, 1);
        change(*s);
        EXPECT_THROW(withSolids(c, water, s), std::invalid_argument);
    };
    refused([](PicSolids& s) { s.input.clumps[0].shape = 1; });
    refused([](PicSolids& s) { s.shapes[0].distance.pop_back(); });
    refused([&](PicSolids& s) { s.shapes[0] = ballShape(2, 1.7*c.cellSize, 0.5*c.cellSize); });
}

} // namespace
} // namespace riprap

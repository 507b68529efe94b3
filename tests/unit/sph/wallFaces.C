/*  Faces of walls hold every particle: where a point is behind one, what happens to a particle that
    comes there, and what is counted.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "sceneTest.hpp"
#include "sph/boundary/faceTables.hpp"

namespace riprap
{
namespace
{

//- Faces as a scene is given them
class Faces
{
public:
    explicit Faces(int dimensions) : D_(dimensions) {}

    //- A segment from a to b, or a triangle, a rectangle a b c d as two; normal into the fluid
    void add(const std::vector<Vector3>& corners, const Vector3& normal, int part, double half = 0,
        int body = -1)
    {
        const int first = int(in.point.size()/3);
        for (const Vector3& p : corners) in.point.insert(in.point.end(), p.begin(), p.end());
        if (D_ == 2) one(first, first + 1, -1, normal, part, half, body);
        else
        {
            one(first, first + 1, first + 2, normal, part, half, body);
            if (corners.size() > 3) one(first, first + 2, first + 3, normal, part, half, body);
        }
    }

    //- The faces of a box; outward: the fluid is outside; open: without its top (the last axis in
    //  use)
    void box(const Vector3& low, const Vector3& high, bool outward, int part, bool open = false,
        int body = -1)
    {
        for (int axis = 0; axis < D_; ++axis)
            for (int side = 0; side < 2; ++side)
            {
                if (open && axis == D_ - 1 && side == 1) continue;
                const int b = (axis + 1)%D_, c = D_ == 3 ? (axis + 2)%3 : 2;
                const auto corner = [&](bool ofB, bool ofC)
                {
                    Vector3 p = low;
                    p[axis] = side ? high[axis] : low[axis];
                    p[b] = ofB ? high[b] : low[b];
                    if (D_ == 3) p[c] = ofC ? high[c] : low[c];
                    return p;
                };
                Vector3 n{{0, 0, 0}};
                n[axis] = (side ? 1 : -1)*(outward ? 1 : -1);
                if (D_ == 2) add({corner(false, false), corner(true, false)}, n, part, 0, body);
                else
                    add({corner(false, false), corner(true, false), corner(true, true),
                            corner(false, true)},
                        n, part, 0, body);
            }
    }

    WallFaceInput in;

private:

    void one(int a, int b, int c, const Vector3& normal, int part, double half, int body)
    {
        for (const int v : {a, b, c}) in.vertex.push_back(v);
        in.normal.insert(in.normal.end(), normal.begin(), normal.end());
        in.body.push_back(body);
        in.part.push_back(part);
        in.halfThickness.push_back(half);
    }

    int D_;
};

//- Tables of the same, without a scene
template<int D>
FaceTables<D> tablesOf(const WallFaceInput& in, double spacing)
{
    std::vector<FaceElement<D>> elements(in.size());
    for (std::size_t i = 0; i < in.size(); ++i)
    {
        for (int d = 0; d < D; ++d)
        {
            elements[i].normal.c[d] = in.normal[3*i + d];
            for (int c = 0; c < D; ++c)
                elements[i].v[c].c[d] = in.point[3*std::size_t(in.vertex[3*i + c]) + d];
        }
        elements[i].group = 0;
        elements[i].part = in.part[i];
        elements[i].half = in.halfThickness[i];
    }
    return FaceTables<D>(elements, spacing, {false});
}

//- Distance from x to the surface of a box, negative inside
template<int D>
double boxDistance(const Vec<D, double>& x, const Vector3& low, const Vector3& high)
{
    double outside2 = 0, inside = -1e30;
    for (int d = 0; d < D; ++d)
    {
        const double beyond = std::max(low[d] - x.c[d], x.c[d] - high[d]);
        outside2 += std::pow(std::max(beyond, 0.0), 2);
        inside = std::max(inside, beyond);
    }
    return inside < 0 ? inside : std::sqrt(outside2);
}

template<int D>
void depthsOfBoxes()
{
    const double spacing = 0.05;
    const Vector3 low{{0.1, 0.2, 0.3}}, high{{0.87, 0.71, 0.93}};
    for (const bool outward : {false, true})
    {
        Faces faces(D);
        faces.box(low, high, outward, 0);
        const auto tables = tablesOf<D>(faces.in, spacing);
        const auto view = tables.view();
        std::mt19937 engine(7);
        int behind = 0;
        for (int k = 0; k < 20000; ++k)
        {
            Vec<D, double> x;
            for (int d = 0; d < D; ++d)
                x.c[d] = uniform(engine, low[d] - spacing, high[d] + spacing);
            const double distance = boxDistance<D>(x, low, high),
                         depth = outward ? -distance : distance;
            if (depth > spacing) continue;
            const FaceHit<D> hit = view.find(x);
            ASSERT_NEAR(hit.depth, std::max(depth, 0.0), 1e-12);
            // in a box nothing in front of its walls is looked at twice
            if (std::abs(depth) > 1e-6) { EXPECT_TRUE(outward || view.near(x) == (depth > 0)); }
            if (depth <= 1e-6) continue;
            ++behind;
            // straight out, onto the surface
            EXPECT_NEAR(boxDistance<D>(hit.nearest, low, high), 0, 1e-12);
            EXPECT_NEAR(squaredNorm(x + hit.depth*hit.normal - hit.nearest), 0, 1e-20);
        }
        EXPECT_GT(behind, 1000);
    }
}

TEST(WallFaceTables, DepthInAndAboutBoxes) { depthsOfBoxes<2>(); depthsOfBoxes<3>(); }

//- A closed surface with dents: an octahedron with divided faces and vertices at random distances.
//  Planes pass nothing that is behind it
TEST(WallFaceTables, PlanesPassNothing)
{
    std::mt19937 engine(3);
    std::map<std::array<int, 3>, double> radius;
    const auto corner = [&](int i, int j, int k)
    {
        double& r = radius[{{i, j, k}}];
        if (r == 0) r = uniform(engine, 0.2, 0.4)/std::sqrt(double(i*i + j*j + k*k));
        return Vector3{{0.5 + i*r, 0.5 + j*r, 0.5 + k*r}};
    };
    Faces faces(3);
    const auto triangle = [&](const Vector3& a, const Vector3& b, const Vector3& c)
    {
        Vec<3, double> p, q, out;
        for (int d = 0; d < 3; ++d)
        {
            p.c[d] = b[d] - a[d];
            q.c[d] = c[d] - a[d];
            out.c[d] = a[d] - 0.5;
        }
        const Vec<3, double> n = cross(p, q);
        const double sign = (dot(n, out) > 0 ? 1 : -1)/std::sqrt(squaredNorm(n));
        faces.add({a, b, c}, {{sign*n.c[0], sign*n.c[1], sign*n.c[2]}}, 0);
    };
    for (const int i : {-1, 1}) for (const int j : {-1, 1}) for (const int k : {-1, 1})
    {
        const Vector3 x = corner(2*i, 0, 0), y = corner(0, 2*j, 0), z = corner(0, 0, 2*k),
                      xy = corner(i, j, 0), yz = corner(0, j, k), zx = corner(i, 0, k);
        triangle(x, xy, zx);
        triangle(y, yz, xy);
        triangle(z, zx, yz);
        triangle(xy, yz, zx);
    }
    const auto tables = tablesOf<3>(faces.in, 0.02);
    const auto view = tables.view();
    int behind = 0, looked = 0, all = 0;
    for (int n = 0; n < 200000; ++n, ++all)
    {
        const Vec<3, double> x{{uniform(engine, 0.05, 0.95), uniform(engine, 0.05, 0.95),
            uniform(engine, 0.05, 0.95)}};
        const bool near = view.near(x);
        looked += near;
        if (!(view.find(x).depth > 0)) continue;
        ++behind;
        ASSERT_TRUE(near);
    }
    EXPECT_GT(behind, 1000);
    EXPECT_LT(looked, all/2);
}

//- Nothing is behind the rim of an open tank, nor above it
TEST(WallFaceTables, RimOfAnOpenTank)
{
    Faces faces(2);
    faces.box({{0, 0, 0}}, {{1, 1, 0}}, false, 0, true);
    const auto tables = tablesOf<2>(faces.in, 0.05);
    const auto view = tables.view();
    EXPECT_EQ(view.find(Vec<2, double>{{-0.01, 1.001}}).depth, 0);
    EXPECT_EQ(view.find(Vec<2, double>{{0.5, 1.02}}).depth, 0);
    EXPECT_NEAR(view.find(Vec<2, double>{{-0.01, 0.9}}).depth, 0.01, 1e-14);
    EXPECT_NEAR(view.find(Vec<2, double>{{-0.03, -0.04}}).depth, 0.05, 1e-14) << "the corner below";
}

//- A plate has two faces, whichever side a point came from, and ends at its rim
TEST(WallFaceTables, Plates)
{
    Faces faces(3);
    faces.add({{{0.5, 0, 0}}, {{0.5, 1, 0}}, {{0.5, 1, 1}}, {{0.5, 0, 1}}}, {{1, 0, 0}}, 1, 0.06);
    const auto tables = tablesOf<3>(faces.in, 0.05);
    const auto view = tables.view();
    for (const double side : {-1.0, 1.0})
    {
        const FaceHit<3> hit = view.find(Vec<3, double>{{0.5 + side*0.04, 0.3, 0.7}});
        EXPECT_NEAR(hit.depth, 0.02, 1e-14);
        EXPECT_NEAR(hit.nearest.c[0], 0.5 + side*0.06, 1e-14);
        EXPECT_TRUE(view.near(Vec<3, double>{{0.5 + side*0.04, 0.3, 0.7}}));
        EXPECT_EQ(view.find(Vec<3, double>{{0.5 + side*0.061, 0.3, 0.7}}).depth, 0);
        EXPECT_FALSE(view.near(Vec<3, double>{{0.5 + side*0.061, 0.3, 0.7}}));
    }
    EXPECT_EQ(view.find(Vec<3, double>{{0.51, 0.3, 1.01}}).depth, 0);
}

//- A plate is a box: the shorter of the ways out of its face and over its rim is that to the
//  surface of the box
template<int D>
void waysOutOfPlates()
{
    const double half = 0.1;
    const Vector3 low{{0.4, 0.2, 0.3}}, high{{0.6, 0.71, 0.93}};
    Faces faces(D);
    if (D == 2) faces.add({{{0.5, 0.2, 0}}, {{0.5, 0.45, 0}}}, {{1, 0, 0}}, 0, half);
    if (D == 2) faces.add({{{0.5, 0.45, 0}}, {{0.5, 0.71, 0}}}, {{1, 0, 0}}, 0, half);
    if (D == 3)
        faces.add({{{0.5, 0.2, 0.3}}, {{0.5, 0.71, 0.3}}, {{0.5, 0.71, 0.93}}, {{0.5, 0.2, 0.93}}},
            {{1, 0, 0}}, 0, half);
    const auto tables = tablesOf<D>(faces.in, 0.05);
    const auto view = tables.view();
    std::mt19937 engine(3);
    int over = 0;
    for (int k = 0; k < 20000; ++k)
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = uniform(engine, low[d] - 0.02, high[d] + 0.02);
        const double depth = -boxDistance<D>(x, low, high);
        const FaceHit<D> hit = view.find(x);
        if (depth <= 1e-6) { ASSERT_LT(hit.depth, 1e-6 + half); continue; }
        const bool rim = hit.overRim > 0;
        over += rim;
        ASSERT_NEAR(rim ? hit.overRim : hit.depth, depth, 1e-12);
        const Vec<D, double> out = rim ? hit.rimNearest : hit.nearest,
                             normal = rim ? hit.rimNormal : hit.normal;
        EXPECT_NEAR(boxDistance<D>(out, low, high), 0, 1e-12);
        EXPECT_NEAR(squaredNorm(x + depth*normal - out), 0, 1e-20);
    }
    EXPECT_GT(over, 1000);
}

TEST(WallFaceTables, WaysOutOfPlates) { waysOutOfPlates<2>(); waysOutOfPlates<3>(); }

//- A box that stands on the floor: the way out of it is never down through the floor
TEST(WallFaceTables, BoxOnTheFloor)
{
    Faces faces(3);
    faces.box({{0, 0, 0}}, {{1, 1, 1}}, false, 0);
    faces.box({{0.4, 0.4, 0}}, {{0.6, 0.6, 0.2}}, true, 1);
    const auto tables = tablesOf<3>(faces.in, 0.05);
    const auto view = tables.view();
    const FaceHit<3> hit = view.find(Vec<3, double>{{0.41, 0.5, 0.002}});
    EXPECT_NEAR(hit.depth, 0.01, 1e-14);
    EXPECT_NEAR(hit.nearest.c[0], 0.4, 1e-14);
    EXPECT_NEAR(view.find(Vec<3, double>{{0.41, 0.5, -0.003}}).depth, 0.003, 1e-14) << "up first";
}

class WallFaces : public SceneTest
{
protected:

    WallFaces() = default;

    //- An open tank in the unit box, and particles far from each other
    WallInput tank(bool open = false) const
    {
        WallInput w;
        Faces faces(D());
        faces.box({{0.1, 0.1, 0.1}}, {{0.9, 0.9, 0.9}}, false, 0, open);
        w.faces = faces.in;
        return w;
    }

    FluidInput one(const Vector3& x, const Vector3& v) const { return oneParticle(D(), x, v); }

    double mass(const SphConfig& c) const { return c.density*std::pow(c.spacing, D()); }
};

RIPRAP_ALL_SETUPS(WallFaces);

TEST_P(WallFaces, TakeTheVelocityIntoTheWall)
{
    const SphConfig c = config();
    const auto s = scene(c, one({{0.2, 0.5, 0.5}}, {{-3, 1, 0.5}}), tank());
    const SphReport r = s->advance(0.1);
    ASSERT_EQ(r.stop, StopReason::none);
    const FluidState f = s->fluid();
    EXPECT_NEAR(f.position[0], 0.1, 1e-6);
    EXPECT_GE(f.position[0], 0.1);
    EXPECT_NEAR(f.position[1], 0.6, 1e-6);
    EXPECT_NEAR(f.velocity[0], 0, 1e-6);
    EXPECT_NEAR(f.velocity[1], 1, 1e-6);
    const FaceContacts contacts = s->faceContacts();
    EXPECT_EQ(contacts.count, 1);
    EXPECT_NEAR(contacts.impulse[0], 3*mass(c), 1e-6*mass(c));
    EXPECT_NEAR(contacts.impulse[1], 0, 1e-6*mass(c));
    EXPECT_NEAR(s->energy().faceWork, -4.5*mass(c), 1e-5*mass(c));
}

//- What is put up against gravity is counted as well: a particle on the floor keeps its energy but
//  for what faces say
TEST_P(WallFaces, CountsHeightToo)
{
    SphConfig c = config();
    c.gravity[1] = -10;
    const auto s = scene(c, one({{0.5, 0.15, 0.5}}, {{0.5, 0, 0}}), tank());
    const auto total = [&]
    {
        const SphEnergy e = s->energy();
        return e.kinetic + e.potential + e.elastic;
    };
    const double before = total();
    s->advance(0.3);
    EXPECT_GT(s->faceContacts().count, 10) << "it lies there";
    EXPECT_NEAR(total() - s->energy().faceWork, before, 1e-4*before);
    EXPECT_NEAR(s->fluid().position[1], 0.1, 1e-6);
}

TEST_P(WallFaces, OpenTopsAreOpen)
{
    const SphConfig c = config();
    Vector3 v{{0, 0, 0}};
    v[D() - 1] = 5;
    const auto s = scene(c, one({{0.5, 0.5, 0.5}}, v), tank(true));
    EXPECT_EQ(s->advance(0.2).escaped.size(), 1u);
    EXPECT_EQ(s->faceContacts().count, 0);
}

//- A wall that moves hands on its own velocity
TEST_P(WallFaces, MoveParticles)
{
    const SphConfig c = config();
    WallInput w;
    Faces faces(D());
    faces.box({{0.1, 0.1, 0.1}}, {{0.9, 0.9, 0.9}}, false, 0, false, 0);
    w.faces = faces.in;
    w.nBodies = 1;
    const auto motion = [](int, double t)
    {
        WallPose p;
        p.translation = Vector3{{2*t, 0, 0}};
        return p;
    };
    // wall points far away, where they meet nothing
    w.position = {0.02, 0.02, D() == 3 ? 0.02 : 0.0};
    w.normal = {1, 0, 0};
    w.body = {0};
    SphConfig wide = c;
    wide.wallSpacing = c.spacing;
    wide.domainMax[0] = 3;
    const auto s = scene(wide, one({{0.15, 0.5, 0.5}}, {{0, 0, 0}}), w, motion);
    ASSERT_EQ(s->advance(0.2).stop, StopReason::none);
    const FluidState f = s->fluid();
    EXPECT_NEAR(f.position[0], 0.1 + 0.4, 1e-4);
    EXPECT_NEAR(f.velocity[0], 2, 1e-4);
    EXPECT_NEAR(s->faceContacts().impulse[0], 2*mass(c), 1e-3*mass(c));
}

//- Each with steps of 0.98 and 1.02 times the limit: a solid is looked for to one spacing behind
//  its face; what has two faces sends a particle out at the nearer one (benchmarks/README.md)
TEST_P(WallFaces, HoldUpToTheirLimits)
{
    SphConfig c = config();
    c.adjustTimeStep = false;
    c.maxSpeedRatio = 1e3;
    const double speed = 2, begin = 0.5 + 1e-4*c.spacing;
    const auto end = [&](const WallInput& w, double way)
    {
        c.fixedTimeStep = way/speed;
        const auto s = scene(c, one({{begin, 0.5, 0.5}}, {{-speed, 0, 0}}), w);
        s->advance(1e30, 1);
        return s->fluid().position[0];
    };
    const auto face = [&](double x, double normal, double half, int part)
    {
        Faces f(D());
        if (D() == 2) f.add({{{x, 0.1, 0}}, {{x, 0.9, 0}}}, {{normal, 0, 0}}, part, half);
        else
            f.add({{{x, 0.1, 0.1}}, {{x, 0.9, 0.1}}, {{x, 0.9, 0.9}}, {{x, 0.1, 0.9}}},
                {{normal, 0, 0}}, part, half);
        WallInput w;
        w.faces = f.in;
        return w;
    };
    const WallInput solid = face(0.5, 1, 0, 0);
    EXPECT_NEAR(end(solid, 0.98*c.spacing), 0.5, 1e-6);
    EXPECT_NEAR(end(solid, 1.02*c.spacing), begin - 1.02*c.spacing, 1e-6) << "not found there";

    const double half = 0.04;
    const WallInput plate = face(0.5 - half, 1, half, 0);
    EXPECT_NEAR(end(plate, 0.98*half), 0.5, 1e-6);
    EXPECT_NEAR(end(plate, 1.02*half), 0.5 - 2*half, 1e-6) << "out at the other side";

    Faces box(D());
    const double thickness = 0.02;
    box.box({{0.5 - thickness, 0.3, 0.3}}, {{0.5, 0.7, 0.7}}, true, 0);
    WallInput thin;
    thin.faces = box.in;
    EXPECT_NEAR(end(thin, 0.49*thickness), 0.5, 1e-6);
    EXPECT_NEAR(end(thin, 0.51*thickness), 0.5 - thickness, 1e-6) << "out at the other side";
}

//- A step of Courant number 0.5 is shorter than 0.5 h: a solid holds at any speed
TEST_P(WallFaces, HoldAtAnySpeedWithAdaptiveSteps)
{
    SphConfig c = config();
    c.acousticCourant = 0.5;
    c.maxSpeedRatio = 1e6;
    for (const double speed : {0.1, 1.0, 10.0, 100.0})
    {
        const double v = speed*c.soundSpeed;
        const auto s = scene(c, one({{0.8, 0.5, 0.5}}, {{-v, 0, 0}}), tank());
        const SphReport r = s->advance(1/v);
        EXPECT_TRUE(r.escaped.empty()) << speed;
        EXPECT_NEAR(s->fluid().position[0], 0.1, 1e-6) << speed;
    }
}

//- What comes down on the end of a plate stays on top of it, however thick it is; beside its foot
//  the floor leaves no way but aside
TEST_P(WallFaces, EndOfAPlate)
{
    SphConfig c = config();
    c.adjustTimeStep = false;
    c.fixedTimeStep = 2e-3;
    const double half = 2*c.spacing, top = 0.5;
    WallInput w = tank(true);
    Faces f(D());
    f.in = w.faces;
    if (D() == 2) f.add({{{0.5, 0.1, 0}}, {{0.5, top, 0}}}, {{1, 0, 0}}, 1, half);
    else
        f.add({{{0.5, 0, 0.1}}, {{0.5, 1, 0.1}}, {{0.5, 1, top}}, {{0.5, 0, top}}}, {{1, 0, 0}}, 1,
            half);
    w.faces = f.in;
    const auto end = [&](double x, double height, double fall)
    {
        const int up = D() - 1;
        Vector3 at{{x, 0.5, 0.5}}, v{{0, 0, 0}};
        at[up] = height + fall/2;
        v[up] = -fall/c.fixedTimeStep;
        const auto s = scene(c, one(at, v), w);
        s->advance(1e30, 1);
        return s->fluid();
    };
    for (const double aside : {-0.9, -0.3, 0.0, 0.5})
    {
        const FluidState on = end(0.5 + aside*half, top, 0.2*(1 - std::abs(aside))*half);
        EXPECT_NEAR(on.position[0], 0.5 + aside*half, 1e-6) << aside;
        EXPECT_NEAR(on.position[D() - 1], top, 1e-6) << aside;
    }
    const FluidState foot = end(0.5 + 0.9*half, 0.1 + 0.2*half, 0.05*half);
    EXPECT_NEAR(foot.position[0], 0.5 + half, 1e-6) << "not into the floor";
}

//- A crowd thrown about in a tank with a box, a plate and no wall points at all: nothing gets
//  through, and twice the same
TEST_P(WallFaces, HoldACrowd)
{
    SphConfig c = config();
    c.maxVelocity = 20;
    c.soundSpeed = 40;
    c.viscosityModel = "artificial";
    c.artificialAlpha = 0.2;
    c.gravity[D() - 1] = -10;
    WallInput w = tank();
    Faces faces(D());
    faces.in = w.faces;
    const Vector3 low{{0.3, 0.1, 0.1}}, high{{0.5, D() == 3 ? 0.5 : 0.3, 0.3}};
    faces.box(low, high, true, 1);
    if (D() == 2) faces.add({{{0.7, 0.1, 0}}, {{0.7, 0.6, 0}}}, {{1, 0, 0}}, 2, 0.05);
    else
        faces.add({{{0.7, 0.1, 0.1}}, {{0.7, 0.9, 0.1}}, {{0.7, 0.9, 0.5}}, {{0.7, 0.1, 0.5}}},
            {{1, 0, 0}}, 2, 0.05);
    w.faces = faces.in;
    FluidInput f = lattice(
        c, {{0.15, 0.6, D() == 3 ? 0.6 : 0.0}}, {{0.85, 0.85, D() == 3 ? 0.85 : 0.0}});
    disturb(c, f, 0.1, 10, 0.01);
    c.maxDensityDeviation = 1e3;
    c.maxSpeedRatio = 1e3;
    FluidState ends[2];
    for (FluidState& end : ends)
    {
        const auto s = scene(c, f, w);
        const SphReport r = s->advance(0.4);
        EXPECT_EQ(r.stop, StopReason::none);
        EXPECT_TRUE(r.escaped.empty());
        EXPECT_GT(s->faceContacts().count, 50);
        end = s->fluid();
    }
    expectSameBits(ends[0], ends[1]);
    const double hair = 1e-7;
    for (std::size_t i = 0; i < ends[0].id.size(); ++i)
    {
        const double* x = &ends[0].position[3*i];
        bool inBox = true;
        for (int d = 0; d < D(); ++d)
        {
            EXPECT_GE(x[d], 0.1 - hair);
            EXPECT_LE(x[d], 0.9 + hair);
            inBox = inBox && x[d] > low[d] + hair && x[d] < high[d] - hair;
        }
        EXPECT_FALSE(inBox);
        EXPECT_FALSE(std::abs(x[0] - 0.7) < 0.05 - hair && x[D() - 1] < (D() == 2 ? 0.6 : 0.5))
            << "in the plate";
    }
}

//- A particle that runs wild is taken out, told, and the others never see it
class Wild : public SceneTest {};
RIPRAP_ALL_SETUPS(Wild);

TEST_P(Wild, IsTakenOutAndTold)
{
    SphConfig c = config();
    c.removeWild = true;
    const double far = mixed() ? 1e25 : 1e200;
    struct
    {
        Vector3 v;
        double density;
    } const cases[] = {
        {{{0, 0, 0}}, 1250}, {{{0, 0, 0}}, 750}, {{{0, -11, 0}}, 1000}, {{{far, 0, 0}}, 1000}};
    for (const std::string integrator : {"leapfrog", "symplectic"})
        for (const auto& wild : cases)
        {
            c.integrator = integrator;
            FluidInput calm = lattice(
                c, {{0.4, 0.4, D() == 3 ? 0.4 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.6 : 0.0}});
            FluidInput f = calm;
            const Vector3 x{{0.1, 0.9, D() == 3 ? 0.2 : 0.0}};
            f.position.insert(f.position.end(), x.begin(), x.end());
            f.velocity.insert(f.velocity.end(), wild.v.begin(), wild.v.end());
            f.density.push_back(wild.density);
            const auto s = scene(c, f), alone = scene(c, calm);
            const SphReport r = s->advance(0.01), undisturbed = alone->advance(0.01);
            EXPECT_EQ(r.stop, StopReason::none);
            ASSERT_EQ(r.wild.size(), 1u);
            EXPECT_EQ(r.wild[0].id, int(calm.size()));
            EXPECT_NEAR(r.wild[0].position[0], 0.1, 1e-6);
            EXPECT_NEAR(r.wild[0].deviation, wild.density/1000 - 1, 1e-6);
            EXPECT_TRUE(r.escaped.empty());
            EXPECT_EQ(r.fluid, calm.size());
            EXPECT_EQ(s->fluid().id.size(), calm.size());
            EXPECT_EQ(r.maxSpeed, undisturbed.maxSpeed);
            EXPECT_EQ(r.steps, undisturbed.steps) << "it does not shorten the step";
            EXPECT_TRUE(s->advance(0.02).wild.empty()) << "told once";
        }
}

//- Each limit from both sides
TEST_P(Wild, ItsLimits)
{
    SphConfig c = config();
    c.removeWild = true;
    c.adjustTimeStep = false;
    c.fixedTimeStep = 1e-9;
    const double speed = c.maxSpeedRatio*c.maxVelocity, deviation = c.maxDensityDeviation;
    const double acceleration = 100*c.soundSpeed*c.soundSpeed/(c.smoothingRatio*c.spacing);
    const auto taken = [&](double v, double d, double a)
    {
        SphConfig k = c;
        k.gravity = {{0, -a, 0}};
        FluidInput f;
        f.position = {0.5, 0.5, D() == 3 ? 0.5 : 0};
        f.velocity = {v, 0, 0};
        f.density = {c.density*(1 + d)};
        return scene(k, f)->advance(1e30, 3).wild.size();
    };
    for (const double part : {0.999, 1.001})
    {
        const std::size_t expected = part > 1;
        EXPECT_EQ(taken(part*speed, 0, 0), expected) << "speed";
        EXPECT_EQ(taken(0, part*deviation, 0), expected) << "density";
        EXPECT_EQ(taken(0, -part*deviation, 0), expected) << "density";
        EXPECT_EQ(taken(0, 0, part*acceleration), expected) << "acceleration";
    }
}

//- In the midst of others, too
TEST_P(Wild, AmongOthers)
{
    SphConfig c = config();
    c.removeWild = true;
    FluidInput f = lattice(
        c, {{0.3, 0.3, D() == 3 ? 0.3 : 0.0}}, {{0.7, 0.7, D() == 3 ? 0.7 : 0.0}});
    const std::size_t middle = f.size()/2;
    f.velocity[3*middle] = mixed() ? 3e38 : 1.7e308;
    const auto s = scene(c, f);
    const SphReport r = s->advance(0.05);
    EXPECT_EQ(r.stop, StopReason::none);
    ASSERT_EQ(r.wild.size(), 1u);
    EXPECT_EQ(r.wild[0].id, int(middle));
    const FluidState end = s->fluid();
    ASSERT_EQ(end.id.size(), f.size() - 1);
    for (const double v : end.velocity) EXPECT_LT(std::abs(v), c.maxVelocity);
}

} // namespace
} // namespace riprap

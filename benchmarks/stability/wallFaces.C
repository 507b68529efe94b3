/*  Where impermeable walls fail (src/sph/boundary/wallFaces.hpp). A single particle is thrown
    straight on faces that have no wall points, from as many places as cut a step's way into equal
    parts; of them the worst counts. It has passed if it ends behind the wall, beyond the plate, or
    out of the domain.

    Theory, with s the way of one step relative to the wall. A solid is looked for to one spacing
    behind its face: it holds while s < dp. What has two faces sends a particle out at the nearer
    one: plates and thin bodies of thickness t hold while s < t/2. With adaptive steps of
    Courant number C, s = C h v/(c0 + v).

    `passage` throws a block on a wall with points and a face.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "resultTable.hpp"
#include "thrownBlock.hpp"

#include <algorithm>
#include <cmath>

namespace riprap
{

namespace
{

constexpr double dp = 0.01, c0 = 10;

//- What the particle is thrown on; thickness 0: a solid
struct Target
{
    double thickness = 0;
    bool plate = false;         // a surface with a thickness; else the faces of a solid
    double tilt = 0;            // of a solid's face [rad]
    bool moves = false;         // the wall comes to the particle
};

void addFace(WallFaceInput& f, const Vector3& a, const Vector3& b, const Vector3& normal,
    double half, int body)
{
    const int first = int(f.point.size()/3);
    for (const Vector3& p : {a, b}) f.point.insert(f.point.end(), p.begin(), p.end());
    for (const int v : {first, first + 1, -1}) f.vertex.push_back(v);
    f.normal.insert(f.normal.end(), normal.begin(), normal.end());
    f.body.push_back(body);
    f.part.push_back(0);
    f.halfThickness.push_back(half);
}

//- The surface that is hit passes through the origin
WallInput faces(const Target& t)
{
    WallInput w;
    const int body = t.moves ? 0 : -1;
    const double reach = 40*dp, sine = std::sin(t.tilt), cosine = std::cos(t.tilt);
    const Vector3 along{{reach*cosine, reach*sine, 0}}, up{{-sine, cosine, 0}},
        down{{sine, -cosine, 0}};
    const auto at = [&](double side, double depth) {
        return Vector3{{side*along[0] + depth*down[0], side*along[1] + depth*down[1], 0}};
    };
    if (t.plate)
        addFace(w.faces, at(-1, 0.5*t.thickness), at(1, 0.5*t.thickness), up, 0.5*t.thickness,
            body);
    else addFace(w.faces, at(-1, 0), at(1, 0), up, 0, body);
    if (!t.plate && t.thickness > 0)
    {
        addFace(w.faces, at(1, 0), at(1, t.thickness), Vector3{{cosine, sine, 0}}, 0, body);
        addFace(w.faces, at(1, t.thickness), at(-1, t.thickness), down, 0, body);
        addFace(w.faces, at(-1, t.thickness), at(-1, 0), Vector3{{-cosine, -sine, 0}}, 0, body);
    }
    if (t.moves)
    {
        // a moving group needs a point; this one is met by nobody
        w.nBodies = 1;
        w.position = {30*dp, -30*dp, 0};
        w.normal = {0, 1, 0};
        w.body = {0};
    }
    return w;
}

SphConfig lone(double speed, double timeStep, double courant)
{
    SphConfig c;
    c.device = DeviceKind::cpu;
    c.precision = PrecisionKind::doubled;
    c.spacing = c.wallSpacing = dp;
    c.soundSpeed = c0;
    c.maxVelocity = std::max(speed, 0.1*c0);
    c.viscosityModel = "none";
    c.integrator = "symplectic";
    c.adjustTimeStep = timeStep <= 0;
    c.fixedTimeStep = timeStep;
    c.acousticCourant = courant;
    c.maxDensityDeviation = c.maxSpeedRatio = 1e9;
    const double side = 100*dp + 200*speed*timeStep;
    c.domainMin = {{-side, -side, 0}};
    c.domainMax = {{side, side, 1}};
    return c;
}

//- From `height` above the surface, until it is there and two steps more
bool passes(const Target& t, const SphConfig& c, double speed, double height)
{
    FluidInput f;
    const double x = -std::sin(t.tilt)*height, y = std::cos(t.tilt)*height;
    f.position = {x, y, 0};
    f.velocity = {t.moves ? 0 : std::sin(t.tilt)*speed, t.moves ? 0 : -std::cos(t.tilt)*speed, 0};
    f.density = {c.density};
    const WallMotion motion = [&](int, double time)
    {
        WallPose p;
        p.translation = Vector3{{0, speed*time, 0}};
        return p;
    };
    const auto scene = createSphScene(c, f, faces(t), t.moves ? motion : WallMotion());
    const double arrival = height/speed;
    SphReport r;
    while (scene->time() < arrival && r.escaped.empty()) r = scene->advance(1e30, 1);
    for (int k = 0; k < 2 && r.escaped.empty(); ++k) r = scene->advance(1e30, 1);
    if (!r.escaped.empty()) return true;
    const FluidState s = scene->fluid();
    const double above = -std::sin(t.tilt)*s.position[0] + std::cos(t.tilt)*s.position[1]
        - (t.moves ? speed*scene->time() : 0);
    return above < -1e-9;
}

//- Does any of the places let it pass? way: of a step; runUp: steps before it, in which adaptive
//  steps grow to their length
bool holds(const Target& t, const SphConfig& c, double speed, double way, int runUp)
{
    constexpr int places = 32;
    for (int k = 0; k < places; ++k)
        if (passes(t, c, speed, (runUp + (k + 0.5)/places)*way + 1e-5*dp)) return false;
    return true;
}

Result row(const Target& t, const char* steps)
{
    Result r;
    r.test = "faces";
    r.kernel = "wendlandC2";
    r.ratio = 1.25;
    r.integrator = "symplectic";
    r.terms = steps;
    r.walls = t.plate ? "plate"
        : t.thickness > 0 ? "thin body"
        : t.moves ? "moving solid"
        : t.tilt > 0 ? "tilted solid"
                          : "solid";
    return r;
}

//- Fixed steps: the longest way in units of the spacing, or of the thickness
void reportWay(ResultTable& table, Target t, bool quick)
{
    const double speed = c0, unit = t.thickness > 0 ? t.thickness : dp;
    const double limit = bisect(0.1, 8, quick ? 0.05 : 0.01, [&](double k)
    { return holds(t, lone(speed, k*unit/speed, 0.5), speed, k*unit, 2); });
    Result r = row(t, "fixed steps");
    r.quantity = t.thickness > 0 ? "particle: way of a step that passes / thickness"
                                 : "particle: way of a step that passes / dp";
    r.measured = limit;
    r.theory = t.thickness > 0 ? 0.5 : 1;
    r.note = t.tilt > 0 ? "theory: at least" : "";
    table.add(r);
}

//- Adaptive steps: the thickness that is passed at a speed
void reportThickness(ResultTable& table, double mach, double courant, bool quick)
{
    Target t;
    const double speed = mach*c0, h = 1.25*dp, way = courant*h*speed/(c0 + speed);
    // thicker holds: bisected downwards
    const double limit = -bisect(-3, -0.01, quick ? 0.05 : 0.01, [&](double minusThickness)
    {
        t.thickness = -minusThickness*dp;
        return holds(t, lone(speed, 0, courant), speed, way, 20);
    });
    Result r = row(t, "adaptive steps");
    char text[80];
    std::snprintf(
        text, sizeof text, "particle: thickness/dp that %.1f c0 passes; Courant %g", mach, courant);
    r.quantity = text;
    r.measured = limit;
    r.theory = 2*way/dp;
    table.add(r);
}

} // namespace

void wallFaces(ResultTable& table, bool quick)
{
    const auto target = [](double thickness, bool plate, double tilt, bool moves)
    {
        Target t;
        t.thickness = thickness;
        t.plate = plate;
        t.tilt = tilt;
        t.moves = moves;
        return t;
    };
    for (const Target& t : {target(0, false, 0, false), target(0, false, 0.5, false),
             target(0, false, 0, true), target(2*dp, true, 0, false),
             target(2*dp, false, 0, false), target(0.2*dp, false, 0, false)})
        reportWay(table, t, quick);
    for (const double mach : {0.1, 0.5, 1.0, 3.0})
        for (const double courant : {0.5, 1.5})
            if (!quick || mach == 1) reportThickness(table, mach, courant, quick);
}

} // namespace riprap

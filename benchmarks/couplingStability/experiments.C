/*  SPDX-License-Identifier: GPL-3.0-or-later  */
#include "experiments.hpp"

#include <algorithm>
#include "sph/kernels/wendlandC2.hpp"

namespace riprap
{

namespace
{

const std::string kinds[] = {
    "stationary", "pressureGradient", "pressureApproximation", "extrapolated"};
const std::string forces[] = {"held", "interpolated", "impulse"};

//- A run has failed when its energy has gone up by this share of the kinetic energy: what the
//  schemes exchange in good runs is below 0.01
constexpr double failure = 0.05;

bool stays(const StirredBlock& b)
{
    const StirredResult r = stir(b);
    return !r.stopped && r.energy < failure;
}

//- Between a value that fails and one that does not, to two hundredths of its logarithm; the end of
//  the range where nothing (or all) fails
template<class Good>
double boundary(double bad, double good, const Good& stays)
{
    if (!stays(good)) return NAN;
    if (stays(bad)) return bad;
    while (std::abs(std::log(good/bad)) > 0.02)
    {
        const double middle = std::sqrt(bad*good);
        (stays(middle) ? good : bad) = middle;
    }
    return good;
}

//- Stiffness of the water about a solid point that moves alone [N/m]: k = rho c0^2 V_S^2 V_F sum
//  (dW/dx)^2 over a lattice
double stiffness(const StirredBlock& b)
{
    const double h = b.smoothing*b.spacing, size = b.sizeRatio*b.spacing;
    const int reach = int(2*b.smoothing) + 1;
    double sum = 0;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
        {
            const double q = std::sqrt(double(i*i + j*j))*b.spacing/h;
            if (q > 0 && q < 2)
                sum += std::pow(
                    WendlandC2::alpha(2)/std::pow(h, 4)*WendlandC2::slope(q)*i*b.spacing,
                    2);
        }
    return b.density*b.soundSpeed*b.soundSpeed*std::pow(size, 4)*b.spacing*b.spacing*sum;
}

//- Mass of the water that sound reaches from the two sides of a square body within a step, over the
//  water that the body displaces: a body that is half as heavy as that is stopped by the pressure
//  of its own step
double reached(const StirredBlock& b)
{
    const double h = b.smoothing*b.spacing, side = b.across*b.sizeRatio*b.spacing;
    return 2*b.courant*h/side;
}

const char* bodyOf(const StirredBlock& b) { return b.rigid ? "rigid" : "bonded"; }

} // namespace

void density(CouplingRows& rows)
{
    for (const bool rigid : {true, false})
        for (const std::string& force : forces)
            for (const std::string& kind : kinds)
            {
                StirredBlock b;
                b.rigid = rigid;
                b.force = force;
                b.kind = kind;
                b.settle = 0.1;
                b.duration = 0.2;
                const double least = boundary(0.05, 3,
                    [&](double ratio)
                    {
                        b.densityRatio = ratio;
                        return stays(b);
                    });
                rows.add({"density", kind, force, bodyOf(b), "least density ratio",
                    b.courant, least, rigid ? 0.5*reached(b) : NAN,
                    rigid ? "theory: half the water that sound reaches in a step"
                          : "undamped bonds, E/(rho c0^2) = 10"});
            }
}

void step(CouplingRows& rows)
{
    for (const double ratio : {0.3, 2.7})
        for (const std::string& force : forces)
            for (const std::string& kind : kinds)
            {
                StirredBlock b;
                b.rigid = true;
                b.force = force;
                b.kind = kind;
                b.densityRatio = ratio;
                const double largest = boundary(2, 0.05,
                    [&](double courant)
                    {
                        b.courant = courant;
                        return stays(b);
                    });
                rows.add({"step", kind, force, bodyOf(b), "largest c0 dt/h", ratio,
                    largest, NAN, "setting: density ratio"});
            }
}

void bonds(CouplingRows& rows)
{
    for (const double young : {1e5, 3e5, 1e6, 3e6, 1e7, 3e7})
        for (const std::string& force : forces)
            for (const std::string kind : {"pressureGradient", "extrapolated"})
            {
                StirredBlock b;
                b.force = force;
                b.kind = kind;
                b.young = young;
                b.densityRatio = 1.1;
                b.duration = 0.2;
                const double relative = young/(b.density*b.soundSpeed*b.soundSpeed);
                const StirredResult r = stir(b);
                rows.add({"bonds", kind, force, bodyOf(b),
                    "energy gained / kinetic", relative, r.stopped ? INFINITY : r.energy, 0,
                    "setting: E/(rho c0^2); subcycles " + std::to_string(r.subcycles)});
                if (force != "held") continue;
                // (1 - cos t)/(2 t) is at most 0.362; the water's share of a bond's stiffness,
                // twice where solids take pressure
                const double share = (kind == "extrapolated" ? 2 : 1)*stiffness(b)
                    /young;
                const double least = boundary(1e-4, 0.5,
                    [&](double damping)
                    {
                        b.dampingRatio = damping;
                        return stays(b);
                    });
                rows.add({"bonds", kind, force, bodyOf(b), "least damping ratio",
                    relative, least, 0.362*share,
                    "theory: 0.362 of the water's share of the stiffness, whatever the mode"});
            }
}

void leak(CouplingRows& rows)
{
    for (const double size : {0.5, 0.75, 1.0, 1.2, 1.5, 2.0, 3.0})
        for (const std::string& kind : kinds)
        {
            StirredBlock b;
            b.rigid = true;
            b.force = "impulse";
            b.kind = kind;
            b.sizeRatio = size;
            b.across = std::max(2, int(std::lround(6/size)));
            b.densityRatio = 1.1;
            b.compression = 0.03;
            b.speed = 1;
            b.duration = 0.5;
            const StirredResult r = stir(b);
            rows.add({"leak", kind, b.force, bodyOf(b),
                "water particles in the body", size, r.stopped ? INFINITY : r.inside, 0,
                "setting: size of solid over fluid particles; pressure 0.03 rho c0^2, speed 0.1 "
                "c0"});
        }
}

} // namespace riprap

/*  A template: copy it to tests/unit beside the term's header. What the formula must give; all that
    is common to terms is tested by terms.hpp and sphCards.C.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include "sph/passes/fluidPass.hpp"
#include "sph/kernels/wendlandC2.hpp"
#include "sph/terms/radialViscosity.hpp"

namespace riprap
{
namespace
{

//- dv/dt of a particle in the middle of a square lattice that moves with v(x, y)
template<class Velocity>
Vec<2, double> acceleration(double viscosity, Velocity velocity)
{
    const double spacing = 0.01, h = 3*spacing, density = 1000;
    TermProperties p;
    RadialViscosity<double>::eta.set(p, 1e-6);
    TermFluid f;
    f.density = density;
    f.viscosity = viscosity;
    const auto term = RadialViscosity<double>::make(p, f);
    const auto kernel = KernelConstants<2, double>::make<WendlandC2>(h, spacing);
    PairParticle<2, double> i{velocity(0, 0), 0, density, h}, j = i;
    Vec<2, double> a{{0, 0}};
    for (int k = -6; k <= 6; ++k)
        for (int l = -6; l <= 6; ++l)
        {
            if (k == 0 && l == 0) continue;
            const Vec<2, double> dx{{-k*spacing, -l*spacing}};
            j.velocity = velocity(k*spacing, l*spacing);
            const double r2 = squaredNorm(dx);
            const auto g = pairGeometry<WendlandC2, false, false>(kernel, h, i, j, dx, r2);
            Channels<double> c{0, 0, 0, 0};
            term(i, j, g, c);
            const double mf = density*spacing*spacing*g.f;
            for (int d = 0; d < 2; ++d) a.c[d] += mf*(c.radial*dx.c[d] + c.cross*g.dv.c[d]);
        }
    return a;
}

//- v = (s y^2, 0): nu d2v/dy2 = 2 nu s, but for the 0.9 % that h of three spacings leaves
TEST(RadialViscosity, ShearFlow)
{
    const auto a = acceleration(1, [](double, double y) { return Vec<2, double>{{100*y*y, 0}}; });
    EXPECT_NEAR(a.c[0], 0.2, 0.2*0.015);
    EXPECT_NEAR(a.c[1], 0, 1e-12);
}

//- What turns as a whole is not slowed
TEST(RadialViscosity, RigidRotation)
{
    const auto a = acceleration(1, [](double x, double y) { return Vec<2, double>{{-5*y, 5*x}}; });
    EXPECT_NEAR(a.c[0], 0, 1e-12);
    EXPECT_NEAR(a.c[1], 0, 1e-12);
}

} // namespace
} // namespace riprap

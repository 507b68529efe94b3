/*  A template: copy it to tests/unit beside the law's header. The closed form that the law is to
    meet; all that is common to laws is tested by lawCards.C.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include "dem/contact/normal/hardeningSpring.hpp"
#include "dem/contact/rolling/noRolling.hpp"
#include "dem/contact/tangential/frictionless.hpp"
#include "dem/impact.hpp"

namespace riprap
{
namespace
{

//- An elastic impact at its deepest has stored what the bodies had: k d^2 (1/2 + beta d/(3 R*)) =
//  m* v^2/2
TEST(HardeningSpring, DeepestOverlap)
{
    PairProperties p;
    p.normalStiffness = 1e5;
    HardeningSpring::beta.set(p, 5);
    Body<3> a, b;
    a.radius = b.radius = 0.01;
    a.mass = b.mass = 0.01;
    const double speed = 2, R = 0.005, m = 0.005;
    approach(a, b, speed, 0);
    const double d =
        collide<Contact<HardeningSpring, Frictionless, NoRolling>>(a, b, p, 1e-7).maxOverlap;
    const double stored = p.normalStiffness*d*d*(0.5 + 5*d/(3*R)), given = 0.5*m*speed*speed;
    EXPECT_NEAR(stored, given, 1e-5*given);
    // the linear spring would sink in deeper by a twentieth at least
    EXPECT_LT(d, 0.95*speed*std::sqrt(m/p.normalStiffness));
}

} // namespace
} // namespace riprap

/*  Contact laws against closed forms of impacts: duration, overlap and force of linear and Hertz
    contacts, restitution, stiffness of paper 2, energy of oblique elastic impacts, momentum,
    sliding, Coulomb's limit, rolling friction; packs against scalars.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include "dem/contact/normal/cellSpring.hpp"
#include "dem/contact/normal/hertz.hpp"
#include "dem/contact/normal/incrementalSpring.hpp"
#include "dem/contact/normal/linearSpring.hpp"
#include "dem/contact/rolling/constantTorque.hpp"
#include "dem/contact/rolling/noRolling.hpp"
#include "dem/contact/rolling/rollingSpring.hpp"
#include "dem/contact/tangential/frictionless.hpp"
#include "dem/contact/tangential/historySpring.hpp"
#include "dem/contact/tangential/mindlin.hpp"
#include "dem/contact/tangential/oneStepSpring.hpp"
#include "impact.hpp"

namespace riprap
{
namespace
{

constexpr double pi = 3.14159265358979323846;

template<class N> using Smooth = Contact<N, Frictionless, NoRolling>;

PairProperties linear(double k, double e = 1)
{
    PairProperties p;
    p.normalStiffness = k;
    p.restitution = e;
    return p;
}

PairProperties glass(double e = 1)
{
    PairProperties p;
    p.youngA = p.youngB = 48e9;
    p.poissonA = p.poissonB = 0.2;
    p.restitution = e;
    return p;
}

template<int D>
void makeBodies(Body<D>& a, Body<D>& b)
{
    a.radius = 0.01;
    b.radius = 0.015;
    a.mass = 0.011;
    b.mass = 0.031;
}

double reduced(double a, double b) { return a*b/(a + b); }

//- Half an oscillation: pi sqrt(m*/k), overlap v sqrt(m*/k). Leapfrog: phase error (w dt)^2/24, the
//  first step up to one dt early
TEST(ContactLaws, LinearImpactIsHalfAnOscillation)
{
    const double k = 1e5, speed = 0.7;
    Body<3> a, b;
    makeBodies(a, b);
    const double root = std::sqrt(reduced(a.mass, b.mass)/k), dt = root/1000;
    approach(a, b, speed, 0);
    const ImpactResult r = collide<Smooth<LinearSpring>>(a, b, linear(k), dt);
    EXPECT_NEAR(r.duration, pi*root, 1.5*dt);
    EXPECT_NEAR(r.maxOverlap, speed*root, 1e-6*speed*root);
    const double vb = 2*a.mass/(a.mass + b.mass)*speed;
    EXPECT_NEAR(b.v.c[0], vb, 1e-5*speed);
    EXPECT_NEAR(a.v.c[0], vb - speed, 1e-5*speed);
}

TEST(ContactLaws, IncrementalSpringForgetsTheFirstOverlap)
{
    const double k = 1e5;
    Body<2> a, b;
    makeBodies(a, b);
    approach(a, b, 0, 0);
    b.x.c[0] -= 1e-4;
    const double dt = 1e-6;
    b.v.c[0] = -0.5;                        // closes by 0.5 dt in the first step
    const double d = b.x.c[0];
    double armA, armB, h[1] = {0};
    const ContactBody<2, double> ca{a.v, a.w, a.radius, a.mass}, cb{b.v, b.w, b.radius, b.mass};
    const auto g = pairGeometry<2, double>(ca, cb, Vec<2, double>{{1, 0}}, d, 0.0, dt, armA, armB);
    NormalForce<double> fn;
    using Law = Smooth<IncrementalSpring>;
    Law::evaluate<2, double>(Law::make<double>(linear(k)), g, armA, armB, h, fn);
    EXPECT_NEAR(fn.force, k*0.5*dt, 1e-12);
    EXPECT_NEAR(h[0], k*0.5*dt, 1e-12);
}

//- Hertz: overlap (15 m* v^2/(16 E* R*^(1/2)))^(2/5), duration 2.868265 (m*^2/(R* E*^2 v))^(1/5)
//  (Johnson 1985, section 11.4:
//  2.87; Gamma(2/5) sqrt(pi)/Gamma(9/10) (4/5) (15/16)^(2/5) gives the digits)
TEST(ContactLaws, HertzImpact)
{
    const double speed = 3.9;
    Body<3> a, b;
    makeBodies(a, b);
    const double m = reduced(a.mass, b.mass), R = reduced(a.radius, b.radius),
                 E = glass().effectiveYoung();
    const double overlap = std::pow(15*m*speed*speed/(16*E*std::sqrt(R)), 0.4);
    const double constant = std::tgamma(0.4)*std::sqrt(pi)/std::tgamma(0.9)*0.8
        *std::pow(15.0/16, 0.4);
    EXPECT_NEAR(constant, 2.87, 0.005);
    const double duration = constant*std::pow(m*m/(R*E*E*speed), 0.2), dt = duration/4000;
    approach(a, b, speed, 0);
    const ImpactResult r = collide<Smooth<Hertz>>(a, b, glass(), dt);
    EXPECT_NEAR(r.maxOverlap, overlap, 1e-5*overlap);
    EXPECT_NEAR(r.duration, duration, 2*dt);
    EXPECT_NEAR(r.maxForce, 4.0/3*E*std::sqrt(R)*std::pow(overlap, 1.5), 2e-5*r.maxForce);
}

//- Chung & Ooi's test 1: two glass spheres of 10 mm radius meet at 10 m/s each: 274.11 um, 10.697
//  kN, 40.34 us
TEST(ContactLaws, ChungOoiGlass)
{
    Body<3> a, b;
    a.radius = b.radius = 0.01;
    a.mass = b.mass = 2800*4.0/3*pi*1e-6;
    approach(a, b, 20, 0);
    const ImpactResult r = collide<Smooth<Hertz>>(a, b, glass(), 1e-8);
    EXPECT_NEAR(r.maxOverlap, 274.11e-6, 1e-4*274.11e-6);
    EXPECT_NEAR(r.maxForce, 10.697e3, 1e-4*10.697e3);
    EXPECT_NEAR(r.duration, 40.34e-6, 3e-8);        // the step and a digit
}

template<class Law>
double measuredRestitution(PairProperties p, double speed, double dt)
{
    Body<3> a, b;
    makeBodies(a, b);
    approach(a, b, speed, 0);
    collide<Law>(a, b, p, dt);
    return (b.v.c[0] - a.v.c[0])/speed;
}

//- Restitution as asked for, with and without attraction, at any speed
TEST(ContactLaws, Restitution)
{
    for (const bool attraction : {false, true})
        for (const double e : {0.05, 0.3, 0.6, 0.9, 1.0})
        {
            PairProperties p = linear(1e5, e), q = glass(e);
            p.attraction = q.attraction = attraction;
            const double root = std::sqrt(reduced(0.011, 0.031)/1e5);
            EXPECT_NEAR(measuredRestitution<Smooth<LinearSpring>>(p, 0.5, root/4000), e, 1e-3)
                << attraction;
            for (const double speed : {0.1, 5.0})
                EXPECT_NEAR(measuredRestitution<Smooth<Hertz>>(q, speed, 1e-8), e, 1e-3)
                    << attraction << " " << speed;
        }
}

//- At the default step, 0.2 sqrt(m/k), wherever within the step the impact begins. What is left is
//  of second order: four times less at half the step. Without dashpot.hpp's two corrections the
//  mean of e = 0.5 is 1.9 % low, and single impacts by up to 9 %
template<class Law>
void restitutionOfCoarseSteps(PairProperties p, double speed, double root)
{
    const double e = p.restitution;
    const auto errors = [&](double fraction)
    {
        const int places = 50;
        double mean = 0, worst = 0;
        for (int k = 0; k < places; ++k)
        {
            Body<3> a, b;
            makeBodies(a, b);
            approach(a, b, speed, 0);
            const double dt = fraction*root;
            b.x.c[0] += (k + 0.5)/places*speed*dt;
            collide<Law>(a, b, p, dt);
            const double error = (b.v.c[0] - a.v.c[0])/speed/e - 1;
            mean += error/places;
            worst = std::max(worst, std::abs(error));
        }
        return std::pair<double, double>(std::abs(mean), worst);
    };
    const auto coarse = errors(0.2), fine = errors(0.05);
    // a dashpot that pulls may make the last step one more
    EXPECT_LT(coarse.first, 5e-3) << e;
    EXPECT_LT(coarse.second, p.attraction ? 0.06 : 0.02) << e;
    EXPECT_LT(fine.first, 1e-3) << e;
    EXPECT_LT(fine.second, p.attraction ? 0.015 : 5e-3) << e;
}
TEST(ContactLaws, RestitutionAtTheDefaultStep)
{
    // the lighter body's sqrt(m/k); Hertz: at the overlap of this impact
    for (const bool attraction : {false, true})
        for (const double e : {0.9, 0.5})
        {
            PairProperties p = linear(1e5, e), q = glass(e);
            p.attraction = q.attraction = attraction;
            restitutionOfCoarseSteps<Smooth<LinearSpring>>(p, 0.5, std::sqrt(0.011/1e5));
            const double speed = 2, R = reduced(0.01, 0.015), m = reduced(0.011, 0.031),
                         E = q.effectiveYoung();
            const double overlap = std::pow(15*m*speed*speed/(16*E*std::sqrt(R)), 0.4);
            restitutionOfCoarseSteps<Smooth<Hertz>>(
                q, speed, std::sqrt(0.011/(2*E*std::sqrt(R*overlap))));
        }
}

TEST(ContactLaws, DashpotDoesNotPull)
{
    for (const bool attraction : {false, true})
    {
        PairProperties p = linear(1e5, 0.2);
        p.attraction = attraction;
        const auto q = LinearSpring::make(p);
        const LinearSpring::Parameters<double> r{q.k, q.twoZeta, q.floor};
        ContactGeometry<2, double> g{};
        g.overlap = 1e-9;
        g.approach = -1;                    // parting
        g.reducedMass = 0.01;
        const double f = LinearSpring::force(r, g, static_cast<double*>(nullptr)).force;
        if (attraction) EXPECT_LT(f, 0); else EXPECT_EQ(f, 0);
    }
}

//- Paper 2, Eqs. 10, 11: at rest under its weight a solid sinks in by theta dx
TEST(ContactLaws, CellSpringSinksThetaDx)
{
    PairProperties p;
    p.theta = 0.01;
    p.cellSize = 5e-4;
    p.gravity = 9.81;
    p.alpha = 0.3;
    const auto q = CellSpring::make(p);
    ContactGeometry<2, double> g{};
    g.meanMass = 0.2;
    g.overlap = p.theta*p.cellSize;
    auto f = CellSpring::force(q, g, static_cast<double*>(nullptr));
    EXPECT_NEAR(f.force, 0.2*9.81, 1e-12);
    g.approach = 0.1;
    f = CellSpring::force(q, g, static_cast<double*>(nullptr));
    EXPECT_NEAR(f.force, 0.2*9.81 + 2*0.3*std::sqrt(0.2*f.stiffness)*0.1, 1e-12);
}

struct Oblique { double gain, loss; };

//- Largest relative gain and loss of energy over angles, elastic impacts
template<class Law, int D>
Oblique energyOverAngles(PairProperties p, double mu, double dt)
{
    p.friction = mu;
    Oblique worst{-1, -1};
    for (int degrees = 0; degrees < 90; degrees += 5)
    {
        Body<D> a, b;
        makeBodies(a, b);
        approach(a, b, 1, degrees*pi/180);
        if (degrees % 10) a.w.c[spins<D> - 1] = 40;
        const double before = a.kinetic() + b.kinetic();
        collide<Law>(a, b, p, dt);
        const double change = (a.kinetic() + b.kinetic() - before)/before;
        worst.gain = std::max(worst.gain, change);
        worst.loss = std::max(worst.loss, -change);
    }
    return worst;
}

//- No angle, stuck or slipping, gains energy: beyond what the step leaves, O(dt^2) of the phase.
//  LAMMPS's mindlin gains 9e-3
TEST(ContactLaws, ElasticObliqueImpactsNeverGainEnergy)
{
    using HistoryLaw = Contact<LinearSpring, HistorySpring, NoRolling>;
    using MindlinLaw = Contact<Hertz, Mindlin, NoRolling>;
    const double root = std::sqrt(reduced(0.011, 0.031)/1e5);
    for (const double mu : {0.0, 0.1, 0.3, 0.5, 1.0, 1e6})
    {
        const Oblique l2 = energyOverAngles<HistoryLaw, 2>(linear(1e5), mu, root/1000);
        const Oblique l3 = energyOverAngles<HistoryLaw, 3>(linear(1e5), mu, root/1000);
        const Oblique h3 = energyOverAngles<MindlinLaw, 3>(glass(), mu, 2e-8);
        EXPECT_LT(l2.gain, 2e-5) << mu;
        EXPECT_LT(l3.gain, 2e-5) << mu;
        EXPECT_LT(h3.gain, 2e-5) << mu;
    }
}

//- The impacts in which LAMMPS's mindlin gains 6e-4 (20 degrees) and 9e-3 (60), and its rescaled
//  form loses 1.8e-2 and 0.109: two equal spheres, mu = 10. What is left in the spring when they
//  part is lost, and nothing else
TEST(ContactLaws, MindlinKeepsMoreThanRescaledAndGainsNothing)
{
    PairProperties p;
    p.youngA = p.youngB = 3.8e11;
    p.poissonA = p.poissonB = 0.23;
    p.friction = 10;
    for (const auto& [degrees, largestLoss] : {std::pair<int, double>{20, 3e-3}, {60, 2e-2}})
    {
        Body<3> a, b;
        a.radius = b.radius = 0.0025;
        a.mass = b.mass = 4000*4.0/3*pi*std::pow(a.radius, 3);
        approach(a, b, 3.9, degrees*pi/180);
        // as seen from their centre of mass
        b.v = -0.5*a.v;
        a.v = 0.5*a.v;
        const double before = a.kinetic() + b.kinetic();
        collide<Contact<Hertz, Mindlin, NoRolling>>(a, b, p, 8e-8);
        const double change = (a.kinetic() + b.kinetic())/before - 1;
        EXPECT_LT(change, 1e-6);
        EXPECT_GT(change, -largestLoss);
    }
}

//- Gross sliding (Chung & Ooi 4): the tangential impulse is mu times the normal one, dv_t = mu (1 +
//  e) v_n. Slow, so that the line of centres does not turn meanwhile: by v_t t_c/(R_A + R_B) = 1e-4
TEST(ContactLaws, GrossSliding)
{
    PairProperties p = glass();
    p.friction = 0.1;
    const double angle = 60*pi/180;
    Body<3> a, b;
    makeBodies(a, b);
    approach(a, b, 0.02, angle);
    const double m = reduced(a.mass, b.mass), vn = 0.02*std::cos(angle), vt = 0.02*std::sin(angle);
    collide<Contact<Hertz, Mindlin, NoRolling>>(a, b, p, 1e-8);
    EXPECT_NEAR(a.v.c[1], vt - p.friction*2*m*vn/a.mass, 0.0003*vt);
    EXPECT_NEAR(a.w.c[2], -p.friction*2*m*vn*a.radius/a.inertia(), 0.001*std::abs(a.w.c[2]));
}

//- Linear and angular momentum of an off-centre impact with everything switched on
template<int D>
void momentumIsKept()
{
    PairProperties p = glass(0.7);
    p.friction = 0.4;
    p.rollingFriction = 0.1;
    p.rollingDamping = 0.3;
    Body<D> a, b;
    makeBodies(a, b);
    approach(a, b, 1, 0.7);
    for (int c = 0; c < spins<D>; ++c) { a.w.c[c] = 10*(c + 1); b.w.c[c] = -7 + 3*c; }
    const auto angular = [&]
    {
        return moment(a.x, a.mass*a.v) + moment(b.x, b.mass*b.v) + a.inertia()*a.w
            + b.inertia()*b.w;
    };
    const auto linearMomentum = [&] { return a.mass*a.v + b.mass*b.v; };
    const auto L = angular();
    const auto I = linearMomentum();
    collide<Contact<Hertz, Mindlin, RollingSpring>>(a, b, p, 5e-8);
    for (int d = 0; d < D; ++d) EXPECT_NEAR(linearMomentum().c[d], I.c[d], 1e-15);
    for (int c = 0; c < spins<D>; ++c) EXPECT_NEAR(angular().c[c], L.c[c], 1e-16);
}
TEST(ContactLaws, MomentumIsKept) { momentumIsKept<2>(); momentumIsKept<3>(); }

//- The one-step spring knows no stretch: f_t = k_t V dt + c_t V, kappa = 1/(2 (1 + psi))
TEST(ContactLaws, OneStepSpring)
{
    PairProperties p;
    p.poissonA = p.poissonB = 0.3;
    p.friction = 0.5;
    const auto q = OneStepSpring::make(p);
    ContactGeometry<2, double> g{};
    g.slip.c[0] = 0.01;
    g.dt = 1e-4;
    NormalForce<double> fn{1000, 1000, 1e5, 20, 1000};
    const double kappa = 1/(2*1.3);
    const double expected = kappa*1e5*0.01*1e-4 + std::sqrt(kappa)*20*0.01;
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR((OneStepSpring::force<2, double>(q, g, fn, nullptr).c[0]), expected, 1e-14);
    fn.force = fn.load = 0.01;
    EXPECT_NEAR((OneStepSpring::force<2, double>(q, g, fn, nullptr).c[0]), 0.5*0.01, 1e-15);
}

//- A stretch keeps its length and stays in the contact plane when the contact turns
TEST(ContactLaws, HistoryTurnsWithTheContact)
{
    const auto p = HistorySpring::make(
        []
        {
            PairProperties q;
            q.friction = 1e9;
            q.stiffnessRatio = 1;
            return q;
        }());
    ContactGeometry<3, double> g{};
    g.dt = g.since = 1e-3;
    NormalForce<double> fn{1, 1, 1, 0, 1};
    double h[3] = {0, 0.002, 0};
    for (int k = 0; k <= 100; ++k)
    {
        const double turn = 0.5*pi*k/100;
        g.n = Vec<3, double>{{std::cos(turn), std::sin(turn), 0}};
        HistorySpring::force<3, double>(p, g, fn, h);
        EXPECT_NEAR(h[0]*g.n.c[0] + h[1]*g.n.c[1], 0, 1e-16);
        EXPECT_NEAR(std::hypot(h[0], h[1], h[2]), 0.002, 1e-15);
    }
    EXPECT_NEAR(h[0], -0.002, 1e-15);
}

//- However a contact is dragged about, with a dashpot that alone exceeds Coulomb's limit: what is
//  stored grows by no more than the bodies' work, and the spring's force stays within the limit.
//  The stiffness is held, since without overlap's change it is
template<class Normal, class Tangential, int D>
void storesNoMoreThanIsPutIn(PairProperties q, double stiffness)
{
    using Law = Contact<Normal, Tangential, NoRolling>;
    q.friction = 0.3;
    const auto p = Law::template make<double>(q);
    ContactGeometry<D, double> g{};
    g.n = filled<D>(0.0);
    g.n.c[0] = 1;
    g.dt = g.since = 1e-5;
    double h[3] = {}, stored = 0, highest = 0;
    unsigned seed = 1;
    const auto random = [&] { seed = seed*1664525u + 1013904223u; return seed/4294967296.0 - 0.5; };
    for (int k = 0; k < 20000; ++k)
    {
        // for some steps one way, then another; now and then slowly
        if (k % 20 == 0)
        {
            const double speed = std::pow(10.0, 6*random() - 2);
            for (int c = 0; c < spins<D>; ++c) g.slip.c[c] = D == 3 && c == 0 ? 0 : speed*random();
        }
        const double load = 1 + random();
        const NormalForce<double> fn{load, 1 + random(), stiffness, 300, load};
        const auto f = Tangential::template force<D, double>(p.tangential, g, fn, h);
        const double now = Tangential::template energy<D, double>(p.tangential, fn, h);
        const double work = g.dt*dot(f, g.slip);
        ASSERT_LE(now - stored, work + 1e-12*std::abs(stored)) << "step " << k;
        ASSERT_LE(std::sqrt(squaredNorm(f)), q.friction*fn.force*(1 + 1e-12)) << "step " << k;
        stored = now;
        highest = std::max(highest, stored);
    }
    EXPECT_GT(highest, 0);
}
TEST(ContactLaws, ContactEnergyComesFromTheBodiesAlone)
{
    storesNoMoreThanIsPutIn<LinearSpring, HistorySpring, 2>(linear(1e5, 0.1), 1e5);
    storesNoMoreThanIsPutIn<LinearSpring, HistorySpring, 3>(linear(1e5, 0.1), 1e5);
    storesNoMoreThanIsPutIn<Hertz, Mindlin, 2>(glass(0.1), 1e5);
    storesNoMoreThanIsPutIn<Hertz, Mindlin, 3>(glass(0.1), 1e5);
}

//- Rolling friction: constant torque, and a spring that yields at the same torque
TEST(ContactLaws, RollingFriction)
{
    PairProperties q;
    q.rollingFriction = 0.2;
    ContactGeometry<3, double> g{};
    g.n = Vec<3, double>{{0, 0, -1}};
    g.reducedRadius = 0.01;
    g.reducedMass = 0.02;
    g.roll = Spin<3, double>{{0, -3, 0}};
    g.dt = g.since = 1e-5;
    const NormalForce<double> fn{5, 5, 1e4, 0, 5};
    const double limit = 0.2*0.01*5;
    EXPECT_NEAR((ConstantTorque::moment<3, double>(ConstantTorque::make(q), g, fn, nullptr).c[1]),
        -limit, 1e-15);
    g.roll = Spin<3, double>{{0, -1e-9, 0}};
    EXPECT_NEAR((ConstantTorque::moment<3, double>(ConstantTorque::make(q), g, fn, nullptr).c[1]),
        -1e-9*2e-6/1e-5, 1e-24);

    double h[3] = {};
    g.roll = Spin<3, double>{{0, -1, 0}};
    const double k = 2.25*1e4*0.2*0.2*1e-4;
    const auto spring = RollingSpring::make(q);
    EXPECT_NEAR((RollingSpring::moment<3, double>(spring, g, fn, h).c[1]), -k*1e-5, 1e-15);
    for (int step = 0; step < 100000; ++step) RollingSpring::moment<3, double>(spring, g, fn, h);
    EXPECT_NEAR(h[1], -limit, 1e-15);
}

//- Eight contacts in a register are eight contacts one by one, to rounding of the float's
//  operations
TEST(ContactLaws, PacksAreScalars)
{
    using Law = Contact<Hertz, Mindlin, RollingSpring>;
    PairProperties q = glass(0.8);
    q.youngA = q.youngB = 1e7;
    q.friction = 0.3;
    q.rollingFriction = 0.05;
    const auto scalar = Law::make<float>(q);
    Law::Parameters<Pack<float>> packed;
    const float* from = reinterpret_cast<const float*>(&scalar);
    Pack<float>* to = reinterpret_cast<Pack<float>*>(&packed);
    for (std::size_t k = 0; k < sizeof(scalar)/sizeof(float); ++k) to[k] = Pack<float>(from[k]);
    ContactGeometry<3, float> g[8];
    ContactGeometry<3, Pack<float>> pack{};
    float h[8][6];
    Pack<float> hp[6];
    for (int l = 0; l < 8; ++l)
    {
        float* word = reinterpret_cast<float*>(&g[l]);
        Pack<float>* words = reinterpret_cast<Pack<float>*>(&pack);
        g[l].n = Vec<3, float>{{0.6f, 0.0f, 0.8f}};
        g[l].overlap = 1e-5f*(l + 1);
        g[l].approach = 0.01f*(l - 3);
        g[l].slip = Tangent<3, float>{{0.8f*0.1f*l, 0.02f, -0.6f*0.1f*l}};
        g[l].roll = Spin<3, float>{{0, 0.3f*l, 0}};
        g[l].reducedMass = 0.01f;
        g[l].meanMass = 0.02f;
        g[l].reducedRadius = 0.005f;
        g[l].dt = g[l].since = 1e-6f;
        for (std::size_t k = 0; k < sizeof(g[l])/sizeof(float); ++k) words[k].v[l] = word[k];
        for (int c = 0; c < 6; ++c) hp[c].v[l] = h[l][c] = 1e-4f*(c - l);
    }
    NormalForce<Pack<float>> fp;
    const auto r = Law::evaluate<3, Pack<float>>(
        packed, pack, Pack<float>(0.01f), Pack<float>(0.01f), hp, fp);
    for (int l = 0; l < 8; ++l)
    {
        NormalForce<float> f;
        const auto one = Law::evaluate<3, float>(scalar, g[l], 0.01f, 0.01f, h[l], f);
        for (int d = 0; d < 3; ++d)
            EXPECT_NEAR(r.force.c[d].v[l], one.force.c[d], 1e-5f*std::abs(f.force) + 1e-12f);
        for (int c = 0; c < 6; ++c)
            EXPECT_NEAR(hp[c].v[l], h[l][c], 1e-5f*std::abs(h[l][c]) + 1e-12f);
    }
}

} // namespace
} // namespace riprap

/*  Pair terms through FluidPass::pair on the device, for random single pairs: against the paper's
    equation in double, and each of the table against itself in double on the host.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "paperEquations.hpp"
#include "solvers/sph/sphFamilies.hpp"
#include "termTables.hpp"

namespace riprap
{
namespace
{

constexpr int pairs = 64;
constexpr double spacing = 0.01, h0 = 0.0125, rho0 = 1000, c0 = 30, mass = 0.1, wallMass = 0.03;
const Vector3 gravity{{0.5, -9.81, 2}};

//- Pair k of the arrays; S: 0 fluid-fluid, 1 fluid-wall
template<class Pass, int S>
struct OnePair
{
    static constexpr const char* name = "onePair";
    static constexpr int D = Pass::dimensions;
    using real = typename Pass::real;

    Pass pass;
    const PairParticle<D, real>* i;
    const PairParticle<D, real>* j;
    const Vec<D, real>* dx;
    real* sums;

    HD void operator()(int k) const
    {
        real s[Pass::channels];
        for (int c = 0; c < Pass::channels; ++c) s[c] = 0;
        pass.template pair<S>(i[k], j[k], dx[k], squaredNorm(dx[k]), k, s);
        for (int c = 0; c < Pass::channels; ++c) sums[Pass::channels*k + c] = s[c];
    }
};

template<class C>
class TermTest : public BackendTest
{
public:
    static constexpr int D = C::D;
    using P = typename C::P;
    using real = typename C::real;
    template<class T> using Particles = std::vector<PairParticle<D, T>>;

    Particles<real> i, j;
    std::vector<Vec<D, real>> dx;
    std::vector<real> wallVelocity[D];

    //- Separations of 0.2 to 2.1 h, speeds of 1 m/s, pressures of both signs. The reference gets
    //  the rounded numbers.
    void makePairs(bool variableH)
    {
        Random random(7);
        for (int k = 0; k < pairs; ++k)
        {
            Vec<D, real> x;
            double r2 = 0;
            for (int d = 0; d < D; ++d)
            {
                x.c[d] = real(random(-1, 1));
                r2 += double(x.c[d])*x.c[d];
            }
            const double r = h0*random(0.2, 2.1);
            for (int d = 0; d < D; ++d) x.c[d] = real(x.c[d]*r/std::sqrt(r2));
            dx.push_back(x);
            for (auto* set : {&i, &j})
            {
                PairParticle<D, real> p;
                for (int d = 0; d < D; ++d) p.velocity.c[d] = real(random(-1, 1));
                p.density = real(rho0*random(0.9, 1.1));
                p.pressureTerm = real(random(-1e4, 2e4)/(double(p.density)*p.density));
                p.h = variableH ? real(h0*random(0.85, 1.15)) : real(h0);
                set->push_back(p);
            }
            for (auto& u : wallVelocity) u.push_back(real(random(-1, 1)));
        }
    }

    paper::Particle particle(const PairParticle<D, real>& p, double m) const
    {
        paper::Particle r;
        for (int d = 0; d < D; ++d) r.v[d] = p.velocity.c[d];
        r.rho = p.density;
        r.p = double(p.pressureTerm)*p.density*p.density;
        r.h = p.h;
        r.m = m;
        return r;
    }

    //- Compare `terms` with what `reference` adds to a paper::Pair, for all pairs
    template<class Kernel, bool VariableH, Part part, int S, class Terms, class Reference>
    void compareKernel(const Terms& terms, const Reference& reference, bool movingWall)
    {
        // here, not in the fixture: that is made even where the test is skipped
        Context<Backend> context;
        i.clear(); j.clear(); dx.clear();
        for (auto& u : wallVelocity) u.clear();
        makePairs(VariableH);
        FluidModel<D, P> model{};
        model.rho0 = real(rho0);
        model.h0 = real(h0);
        model.mass = real(mass);
        model.wallMass = real(wallMass);
        using Pass = FluidPass<Backend, D, P, Kernel, VariableH, part, Terms, Terms, false>;
        const Box<D, P> box{};
        Array<Backend, real> u[D];
        Pass pass{box, CellGrid<D, P>(), {}, terms, terms,
            KernelConstants<D, real>::template make<Kernel>(h0, spacing), {}, model, {}, {},
            nullptr, nullptr, Finish::store, {}, {}};
        for (int d = 0; d < D; ++d)
        {
            u[d].upload(context, wallVelocity[d]);
            pass.wallVelocity[d] = movingWall ? u[d].data() : nullptr;
        }
        Array<Backend, PairParticle<D, real>> iDevice, jDevice;
        Array<Backend, Vec<D, real>> x;
        Array<Backend, real> out;
        iDevice.upload(context, i); jDevice.upload(context, j); x.upload(context, dx);
        out.allocate(context, pairs*Pass::channels);
        runEach(context, pairs,
            OnePair<Pass, S>{pass, iDevice.data(), jDevice.data(), x.data(), out.data()});
        const auto sums = out.download();

        std::vector<paper::Pair> expected;
        // acceleration, rate, drift: what tolerances are relative to
        Vector3 largest{{0, 0, 0}};
        for (int k = 0; k < pairs; ++k)
        {
            Vector3 separation{{0, 0, 0}};
            for (int d = 0; d < D; ++d) separation[d] = dx[k].c[d];
            auto other = particle(j[k], S == 0 ? mass : wallMass);
            // else 0
            if (movingWall) for (int d = 0; d < D; ++d) other.u[d] = wallVelocity[d][k];
            paper::Pair p(Kernel::word, D, particle(i[k], mass), other, separation);
            reference(p);
            for (int d = 0; d < D; ++d)
            {
                largest[0] = std::max(largest[0], std::abs(p.a[d]));
                largest[2] = std::max(largest[2], std::abs(p.drift[d]));
            }
            largest[1] = std::max(largest[1], std::abs(p.rate));
            expected.push_back(p);
        }
        // some 30 roundings, of which (1 - q/2)^16 of the anti-clump term counts most of them
        // sixteenfold; the GPU's float division and square root are 2 ulp
        const double tolerance = 100*C::epsilon;
        for (int k = 0; k < pairs; ++k)
        {
            const real* s = &sums[Pass::channels*k];
            for (int d = 0; d < D; ++d)
            {
                EXPECT_NEAR(s[d], expected[k].a[d], tolerance*largest[0])
                    << "acceleration, pair " << k;
                if constexpr (Pass::smooths && S == 0)
                {
                    EXPECT_NEAR(s[Pass::smoothAt + d], expected[k].drift[d], tolerance*largest[2])
                        << "drift, pair " << k;
                }
            }
            EXPECT_NEAR(s[D], expected[k].rate, tolerance*largest[1]) << "rate, pair " << k;
        }
    }

    //- All kernels, constant and variable h
    template<Part part, int S, class Terms, class Reference>
    void compare(const Terms& terms, const Reference& reference, bool movingWall = false)
    {
        Kernels::each([&](auto kernel)
        {
            using Kernel = typename decltype(kernel)::type;
            SCOPED_TRACE(Kernel::word);
            compareKernel<Kernel, false, part, S>(terms, reference, movingWall);
            SCOPED_TRACE("variable h");
            compareKernel<Kernel, true, part, S>(terms, reference, movingWall);
        });
    }
};

template<class C> class PairTerm : public TermTest<C> { };
TYPED_TEST_SUITE(PairTerm, AllCases, CaseNames);

TYPED_TEST(PairTerm, Continuity)
{
    this->template compare<Part::all, 0>(Terms{Continuity{}}, [](auto& p) { p.continuity(); });
}

TYPED_TEST(PairTerm, WallContinuitySeesTheWallsOwnVelocity)
{
    this->template compare<Part::all, 1>(Terms{Continuity{}}, [](auto& p) { p.wallContinuity(); });
    this->template compare<Part::all, 1>(
        Terms{Continuity{}}, [](auto& p) { p.wallContinuity(); }, true);
}

TYPED_TEST(PairTerm, PressureGradient)
{
    this->template compare<Part::all, 0>(Terms{Pressure{}}, [](auto& p) { p.pressure(); });
    this->template compare<Part::all, 1>(Terms{Pressure{}}, [](auto& p) { p.pressure(); });
}

TYPED_TEST(PairTerm, LaminarViscosity)
{
    using real = typename TypeParam::real;
    LaminarViscosity<real> term;
    term.mu = real(0.7);
    this->template compare<Part::all, 0>(Terms{term}, [](auto& p) { p.laminar(0.7); });
    this->template compare<Part::all, 1>(Terms{term}, [](auto& p) { p.laminar(0.7); }, true);
    term.softening = real(1e-4);
    this->template compare<Part::all, 0>(Terms{term}, [](auto& p) { p.laminar(0.7, 1e-4); });
}

TYPED_TEST(PairTerm, ArtificialViscosity)
{
    using real = typename TypeParam::real;
    ArtificialViscosity<real> term;
    term.alphaC0 = real(0.02*c0);
    this->template compare<Part::all, 0>(Terms{term}, [](auto& p) { p.artificial(0.02, c0); });
    // at walls it sees their own velocity: then it only ever takes energy from the fluid
    this->template compare<Part::all, 1>(
        Terms{term}, [](auto& p) { p.wallArtificial(0.02, c0); }, true);
}

TYPED_TEST(PairTerm, AntiClump)
{
    using real = typename TypeParam::real;
    AntiClump<real> term;
    term.epsilon = real(0.01);
    this->template compare<Part::all, 0>(Terms{term}, [](auto& p) { p.antiClump(0.01, spacing); });
}

TYPED_TEST(PairTerm, Xsph)
{
    using real = typename TypeParam::real;
    Xsph<real> term;
    term.epsilon = real(0.5);
    this->template compare<Part::all, 0>(Terms{term}, [](auto& p) { p.xsph(0.5); });
}

TYPED_TEST(PairTerm, DensityDiffusion)
{
    using real = typename TypeParam::real;
    constexpr int D = TypeParam::D;
    DensityDiffusion<D, real> molteni, fourtakas;
    molteni.factor = fourtakas.factor = real(2*0.1*c0);
    Vector3 g{{0, 0, 0}};
    for (int d = 0; d < D; ++d)
    {
        g[d] = gravity[d];
        molteni.hydrostatic.c[d] = 0;
        fourtakas.hydrostatic.c[d] = real(rho0*g[d]/(c0*c0));
    }
    this->template compare<Part::all, 0>(Terms{molteni},
        [](auto& p) {
            p.diffusion(0.1, c0, rho0, {{0, 0, 0}});
        });
    this->template compare<Part::all, 0>(
        Terms{fourtakas}, [&](auto& p) { p.diffusion(0.1, c0, rho0, g); });
}

TYPED_TEST(PairTerm, TogetherTheyAdd)
{
    using real = typename TypeParam::real;
    LaminarViscosity<real> laminar;
    laminar.mu = real(0.7);
    AntiClump<real> antiClump;
    antiClump.epsilon = real(0.01);
    Xsph<real> xsph;
    xsph.epsilon = real(0.5);
    ArtificialViscosity<real> artificial;
    artificial.alphaC0 = real(1e9);
    const Switchable<ArtificialViscosity<real>> off(artificial, false);
    this->template compare<Part::all, 0>(
        Terms{Pressure{}, Continuity{}, laminar, antiClump, xsph, off},
        [](auto& p)
        {
            p.pressure();
            p.continuity();
            p.laminar(0.7);
            p.antiClump(0.01, spacing);
            p.xsph(0.5);
        });
}

//- What a term adds in double; at walls with the wall's own velocity, as in FluidPass
template<int D, class Term>
void addTerm(const Term& term, paper::Pair& p, bool wall)
{
    using paper::operator-;
    PairGeometry<D, double> g{};
    PairParticle<D, double> i{}, j{};
    for (int d = 0; d < D; ++d)
    {
        g.dx.c[d] = p.x[d];
        g.dv.c[d] = p.v[d];
        i.velocity.c[d] = p.i.v[d];
        j.velocity.c[d] = p.j.v[d];
    }
    g.r2 = p.r2;
    g.h = p.h;
    g.approach = paper::dot(wall ? p.i.v - p.j.u : p.v, p.x);
    g.f = paper::dot(p.x, p.grad)/p.r2;
    g.w = p.w;
    g.wRatio = p.w/paper::W(p.kernel, D, spacing, p.h);
    i.density = p.i.rho;
    j.density = p.j.rho;
    i.pressureTerm = p.i.p/(p.i.rho*p.i.rho);
    j.pressureTerm = p.j.p/(p.j.rho*p.j.rho);
    Channels<double> c{0, 0, 0, 0};
    term(i, j, g, c);
    paper::add(p.a, p.j.m*g.f*c.radial, p.x);
    paper::add(p.a, p.j.m*g.f*c.cross, p.v);
    p.rate += p.j.m*g.f*c.rate;
    paper::add(p.drift, -p.j.m*p.w*c.smooth, p.v);
}

TYPED_TEST(PairTerm, EachOfTheTableAsInDouble)
{
    constexpr int D = TypeParam::D;
    TermFluid f = triedFluid(D, spacing, h0);
    f.density = rho0;
    f.soundSpeed = c0;
    eachTerm<D, typename TypeParam::real>([&](auto rounded, auto exact)
    {
        using Term = typename decltype(rounded)::type;
        using Exact = typename decltype(exact)::type;
        for (const TermProperties& p : typicalTerms<Term>())
        {
            SCOPED_TRACE(std::string(Term::word) + " " + Term::chosenBy.word(p));
            const Exact expected = Exact::make(p, f);
            this->template compareKernel<WendlandC2, true, Part::all, 0>(
                Terms<Term>{Term::make(p, f)},
                [&](auto& pair) { addTerm<D>(expected, pair, false); }, false);
            if constexpr (Term::atWalls)
                this->template compareKernel<WendlandC2, true, Part::all, 1>(
                    Terms<Term>{Term::make(p, f)},
                    [&](auto& pair) { addTerm<D>(expected, pair, true); }, true);
        }
    });
}

} // namespace
} // namespace riprap

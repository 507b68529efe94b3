/*  Equations of state (paper Eq. 35 and the linear one), against pow in double.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "sph/eos/equationOfState.hpp"

namespace riprap
{
namespace
{

constexpr double c0 = 20, rho0 = 1000;

template<class R>
struct EvaluateEos
{
    static constexpr const char* name = "evaluateEos";
    EquationOfState<R> eos;
    const R* d;
    R* pressure;
    R* inverse;
    R* soundSpeed;
    double* energy;

    HD void operator()(int i) const
    {
        pressure[i] = eos.pressure(d[i]);
        inverse[i] = eos.deviation(pressure[i]);
        soundSpeed[i] = eos.soundSpeed(d[i]);
        energy[i] = eos.elasticEnergy(d[i]);
    }
};

//- gamma 0: linear
struct Law
{
    double gamma;
    bool linear() const { return gamma == 0; }

    template<class R>
    EquationOfState<R> equation() const
    {
        EquationProperties p;
        p.eos = linear() ? "linear" : "Tait";
        p.gamma = gamma;
        return EquationOfState<R>::make(p, c0, rho0);
    }

    double pressure(double d) const
    { return linear() ? c0*c0*rho0*d : c0*c0*rho0/gamma*(std::pow(1 + d, gamma) - 1); }

    //- dp/drho
    double stiffness(double d) const { return linear() ? c0*c0 : c0*c0*std::pow(1 + d, gamma - 1); }

    //- integral of p/rho^2 from rho0, by Simpson over 2000 intervals
    double energy(double d) const
    {
        const int n = 2000;
        double sum = 0;
        for (int i = 0; i <= n; ++i)
        {
            const double e = d*i/n, weight = i == 0 || i == n ? 1 : (i % 2 ? 4 : 2);
            sum += weight*pressure(e)/((1 + e)*(1 + e));
        }
        return sum*d/(3*n)/rho0;
    }
};

template<class R>
struct Eos : BackendTest
{
    std::vector<R> deviations, pressure, inverse, soundSpeed;
    std::vector<double> energy;

    void evaluate(const Law& law)
    {
        Context<Backend> context;
        deviations.clear();
        for (const double d : {-0.3, -0.1, -0.01, -1e-3, -1e-5, -1e-7, 0.0, 1e-7, 1e-6, 1e-4, 1e-3,
                 0.01, 0.05, 0.1, 0.2, 0.3})
            deviations.push_back(R(d));
        const int n = int(deviations.size());
        Array<Backend, R> d, p, i, c;
        Array<Backend, double> e;
        d.upload(context, deviations);
        for (auto* a : {&p, &i, &c}) a->allocate(context, n);
        e.allocate(context, n);
        const auto eos = law.template equation<R>();
        runEach(context, n, EvaluateEos<R>{eos, d.data(), p.data(), i.data(), c.data(), e.data()});
        pressure = p.download();
        inverse = i.download();
        soundSpeed = c.download();
        energy = e.download();
    }
};

const Law laws[] = {{7}, {1.4}, {4}, {0}};
constexpr bool single(float) { return true; }
constexpr bool single(double) { return false; }

struct RealNames
{
    template<class R> static std::string GetName(int)
    {
        return std::string(Backend::gpu ? "Gpu_" : "Cpu_") + (single(R()) ? "float" : "double");
    }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Eos, Reals, RealNames);

TYPED_TEST(Eos, PressureAgainstPow)
{
    // relative to p itself, also at d = 1e-7 where (1 + d)^gamma - 1 in float would be 20 % off:
    // some ten roundings.
    // In double the reference itself cancels: 1e-16/d
    for (const Law& law : laws)
    {
        this->evaluate(law);
        for (std::size_t k = 0; k < this->deviations.size(); ++k)
        {
            const double d = this->deviations[k], p = law.pressure(d);
            const double tolerance = single(TypeParam()) ? 1e-6 + 3e-16/(std::abs(d) + 1e-300)
                                                         : 1e-14 + 6e-16/(std::abs(d) + 1e-300);
            EXPECT_NEAR(this->pressure[k], p, std::abs(p)*std::min(tolerance, 1.0))
                << "gamma " << law.gamma << ", d " << d;
        }
        EXPECT_EQ(this->pressure[6], 0) << "no pressure at rest density, exactly";
    }
}

TYPED_TEST(Eos, DeviationInvertsPressure)
{
    // relative: conditioning of the inverse is d/p dp/dd = 1 at small d and at most 3 here; some
    // ten roundings
    for (const Law& law : laws)
    {
        this->evaluate(law);
        for (std::size_t k = 0; k < this->deviations.size(); ++k)
        {
            const double d = this->deviations[k];
            EXPECT_NEAR(this->inverse[k], d, std::abs(d)*(single(TypeParam()) ? 3e-6 : 6e-15))
                << "gamma " << law.gamma;
        }
    }
}

TYPED_TEST(Eos, InverseStaysAboveHalfDensity)
{
    for (const Law& law : laws)
    {
        const auto eos = law.template equation<TypeParam>();
        for (const double p : {-1e3, -1e5, -1e7, -1e12})
            EXPECT_GE(eos.deviation(TypeParam(p)), TypeParam(-0.5));
    }
}

//- Above it a pressure has a density of its own, unless that is cut off before; below it none has
TYPED_TEST(Eos, LowestPressureIsWhereDensityIsCutOff)
{
    for (const Law& law : laws)
    {
        const auto eos = law.template equation<TypeParam>();
        const double lowest = eos.lowestPressure();
        EXPECT_LT(lowest, 0) << law.gamma;
        EXPECT_EQ(eos.deviation(TypeParam(1.01*lowest)), eos.deviation(TypeParam(2*lowest)));
        if (law.linear())
        {
            EXPECT_LT(eos.deviation(TypeParam(1.01*lowest)), eos.deviation(TypeParam(0.99*lowest)));
        }
    }
}

//- Each of the table, by its word, is what its own struct is
TYPED_TEST(Eos, WordsChooseTheirEquations)
{
    using R = TypeParam;
    EquationsOfState<R>::each([](auto model)
    {
        using Equation = typename decltype(model)::type;
        EquationProperties p;
        p.eos = Equation::word;
        const auto chosen = EquationOfState<R>::make(p, c0, rho0);
        const Equation own = Equation::make(p, c0, rho0);
        for (const double d : {-0.2, -1e-4, 0.0, 1e-4, 0.2})
        {
            EXPECT_EQ(chosen.pressure(R(d)), own.pressure(R(d))) << p.eos;
            EXPECT_EQ(chosen.deviation(own.pressure(R(d))), own.deviation(own.pressure(R(d))));
            EXPECT_EQ(chosen.soundSpeed(R(d)), own.soundSpeed(R(d))) << p.eos;
            EXPECT_EQ(chosen.elasticEnergy(d), own.elasticEnergy(d)) << p.eos;
        }
        EXPECT_EQ(chosen.lowestPressure(), own.lowestPressure()) << p.eos;
    });
    EquationProperties p;
    p.eos = "stiffened";
    EXPECT_THROW(EquationOfState<R>::make(p, c0, rho0), std::invalid_argument);
}

TYPED_TEST(Eos, SoundSpeedIsRootOfStiffness)
{
    for (const Law& law : laws)
    {
        this->evaluate(law);
        for (std::size_t k = 0; k < this->deviations.size(); ++k)
            EXPECT_NEAR(this->soundSpeed[k], std::sqrt(law.stiffness(this->deviations[k])),
                c0*(single(TypeParam()) ? 1e-6 : 1e-14));
    }
}

TYPED_TEST(Eos, ElasticEnergyIsIntegralOfPressure)
{
    // closed form in double even where the state is float; its terms of order d, each off by some
    // 1e-16, cancel to d^2/2
    for (const Law& law : laws)
    {
        this->evaluate(law);
        for (std::size_t k = 0; k < this->deviations.size(); ++k)
        {
            const double d = this->deviations[k], e = law.energy(d);
            EXPECT_NEAR(this->energy[k], e, 1e-7*e + 1e-15*c0*c0*std::abs(d))
                << "gamma " << law.gamma << ", d " << d;
        }
    }
}

TYPED_TEST(Eos, GammaOneIsLinear)
{
    const auto eos = Law{1}.equation<TypeParam>();
    EXPECT_NEAR(eos.elasticEnergy(0.1), Law{0}.energy(0.1), 1e-9);
    EXPECT_NEAR(eos.pressure(TypeParam(0.1)), c0*c0*rho0*0.1, 1e-6*c0*c0*rho0);
}

} // namespace
} // namespace riprap

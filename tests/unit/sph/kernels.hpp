/*  Every kernel of the table: normalisation, slope and support. Published values of two (paper Eq.
    28; Wendland 1995; Monaghan & Lattanzio 1985).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "sph/models.hpp"

namespace riprap
{
namespace
{

constexpr double pi = 3.14159265358979323846;

//- value and slope at q = i dq
template<class Kernel, class R>
struct Tabulate
{
    static constexpr const char* name = "tabulate";
    R dq;
    R* value;
    R* slope;

    HD void operator()(int i) const
    {
        value[i] = Kernel::value(R(i)*dq);
        slope[i] = Kernel::slope(R(i)*dq);
    }
};

template<class KernelType, class R>
struct KernelCase
{
    using Kernel = KernelType;
    using real = R;
    static constexpr bool single = sizeof(R) == 4;

    //- Tables up to twice the support with 1024 points a unit: exact in float
    static constexpr int perUnit = 1024, edge = int(Kernel::support*perUnit), points = 2*edge + 1;
    static_assert(edge == Kernel::support*perUnit && edge % 2 == 0, "Simpson's rule needs it even");
    std::vector<R> value, slope;

    KernelCase()
    {
        Context<Backend> context;
        Array<Backend, R> v, s;
        v.allocate(context, points);
        s.allocate(context, points);
        runEach(context, points, Tabulate<Kernel, R>{R(1.0/perUnit), v.data(), s.data()});
        value = v.download();
        slope = s.download();
    }

    static double q(int i) { return double(i)/perUnit; }
};

template<class C> class KernelTest : public BackendTest { };
template<class C> class PublishedKernel : public BackendTest { };

struct KernelNames
{
    template<class C>
    static std::string GetName(int)
    {
        return std::string(Backend::gpu ? "Gpu_" : "Cpu_") + C::Kernel::word
            + (C::single ? "_float" : "_double");
    }
};

template<class Table> struct CasesOf;
template<class... K> struct CasesOf<Models<K...>>
{
    using type = testing::Types<KernelCase<K, float>..., KernelCase<K, double>...>;
};
using KernelCases = typename CasesOf<riprap::Kernels>::type;
TYPED_TEST_SUITE(KernelTest, KernelCases, KernelNames);

TYPED_TEST(KernelTest, IntegralIsOne)
{
    const TypeParam t;
    for (int D = 2; D <= 3; ++D)
    {
        // Simpson; the kernels are smooth in pieces that begin at grid points
        double sum = 0;
        for (int i = 0; i < TypeParam::points; ++i)
        {
            const double q = t.q(i),
                         weight = i == 0 || i == TypeParam::points - 1 ? 1 : (i % 2 ? 4 : 2);
            sum += weight*t.value[i]*(D == 2 ? 2*pi*q : 4*pi*q*q);
        }
        sum *= TypeParam::Kernel::alpha(D)/(3.0*TypeParam::perUnit);
        // Simpson's error: dq^4/180 max|f''''| ~ 1e-12*40/180; float: values rounded at random to
        // 6e-8
        EXPECT_NEAR(sum, 1, TypeParam::single ? 1e-7 : 1e-11) << D << "D";
    }
}

TYPED_TEST(KernelTest, SlopeIsDerivativeOfValue)
{
    const TypeParam t;
    const auto w = [](double q) { return TypeParam::Kernel::value(q); };
    const double d = 1e-4;
    for (int i = 1; i < TypeParam::points; ++i)
    {
        const double q = t.q(i), difference = (w(q + d) - w(q - d))/(2*d);
        // W of a truncated kernel has a kink
        if (std::abs(q - TypeParam::Kernel::support) < 2*d) continue;
        // central difference: d^2/6 max|W'''| = 1e-8/6*30 and cancellation 1e-16/d; float: 4
        // roundings of numbers up to 5
        EXPECT_NEAR(q*t.slope[i], difference, TypeParam::single ? 2e-6 : 6e-8) << "q = " << q;
    }
}

TYPED_TEST(KernelTest, ZeroAtAndBeyondSupport)
{
    const TypeParam t;
    for (int i = TypeParam::edge; i < TypeParam::points; ++i)
    {
        EXPECT_EQ(t.value[i], 0);
        EXPECT_EQ(t.slope[i], 0);
    }
    // and where unused lanes are sent
    using real = typename TypeParam::real;
    EXPECT_EQ(TypeParam::Kernel::value(real(1e12)), 0);
    EXPECT_EQ(TypeParam::Kernel::slope(real(1e12)), 0);
}

TYPED_TEST(KernelTest, PositiveAndFalling)
{
    const TypeParam t;
    for (int i = 1; i < TypeParam::edge - 8; ++i)
    {
        EXPECT_GT(t.value[i], 0);
        EXPECT_LE(t.value[i], t.value[i - 1]);
        EXPECT_LT(t.slope[i], 0);
    }
}

using PublishedCases = testing::Types<KernelCase<WendlandC2, float>, KernelCase<WendlandC2, double>,
    KernelCase<CubicSpline, float>, KernelCase<CubicSpline, double>>;
TYPED_TEST_SUITE(PublishedKernel, PublishedCases, KernelNames);

TYPED_TEST(PublishedKernel, Values)
{
    const TypeParam t;
    const double alpha2 = TypeParam::Kernel::alpha(2), alpha3 = TypeParam::Kernel::alpha(3);
    const double w0 = t.value[0], w1 = t.value[TypeParam::perUnit];
    // exact powers of two: no rounding
    if (std::is_same<typename TypeParam::Kernel, WendlandC2>::value)
    {
        EXPECT_DOUBLE_EQ(alpha2*w0, 7/(4*pi));
        EXPECT_DOUBLE_EQ(alpha3*w0, 21/(16*pi));
        EXPECT_DOUBLE_EQ(w1, 3.0/16);
        EXPECT_DOUBLE_EQ(t.slope[0], -5);
    }
    else
    {
        EXPECT_DOUBLE_EQ(alpha2*w0, 10/(7*pi));
        EXPECT_DOUBLE_EQ(alpha3*w0, 1/pi);
        EXPECT_DOUBLE_EQ(w1, 0.25);
        EXPECT_DOUBLE_EQ(t.slope[0], -3);
    }
}

} // namespace
} // namespace riprap

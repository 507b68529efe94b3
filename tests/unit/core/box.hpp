/*  Box: fixed-point positions there and back, and separations with the nearest image.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"

namespace riprap
{
namespace
{

template<class C>
struct FixAndBack
{
    static constexpr const char* name = "fixAndBack";
    static constexpr int D = C::D;
    Box<D, typename C::P> box;
    const double* x;            // D a point
    std::int64_t* fixed;
    double* metres;
    double* pair;               // pairRelative(pairPosition(fixed))

    HD void operator()(int i) const
    {
        for (int d = 0; d < D; ++d)
        {
            const int k = D*i + d;
            fixed[k] = box.toFixed(d, x[k]);
            metres[k] = box.toMetres(d, fixed[k]);
            pair[k] = double(box.pairRelative(d, box.pairPosition(d, fixed[k])));
        }
    }
};

template<class C>
struct Separate
{
    static constexpr const char* name = "separate";
    static constexpr int D = C::D;
    using real = typename C::real;
    Box<D, typename C::P> box;
    const double* a;
    const double* b;
    real* result;

    HD void operator()(int i) const
    {
        for (int d = 0; d < D; ++d)
        {
            const int k = D*i + d;
            const auto p = box.pairPosition(d, box.toFixed(d, a[k])),
                       q = box.pairPosition(d, box.toFixed(d, b[k]));
            result[k] = box.template separation<real>(d, p, q);
        }
    }
};

template<class C>
class BoxTest : public BackendCase<C>
{
public:
    static constexpr int D = C::D;
    static constexpr int n = 3000;
    Box<D, typename C::P> box;
    double lower[3] = {-3.7, 1000.125, 0.001}, length[3] = {10.3, 0.07, 400};

    void SetUp() override
    {
        BackendTest::SetUp();
        if (this->IsSkipped()) return;
        for (int d = 0; d < D; ++d) box.set(d, lower[d], length[d], d != 1);
    }

    //- What one double can say of a position in the box
    double roundOff(int d) const { return 2.2e-16*(std::abs(lower[d]) + length[d]); }
};

TYPED_TEST_SUITE(BoxTest, AllCases, CaseNames);

TYPED_TEST(BoxTest, ThereAndBack)
{
    constexpr int D = TypeParam::D, n = TestFixture::n;
    Context<Backend> context;
    Random random(1);
    std::vector<double> x;
    for (int i = 0; i < n; ++i)
        for (int d = 0; d < D; ++d)
        {
            const double s = i == 0 ? 0 : (i == 1 ? 0.5 : (i == 2 ? 1 - 1e-9 : random(0, 1)));
            x.push_back(this->lower[d] + s*this->length[d]);
        }
    Array<Backend, double> in, metres, pair;
    Array<Backend, std::int64_t> fixed;
    in.upload(context, x);
    metres.allocate(context, x.size());
    pair.allocate(context, x.size());
    fixed.allocate(context, x.size());
    runEach(context, n,
        FixAndBack<TypeParam>{this->box, in.data(), fixed.data(), metres.data(), pair.data()});
    const auto back = metres.download(), seen = pair.download();
    const auto bits = fixed.download();
    for (int k = 0; k < n*D; ++k)
    {
        const int d = k % D;
        // subtraction, division, product and sum in double: a rounding each
        EXPECT_NEAR(back[k], x[k], 4*this->roundOff(d)) << "axis " << d;
        // Mixed: cut to 2^-32 of the box and one float in the box
        const double resolution = TypeParam::mixed ? this->length[d]*(std::ldexp(1, -32) + 2.5e-7)
                                                   : 4*this->roundOff(d);
        EXPECT_NEAR(seen[k], x[k] - this->lower[d], resolution);
    }
    // order is kept, so that equal bits mean equal places: the lower edge is the smallest number
    EXPECT_EQ(bits[0], INT64_MIN);
    EXPECT_NEAR(double(bits[D]), 0, 4096)
        << "the middle is 0, but for the rounding of lower + length/2: 2^64 2e-16/10";
}

TYPED_TEST(BoxTest, NearestImage)
{
    constexpr int D = TypeParam::D, n = TestFixture::n;
    Context<Backend> context;
    using real = typename TypeParam::real;
    Random random(2);
    std::vector<double> a, b;
    for (int i = 0; i < n; ++i)
        for (int d = 0; d < D; ++d)
        {
            // a third are neighbours, some of them across the edge
            const double s = random(0, 1), t = i % 3 ? random(0, 1) : s + random(-0.01, 0.01);
            a.push_back(this->lower[d] + s*this->length[d]);
            b.push_back(this->lower[d]
                + (t - (this->box.periodic[d] ? std::floor(t) : 0))*this->length[d]);
            if (!this->box.periodic[d])
                b.back() = std::min(std::max(b.back(), this->lower[d]),
                    this->lower[d] + 0.999999*this->length[d]);
        }
    Array<Backend, double> first, second;
    Array<Backend, real> result;
    first.upload(context, a);
    second.upload(context, b);
    result.allocate(context, a.size());
    runEach(context, n, Separate<TypeParam>{this->box, first.data(), second.data(), result.data()});
    const auto dx = result.download();
    for (int k = 0; k < n*D; ++k)
    {
        const int d = k % D;
        const double length = this->length[d];
        double expected = a[k] - b[k];
        // the fixed-point difference wraps on every axis: scenes keep a margin where they are not
        // periodic
        if (this->box.periodic[d] || TypeParam::mixed)
            expected -= length*std::round(expected/length);
        // Mixed: both ends cut to 2^-32 of the box, then a float; beyond half a length it may
        // choose either image
        const double tolerance = TypeParam::mixed
            ? length*std::ldexp(1, -32) + 1.3e-7*std::abs(expected)
            : 8*this->roundOff(d);
        if (std::abs(std::abs(expected) - 0.5*length) < 1e-6*length) continue;
        EXPECT_NEAR(dx[k], expected, tolerance) << "axis " << d << ": " << a[k] << " - " << b[k];
    }
}

//- Positions move by integers: as many steps there and back end where they began, and neighbours
//  keep their distance anywhere
TYPED_TEST(BoxTest, ShiftInvariance)
{
    constexpr int D = TypeParam::D, n = TestFixture::n;
    Context<Backend> context;
    using real = typename TypeParam::real;
    Random random(3);
    std::vector<double> a, b;
    const double unit[3] = {std::ldexp(1, -20), std::ldexp(1, -20), std::ldexp(1, -20)};
    for (int d = 0; d < D; ++d) this->box.set(d, 0, 16, true);
    for (int i = 0; i < n; ++i)
        for (int d = 0; d < D; ++d)
        {
            // the same separation, exact in binary, at random places of a box of 16 m
            const double x = std::floor(random(0, 16)/unit[d])*unit[d], y = x + 0.03125;
            a.push_back(x);
            b.push_back(y - 16*std::floor(y/16));
        }
    Array<Backend, double> first, second;
    Array<Backend, real> result;
    first.upload(context, a);
    second.upload(context, b);
    result.allocate(context, a.size());
    runEach(context, n, Separate<TypeParam>{this->box, first.data(), second.data(), result.data()});
    for (const real s : result.download()) EXPECT_EQ(s, real(-0.03125));
}

} // namespace
} // namespace riprap

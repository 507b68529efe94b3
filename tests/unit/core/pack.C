/*  Pack: a register of values that computes what each value would alone (Cpu only: the Gpu has no
    packs).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include "backendTest.hpp"
#include "sph/models.hpp"

namespace riprap
{
namespace
{

template<class R>
class PackTest : public testing::Test
{
protected:
    using T = Pack<R>;
    static constexpr int width = T::width;
    R a[width + 3], b[width + 3];
    T pa, pb;

    void SetUp() override
    {
        Random random(4);
        for (int l = 0; l < width + 3; ++l)
        {
            a[l] = R(random(-3, 3));
            b[l] = R(random(0.1, 2));
        }
        pa = T::load(a);
        pb = T::load(b);
    }

    //- Lane by lane, exactly: the same operation on the same numbers
    template<class F> void expect(const T& p, const F& f)
    {
        for (int l = 0; l < width; ++l) EXPECT_EQ(p.v[l], f(a[l], b[l])) << "lane " << l;
    }
};

struct PackNames
{
    template<class R> static std::string GetName(int)
    {
        return sizeof(R) == 4 ? "float" : "double";
    }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(PackTest, Reals, PackNames);

TYPED_TEST(PackTest, Arithmetic)
{
    using R = TypeParam;
    using T = Pack<R>;
    const T a = this->pa, b = this->pb;
    this->expect(a + b, [](R x, R y) { return x + y; });
    this->expect(a - b, [](R x, R y) { return x - y; });
    this->expect(a*b, [](R x, R y) { return x*y; });
    this->expect(a/b, [](R x, R y) { return x/y; });
    this->expect(-a, [](R x, R) { return -x; });
    this->expect(maximum(a, b), [](R x, R y) { return std::max(x, y); });
    this->expect(minimum(a, b), [](R x, R y) { return std::min(x, y); });
    this->expect(absolute(a), [](R x, R) { return std::abs(x); });
    this->expect(squareRoot(b), [](R, R y) { return std::sqrt(y); });
    this->expect(selectGreater(a, b, b, a), [](R x, R y) { return x > y ? y : x; });
    T sum = a;
    sum += b;
    this->expect(sum, [](R x, R y) { return x + y; });
    sum = a;
    sum -= b;
    this->expect(sum, [](R x, R y) { return x - y; });
    sum = a;
    sum *= b;
    this->expect(sum, [](R x, R y) { return x*y; });
    this->expect(T(R(1.5)), [](R, R) { return R(1.5); });
}

TYPED_TEST(PackTest, LoadsFromAnyAddress)
{
    for (int offset = 0; offset < 3; ++offset)
    {
        const auto p = Pack<TypeParam>::load(this->a + offset);
        for (int l = 0; l < this->width; ++l) EXPECT_EQ(p.v[l], this->a[l + offset]);
        const auto q = loadLanes<Pack<TypeParam>>(this->a + offset);
        for (int l = 0; l < this->width; ++l) EXPECT_EQ(q.v[l], this->a[l + offset]);
        EXPECT_EQ(loadLanes<TypeParam>(this->a + offset), this->a[offset]);
    }
}

TYPED_TEST(PackTest, KeepFirst)
{
    for (int count = -1; count <= this->width + 2; ++count)
    {
        const auto p = keepFirst(this->pa, count, TypeParam(9));
        for (int l = 0; l < this->width; ++l)
            EXPECT_EQ(p.v[l], l < count ? this->a[l] : TypeParam(9)) << count << " kept";
    }
}

TYPED_TEST(PackTest, SumLanesInOrder)
{
    TypeParam sum = 0;
    for (int l = 0; l < this->width; ++l) sum += this->a[l];
    EXPECT_EQ(sumLanes(this->pa), sum);
    EXPECT_EQ(sumLanes(this->a[2]), this->a[2]);
}

TEST(PackInt32Test, DifferencesWrap)
{
    const std::int32_t a[8] = {0, 5, INT32_MIN, INT32_MAX, INT32_MIN, -1, 1 << 30, -7};
    const std::int32_t b[8] = {0, 7, INT32_MAX, INT32_MIN, 0, 1, -(1 << 30) + 64, -7};
    const double expected[8] = {0, -2, 1, -1, -2147483648.0, -2, 2147483648.0 - 64, 0};
    const auto d = wrappedDifference(PackInt32::load(a), PackInt32::load(b));
    for (int l = 0; l < 8; ++l)
    {
        EXPECT_EQ(d.v[l], wrappedDifference(a[l], b[l]));
        const double exact = double(std::int32_t(std::uint32_t(a[l]) - std::uint32_t(b[l])));
        EXPECT_EQ(exact, expected[l]);
        EXPECT_EQ(d.v[l], float(exact)) << "lane " << l;
    }
}

template<class Kernel, class R>
void expectKernelOfPack()
{
    // the same operations; a compiler may fuse products and sums differently: two ulp of numbers up
    // to 5
    const double tolerance = 5*4*(sizeof(R) == 4 ? 6e-8 : 1.2e-16);
    R q[64];
    for (int i = 0; i < 64; ++i) q[i] = R(1.1*Kernel::support*i/63);
    for (int i = 0; i < 64; i += Pack<R>::width)
    {
        const auto p = Pack<R>::load(q + i);
        const auto value = Kernel::value(p), slope = Kernel::slope(p);
        for (int l = 0; l < Pack<R>::width; ++l)
        {
            EXPECT_NEAR(value.v[l], Kernel::value(q[i + l]), tolerance);
            EXPECT_NEAR(slope.v[l], Kernel::slope(q[i + l]), tolerance);
        }
    }
}

TYPED_TEST(PackTest, KernelsOfPacks)
{
    Kernels::each(
        [](auto kernel) { expectKernelOfPack<typename decltype(kernel)::type, TypeParam>(); });
}

TYPED_TEST(PackTest, Powers)
{
    const TypeParam x = TypeParam(1.25);        // exact up to the 7th power
    EXPECT_EQ(power<0>(x), 1);
    EXPECT_EQ(power<1>(x), x);
    EXPECT_EQ(power<4>(x), x*x*x*x);
    EXPECT_EQ(power<7>(x), x*x*x*x*x*x*x);
    EXPECT_EQ(power<3>(Pack<TypeParam>(x)).v[0], x*x*x);
    EXPECT_EQ(floorInt(TypeParam(-0.25)), -1);
    EXPECT_EQ(floorInt(TypeParam(3.75)), 3);
}

//- Rows of four numbers, one a lane, as registers, and back
TYPED_TEST(PackTest, Rows)
{
    constexpr int width = Pack<TypeParam>::width;
    TypeParam table[width][6];
    for (int l = 0; l < width; ++l) for (int c = 0; c < 6; ++c) table[l][c] = TypeParam(10*l + c);
    Pack<TypeParam> v[4];
    loadRows([&](int l) { return table[width - 1 - l] + 1; }, v);
    for (int l = 0; l < width; ++l)
        for (int c = 0; c < 4; ++c) EXPECT_EQ(v[c].v[l], 10*(width - 1 - l) + c + 1);
    typename Row<TypeParam>::vec row[width];
    storeRows(v, row);
    for (int l = 0; l < width; ++l)
        for (int c = 0; c < 4; ++c) EXPECT_EQ(row[l][c], 10*(width - 1 - l) + c + 1);
}

} // namespace
} // namespace riprap

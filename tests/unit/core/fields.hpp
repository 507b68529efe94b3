/*  Arrays, fields that are sorted together, and sums over particles.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <numeric>
#include "backendTest.hpp"
#include "core/backend/snapshot.hpp"
#include "core/containers/fieldSet.hpp"

namespace riprap
{
namespace
{

#ifdef __CUDACC__
class GpuFields : public BackendTest { };
#define FIELDS_TEST(name) TEST_F(GpuFields, name)
#else
class CpuFields : public BackendTest { };
#define FIELDS_TEST(name) TEST_F(CpuFields, name)
#endif

//- Bytes from the end of an array of one-byte elements, where vector loads run over
struct ReadPastEnd
{
    static constexpr const char* name = "readPastEnd";
    const unsigned char* end;
    int* out;
    HD void operator()(int i) const { out[i] = end[i]; }
};

FIELDS_TEST(ArraysArePaddedWithZeros)
{
    // a register of 32 bytes may be loaded at the last element: what lies behind must be finite as
    // float and as double, also in memory that held something before
    Context<Backend> context;
    for (const int bytes : {4, 8, 40, 400, 4000})
    {
        void* used = context.allocate(bytes + 16);
        const std::vector<unsigned char> ones(bytes + 64, 0xff);
        context.toDevice(used, ones.data(), ones.size());
        context.release(used);
        Array<Backend, unsigned char> a;
        a.allocate(context, bytes);
        Array<Backend, int> out;
        out.allocate(context, 28);
        runEach(context, 28, ReadPastEnd{a.data() + bytes, out.data()});
        for (const int b : out.download()) EXPECT_EQ(b, 0) << bytes << " bytes";
    }
}

FIELDS_TEST(ArraysGrowOnlyWhenTheyMust)
{
    Context<Backend> context;
    Array<Backend, double> a;
    EXPECT_EQ(a.bytes(), 0u);
    a.upload(context, {1, 2, 3});
    const double* at = a.data();
    a.allocate(context, 2);
    EXPECT_EQ(a.size(), 2u);
    EXPECT_EQ(a.data(), at);
    EXPECT_EQ(a.bytes(), 3*sizeof(double));
    EXPECT_EQ(a.download(), (std::vector<double>{1, 2}));
    Array<Backend, double> b(std::move(a));
    EXPECT_EQ(b.data(), at);
    a = std::move(b);
    EXPECT_EQ(a.data(), at);
    a.allocate(context, 1000);
    EXPECT_EQ(a.download(), std::vector<double>(1000, 0.0)) << "new memory is zero";
}

FIELDS_TEST(PermuteMovesEveryField)
{
    // more fields than one launch takes, of 4 and 8 bytes
    const int n = 1000, fields = 2*Permute::maxFields + 3;
    Context<Backend> context;
    FieldSet<Backend> set;
    std::vector<int> wide, narrow;
    for (int f = 0; f < fields; ++f)
    {
        if (f % 3 == 0) wide.push_back(set.add<std::int64_t>("wide" + std::to_string(f)));
        else narrow.push_back(set.add<float>("narrow" + std::to_string(f)));
    }
    set.allocate(context, n);
    ASSERT_EQ(set.fields(), fields);
    EXPECT_EQ(set.size(), std::size_t(n));
    EXPECT_EQ(set.info()[3].name, "wide3");
    EXPECT_EQ(set.info()[3].bytes, 2*8u*n);      // the field and its spare
    EXPECT_EQ(set.elementBytes(narrow[0]), 4);
    const auto wideValue = [](int f, int i) { return (std::int64_t(f) << 40) - 3*i; };
    const auto narrowValue = [](int f, int i) { return float(f) + 0.25f*i; };
    for (const int f : wide)
    {
        std::vector<std::int64_t> v(n);
        for (int i = 0; i < n; ++i) v[i] = wideValue(f, i);
        set.upload(context, f, v);
    }
    for (const int f : narrow)
    {
        std::vector<float> v(n);
        for (int i = 0; i < n; ++i) v[i] = narrowValue(f, i);
        set.upload(context, f, v);
    }
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), std::mt19937(5));
    Array<Backend, std::uint32_t> device;
    device.upload(context, order);
    // twice: the halves of the buffers change places
    for (int round = 1; round <= 2; ++round)
    {
        set.permute(context, device.data(), n);
        context.synchronise();
        for (int i = 0; i < n; ++i)
        {
            const int from = int(round == 1 ? order[i] : order[order[i]]);
            for (const int f : {wide.front(), wide.back()})
                ASSERT_EQ(set.download<std::int64_t>(context, f)[i], wideValue(f, from));
            if (i % 50) continue;
            for (const int f : narrow)
                ASSERT_EQ(set.download<float>(context, f)[i], narrowValue(f, from));
        }
    }
}

//- Large sets share spare memory: fields move one after the other
FIELDS_TEST(PermuteOfLargeSets)
{
    const int n = int(FieldSet<Backend>::tightFrom);
    Context<Backend> context;
    FieldSet<Backend> set;
    const int a = set.add<std::int64_t>("a"), b = set.add<float>("b"),
              c = set.add<std::int64_t>("c"), d = set.add<float>("d");
    set.allocate(context, n);
    EXPECT_FALSE(set.alternates());
    EXPECT_EQ(set.bytes(), std::size_t(n)*(3*8 + 3*4)) << "four fields and two spares";
    std::vector<std::int64_t> wide(n);
    std::vector<float> narrow(n);
    std::vector<std::uint32_t> order(n);
    for (int i = 0; i < n; ++i)
    {
        wide[i] = 3*std::int64_t(i);
        narrow[i] = float(i);           // exact below 2^24
        order[i] = std::uint32_t((std::int64_t(i)*1000003 + 17) % n);
    }
    for (const int f : {a, c}) set.upload(context, f, wide);
    for (const int f : {b, d}) set.upload(context, f, narrow);
    Array<Backend, std::uint32_t> device;
    device.upload(context, order);
    for (int round = 0; round < 3; ++round) set.permute(context, device.data(), n);
    context.synchronise();
    const auto first = set.download<std::int64_t>(context, a),
               third = set.download<std::int64_t>(context, c);
    const auto second = set.download<float>(context, b), fourth = set.download<float>(context, d);
    for (int i = 0; i < n; ++i)
    {
        const std::uint32_t from = order[order[order[i]]];
        ASSERT_EQ(first[i], 3*std::int64_t(from));
        ASSERT_EQ(third[i], 3*std::int64_t(from));
        ASSERT_EQ(second[i], float(from));
        ASSERT_EQ(fourth[i], float(from));
    }
    set.releaseSpare();
    EXPECT_EQ(set.bytes(), std::size_t(n)*(2*8 + 2*4));
    EXPECT_EQ(set.download<float>(context, b)[5], second[5]);
}

struct AddHarmonics
{
    static constexpr const char* name = "addHarmonics";
    const float* x;
    HD void add(int i, double* sums) const
    {
        sums[0] += 1;
        sums[1] += double(x[i]);
        sums[2] += double(x[i])*x[i];
    }
};

FIELDS_TEST(SumsDoNotDependOnThreads)
{
    // sizes below, at and above the number of chunks
    for (const int n : {0, 1, 255, 256, 257, 5000, 100003})
    {
        Random random{unsigned(n)};
        std::vector<float> x(n);
        long double first = 0, second = 0;
        for (float& v : x)
        {
            v = float(random(-1, 1));
            first += v;
            second += (long double)(v)*v;
        }
        std::vector<std::array<double, 3>> results;
        withThreads([&](int)
        {
            Context<Backend> context;
            Array<Backend, float> device;
            device.upload(context, x);
            for (int repeat = 0; repeat < 2; ++repeat)
                results.push_back(sumOver<3>(context, n, AddHarmonics{device.data()}));
        });
        for (const auto& r : results)
            EXPECT_EQ(r, results[0])
                << n << ": the same bits with any number of threads, every time";
        // n roundings of partial sums no larger than n in the worst case, at random: 1e-16 sqrt(n)
        // of the sum of magnitudes
        EXPECT_EQ(results[0][0], n);
        EXPECT_NEAR(results[0][1], double(first), 1e-15*std::sqrt(n + 1.0)*double(second + 1));
        EXPECT_NEAR(results[0][2], double(second), 1e-15*std::sqrt(n + 1.0)*double(second + 1));
    }
}

//- Those of more than 2 MB go in pieces of 4 MB through memory that is used again and again
FIELDS_TEST(LargeCopiesComeBackWhole)
{
    Context<Backend> context;
    const int mega = 1 << 20;
    std::vector<std::uint32_t> sent;
    std::vector<unsigned char> back(40*mega);
    for (const int bytes : {2*mega - 1, 2*mega, 2*mega + 1, 4*mega - 3, 4*mega, 4*mega + 1,
             16*mega, 16*mega + 1, 20*mega - 1, 37*mega + 12345})
    {
        sent.resize(bytes/4 + 3);
        for (std::size_t i = 0; i < sent.size(); ++i)
            sent[i] = std::uint32_t(i*2654435761u + bytes);
        // to and from any byte
        const auto* from = reinterpret_cast<const unsigned char*>(sent.data()) + 1;
        Array<Backend, unsigned char> there;
        there.allocate(context, bytes + 2);
        context.toDevice(there.data() + 1, from, bytes);
        back.assign(back.size(), 0xee);
        context.toHost(back.data() + 3, there.data() + 1, bytes);
        EXPECT_TRUE(std::equal(from, from + bytes, back.begin() + 3)) << bytes << " bytes";
        for (const int k : {0, 2, bytes + 3, bytes + 5})
            EXPECT_EQ(back[k], 0xee) << bytes << " bytes, beside them";
    }
}

//- What a snapshot keeps is what was there, whatever becomes of the arrays
FIELDS_TEST(SnapshotsKeepWhatWasThere)
{
    Context<Backend> context;
    for (const std::size_t n : {std::size_t(0), std::size_t(1), std::size_t(1000),
             std::size_t(3000001)})
    {
        std::vector<int> given(n), others(n, -1);
        std::iota(given.begin(), given.end(), 7);
        Array<Backend, int> a;
        a.upload(context, given);
        Snapshot<Backend> kept(context, true), live(context, false);
        const auto then = kept.values(a), now = live.values(a);
        const auto half = kept.values(a.data() + n/2, n - n/2);
        EXPECT_EQ(now(), given) << n;
        a.upload(context, others);
        EXPECT_EQ(now(), others) << n;
        EXPECT_EQ(then(), given) << n;
        a = Array<Backend, int>();
        EXPECT_EQ(then(), given) << n;
        EXPECT_TRUE(std::equal(given.begin() + n/2, given.end(), half().begin())) << n;
    }
}

FIELDS_TEST(LaunchesAreCounted)
{
    Context<Backend> context;
    Array<Backend, int> out;
    out.allocate(context, 28);
    Array<Backend, unsigned char> a;
    a.allocate(context, 64);
    for (int k = 0; k < 3; ++k) runEach(context, 28, ReadPastEnd{a.data(), out.data()});
    runEach(context, 0, ReadPastEnd{nullptr, nullptr});     // nothing to do: no launch
    ASSERT_EQ(context.profile.entries().size(), 1u);
    EXPECT_EQ(context.profile.entries()[0].name, "readPastEnd");
    EXPECT_EQ(context.profile.entries()[0].launches, 3);
    EXPECT_EQ(context.profile.entries()[0].seconds, 0) << "not timed unless asked";
    context.profile.timing = true;
    runEach(context, 28, ReadPastEnd{a.data(), out.data()});
    EXPECT_GT(context.profile.entries()[0].seconds, 0);
}

} // namespace
} // namespace riprap

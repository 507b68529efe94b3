/*  Sums that stay on the device, work in one block, and writes that several threads share.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "core/loops/deviceLoop.hpp"
#include "core/loops/deviceReduce.hpp"
#include "core/backend/singleBlock.hpp"
#include "core/loops/deterministicAtomics.hpp"

namespace riprap
{
namespace
{

struct Numbers
{
    static constexpr const char* name = "numbers";
    HD void add(int i, double* sums) const
    {
        sums[0] += i;
        sums[1] += 1.0/(i + 1);
    }
};

struct Keep
{
    static constexpr const char* name = "keep";
    double* to;
    HD void operator()(const double* total) const { to[0] = total[0]; to[1] = total[1]; }
};

//- Halves a number as long as it is above one
struct Halve
{
    static constexpr const char* name = "halve";
    double* value;
    int* again;
    LoopCondition condition;
    HD void operator()(int) const
    {
        *value /= 2;
        *again = *value > 1;
        condition.set(*again);
    }
};

//- Prefix sums by doubling, which need every barrier
struct Prefix
{
    static constexpr const char* name = "prefix";
    int n;
    int* a;
    int* b;

    HD void operator()(const Team& team) const
    {
        int* from = a;
        int* to = b;
        for (int step = 1; step < n; step *= 2)
        {
            const int* f = from;
            int* t = to;
            const int s = step;
            team.each(n, [f, t, s](int i) { t[i] = f[i] + (i >= s ? f[i - s] : 0); });
            to = from;
            from = t;
        }
        const int* f = from;
        int* t = a;
        if (f != t) team.each(n, [f, t](int i) { t[i] = f[i]; });
    }
};

struct Share
{
    static constexpr const char* name = "share";
    int* least;
    std::int64_t* sum;
    int* flag;
    HD void operator()(int i) const
    {
        atomicMinimum(least, 5000 - (i*37) % 4999);
        addShared(sum, i);
        if (i == 77) raise(flag);
    }
};

#ifdef __CUDACC__
class GpuDevice : public BackendTest {};
#define DEVICE_TEST(name) TEST_F(GpuDevice, name)
#else
class CpuDevice : public BackendTest {};
#define DEVICE_TEST(name) TEST_F(CpuDevice, name)
#endif

DEVICE_TEST(SumsStayThere)
{
    for (const int n : {0, 1, 100, 1000, 100000})
    {
        std::vector<double> first;
        withThreads([&](int)
        {
            Context<Backend> context;
            Array<Backend, double> partial, total;
            partial.allocate(context, deviceReduceRoom(2));
            total.allocate(context, 2);
            // in the same memory
            for (int again = 0; again < 2; ++again)
                sumThen<2>(context, n, Numbers{}, partial.data(), Keep{total.data()});
            context.synchronise();
            const std::vector<double> t = total.download();
            double harmonic = 0;
            for (int i = n; i > 0; --i) harmonic += 1.0/i;
            EXPECT_EQ(t[0], 0.5*n*(n - 1.0));
            EXPECT_NEAR(t[1], harmonic, 1e-13*(1 + harmonic));
            if (first.empty()) first = t;
            EXPECT_EQ(first, t);
        });
    }
}

DEVICE_TEST(LoopsEndThere)
{
    Context<Backend> context;
    Array<Backend, double> value;
    Array<Backend, int> again;
    value.upload(context, {1000});
    again.upload(context, {1});
    DeviceLoop<Backend> loop;
    loop.run(context, again.data(),
        [&](const LoopCondition& c) {
            forEach(context, 1, Halve{value.data(), again.data(), c});
        });
    context.synchronise();
    EXPECT_EQ(value.download()[0], 1000.0/1024);
    // recorded once, run again
    const double more = 40;
    context.toDevice(value.data(), &more, sizeof(more));
    loop.run(context, again.data(),
        [&](const LoopCondition& c) {
            forEach(context, 1, Halve{value.data(), again.data(), c});
        });
    context.synchronise();
    EXPECT_EQ(value.download()[0], 40.0/64);
}

DEVICE_TEST(OneBlockWaits)
{
    Context<Backend> context;
    const int n = 5000;
    Array<Backend, int> a, b;
    a.upload(context, std::vector<int>(n, 1));
    b.upload(context, std::vector<int>(n, 0));
    singleBlock(context, Prefix{n, a.data(), b.data()});
    context.synchronise();
    const std::vector<int> sums = a.download();
    for (int i = 0; i < n; ++i) ASSERT_EQ(sums[i], i + 1);
}

DEVICE_TEST(SharedWritesDoNotDependOnTheirOrder)
{
    withThreads([&](int)
    {
        Context<Backend> context;
        Array<Backend, int> least, flag;
        Array<Backend, std::int64_t> sum;
        least.upload(context, {100000});
        flag.upload(context, {0});
        sum.upload(context, {0});
        forEach(context, 20000, Share{least.data(), sum.data(), flag.data()});
        context.synchronise();
        EXPECT_EQ(least.download()[0], 2);
        EXPECT_EQ(sum.download()[0], 20000ll*19999/2);
        EXPECT_EQ(flag.download()[0], 1);
    });
}

} // namespace
} // namespace riprap

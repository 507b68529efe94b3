/*  Particles of slow water that are stepped once an interval (pic/multirate): what they do is what
    they would do in each step, within the path that slow ones may go.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picSolidScene.hpp"
#include "solvers/pic/transfer/picTransfers.hpp"

namespace riprap
{
namespace
{

class PicMultirate : public PicSolidScene
{
protected:

    static constexpr int n = 16;
    static constexpr double h = 1.0/n;

    //- A tank 4 m long and 1 m high; thin in 3D
    PicConfig tank(int interval) const
    {
        PicConfig c = config(n);
        c.cells[0] = 4*n;
        c.domainMax[0] = 4;
        if (D() == 3) { c.cells[2] = 4; c.domainMax[2] = 4*h; }
        c.slowInterval = interval;
        c.pressureTolerance = 1e-9;
        return c;
    }

    //- Water of a height at x
    template<class Height>
    static FluidInput water(const PicConfig& c, const Height& height)
    {
        return box(c, c.domainMin, c.domainMax,
            [&](double x, double y) { return y < height(x); });
    }

    static FluidInput dam(const PicConfig& c)
    {
        return water(c, [](double x) { return x < 0.75 ? 0.625 : 0.25; });
    }

    static FluidInput pool(const PicConfig& c)
    {
        return water(c, [](double) { return 0.375; });
    }

    static std::unique_ptr<PicScene> make(const PicConfig& c, const FluidInput& f)
    {
        return createPicScene(c, f, PicWalls());
    }

    static double share(const PicReport& r) { return double(r.slow)/double(r.fluid); }

    static int launches(const PicScene& s, const std::string& kernel)
    {
        int all = 0;
        for (const KernelInfo& k : s.kernels()) if (k.name == kernel) all += int(k.launches);
        return all;
    }

    //- Height of the water along the tank, from the part of each column's cells
    static std::vector<double> levels(const PicConfig& c, PicScene& s)
    {
        const PicGridState g = s.grid();
        std::vector<double> level(c.cells[0], 0.0);
        for (int k = 0; k < c.cells[2]; ++k)
            for (int j = 0; j < c.cells[1]; ++j)
                for (int i = 0; i < c.cells[0]; ++i)
                    level[i] += h/c.cells[2]*g.water[i + c.cells[0]*(j + c.cells[1]*k)];
        return level;
    }

    //- Where the bore is: the last column whose water stands higher than that
    static double front(const std::vector<double>& level, double height)
    {
        int last = -1;
        for (int i = 0; i < int(level.size()); ++i) if (level[i] > height) last = i;
        return last*h;
    }

    static double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
    {
        double most = 0;
        for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
        return most;
    }

    //- Particles of both by their ids
    static double farthest(const FluidState& a, const FluidState& b)
    {
        std::map<std::int32_t, std::size_t> of;
        for (std::size_t i = 0; i < b.id.size(); ++i) of[b.id[i]] = i;
        double most = 0;
        for (std::size_t i = 0; i < a.id.size(); ++i)
            for (int d = 0; d < 3; ++d)
                most = std::max(most,
                    std::abs(a.position[3*i + d] - b.position[3*of.at(a.id[i]) + d]));
        return most;
    }
};

RIPRAP_ALL_SETUPS(PicMultirate);

//- Neither kernels nor arrays of it are there, whatever else is said of it
TEST_P(PicMultirate, OffItDoesNothing)
{
    PicConfig c = tank(1);
    const auto plain = make(c, dam(c));
    c.slowCourant = 0.4;
    const auto other = make(c, dam(c));
    for (PicScene* s : {plain.get(), other.get()})
    {
        const PicReport r = s->advance(10, 25);
        EXPECT_EQ(r.slow, 0u);
        for (const char* k : {"findFastTiles", "addToInterval", "chooseSlowTiles", "wakeTiles"})
            EXPECT_EQ(launches(*s, k), 0) << k;
        for (const ArrayInfo& a : s->arrays()) EXPECT_NE(a.name, "multirate");
    }
    EXPECT_TRUE(plain->saveState() == other->saveState());
}

//- Where no water is slow enough each bit is the same
TEST_P(PicMultirate, FastWaterIsSteppedAsEver)
{
    PicConfig c = tank(1);
    const auto plain = make(c, dam(c));
    c.slowInterval = 4;
    c.slowCourant = 1e-300;
    const auto other = make(c, dam(c));
    plain->advance(10, 30);
    EXPECT_EQ(other->advance(10, 30).slow, 0u);
    EXPECT_GT(launches(*other, "findFastTiles"), 0);
    expectSameBits(plain->fluid(), other->fluid());
}

//- All particles wait; nothing drifts in 600 steps
TEST_P(PicMultirate, WaterAtRestStaysAtRest)
{
    PicConfig c = tank(10);
    c.jitter = 1;
    const auto s = make(c, pool(c));
    s->advance(10, 1);
    const FluidState before = s->fluid();
    const std::vector<double> level = levels(c, *s);
    const FluidEnergy first = s->energy();
    const PicReport r = s->advance(1e3, 600);
    EXPECT_EQ(share(r), 1.0);
    EXPECT_LT(farthest(before, s->fluid()), 1e-5*h);
    EXPECT_LT(largestDifference(level, levels(c, *s)), 1e-4*h);
    EXPECT_LT(std::abs(r.volumeError), 1e-6);
    const FluidEnergy last = s->energy();
    EXPECT_LT(std::abs(last.potential - first.potential), 1e-5*first.potential);
    EXPECT_LT(last.kinetic, 1e-8*first.potential);
}

//- A long wave so slow that all particles wait all the time: it sloshes as it would, since the grid
//  is stepped, and particles take all that it has made of them
TEST_P(PicMultirate, SlowWavesGoOn)
{
    constexpr double most = 0.01;               // m/s
    const PicConfig c[2] = {tank(1), tank(10)};
    FluidInput f = pool(c[0]);
    for (std::size_t i = 0; i < f.size(); ++i)
        f.velocity[3*i] = most*std::sin(M_PI*f.position[3*i]/4);
    const auto each = make(c[0], f), slow = make(c[1], f);
    double largest = 0, difference = 0;
    for (int k = 1; k <= 12; ++k)
    {
        each->advance(0.2*k);
        const PicReport r = slow->advance(0.2*k);
        if (k > 1) { EXPECT_EQ(share(r), 1.0) << k; }
        const std::vector<double> a = levels(c[0], *each), b = levels(c[1], *slow);
        difference = std::max(difference, largestDifference(a, b));
        largest = std::max(largest, largestDifference(a, std::vector<double>(a.size(), 0.375)));
    }
    EXPECT_GT(largest, 0.02*h);
    EXPECT_LT(difference, 1e-3*largest);
}

//- Fast drops wake the tile that they come to in the same step: nobody is moved there twice
TEST_P(PicMultirate, WhoComesToWakingWaterIsMovedOnce)
{
    PicConfig c = tank(10);
    c.cells[1] = 4*n;
    c.domainMax[1] = 4;
    const double speed = 8, dt = 3*h/speed;
    c.seedsPerDirection = 0;
    c.adjustTimeStep = false;
    c.fixedTimeStep = dt;
    FluidInput f = pool(c);
    const std::size_t still = f.size();
    // one in a column, each at another place of its cell
    for (int k = 0; k < 14; ++k)
        for (const double x : {(4*k + 4.5)*h, 3.8 - 0.3*h*k, 2.5*h}) f.position.push_back(x);
    f.velocity.resize(f.position.size(), 0);
    for (std::size_t i = still; i < f.size(); ++i) f.velocity[3*i + 1] = -speed;
    const auto s = make(c, f);
    FluidState before = s->fluid();
    double least = 1, most = 0;
    for (int k = 0; k < 25; ++k)
    {
        const PicReport r = s->advance(10, 1);
        most = std::max(most, share(r));
        if (most > 0) least = std::min(least, share(r));
        const FluidState after = s->fluid();
        EXPECT_LT(farthest(before, after), 1.1*(speed + 9.81*dt*(k + 1))*dt) << k;
        before = after;
    }
    // all wait, then come some drops
    EXPECT_GT(most, 0.9);
    EXPECT_LT(least, 0.9);
}

//- A bore over a long bed, too low to break: what breaks does not repeat, whatever changes. Where
//  it is, and how high water stands, are those of steps for each particle, far within the path of
//  slow ones
TEST_P(PicMultirate, ABoreMeetsWaterThatWaited)
{
    const PicConfig c[2] = {tank(1), tank(10)};
    const FluidInput f = water(c[0], [](double x) { return x < 1 ? 0.375 : 0.25; });
    const auto each = make(c[0], f), slow = make(c[1], f);
    const double path = c[1].slowCourant*h;
    double most = 0;
    for (int k = 1; k <= 8; ++k)
    {
        each->advance(0.2*k);
        const PicReport r = slow->advance(0.2*k);
        most = std::max(most, share(r));
        const std::vector<double> a = levels(c[0], *each), b = levels(c[1], *slow);
        EXPECT_EQ(front(a, 0.27), front(b, 0.27)) << k;
        double mean = 0;
        for (std::size_t i = 0; i < a.size(); ++i) mean += std::abs(a[i] - b[i])/a.size();
        EXPECT_LT(mean, 0.05*path) << k;
        EXPECT_NEAR(
            slow->energy().kinetic, each->energy().kinetic, 0.01*each->energy().kinetic);
        EXPECT_LT(std::abs(r.volumeError), 1e-3);
    }
    EXPECT_GT(most, 0.25);
    EXPECT_GT(front(levels(c[1], *slow), 0.27), 2.5);
}

//- Particles anywhere, water of any shape at the start; what a step gives to the grid and to
//  particles is in balance as without
TEST_P(PicMultirate, MomentumIsThatOfEachStep)
{
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> in(0.2, 0.5);
        std::vector<double> height(8);
        for (double& y : height) y = in(random);
        std::fill(height.begin() + 3, height.end(), 0.25);
        PicConfig c[2] = {tank(1), tank(3)};
        for (PicConfig& one : c) one.jitter = 1;
        std::unique_ptr<PicScene> s[2];
        for (int k = 0; k < 2; ++k)
        {
            s[k] = make(c[k], water(c[k], [&](double x) { return height[int(2*x)]; }));
            s[k]->watchMomentum(true);
        }
        Vector3 sum[2] = {};
        double gone = 0, share = 0;
        for (int step = 0; step < 21; ++step)
        {
            for (int k = 0; k < 2; ++k)
            {
                const PicReport r = s[k]->advance(10, 1);
                for (int d = 0; d < 3; ++d) sum[k][d] += s[k]->momentum().particles[d];
                if (k) share = std::max(share, double(r.slow)/r.fluid);
            }
            gone += std::abs(s[0]->momentum().particles[0]) + std::abs(sum[0][0]);
        }
        EXPECT_GT(share, 0.2);
        for (int d = 0; d < 2; ++d)
            EXPECT_NEAR(sum[1][d], sum[0][d], 1e-4*gone) << seed;
    }
}

//- In the middle of an interval too, with each transfer scheme
TEST_P(PicMultirate, StatesGoOnToTheBit)
{
    for (const TransferCard& card : transfers())
    {
        PicConfig c = tank(10);
        c.transfer = card.word;
        c.splineOrder = card.orders.back();
        const auto whole = make(c, dam(c)), second = make(c, dam(c));
        EXPECT_GT(share(whole->advance(10, 25)), 0.2) << card.word;
        second->advance(10, 12);                // other tiles wait there
        const std::vector<std::int32_t> half = whole->saveState();
        second->loadState(half);
        EXPECT_TRUE(second->saveState() == half) << card.word;
        for (const int steps : {2, 6, 20})
        {
            EXPECT_GT(whole->advance(10, steps).slow, 0u);
            second->advance(10, steps);
            EXPECT_TRUE(whole->saveState() == second->saveState()) << card.word << " " << steps;
        }
        c.slowInterval = 1;
        EXPECT_THROW(make(c, dam(c))->loadState(half), std::invalid_argument);
    }
}

//- Tiles about solids that move never wait: a ball falls into water that does
TEST_P(PicMultirate, ABallFallsIntoWaterThatWaits)
{
    PicConfig c[2] = {tank(1), tank(10)};
    std::unique_ptr<PicScene> s[2];
    for (int k = 0; k < 2; ++k)
    {
        const FluidInput f = pool(c[k]);
        s[k] = withSolids(c[k], f, balls(c[k], {{{1, 0.6, D() == 3 ? 2*h : 0}}}, 2*h, 2000));
    }
    double most = 0;
    for (int k = 1; k <= 5; ++k)
    {
        PicReport r[2];
        for (int i = 0; i < 2; ++i) r[i] = s[i]->advance(0.1*k);
        most = std::max(most, share(r[1]));
        const DemState a = s[0]->solids()->particles(), b = s[1]->solids()->particles();
        EXPECT_NEAR(a.position[1], b.position[1], 1e-3*h) << k;
        EXPECT_EQ(r[1].stop, StopReason::none);
    }
    EXPECT_GT(most, 0.3);
}

//- Tiles about openings never wait; water comes in, and a state of that goes on, with what water
//  sticks to
TEST_P(PicMultirate, WaterComesInBesideWaterThatWaits)
{
    std::unique_ptr<PicScene> s[3];
    PicWalls sides;
    for (int k = 0; k < 3; ++k)
    {
        PicConfig c = tank(k ? 8 : 1);
        c.noSlip = true;
        c.viscosity = 0.1;
        PicOpening o;
        o.name = "river";
        o.kind = "flowRate";
        o.flowRate = [&](double) { return D() == 3 ? 0.01*4*h : 0.01; };
        o.level = [](double) { return 0.375; };
        c.openings = {o};
        const int rows = c.cells[1]*c.cells[2];
        sides.opening[0].assign((c.cells[0] + 1)*rows, -1);
        for (int j = 0; j < rows; ++j) sides.opening[0][(c.cells[0] + 1)*j] = 0;
        s[k] = createPicScene(c, pool(c), sides);
    }
    s[0]->advance(1);
    const PicReport r = s[1]->advance(1);
    EXPECT_GT(share(r), 0.3);
    EXPECT_LT(share(r), 0.95);
    ASSERT_EQ(r.passed.size(), 1u);
    EXPECT_GT(r.passed[0].in, 4);
    EXPECT_LT(std::abs(r.volumeError), 1e-3);
    const PicConfig c = tank(1);
    EXPECT_LT(largestDifference(levels(c, *s[0]), levels(c, *s[1])), 0.05*h);
    s[2]->loadState(s[1]->saveState());
    for (int k = 1; k < 3; ++k) s[k]->advance(10, 21);
    EXPECT_TRUE(s[1]->saveState() == s[2]->saveState());
}

TEST_P(PicMultirate, WrongNumbersAreRefused)
{
    for (const int interval : {0, -3})
    {
        const PicConfig c = tank(interval);
        EXPECT_THROW(make(c, pool(c)), std::invalid_argument);
    }
    for (const double path : {0.0, -1.0, 0.6, std::nan("")})
    {
        PicConfig c = tank(10);
        c.slowCourant = path;
        EXPECT_THROW(make(c, pool(c)), std::invalid_argument);
    }
}

} // namespace
} // namespace riprap

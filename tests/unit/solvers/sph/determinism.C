/*  The same input gives the same bits: again, with any number of threads, and whatever is read in
    between.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <omp.h>
#include "tankScene.hpp"

namespace riprap
{
namespace
{

class Determinism : public TankScene
{
protected:

    //- With everything that sums over neighbours
    SphConfig full() const
    {
        SphConfig c = tank();
        c.viscosityModel = "laminarAndArtificial";
        c.viscosity = 0.1;
        c.antiClump = 0.01;
        c.xsph = 0.3;
        c.diffusion = "fourtakas";
        c.shifting = "fickian";
        c.variableSmoothing = true;
        return c;
    }

    std::unique_ptr<SphScene> make(const SphConfig& c, bool piston) const
    {
        WallInput w = walls(c);
        if (piston) makePiston(w);
        return scene(c, column(c), w, piston ? pistonMotion() : WallMotion());
    }
};

RIPRAP_ALL_SETUPS(Determinism);

TEST_P(Determinism, AgainTheSameBits)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
        for (const bool piston : {false, true})
        {
            SCOPED_TRACE(
                integrator
                + (piston ? ", piston" : ""));
            SphConfig c = full();
            c.integrator = integrator;
            const auto a = make(c, piston), b = make(c, piston);
            for (int k = 1; k <= 3; ++k)
            {
                const SphReport first = a->advance(0.01*k), second = b->advance(0.01*k);
                EXPECT_EQ(first.totalSteps, second.totalSteps);
                EXPECT_EQ(first.lastTimeStep, second.lastTimeStep);
                expectSameBits(a->fluid(), b->fluid());
            }
            EXPECT_EQ(a->saveState(), b->saveState());
        }
}

TEST_P(Determinism, AnyNumberOfThreads)
{
    if (GetParam().device == DeviceKind::gpu) GTEST_SKIP() << "of the CPU";
    const int before = omp_get_max_threads();
    SphConfig c = full();
    // sorting and summing use several threads from 20000 particles on, most loops from 64 or 256
    if (D() == 2) { c.spacing = 1.0/160; c.wallSpacing = c.spacing; }
    std::vector<FluidState> states;
    std::vector<double> energies;
    for (const int threads : {1, 2, 3})
    {
        omp_set_num_threads(threads);
        FluidInput f = D() == 2 ? lattice(c, {{0, 0, 0}}, {{0.8, 1, 0}}) : column(c);
        disturb(c, f, 0.05, 0.5, 0);
        for (std::size_t k = 0; k < f.size(); ++k)
            f.position[3*k + 1] = std::min(f.position[3*k + 1], 1.0);
        SphConfig open = c;
        open.domainMax[1] = 1.2;
        WallInput w = floorOf(open, 1, 0, 3);
        const auto s = scene(open, f, w);
        s->advance(1, 5);
        states.push_back(s->fluid());
        energies.push_back(s->energy().kinetic);
    }
    omp_set_num_threads(before);
    for (int k = 1; k < 3; ++k)
    {
        expectSameBits(states[0], states[k]);
        EXPECT_EQ(energies[0], energies[k]);
    }
}

TEST_P(Determinism, ReadingChangesNothing)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
        for (const bool piston : {false, true})
        {
            SCOPED_TRACE(
                integrator
                + (piston ? ", piston" : ""));
            SphConfig c = full();
            c.integrator = integrator;
            const auto a = make(c, piston), b = make(c, piston);
            std::string limit;
            for (int k = 1; k <= 3; ++k)
            {
                a->advance(0.01*k);
                b->advance(0.01*k);
                b->fluid();
                b->energy();
                b->sample({0.1, 0.1, 0.1});
                b->neighboursPerParticle();
                b->estimateTimeStep(limit);
                const auto forces = b->wallForces();
                EXPECT_EQ(forces, b->wallForces());
                const WallState w = b->walls(), unread = a->walls();
                EXPECT_EQ(w.position, unread.position);
                EXPECT_EQ(w.velocity, unread.velocity);
                // wallForces sorts the fluid anew: sums in another order
                for (std::size_t i = 0; i < w.pressure.size(); ++i)
                    ASSERT_NEAR(
                        w.pressure[i], unread.pressure[i], 100*epsilon()*largest(w.pressure))
                        << "wall point " << i;
            }
            a->advance(0.04);
            b->advance(0.04);
            expectSameBits(a->fluid(), b->fluid());
        }
}

} // namespace
} // namespace riprap

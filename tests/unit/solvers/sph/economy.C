/*  What a scene does not use is not there: the kernels it launches, how often, and the arrays it
    holds, exactly. A test here fails when something is added that costs every scene; then say so
    here, with the reason.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "sceneTest.hpp"

namespace riprap
{
namespace
{

//- Launches a step and a rebuild
struct Launches { int step = 0, rebuild = 0; };
using Kernels = std::map<std::string, Launches>;
//- Bytes a particle of each array
using Arrays = std::map<std::string, std::size_t>;

class Economy : public SceneTest
{
protected:

    static constexpr int layers = 3;

    SphConfig base() const
    {
        SphConfig c = config();
        c.domainMin = {{0, -0.3, 0}};
        c.wallSpacing = c.spacing;
        c.gravity = {{0, -9.81, 0}};
        c.soundSpeed = 30;
        c.viscosityModel = "laminar";
        c.viscosity = 1e-3;
        return c;
    }

    FluidInput fluid(const SphConfig& c) const
    {
        return lattice(c, {{0, 0, 0}}, {{1, 0.5, D() == 3 ? 0.5 : 0.0}});
    }

    std::unique_ptr<SphScene> make(const SphConfig& c, bool walls, bool moving) const
    {
        WallInput w = walls ? floorOf(c, 1, 0, layers) : WallInput();
        WallMotion motion;
        if (moving)
        {
            w.nBodies = 1;
            w.body.assign(w.size(), 0);
            motion = [](int, double t) { WallPose p; p.translation[0] = 0.01*t; return p; };
        }
        return scene(c, fluid(c), w, motion);
    }

    //- Of every scene, with the leapfrog
    static Kernels always()
    {
        Kernels k;
        k["clock"] = {1, 1};                // the last one before a rebuild finds that it is due
        k["leapfrogDrift"] = {1, 0};
        k["fluidPass"] = {1, 0};
        for (const char* name :
            {"fluidKeys", "sort", "clearCells", "countCells", "scan", "permute", "placeFluid"})
            k[name] = {0, 1};
        return k;
    }

    //- What motion of walls adds
    static void addMotion(Kernels& k)
    {
        k["moveWalls"] = {1, 0};
        k["wallForce"] = {1, 0};            // their work
        k["wallKeys"] = k["placeWalls"] = {0, 1};
        for (const char* name : {"sort", "clearCells", "countCells", "scan", "permute"})
            k[name].rebuild += 1;
    }

    //- What is kept of searches: fluid about fluid, and walls about it, and it about walls
    static std::size_t searches(const SphConfig& c, bool walls, bool moving)
    {
        return walls ? 2 + (moving || c.wallModel == "extrapolated") : 1;
    }

    void expectKernels(const char* what, const SphConfig& c, bool walls, bool moving,
        Kernels expected) const
    {
        SCOPED_TRACE(what);
        const bool gpu = GetParam().device == DeviceKind::gpu;
        if (!gpu) expected["findRanges"] = {0, int(searches(c, walls, moving))};
        const auto s = make(c, walls, moving);
        std::map<std::string, std::int64_t> before;
        for (const KernelInfo& k : s->kernels()) before[k.name] = k.launches;
        const SphReport r = s->advance(1, 20);
        ASSERT_EQ(r.steps, 20);
        std::map<std::string, std::int64_t> launched;
        for (const KernelInfo& k : s->kernels())
            if (k.launches > before[k.name]) launched[k.name] = k.launches - before[k.name];
        for (const auto& k : expected)
        {
            EXPECT_EQ(launched.count(k.first), 1u) << k.first << " was not launched";
            // recorded cycles on the GPU run on after the last step, switched off
            if (!gpu)
            {
                EXPECT_EQ(
                    launched[k.first], k.second.step*r.steps + k.second.rebuild*r.rebuilds)
                    << k.first;
            }
            launched.erase(k.first);
        }
        if (gpu)
            for (const char* list : {"listFluid", "listFluidWall", "listWallFluid", "clearFrames",
                     "clearStill", "settleFrames"})
                launched.erase(list);
        for (const auto& k : launched)
            ADD_FAILURE() << k.first << " was launched " << k.second << " times";
    }

    //- Double-buffered fields, pair records and positions when neighbours were sought
    Arrays fluidArrays() const
    {
        const std::size_t real = mixed() ? 4 : 8;
        Arrays a;
        const char* axes[3] = {".x", ".y", ".z"};
        for (int d = 0; d < D(); ++d)
        {
            a[std::string("fluid position") + axes[d]] = 2*8;
            a[std::string("fluid velocity") + axes[d]] =
                a[std::string("fluid acceleration") + axes[d]] = 2*real;
        }
        a["fluid densityDeviation"] = a["fluid densityRate"] = 2*real;
        a["fluid id"] = 2*4;
        a["fluid records"] = (2*D() + 2)*real;
        a["fluid reference"] = D()*real;
        return a;
    }

    void addWalls(Arrays& a, bool moving) const
    {
        const std::size_t real = mixed() ? 4 : 8, copies = moving ? 2 : 1;
        for (int d = 0; d < D(); ++d)
        {
            const std::string axis = std::string(".") + char('0' + d);
            a["wall position" + axis] = copies*8;
            if (moving) a["wall velocity" + axis] = a["wall acceleration" + axis] = 2*real;
        }
        a["wall id"] = copies*4;
        a["wall records"] = (2*D() + 2)*real;
        if (!moving) return;
        a["wall body"] = 2*4;
        a["wall work"] = a["wall pressureWork"] = 2*8;
        a["wall motion"] = 0;       // compared below
    }

    void expectArrays(
        const char* what, const SphConfig& c, bool walls, bool moving, Arrays expected) const
    {
        SCOPED_TRACE(what);
        const auto s = make(c, walls, moving);
        s->advance(1, 20);
        const std::size_t n = fluid(c).size(), nWalls = walls ? floorOf(c, 1, 0, layers).size() : 0;
        const std::size_t position = mixed() ? 4 : 8;
        double volume = 1;
        // with the margin of the box
        for (int d = 0; d < D(); ++d) volume *= (c.domainMax[d] - c.domainMin[d] + 0.5)/c.spacing;
        std::size_t lists = 0;
        for (const ArrayInfo& a : s->arrays())
        {
            const std::string name = a.set + " " + a.name;
            if (a.set == "lists") { ++lists; continue; }
            const std::size_t count = a.set == "fluid" ? n : nWalls;
            EXPECT_EQ(a.bytesPerParticle, a.bytes/count);
            if (a.name == "cells")
            {
                // keys and order of particles, each with a copy to sort into, unless they never
                // move; at most two cells a spacing^D; what the GPU's sort needs besides
                const std::size_t sort = a.set == "fluid" || moving ? 16*count : 0;
                EXPECT_GE(a.bytes, sort);
                EXPECT_LE(a.bytes, sort + 4*std::size_t(std::max(1000.0, 2*volume) + 2)
                  + (GetParam().device == DeviceKind::gpu ? (1 << 20) + 8*count : 0));
                continue;
            }
            ASSERT_EQ(expected.count(name), 1u) << name << " of " << a.bytes << " bytes";
            if (a.name == "motion")
                EXPECT_EQ(a.bytes, nWalls*(D()*position + 3*8) + 33*2*12*8)
                    << "where neighbours were sought, reference position, poses";
            else if (a.name == "records")       // padded by 16
                EXPECT_EQ(a.bytes, (count + 16)*expected[name]);
            else
                EXPECT_EQ(a.bytes, count*expected[name]) << name;
            expected.erase(name);
        }
        for (const auto& a : expected) ADD_FAILURE() << a.first << " is missing";
        EXPECT_EQ(lists, searches(c, walls, moving));
    }
};

RIPRAP_ALL_SETUPS(Economy);

TEST_P(Economy, KernelsWithoutWalls)
{
    SphConfig c = base();
    expectKernels("constant h", c, false, false, always());
    SphConfig other = c;
    other.variableSmoothing = true;
    expectKernels("variable h", other, false, false, always());
    other = c;
    other.viscosityModel = "none";
    expectKernels("no viscosity", other, false, false, always());
    other.xsph = 0.5;
    other.antiClump = 0.01;
    other.diffusion = "fourtakas";
    other.shifting = "fickian";
    expectKernels("all terms in one pass", other, false, false, always());
    other = c;
    other.integrator = "symplectic";
    Kernels k = always();
    k.erase("leapfrogDrift");
    k.erase("fluidPass");
    for (const char* name : {"symplecticKick", "densityPass", "symplecticDrift", "momentumPass"})
        k[name] = {1, 0};
    expectKernels("symplectic", other, false, false, k);
}

TEST_P(Economy, KernelsOfWalls)
{
    SphConfig c = base();
    c.wallModel = "stationary";
    expectKernels("stationary, fixed", c, true, false, always());
    Kernels k = always();
    addMotion(k);
    k["stationaryWall"] = {1, 1};
    expectKernels("stationary, moving", c, true, true, k);
    c.wallModel = "extrapolated";
    k = always();
    k["extrapolatedWall"] = {1, 0};
    expectKernels("extrapolated, fixed", c, true, false, k);
    addMotion(k);
    k["extrapolatedWall"] = {1, 1};         // after sorting
    expectKernels("extrapolated, moving", c, true, true, k);
}

TEST_P(Economy, ArraysWithoutWalls)
{
    const SphConfig c = base();
    expectArrays("constant h", c, false, false, fluidArrays());
    SphConfig other = c;
    other.viscosityModel = "none";
    expectArrays("no viscosity", other, false, false, fluidArrays());
    other.antiClump = 0.01;
    other.diffusion = "fourtakas";
    expectArrays("anti-clump term and diffusion", other, false, false, fluidArrays());
    other = c;
    other.integrator = "symplectic";
    expectArrays("symplectic", other, false, false, fluidArrays());
    const std::size_t real = mixed() ? 4 : 8;
    Arrays a = fluidArrays();
    a["fluid records"] += real;
    other = c;
    other.variableSmoothing = true;
    expectArrays("variable h", other, false, false, a);
    for (const bool xsph : {true, false})
    {
        a = fluidArrays();
        for (int d = 0; d < D(); ++d) a[std::string("fluid drift.") + char('x' + d)] = 2*real;
        other = c;
        if (xsph) other.xsph = 0.5; else other.shifting = "fickian";
        expectArrays(xsph ? "XSPH" : "shifting", other, false, false, a);
    }
}

TEST_P(Economy, ArraysOfWalls)
{
    for (const std::string model : {"stationary", "extrapolated"})
        for (const bool moving : {false, true})
        {
            SphConfig c = base();
            c.wallModel = model;
            Arrays a = fluidArrays();
            addWalls(a, moving);
            expectArrays(moving ? "moving" : "fixed", c, true, moving, a);
        }
}

//- The sum that a user asks about: bytes a particle, mixed precision, without cells and lists
TEST_P(Economy, BytesAParticle)
{
    std::size_t sum = 0;
    for (const auto& a : fluidArrays()) sum += a.second;
    EXPECT_EQ(sum, std::size_t(mixed() ? (D() == 2 ? 120 : 164) : (D() == 2 ? 200 : 272)));
}

} // namespace
} // namespace riprap

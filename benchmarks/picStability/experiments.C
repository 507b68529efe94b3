/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "experiments.hpp"
#include "../stability/experiments.hpp"
#include <cmath>

namespace riprap
{

namespace
{

struct Transfer { const char* name; const char* word; bool affine; };
constexpr Transfer kinds[] = {{"flip", "flip", true}, {"flip, no gradients", "flip", false},
    {"flipPic", "flipPic", true}, {"pic", "pic", true}, {"apic", "apic", true}};

PicConfig of(const Transfer& t, int n)
{
    PicConfig c = picSettings(n);
    c.transfer = t.word;
    c.transferNumbers.affine = t.affine;
    return c;
}

} // namespace

void step(PicRows& rows)
{
    for (const Transfer& t : kinds)
        for (const int order : {2, 3})
        {
            const auto good = [&](double courant)
            {
                PicConfig c = of(t, 24);
                c.advectionOrder = order;
                c.maxCourant = courant;
                const PicOutcome o = vortices(c, 3);
                return !o.stopped && o.energy < 1.05;
            };
            const std::string kind = std::string(t.name) + ", RungeKutta" + std::to_string(order);
            rows.add("step", kind, order, "largest Courant number, vortices",
                bisectRatio(0.1, 2, true, good));
        }
}

void blend(PicRows& rows)
{
    for (const double part : {0.0, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0})
    {
        PicConfig c = picSettings(32);
        c.transfer = "flipPic";
        c.transferNumbers.picPart = part;
        const PicOutcome o = vortices(c, 4);
        rows.add("blend", "flipPic", part, "noise", o.noise);
        rows.add("blend", "flipPic", part, "energy kept", o.kept);
        rows.add("blend", "flipPic", part, "velocity L2", o.error);
    }
    const PicOutcome o = vortices(of(kinds[4], 32), 4);
    rows.add("blend", "apic", 1, "noise", o.noise);
    rows.add("blend", "apic", 1, "energy kept", o.kept);
    rows.add("blend", "apic", 1, "velocity L2", o.error);
}

void particles(PicRows& rows)
{
    for (const Transfer& t : kinds)
        for (const int seeds : {1, 2, 3, 4, 5})
        {
            PicConfig c = of(t, 32);
            c.seedsPerDirection = seeds;
            const PicOutcome o = vortices(c, 2);
            rows.add("particles", t.name, seeds*seeds, "noise", o.noise);
            rows.add("particles", t.name, seeds*seeds, "velocity L2", o.error);
            rows.add("particles", t.name, seeds*seeds, "energy kept", o.kept);
        }
}

void tolerance(PicRows& rows)
{
    for (const double wanted : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    {
        PicConfig c = picSettings(32);
        c.pressureTolerance = wanted;
        const PicOutcome o = sloshing(c, 4);
        rows.add("tolerance", "flip", wanted, "volume put right", o.volumeDrift);
        rows.add("tolerance", "flip", wanted, "volume error", o.volumeError);
        rows.add("tolerance", "flip", wanted, "iterations a step", o.iterations);
        rows.add("tolerance", "flip", wanted, "energy kept", o.stopped ? NAN : o.kept);
    }
}

void levels(PicRows& rows)
{
    for (int k = 0; k <= 20; ++k)
    {
        const double part = k == 0 ? 0.001 : (k == 20 ? 0.999 : 0.05*k);
        rows.add(
            "levels", "surface", part, "largest speed", pool(picSettings(12), 6 + part, 0).speed);
        rows.add("levels", "floor", part, "largest speed",
            pool(picSettings(12), 6.5 - part, 2 + part).speed);
    }
}

} // namespace riprap

/*  All pairs in double by the paper's equations, without cells, lists or sorting: what one pass of
    a scene must give.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "paperEquations.hpp"
#include "sceneTest.hpp"

namespace riprap
{

class BruteForce
{
public:

    std::vector<Vector3> acceleration, drift;
    std::vector<double> rate;               // drho/dt
    std::vector<double> wallPressure;
    // a particle, within the support at rest density, walls included
    double neighbours = 0;

    BruteForce(const SphConfig& config, const FluidInput& f, const WallInput& w = {},
        const Vector3& wallSpeed = {{0, 0, 0}})
        : c(config)
    {
        h0 = c.smoothingRatio*c.spacing;
        support = supportOf(c);
        for (std::size_t i = 0; i < f.size(); ++i) fluid.push_back(fluidParticle(f, i));
        for (std::size_t i = 0; i < w.size(); ++i) walls.push_back(wallPoint(w, i, wallSpeed));
        for (const auto& p : walls) wallPressure.push_back(p.p);
        for (std::size_t i = 0; i < fluid.size(); ++i) sum(i);
        neighbours /= double(fluid.size());
    }

private:

    SphConfig c;
    double h0, support;
    std::vector<paper::Particle> fluid, walls;

    double pressure(double rho) const
    {
        const double s = c.soundSpeed*c.soundSpeed*c.density;
        return c.eos == "linear" ? s*(rho/c.density - 1)
                                        : s/c.gamma*(std::pow(rho/c.density, c.gamma) - 1);
    }

    double densityAt(double p) const
    {
        const double s = c.soundSpeed*c.soundSpeed*c.density;
        return c.density
            *(c.eos == "linear" ? 1 + p/s : std::pow(1 + p*c.gamma/s, 1/c.gamma));
    }

    //- x_i - x_j in the solved directions, nearest image
    Vector3 separation(const Vector3& a, const Vector3& b) const
    {
        Vector3 r{{0, 0, 0}};
        for (int d = 0; d < c.dimensions; ++d)
        {
            const int axis = c.axes[d];
            const double length = c.domainMax[axis] - c.domainMin[axis];
            r[axis] = a[axis] - b[axis];
            if (c.periodic[axis]) r[axis] -= length*std::round(r[axis]/length);
        }
        return r;
    }

    paper::Particle fluidParticle(const FluidInput& f, std::size_t i) const
    {
        paper::Particle p;
        for (int d = 0; d < c.dimensions; ++d)
        {
            p.x[c.axes[d]] = f.position[3*i + c.axes[d]];
            p.v[c.axes[d]] = f.velocity[3*i + c.axes[d]];
        }
        p.rho = f.density[i];
        p.p = pressure(p.rho);
        p.m = c.density*std::pow(c.spacing, c.dimensions);
        p.h = h0;
        if (c.variableSmoothing)        // Eq. 37 integrated, limited
            p.h = std::min(std::max(h0*std::pow(c.density/p.rho, 1.0/c.dimensions),
                               h0/c.maxSmoothingGrowth),
                h0*c.maxSmoothingGrowth);
        return p;
    }

    //- Section 5 of the paper, or Adami, Hu & Adams 2012 (their Eqs. 22, 23 and 27)
    paper::Particle wallPoint(const WallInput& w, std::size_t i, const Vector3& u) const
    {
        paper::Particle p;
        for (int d = 0; d < c.dimensions; ++d)
        {
            p.x[c.axes[d]] = w.position[3*i + c.axes[d]];
            p.u[c.axes[d]] = p.v[c.axes[d]] = u[c.axes[d]];
        }
        p.rho = c.density;
        p.m = c.density*std::pow(c.wallSpacing, c.dimensions);
        p.h = h0;
        if (c.wallModel == "stationary") return p;
        double sumW = 0, sumP = 0;
        Vector3 sumV{{0, 0, 0}};
        for (const auto& f : fluid)
        {
            const Vector3 x = separation(p.x, f.x);
            const double weight = paper::W(
                c.kernel, c.dimensions, std::sqrt(paper::dot(x, x)), 0.5*(h0 + f.h));
            sumW += weight;
            sumP += weight*(f.p + f.rho*paper::dot(solved(c.gravity), x));
            paper::add(sumV, weight, f.v);
        }
        // a point that hardly reaches the fluid keeps p = 0: no force of such weights matters
        if (sumW <= 1e-6*paper::W(c.kernel, c.dimensions, 0, h0)) return p;
        p.p = std::max(sumP/sumW, 0.0);
        p.rho = densityAt(p.p);
        for (int d = 0; d < 3; ++d) p.v[d] = 2*p.u[d] - sumV[d]/sumW;
        return p;
    }

    Vector3 solved(const Vector3& g) const
    {
        Vector3 r{{0, 0, 0}};
        for (int d = 0; d < c.dimensions; ++d) r[c.axes[d]] = g[c.axes[d]];
        return r;
    }

    void sum(std::size_t i)
    {
        Vector3 a = solved(c.gravity), u{{0, 0, 0}}, gradC{{0, 0, 0}};
        double r = 0, divergence = 0;
        const bool laminar = c.viscosityModel == "laminar"
            || c.viscosityModel == "laminarAndArtificial";
        const bool artificial = c.viscosityModel == "artificial"
            || c.viscosityModel == "laminarAndArtificial";
        const auto take = [&](paper::Pair& p)
        {
            paper::add(a, 1, p.a);
            paper::add(u, 1, p.drift);
            r += p.rate;
            paper::add(gradC, p.j.m/p.j.rho, p.grad);
            divergence -= p.j.m/p.j.rho*paper::dot(p.x, p.grad);
            if (p.r2 > 0 && p.r2 < support*support) ++neighbours;
        };
        for (std::size_t j = 0; j < fluid.size(); ++j)
        {
            if (j == i) continue;
            paper::Pair p(
                c.kernel, c.dimensions, fluid[i], fluid[j], separation(fluid[i].x, fluid[j].x));
            p.pressure();
            p.continuity();
            if (laminar) p.laminar(c.viscosity);
            if (artificial) p.artificial(c.artificialAlpha, c.soundSpeed);
            if (c.antiClump > 0) p.antiClump(c.antiClump, c.spacing);
            if (c.xsph > 0) p.xsph(c.xsph);
            if (c.diffusion == "molteni")
                p.diffusion(c.diffusionDelta, c.soundSpeed, c.density, {{0, 0, 0}});
            if (c.diffusion == "fourtakas")
                p.diffusion(c.diffusionDelta, c.soundSpeed, c.density, solved(c.gravity));
            take(p);
        }
        for (const auto& wall : walls)
        {
            paper::Pair p(c.kernel, c.dimensions, fluid[i], wall, separation(fluid[i].x, wall.x));
            p.pressure();
            p.wallContinuity();
            if (laminar && c.noSlip) p.laminar(c.viscosity);
            if (artificial && c.noSlip) p.wallArtificial(c.artificialAlpha, c.soundSpeed);
            take(p);
        }
        if (c.shifting == "fickian") shift(fluid[i], gradC, divergence, u);
        acceleration.push_back(a);
        rate.push_back(r);
        drift.push_back(u);
    }

    //- Skillen et al. 2013: - A h |v| grad C, faded out linearly where div r falls from D to the
    //  threshold, at most |v|/5 an axis
    void shift(const paper::Particle& p, const Vector3& gradC, double divergence, Vector3& u) const
    {
        const double threshold = c.shiftingSurfaceThreshold > 0 ? c.shiftingSurfaceThreshold
                                                                : (c.dimensions == 2 ? 1.5 : 2.75);
        const double fade = std::min(
            std::max((divergence - threshold)/(c.dimensions - threshold), 0.0), 1.0);
        const double speed = std::sqrt(paper::dot(p.v, p.v));
        for (int d = 0; d < 3; ++d)
            u[d] += std::min(
                std::max(-c.shiftingCoefficient*h0*speed*fade*gradC[d], -0.2*speed),
                0.2*speed);
    }
};

} // namespace riprap

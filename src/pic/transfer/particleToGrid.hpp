/*  Particles to grid: mass and momentum at the faces of one direction.

        m_f = sum_p W(x_f - x_p),       m_f u_f = sum_p W(x_f - x_p) (v_p + C_p.(x_f - x_p))

    in units of a particle's mass; C_p only with APIC (Jiang et al. 2015, Eqs. 8-10). W, a product of B-splines, sums to one over the faces: mass and momentum
    are conserved to round-off, and with APIC angular momentum about the nodes. Each face gathers from the cells about it in their order: the same input gives the same bits.
    At the sides of the block images of the particles count as well (mirror.hpp): the mass stays, the wall takes momentum.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/particles.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

//- f(particle) for all particles in the cells that lie within `reach` (in cells) of a point at s (in cells from the corner);
//  cells beyond the block do not exist
template<int D, class F>
HD void forEachNear(const UniformGrid<D>& g, const int* start, const double* s, double reach, const F& f)
{
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int a = 0; a < D; ++a)
    {
        low[a] = floorInt(s[a] - reach);
        high[a] = floorInt(s[a] + reach);
        low[a] = low[a] < 0 ? 0 : low[a];
        high[a] = high[a] >= g.n[a] ? g.n[a] - 1 : high[a];
    }
    if (low[0] > high[0]) return;
    for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
        {
            const int row = g.n[0]*(j + g.n[1]*k);
            for (int p = start[row + low[0]]; p < start[row + high[0] + 1]; ++p) f(p);
        }
}

//- What an image makes of a velocity: offset + sign v
struct ImageOf
{
    double sign, offset;
};

//- f(s, image) for a node at s and those of its images that particles in the block can see; component -1: cells
template<int D, class F>
HD void forEachImage(const UniformGrid<D>& g, int component, const double* node, double reach, const F& f)
{
    double variant[D][3];
    ImageOf image[D][3];
    int variants[3] = {1, 1, 1};
    for (int a = 0; a < D; ++a)
    {
        const double s = node[a], n = g.n[a];
        variant[a][0] = s;
        image[a][0] = ImageOf{1, 0};
        const auto add = [&](double at, ImageOf of)
        {
            variant[a][variants[a]] = at;
            image[a][variants[a]++] = of;
        };
        const auto mirror = [&](int upper)
        {
            if (component < 0) return ImageOf{1, 0};
            if (a == component) return ImageOf{-1, 0};
            return g.sticks[a][upper] ? ImageOf{-1, 2*g.slide[a][upper][component]} : ImageOf{1, 0};
        };
        if (g.periodic[a])
        {
            if (s < reach) add(s + n, ImageOf{1, 0});
            if (n - s < reach) add(s - n, ImageOf{1, 0});
        }
        else
        {
            if (s > 0 && s < reach) add(-s, mirror(0));
            if (s < n && n - s < reach) add(2*n - s, mirror(1));
        }
    }
    const auto both = [](ImageOf a, ImageOf b) { return ImageOf{a.sign*b.sign, a.offset + a.sign*b.offset}; };
    for (int k = 0; k < (D == 3 ? variants[2] : 1); ++k)
        for (int j = 0; j < variants[1]; ++j)
            for (int i = 0; i < variants[0]; ++i)
            {
                double s[D] = {variant[0][i], variant[1][j]};
                ImageOf of = both(image[0][i], image[1][j]);
                if constexpr (D == 3) { s[2] = variant[2][k]; of = both(of, image[2][k]); }
                f(s, of);
            }
}

template<int Order, int D, class R>
struct ParticleToGrid
{
    static constexpr const char* name = "particleToGrid";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    int component;
    bool affine;
    R* u;                       // velocity [m/s], 0 where no particle is near
    R* mass;                    // in particles

    HD void operator()(int i) const
    {
        const typename UniformGrid<D>::Index at = grid.faceIndex(component, i);
        double node[D];
        for (int a = 0; a < D; ++a) node[a] = at.c[a] + (a == component ? 0.0 : 0.5);
        constexpr double reach = BSpline<Order>::support;
        const double inverse = 1/grid.h;
        R sum = 0, momentum = 0;
        forEachImage<D>(grid, component, node, reach, [&](const double* s, ImageOf image)
        {
            R m = 0, mv = 0;
            forEachNear<D>(grid, particles.start, s, reach, [&](int p)
            {
                R w = 1, away[D];
                for (int a = 0; a < D; ++a)
                {
                    away[a] = R(s[a] - particles.x[a][p]*inverse);
                    w *= BSpline<Order>::value(away[a]);
                }
                R v = particles.v[component][p];
                if (affine)
                    for (int a = 0; a < D; ++a) v += particles.affine[component*D + a][p]*away[a]*R(grid.h);
                m += w;
                mv += w*v;
            });
            sum += m;
            momentum += R(image.sign)*mv + R(image.offset)*m;
        });
        mass[i] = sum;
        u[i] = sum > 0 ? momentum/sum : R(0);
    }
};

} // namespace riprap

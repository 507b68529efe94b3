/*  Scenes for the pressure step, as functions of the position in a box of height 1 (the last
    direction is up).

        wavy      water to about half the height below waves, with four balls cut out
        spray     a thin film, drops of a few cells, bubbles in the water
        tank      full, closed on all sides: a singular system
        baffles   half full, with thin walls that part it but for a gap, on faces that no coarse
                  grid has

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include "pic/cutCells/apertures.hpp"
#include "pic/grid/pressureFields.hpp"
#include "pressureSpeed.hpp"

namespace riprap
{

template<int D, class R>
struct PressureScene
{
    UniformGrid<D> grid;
    std::vector<R> phi, aperture[D], u[D];

    explicit PressureScene(const SpeedCase& c) : scene_(c.scene)
    {
        if (scene_ != "wavy" && scene_ != "spray" && scene_ != "tank" && scene_ != "baffles")
            throw std::invalid_argument(
                "unknown scene '" + scene_ + "'; valid: wavy spray tank baffles");
        grid.h = 1.0/c.n[D - 1];
        for (int d = 0; d < D; ++d)
        {
            grid.n[d] = c.n[d]*(d == D - 1 ? c.box : 1);
            grid.origin[d] = 0;
        }
        phi.resize(grid.cells());
        #pragma omp parallel for
        for (int i = 0; i < grid.cells(); ++i) phi[i] = R(surface(centre(grid.cellIndex(i), 0.5)));
        setFaces();
    }

private:

    std::string scene_;

    Vec<3, double> centre(const typename UniformGrid<D>::Index& x, double shift) const
    {
        Vec<3, double> p{{0, 0.3, 0}};
        for (int d = 0; d < D; ++d) p[d == D - 1 ? 2 : d] = (x.c[d] + shift)*grid.h;
        return p;
    }

    double surface(const Vec<3, double>& x) const
    {
        if (scene_ == "tank") return -1;
        if (scene_ == "baffles") return x[2] - 0.5007;
        const double wave = x[2] - 0.5 - 0.08*std::sin(7*x[0] + 1)*std::cos(5*x[1])
            - 0.02*std::sin(31*x[0])*std::sin(29*x[1] + 1);
        if (scene_ == "wavy") return wave;
        // drops on a cubic lattice with a spacing of 12 cells above the water, bubbles below it
        const double spacing = 12*grid.h;
        double r2 = 0;
        for (int d = 0; d < 3; ++d)
        {
            if (D == 2 && d == 1) continue;
            const double c = x[d]/spacing - std::floor(x[d]/spacing) - 0.5;
            r2 += c*c;
        }
        const double ball = (std::sqrt(r2) - 0.19)*spacing;
        return x[2] < 0.8 ? std::min(std::max(wave, -ball), ball + (x[2] < 0.3 ? 10 : 0)) : 10;
    }

    double solid(const Vec<3, double>& x) const
    {
        double nearest = 10;
        for (int k = 0; k < 4 && scene_ == "wavy"; ++k)
        {
            double r2 = 0;
            const double at[3] = {0.2 + 0.2*k, 0.3 + 0.11*k, 0.15 + 0.1*k};
            for (int d = 0; d < 3; ++d) r2 += std::pow(x[d] - at[d], 2);
            nearest = std::min(nearest, std::sqrt(r2) - 0.09);
        }
        return nearest;
    }

    void setFaces()
    {
        const NodeGrid<D> nodes{grid};
        std::vector<double> distance(nodes.count());
        #pragma omp parallel for
        for (int i = 0; i < nodes.count(); ++i)
        {
            const Vec<D, double> p = nodes.position(i);
            Vec<3, double> x{{p[0], 0.3, p[D - 1]}};
            if (D == 3) x[1] = p[1];
            distance[i] = solid(x);
        }
        for (int d = 0; d < D; ++d)
        {
            aperture[d].resize(grid.faces(d));
            u[d].resize(grid.faces(d));
            #pragma omp parallel for
            for (int f = 0; f < grid.faces(d); ++f)
            {
                const auto x = grid.faceIndex(d, f);
                const bool end = x.c[d] == 0 || x.c[d] == grid.n[d];
                const double open = 1 - solidOfFace(nodes, d, x, distance.data()).share;
                aperture[d][f] = R(end || open < smallestAperture || baffle(d, x) ? 0 : open);
                const auto p = centre(x, 0.5);
                u[d][f] = R(std::sin(13*p[0] + d)*std::cos(11*p[2])
                    + 0.3*std::sin(91*p[0] + 57*p[1] + 73*p[2]));
            }
        }
    }

    bool baffle(int d, const typename UniformGrid<D>::Index& x) const
    {
        if (scene_ != "baffles" || d != 0) return false;
        const int every = grid.n[0]/5;
        const bool here = x.c[0] % every == every/2 + 1 - every/2 % 2;       // odd faces
        return here && x.c[D - 1] > grid.n[D - 1]/40;
    }
};

} // namespace riprap

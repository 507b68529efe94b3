/*  FluidScene::farEnd on a device. Where has `double x(int d, int i)`: component d of particle i
    [m], and `bool skips(int i)`: is it another rank's?

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include "core/loops/collect.hpp"
#include "core/loops/reduceMax.hpp"
#include "core/simd/vec.hpp"
#include "api/fluidScene.hpp"

namespace riprap
{

template<int D, class Where>
struct AlongDirection
{
    static constexpr const char* name = "alongDirection";
    Where where;
    Vec<D, double> direction;
    double from;                // along direction; nothing of interest lies before it

    HD double value(int i) const
    {
        if (where.skips(i)) return 0;
        double s = -from;
        for (int d = 0; d < D; ++d) s += direction.c[d]*where.x(d, i);
        return s > 0 ? s : 0;
    }
};

template<int D, class Where>
struct FarParticles
{
    AlongDirection<D, Where> along;
    double least;
    double* position;           // D components each

    HD bool wanted(int i) const { return !along.where.skips(i) && along.value(i) >= least; }
    HD void put(int i, int k) const
    {
        for (int d = 0; d < D; ++d) position[D*std::size_t(k) + d] = along.where.x(d, i);
    }
};

//- n particles in a domain whose corners are known; empty: the coordinate along the direction that
//  is not solved in 2D; ofAll: the largest of a number of all ranks
template<class Backend, int D, class Where>
FluidEnd farEndOf(Context<Backend>& context, int n, const Where& where, const int* axes,
    const Vector3& direction, double reach, const Vec<D, double>& lower,
    const Vec<D, double>& upper, double empty,
    const std::function<double(double)>& ofAll = nullptr)
{
    AlongDirection<D, Where> along{where, {}, 0};
    double length = 0;
    for (int d = 0; d < D; ++d)
    {
        along.direction.c[d] = direction[axes[d]];
        along.from += std::min(along.direction.c[d]*lower.c[d], along.direction.c[d]*upper.c[d]);
        length += std::abs(upper.c[d] - lower.c[d]);
    }
    along.from -= length;       // particles may have left it a little

    FluidEnd end;
    end.particles = n;
    const double rounding = 1e-12*(length + std::abs(along.from));
    const double most = reduceMax(context, n, along);
    FarParticles<D, Where> far{along, (ofAll ? ofAll(most) : most) - reach - rounding, nullptr};
    Array<Backend, double> room;
    const int m = collect(context, n, far, [&](int count)
    {
        room.allocate(context, std::size_t(count)*D);
        far.position = room.data();
        return far;
    });
    end.position.assign(3*std::size_t(m), empty);
    if (!m) return end;
    const std::vector<double> x = room.download();
    for (int k = 0; k < m; ++k)
        for (int d = 0; d < D; ++d)
            end.position[3*std::size_t(k) + axes[d]] = x[std::size_t(k)*D + d];
    return end;
}

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later
/*  How much of the kernel's support at a point lies in the walls, from the wall particles.

    A kernel sum over the fluid alone is one-sided near walls. With V_w the volume of a wall particle,

        share  = 1 - sum_w V_w W(|x - x_w|)                     of the support that fluid can fill
        offset = - sum_w V_w W(|x - x_w|) (x_w - x) / share     from x to the centroid of that part

    so that f/share is the fraction of the accessible volume that is filled, and a Shepard mean of a
    linear field at x is its value at x + offset (when that part is full). Along a plane wall share is
    1/2 and offset 0.4 h or so into the fluid. The second is what Adami et al. (2012), J. Comput. Phys.
    231, Eq. 27, correct for when they extrapolate the pressure to a wall.
*/
#ifndef wallCoverage_hpp
#define wallCoverage_hpp

#include "scene/sphScene.hpp"
#include "sph/kernels/cubicSpline.hpp"
#include "sph/kernels/wendlandC2.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace riprap
{

struct Coverage
{
    double share = 1;
    Vector3 offset{{0, 0, 0}};              // [m]
};

class WallCoverage
{
    // Less than the edge of a cube's corner leaves free: the point is inside a wall
    static constexpr double leastShare = 0.1;

    SphConfig config_;
    double h_, support_;                            // [m]
    double factor_;                                 // V_w times the kernel's constant [-]
    std::unordered_map<std::int64_t, std::vector<Vector3>> cells_;

    double weight(double r) const
    {
        const double q = r/h_;
        return factor_*
        (
            config_.kernel == KernelKind::wendlandC2
          ? WendlandC2::value(q) : CubicSpline::value(q)
        );
    }

    std::int64_t cellIndex(double x) const
    {
        return static_cast<std::int64_t>(std::floor(x/support_));
    }

    // 21 bits an axis
    static std::int64_t key(std::int64_t i, std::int64_t j, std::int64_t k)
    {
        constexpr std::int64_t half = 1 << 20, mask = (1 << 21) - 1;
        return ((i + half) & mask) << 42 | ((j + half) & mask) << 21 | ((k + half) & mask);
    }

    //- Without the empty direction
    Vector3 solved(Vector3 x) const
    {
        if (config_.dimensions == 2) x[config_.axes[2]] = 0;
        return x;
    }

    void insert(const Vector3& x)
    {
        cells_[key(cellIndex(x[0]), cellIndex(x[1]), cellIndex(x[2]))].push_back(x);
    }

public:

    //- From wall particles (3 n); those near a periodic end get their images
    WallCoverage(const SphConfig& config, const std::vector<double>& position)
    :
        config_(config),
        h_(config.smoothingRatio*config.spacing),
        support_(2*h_)
    {
        const int D = config.dimensions;
        factor_ =
            std::pow(config.wallSpacing/h_, D)
           *(
                config.kernel == KernelKind::wendlandC2
              ? WendlandC2::alpha(D) : CubicSpline::alpha(D)
            );

        for (std::size_t w = 0; w + 2 < position.size(); w += 3)
        {
            std::vector<Vector3> images
            {
                solved({{position[w], position[w + 1], position[w + 2]}})
            };
            for (int a = 0; a < 3; ++a)
            {
                if (!config.periodic[a]) continue;

                const double lower = config.domainMin[a], upper = config.domainMax[a];
                for (std::size_t n = images.size(), i = 0; i < n; ++i)
                {
                    Vector3 image = images[i];
                    if (image[a] < lower + support_) image[a] += upper - lower;
                    else if (image[a] > upper - support_) image[a] -= upper - lower;
                    else continue;
                    images.push_back(image);
                }
            }
            for (const Vector3& image : images) insert(image);
        }
    }

    Coverage at(const Vector3& point) const
    {
        const Vector3 x = solved(point);
        double covered = 0;
        Vector3 moment{{0, 0, 0}};

        for (std::int64_t n = 0; n < 27; ++n)
        {
            const auto cell = cells_.find
            (
                key
                (
                    cellIndex(x[0]) + n%3 - 1,
                    cellIndex(x[1]) + n/3%3 - 1,
                    cellIndex(x[2]) + n/9 - 1
                )
            );
            if (cell == cells_.end()) continue;

            for (const Vector3& w : cell->second)
            {
                const Vector3 d{{w[0] - x[0], w[1] - x[1], w[2] - x[2]}};
                const double r = std::sqrt(d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);
                if (r >= support_) continue;

                covered += weight(r);
                for (int a = 0; a < 3; ++a) moment[a] += weight(r)*d[a];
            }
        }

        Coverage c;
        c.share = std::max(1 - covered, leastShare);
        for (int a = 0; a < 3; ++a) c.offset[a] = -moment[a]/c.share;
        return c;
    }
};

} // namespace riprap

#endif

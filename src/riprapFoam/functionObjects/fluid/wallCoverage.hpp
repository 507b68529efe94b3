// SPDX-License-Identifier: GPL-3.0-or-later
/*  How much of the kernel's support at a point lies in the walls, or is hidden by them.

    A kernel sum over the fluid alone is one-sided near walls. With V_w the volume of a wall point,

        share  = 1 - sum_w V_w W(|x - x_w|)                     of the support that fluid can fill
        offset = - sum_w V_w W(|x - x_w|) (x_w - x) / share     from x to the centroid of that part

    so that f/share is the fraction of the accessible volume that is filled, and a Shepard mean of a
    linear field at x is its value at x + offset (when that part is full). Along a plane wall share
    is 1/2 and offset 0.4 h or so into the fluid. The second is what Adami et al. (2012), J. Comput.
    Phys. 231, Eq. 27, correct for when they extrapolate the pressure to a wall.

    Where planes (wallSight.hpp) hide more than wall points fill, at thin walls and rims, what they
    hide is integrated. What is seen is star-shaped about the point, with R(u) its extent along the
    direction u:

        hidden = <A(R)>,      A(R) = S int_R^s W r^(D-1) dr
        moment = <u B(R)>,    B(R) = S int_R^s W r^D dr

    <> the mean over directions, S the surface of the unit ball, s the support.
*/
#ifndef wallCoverage_hpp
#define wallCoverage_hpp

#include "solvers/sph/sphModels.hpp"
#include "wallSight.hpp"

#include <array>

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

    // Part of the support by which wall points may miss what planes hide: 30 times a lattice's
    // error
    static constexpr double missing = 0.03;

    static constexpr int rings = 64;                // from 0 to the support

    int dimensions_;
    int axes_[3];
    const KernelModel& kernel_;
    double h_, volume_;                             // [m], V_w
    std::array<double, rings + 1> beyond_{}, momentBeyond_{};       // A, B
    std::vector<Vector3> directions_;

    //- W [1/m^D]
    double weight(double r) const
    {
        return kernel_.weight(dimensions_, r, h_);
    }

    void integrateRings()
    {
        const double dr = support()/rings, unit = 2*(dimensions_ - 1)*std::acos(-1.0);
        constexpr int parts = 8;
        for (int k = rings; k-- > 0;)
        {
            beyond_[k] = beyond_[k + 1];
            momentBeyond_[k] = momentBeyond_[k + 1];
            for (int part = 0; part < parts; ++part)
            {
                const double r = (k + (part + 0.5)/parts)*dr;
                const double shell = unit*weight(r)*std::pow(r, dimensions_ - 1)*dr/parts;
                beyond_[k] += shell;
                momentBeyond_[k] += r*shell;
            }
        }
    }

    //- Even over the circle, or on Fibonacci's spiral over the sphere
    void spreadDirections()
    {
        const double pi = std::acos(-1.0), golden = pi*(3 - std::sqrt(5.0));
        const int n = dimensions_ == 2 ? 720 : 4096;
        for (int k = 0; k < n; ++k)
        {
            Vector3 u{{0, 0, 0}};
            const double z = dimensions_ == 2 ? 0 : 1 - (2*k + 1.0)/n, s = std::sqrt(1 - z*z);
            const double angle = dimensions_ == 2 ? 2*pi*(k + 0.5)/n : golden*k;
            u[axes_[0]] = s*std::cos(angle);
            u[axes_[1]] = s*std::sin(angle);
            if (dimensions_ == 3) u[axes_[2]] = z;
            directions_.push_back(u);
        }
    }

    static double at(const std::array<double, rings + 1>& table, double ring)
    {
        const int k = std::min(int(ring), rings - 1);
        return table[k] + (ring - k)*(table[k + 1] - table[k]);
    }

    //- What planes hide: part of the support, and its moment
    void hidden(const std::vector<SightPlane>& planes, double& part, Vector3& moment) const
    {
        part = 0;
        moment = {{0, 0, 0}};
        for (const Vector3& u : directions_)
        {
            double extent = support();
            for (const SightPlane& plane : planes)
            {
                const double down = -dotOf(plane.normal, u);
                if (down > 0) extent = std::min(extent, plane.depth/down);
            }
            const double ring = rings*extent/support();
            part += at(beyond_, ring)/directions_.size();
            for (int d = 0; d < 3; ++d)
                moment[d] += u[d]*at(momentBeyond_, ring)/directions_.size();
        }
    }

public:

    explicit WallCoverage(const SphConfig& config)
    :
        dimensions_(config.dimensions),
        axes_{config.axes[0], config.axes[1], config.axes[2]},
        kernel_(kernelOf(config.kernel)),
        h_(config.smoothingRatio*config.spacing),
        volume_(std::pow(config.wallSpacing, config.dimensions))
    {
        integrateRings();
        spreadDirections();
    }

    double support() const
    {
        return kernel_.support*h_;
    }

    //- Of wall points near a point, and of planes that hide fluid from it
    Coverage of(
        const std::vector<WallNeighbour>& walls, const std::vector<SightPlane>& planes) const
    {
        // Wall points that are seen, and those behind planes
        double covered[2] = {0, 0};
        Vector3 moment[2] = {{{0, 0, 0}}, {{0, 0, 0}}};
        for (const WallNeighbour& w : walls)
        {
            const double r = std::sqrt(dotOf(w.offset, w.offset));
            if (r >= support()) continue;

            const int behind = !seenFrom(planes, w.offset);
            const double part = volume_*weight(r);
            covered[behind] += part;
            for (int d = 0; d < 3; ++d) moment[behind][d] += part*w.offset[d];
        }

        if (!planes.empty())
        {
            double part;
            Vector3 m;
            hidden(planes, part, m);
            if (part > covered[1] + missing)
            {
                covered[1] = part;
                moment[1] = m;
            }
        }

        Coverage c;
        c.share = std::max(1 - covered[0] - covered[1], leastShare);
        for (int d = 0; d < 3; ++d) c.offset[d] = -(moment[0][d] + moment[1][d])/c.share;
        return c;
    }
};

} // namespace riprap

#endif

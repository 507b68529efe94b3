// SPDX-License-Identifier: GPL-3.0-or-later
/*  Which wall points are near a point. The points of one rigid set (the fixed walls, or a group
    that moves) lie in cells of the set's own frame, so that they are sorted once: where the set
    moves, the point that asks is taken into its frame instead, and what is found is turned back.
*/
#ifndef wallNeighbours_hpp
#define wallNeighbours_hpp

#include "api/fluidScene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace riprap
{

//- A wall point as seen from the point that asked
struct WallNeighbour
{
    Vector3 offset{{0, 0, 0}};              // to it [m]
    Vector3 normal{{0, 0, 0}};              // unit, out of the wall
};

inline double dotOf(const Vector3& a, const Vector3& b)
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

//- Reference frame to space, and back
inline Vector3 turned(const WallPose& pose, const Vector3& v)
{
    const auto& R = pose.rotation;
    return {{R[0]*v[0] + R[1]*v[1] + R[2]*v[2], R[3]*v[0] + R[4]*v[1] + R[5]*v[2],
        R[6]*v[0] + R[7]*v[1] + R[8]*v[2]}};
}

inline Vector3 turnedBack(const WallPose& pose, const Vector3& v)
{
    const auto& R = pose.rotation;
    return {{R[0]*v[0] + R[3]*v[1] + R[6]*v[2], R[1]*v[0] + R[4]*v[1] + R[7]*v[2],
        R[2]*v[0] + R[5]*v[1] + R[8]*v[2]}};
}

inline Vector3 placed(const WallPose& pose, const Vector3& x)
{
    const Vector3 r = turned(pose, x);
    const Vector3& s = pose.translation;
    return {{r[0] + s[0], r[1] + s[1], r[2] + s[2]}};
}

inline Vector3 placedBack(const WallPose& pose, const Vector3& x)
{
    const Vector3& s = pose.translation;
    return turnedBack(pose, {{x[0] - s[0], x[1] - s[1], x[2] - s[2]}});
}

class WallPointSet
{
    double reach_ = 1;                              // [m]
    Vector3 lower_{{1e300, 1e300, 1e300}}, upper_{{-1e300, -1e300, -1e300}};
    std::unordered_map<std::int64_t, std::vector<WallNeighbour>> cells_;

    std::int64_t cellIndex(double x) const
    {
        return static_cast<std::int64_t>(std::floor(x/reach_));
    }

    // 21 bits an axis
    static std::int64_t key(std::int64_t i, std::int64_t j, std::int64_t k)
    {
        constexpr std::int64_t half = 1 << 20, mask = (1 << 21) - 1;
        return ((i + half) & mask) << 42 | ((j + half) & mask) << 21 | ((k + half) & mask);
    }

public:

    //- @param reach  of every search [m]
    explicit WallPointSet(double reach) : reach_(reach) {}

    void insert(const Vector3& x, const Vector3& normal)
    {
        for (int d = 0; d < 3; ++d)
        {
            lower_[d] = std::min(lower_[d], x[d]);
            upper_[d] = std::max(upper_[d], x[d]);
        }
        cells_[key(cellIndex(x[0]), cellIndex(x[1]), cellIndex(x[2]))].push_back({x, normal});
    }

    //- Of the box about its points; of none, the origin
    Vector3 centre() const
    {
        Vector3 c{{0, 0, 0}};
        for (int d = 0; d < 3 && !cells_.empty(); ++d) c[d] = 0.5*(lower_[d] + upper_[d]);
        return c;
    }

    //- Can it have a point within reach of x?
    bool mayReach(const Vector3& x) const
    {
        for (int d = 0; d < 3; ++d)
        {
            if (!(x[d] > lower_[d] - reach_ && x[d] < upper_[d] + reach_)) return false;
        }
        return true;
    }

    //- Those nearer than reach to x are appended; all of it in the set's frame
    void near(const Vector3& x, std::vector<WallNeighbour>& found) const
    {
        for (std::int64_t n = 0; n < 27; ++n)
        {
            const auto cell = cells_.find(key(cellIndex(x[0]) + n%3 - 1,
                cellIndex(x[1]) + n/3%3 - 1, cellIndex(x[2]) + n/9 - 1));
            if (cell == cells_.end()) continue;

            for (const WallNeighbour& w : cell->second)
            {
                const Vector3 d{{w.offset[0] - x[0], w.offset[1] - x[1], w.offset[2] - x[2]}};
                if (dotOf(d, d) < reach_*reach_) found.push_back({d, w.normal});
            }
        }
    }

    //- The same of a set that has moved
    void near(const Vector3& x, const WallPose& pose, std::vector<WallNeighbour>& found) const
    {
        const Vector3 inFrame = placedBack(pose, x);
        if (!mayReach(inFrame)) return;

        const std::size_t first = found.size();
        near(inFrame, found);
        for (std::size_t k = first; k < found.size(); ++k)
        {
            found[k] = {turned(pose, found[k].offset), turned(pose, found[k].normal)};
        }
    }
};

} // namespace riprap

#endif

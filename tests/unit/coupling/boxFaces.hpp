/*  Faces of a rigid body that is a box: of tests in which water meets them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphScene.hpp"

namespace riprap
{

//- Of a box (2D: a rectangle) about the body's centre, all sides. body: also the number of the part
inline void addBoxFaces(WallFaceInput& f, int dimensions, int body, const Vector3& half)
{
    const auto add = [&](const std::vector<Vector3>& points, const Vector3& n)
    {
        for (const Vector3& p : points)
        {
            f.vertex.push_back(std::int32_t(f.point.size()/3));
            f.point.insert(f.point.end(), p.begin(), p.end());
        }
        if (dimensions == 2) f.vertex.push_back(-1);
        f.normal.insert(f.normal.end(), n.begin(), n.end());
        f.body.push_back(body);
        f.part.push_back(body);
        f.halfThickness.push_back(0);
    };
    for (int d = 0; d < dimensions; ++d)
        for (const double side : {-1.0, 1.0})
        {
            const int e = (d + 1) % dimensions, g = (d + 2) % 3;
            Vector3 n{{0, 0, 0}}, corner[4];
            n[d] = side;
            for (int k = 0; k < 4; ++k)
            {
                corner[k] = Vector3{{0, 0, 0}};
                corner[k][d] = side*half[d];
                corner[k][e] = k & 1 ? half[e] : -half[e];
                if (dimensions == 3) corner[k][g] = k & 2 ? half[g] : -half[g];
            }
            if (dimensions == 2) { add({corner[0], corner[1]}, n); continue; }
            add({corner[0], corner[1], corner[3]}, n);
            add({corner[0], corner[3], corner[2]}, n);
        }
}

} // namespace riprap

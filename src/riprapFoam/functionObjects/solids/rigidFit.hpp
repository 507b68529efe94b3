// SPDX-License-Identifier: GPL-3.0-or-later
/*  The rigid motion that brings points nearest to where they are now, in the least-squares sense.
    3D: the rotation is the eigenvector of the largest eigenvalue of Horn's matrix (Horn 1987, J.
    Opt. Soc. Am. A 4, 629, Section 4); 2D: the angle of the summed cross and dot products.
*/
#ifndef rigidFit_hpp
#define rigidFit_hpp

#include "api/sceneTypes.hpp"

#include <eigen3/Eigen/Eigenvalues>
#include <cmath>
#include <cstddef>
#include <vector>

namespace riprap
{

using Quaternion = std::array<double, 4>;           // w, x, y, z

inline std::array<double, 9> rotationOf(Quaternion q)
{
    const double n = std::sqrt(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
    for (double& c : q) c /= n;
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return
    {{
        1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y),
        2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x),
        2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)
    }};
}

//- first b, then a
inline std::array<double, 9> productOf(
    const std::array<double, 9>& a, const std::array<double, 9>& b)
{
    std::array<double, 9> c{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) c[3*i + j] += a[3*i + k]*b[3*k + j];
    return c;
}

inline std::array<double, 9> transposeOf(const std::array<double, 9>& a)
{
    return {{a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]}};
}

//- @param from, to as many points; @param emptyAxis of a 2D case, in which points stay in their
//  plane, or -1
inline WallPose rigidFit(
    const std::vector<Vector3>& from, const std::vector<Vector3>& to, int emptyAxis = -1)
{
    WallPose pose;
    Vector3 a{{0, 0, 0}}, b{{0, 0, 0}};
    for (std::size_t i = 0; i < from.size(); ++i)
        for (int d = 0; d < 3; ++d)
        {
            a[d] += from[i][d]/from.size();
            b[d] += to[i][d]/from.size();
        }

    double S[3][3] = {};
    for (std::size_t i = 0; i < from.size(); ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) S[j][k] += (from[i][j] - a[j])*(to[i][k] - b[k]);

    Quaternion q{{1, 0, 0, 0}};
    if (emptyAxis >= 0)
    {
        const int x = (emptyAxis + 1) % 3, y = (emptyAxis + 2) % 3;
        const double half = 0.5*std::atan2(S[x][y] - S[y][x], S[x][x] + S[y][y]);
        q = {{std::cos(half), 0, 0, 0}};
        q[1 + emptyAxis] = std::sin(half);
    }
    else
    {
        Eigen::Matrix4d N;
        N <<
            S[0][0] + S[1][1] + S[2][2], S[1][2] - S[2][1], S[2][0] - S[0][2], S[0][1] - S[1][0],
            S[1][2] - S[2][1], S[0][0] - S[1][1] - S[2][2], S[0][1] + S[1][0], S[2][0] + S[0][2],
            S[2][0] - S[0][2], S[0][1] + S[1][0], S[1][1] - S[0][0] - S[2][2], S[1][2] + S[2][1],
            S[0][1] - S[1][0], S[2][0] + S[0][2], S[1][2] + S[2][1], S[2][2] - S[0][0] - S[1][1];
        // eigenvalues ascend
        const Eigen::Vector4d largest =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(N).eigenvectors().col(3);
        q = {{largest[0], largest[1], largest[2], largest[3]}};
    }

    pose.rotation = rotationOf(q);
    for (int i = 0; i < 3; ++i)
    {
        pose.translation[i] = b[i];
        for (int j = 0; j < 3; ++j) pose.translation[i] -= pose.rotation[3*i + j]*a[j];
    }
    return pose;
}

} // namespace riprap

#endif

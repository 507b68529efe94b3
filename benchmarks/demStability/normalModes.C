/*  SPDX-License-Identifier: GPL-3.0-or-later */
#include "normalModes.hpp"

#include <cmath>
#include <random>

namespace riprap
{

namespace
{

struct Link { int i, j; Vector3 n; double arm; };

std::vector<Link> links(const LatticePoints& p, const bool periodic[3])
{
    std::vector<Link> out;
    const int n = int(p.position.size()/3);
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j)
        {
            Vector3 d;
            double square = 0;
            for (int a = 0; a < 3; ++a)
            {
                d[a] = p.position[3*j + a] - p.position[3*i + a];
                if (periodic[a]) d[a] -= p.size[a]*std::round(d[a]/p.size[a]);
                square += d[a]*d[a];
            }
            const double distance = std::sqrt(square);
            if (distance > 2 + 1e-6) continue;
            for (double& x : d) x /= distance;
            out.push_back(Link{i, j, d, 0.5*distance});
        }
    return out;
}

Vector3 cross(const Vector3& a, const Vector3& b)
{ return Vector3{{a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]}}; }

double dot(const Vector3& a, const Vector3& b) { return a[0]*b[0] + a[1]*b[1] + a[2]*b[2]; }

} // namespace

double fastestMode(const LatticePoints& p, const bool periodic[3], const Springs& k)
{
    const std::vector<Link> all = links(p, periodic);
    const std::size_t n = p.position.size()/3;
    const double rootInertia = std::sqrt(p.dimensions == 2 ? 0.5 : 0.4);
    const auto allowed = [&](int axis, bool spin)
    { return p.dimensions == 3 || (spin ? axis == 2 : axis < 2); };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    // displacements, then rotations times sqrt(I), of each body
    std::vector<double> x(6*n), y(6*n);
    for (std::size_t i = 0; i < 6*n; ++i) x[i] = allowed(int(i % 3), i % 6 > 2) ? any(random) : 0;
    const auto part = [&](const std::vector<double>& v, int i, int offset)
    { return Vector3{{v[6*i + offset], v[6*i + offset + 1], v[6*i + offset + 2]}}; };
    double value = 0;
    for (int iteration = 0; iteration < 4000; ++iteration)
    {
        double norm = 0;
        for (const double v : x) norm += v*v;
        norm = std::sqrt(norm);
        for (double& v : x) v /= norm;
        std::fill(y.begin(), y.end(), 0.0);
        for (const Link& l : all)
        {
            const Vector3 ui = part(x, l.i, 0), uj = part(x, l.j, 0);
            Vector3 ti = part(x, l.i, 3), tj = part(x, l.j, 3), both, bend;
            for (int a = 0; a < 3; ++a)
            {
                ti[a] /= rootInertia; tj[a] /= rootInertia;
                both[a] = ti[a] + tj[a];
                bend[a] = tj[a] - ti[a];
            }
            const Vector3 swing = cross(both, l.n);
            Vector3 du, force;
            for (int a = 0; a < 3; ++a) du[a] = uj[a] - ui[a];
            const double along = dot(du, l.n), turn = dot(bend, l.n);
            for (int a = 0; a < 3; ++a)
                force[a] = k.normal*along*l.n[a]
                    + k.shear*(du[a] - along*l.n[a] - l.arm*swing[a]);
            const Vector3 moment = cross(l.n, force);
            for (int a = 0; a < 3; ++a)
            {
                const double couple = k.bending*(bend[a] - turn*l.n[a]) + k.twist*turn*l.n[a];
                y[6*l.i + a] -= force[a];
                y[6*l.j + a] += force[a];
                y[6*l.i + 3 + a] -= (l.arm*moment[a] + couple)/rootInertia;
                y[6*l.j + 3 + a] -= (l.arm*moment[a] - couple)/rootInertia;
            }
        }
        for (std::size_t i = 0; i < 6*n; ++i) if (!allowed(int(i % 3), i % 6 > 2)) y[i] = 0;
        value = 0;
        for (std::size_t i = 0; i < 6*n; ++i) value += x[i]*y[i];
        x.swap(y);
    }
    return std::sqrt(value);
}

} // namespace riprap

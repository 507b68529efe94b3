/*  A solver of the pressure equation on the host that knows bodies: conjugate gradients with the
    diagonal, for tests without OpenFOAM.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "api/linearSolver.hpp"

namespace riprap
{

class HostSolver : public LinearSolver
{
public:

    double tolerance = 1e-11;
    int iterations = 0;

    PressureReport solve(ReducedSystem& s) override
    {
        const int n = s.rows();
        std::vector<double> r(n), z(n), p(n, 0.0), q(n), inverse(n);
        std::vector<double> diagonal(s.diagonal);
        for (const BodyRows& b : s.bodies)
            for (std::size_t i = 0; i < b.row.size(); ++i)
                for (int m = 0; m < b.modes; ++m)
                    diagonal[b.row[i]] += b.u[i*b.modes + m]*b.u[i*b.modes + m];
        for (int i = 0; i < n; ++i) inverse[i] = 1/diagonal[i];
        product(s, s.x, q);
        double first = 0, now = 0, rz = 0;
        for (int i = 0; i < n; ++i)
        {
            r[i] = s.rhs[i] - q[i];
            first += std::abs(s.rhs[i]);
            now += std::abs(r[i]);
        }
        PressureReport report;
        report.initialResidual = first > 0 ? now/first : 0;
        for (iterations = 0; iterations < 5000 && now > tolerance*first; ++iterations)
        {
            double next = 0, pq = 0;
            for (int i = 0; i < n; ++i) { z[i] = inverse[i]*r[i]; next += z[i]*r[i]; }
            for (int i = 0; i < n; ++i) p[i] = z[i] + (iterations ? next/rz : 0)*p[i];
            rz = next;
            product(s, p, q);
            for (int i = 0; i < n; ++i) pq += p[i]*q[i];
            now = 0;
            for (int i = 0; i < n; ++i)
            {
                s.x[i] += rz/pq*p[i];
                r[i] -= rz/pq*q[i];
                now += std::abs(r[i]);
            }
        }
        report.finalResidual = first > 0 ? now/first : 0;
        report.iterations = iterations;
        report.converged = now <= tolerance*first;
        return report;
    }

private:
    static void product(
        const ReducedSystem& s, const std::vector<double>& x, std::vector<double>& y)
    {
        for (int i = 0; i < s.rows(); ++i) y[i] = s.diagonal[i]*x[i];
        for (std::size_t f = 0; f < s.owner.size(); ++f)
        {
            y[s.owner[f]] += s.offDiagonal[f]*x[s.neighbour[f]];
            y[s.neighbour[f]] += s.offDiagonal[f]*x[s.owner[f]];
        }
        for (const BodyRows& b : s.bodies)
            for (int m = 0; m < b.modes; ++m)
            {
                double dot = 0;
                for (std::size_t i = 0; i < b.row.size(); ++i)
                    dot += b.u[i*b.modes + m]*x[b.row[i]];
                for (std::size_t i = 0; i < b.row.size(); ++i)
                    y[b.row[i]] += b.u[i*b.modes + m]*dot;
            }
    }
};

} // namespace riprap

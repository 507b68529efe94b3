/*  The largest time step for laminar viscosity: noise of all shear waves in a periodic box, with a
    viscosity beside which sound is slow
    (c0 h/nu = 0.01).

    Theory: both schemes see the velocity predicted to the end of the step, which for a decay is the
    two-step Adams-Bashforth scheme: nu(k) dt < 1, nu(k) the largest rate of decay of the lattice.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "periodicLattice.hpp"
#include "resultTable.hpp"

#include <cmath>

namespace riprap
{

namespace
{

constexpr int sites = 16;

bool decays(const LatticeModel& l, const std::string& integrator, double dt)
{
    PeriodicLattice p = makeLattice(l, sites, integrator, dt);
    addVelocityNoise(p, 1e-6);
    const auto scene = createSphScene(p.config, p.fluid, WallInput());
    if (!take(*scene, 300)) return false;
    const double middle = disturbance(*scene, p.config);
    return take(*scene, 300) && disturbance(*scene, p.config) < middle;
}

} // namespace

void viscous(ResultTable& table, bool quick)
{
    LatticeModel l;
    l.spacing = 0.01;
    l.soundSpeed = 1;
    l.density = 1000;
    for (const std::string& kernel : kernelWords())
        for (const double ratio : {1.25, 1.5})
            for (const std::string integrator : {"leapfrog", "symplectic"})
            {
                if (quick && (ratio != 1.25 || kernel != "wendlandC2")) continue;
                l.kernel = kernel;
                l.ratio = ratio;
                l.viscosity = 100*l.soundSpeed*l.h();
                const double unit = l.h()*l.h()/l.viscosity;
                Result r;
                r.test = "viscous";
                r.kernel = kernel;
                r.ratio = ratio;
                r.integrator = integrator;
                r.terms = "laminar";
                r.quantity = "largest nu dt/h^2";
                r.theory = 1/(reduceMax(l, sites, viscousRate).value*unit);
                r.measured = bisect(0.02, 1, quick ? 0.01 : 0.002,
                    [&](double c) { return decays(l, integrator, c*unit); });
                table.add(r);
            }
}

} // namespace riprap

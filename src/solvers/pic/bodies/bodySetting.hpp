/*  What the parts of bodies in the water refer to (picBodies.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "dem/motion/integrators.hpp"
#include "pic/bodies/bodyTerm.hpp"
#include "api/picScene.hpp"

namespace riprap
{

template<int D>
struct BodySetting
{
    static constexpr int modes = bodyModes<D>;
    using Modes = std::array<double, modes>;

    int axes[3];
    double gravity[D];
    DemScene& scene;
    std::vector<DemGroup> groups;
    GroupMotion motion;
    bool verlet = false, clumps = false, weak = false;
    // what water between solids that touch keeps of its velocity, in what time [s]; 0: a step
    double contactVelocity = 1, contactTime = 0;
    // [m/s2] change of acceleration that wakes; 0: nobody sleeps
    double stir = 0;

    BodySetting(const PicConfig& config, const PicSolids& solids, DemScene& s)
    :
        scene(s),
        groups(solids.input.groups.empty() ? std::vector<DemGroup>(1) : solids.input.groups),
        motion(solids.input.groupMotion),
        verlet(demIntegratorOf(solids.config.integrator).kicksTwice),
        clumps(!solids.input.clumps.empty()),
        weak(solids.weak),
        contactVelocity(solids.contactVelocity),
        contactTime(solids.contactVelocityTime),
        stir(solids.config.sleepAfter > 0 ? solids.config.sleepSpeed/solids.config.sleepAfter : 0)
    {
        for (int d = 0; d < 3; ++d) axes[d] = config.axes[d];
        for (int d = 0; d < D; ++d) gravity[d] = config.gravity[axes[d]];
    }

    BodySetting(const BodySetting&) = delete;

    //- How many of the times that contactVelocity is meant for are in dt
    double contactTimes(double dt) const { return contactTime > 0 ? dt/contactTime : 1; }

    double spinSign() const;
    Modes modesOf(const double* vector, const double* turn) const;
};

//- Of spins about axes in this order against those of space
template<int D>
double BodySetting<D>::spinSign() const { return (axes[1] - axes[0] + 3) % 3 == 1 ? 1 : -1; }

template<int D>
typename BodySetting<D>::Modes BodySetting<D>::modesOf(
    const double* vector, const double* turn) const
{
    Modes m{};
    for (int d = 0; d < D; ++d) m[d] = vector[axes[d]];
    for (int s = D; s < modes; ++s) m[s] = spinSign()*turn[D == 2 ? axes[2] : axes[s - D]];
    return m;
}

} // namespace riprap

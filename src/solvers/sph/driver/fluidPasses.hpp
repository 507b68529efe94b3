/*  Passes over the particles of the fluid, and what moves them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/parts/sphParts.hpp"
#include "solvers/sph/parts/sphReadBack.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class FluidPasses
{
public:

    using real = typename P::real;

    explicit FluidPasses(SphParts<Backend, D, P>& parts) : p_(parts) {}

    //- Accelerations, density rates and drifts, or what of them a part of a step needs
    template<Part part> void pass(Finish);

    //- M: one of the kernels that move particles or write their records
    template<class M> M mover();

    //- Moves them
    template<class M> void move();

    //- Records of the state at hand; steps leave predicted ones
    void refreshRecords();

private:

    SphParts<Backend, D, P>& p_;
};

template<class Backend, int D, class P>
template<class M>
M FluidPasses<Backend, D, P>::mover()
{
    M m{};
    m.box = p_.set.box;
    m.model = p_.set.model;
    m.fluid = p_.fluid.fields();
    m.records = p_.fluid.records.view();
    for (int d = 0; d < D; ++d)
        m.reference[d] = p_.fluid.reference.data() + std::size_t(d)*p_.fluid.n;
    m.allowedWay = p_.set.allowedWay;
    if constexpr (Backend::gpu) m.frames = p_.memory.frames.view();
    m.count = p_.fluid.sort.active();
    m.clock = p_.clock.data();
    m.contact = p_.faces.contact(p_.solids);
    m.ghosts = p_.ghosts();
    return m;
}

template<class Backend, int D, class P>
template<class M>
void FluidPasses<Backend, D, P>::move()
{
    const M m = mover<M>();
    if constexpr (!Backend::gpu)
        if (m.isPlain()) return forEach(p_.set.context, p_.fluid.n, PlainMover<M>{m});
    forEach(p_.set.context, p_.fluid.n, m);
}

template<class Backend, int D, class P>
template<Part part>
void FluidPasses<Backend, D, P>::pass(Finish mode)
{
    withKernel(p_.set.config, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        // exact combinations where speed is sought
        constexpr bool specialised = Kernel::frequent && sizeof(real) == 4;
        p_.set.terms.template withFluidTerms<part, specialised>(
            [&](const auto& fluidTerms, const auto& wallTerms, auto shifts)
            {
                FluidPass<Backend, D, P, Kernel, decltype(variable)::value, part,
                    std::decay_t<decltype(fluidTerms)>, std::decay_t<decltype(wallTerms)>,
                    decltype(shifts)::value>
                    pass{p_.set.box, p_.set.grid, {p_.fluidSource(false), p_.wallSource()},
                        fluidTerms, wallTerms, p_.set.template kernelConstants<Kernel>(),
                        p_.set.terms.shifting, p_.set.model, p_.fluid.fields(), {},
                        p_.fluid.sort.active(), p_.clock.data(), mode, p_.solids.action(),
                        p_.ghosts()};
                for (int d = 0; d < D; ++d) pass.wallVelocity[d] = p_.walls.velocity(d);
                p_.run(pass, p_.fluid.n);
            });
    });
}

template<class Backend, int D, class P>
void FluidPasses<Backend, D, P>::refreshRecords()
{
    forEach(p_.set.context, p_.fluid.n, mover<RefreshRecords<Backend, D, P>>());
    if (p_.ranks) p_.ranks->shareRecords();
}

} // namespace riprap

/*  What viscosity does in a step. The equations: pic/terms/viscosity.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/projection/project.hpp"
#include "pic/terms/forces.hpp"
#include "solvers/pic/driver/bodyCoupling.hpp"
#include "solvers/pic/driver/faceSums.hpp"
#include "solvers/pic/driver/forcesOnWalls.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class ViscousStep
{
public:

    using real = typename P::real;

    ViscousStep(PicParts<Backend, D, P>& parts, BodyCoupling<Backend, D, P>& coupling,
        ForcesOnWalls<Backend, D, P>& wallForces)
        : p_(parts), coupling_(coupling), wallForces_(wallForces)
    {}

    void diffuse(double dt);

    //- Have all solutions so far?
    bool converged() const { return converged_; }
    std::size_t bytes() const;

private:

    bool implicit(double dt) const;
    ViscousFaces<D, real> view(int d, bool homogeneous = false);
    void diffuseImplicitly(double dt, double number);
    void setForce(double dt);
    void share(Array<Backend, real>* a);
    void copyAround(Array<Backend, real>* a);
    void solve(real k);

    PicParts<Backend, D, P>& p_;
    BodyCoupling<Backend, D, P>& coupling_;
    ForcesOnWalls<Backend, D, P>& wallForces_;
    // of the implicit one
    Array<Backend, real> force_[D], source_[D], residual_[D], direction_[D], product_[D];
    Array<Backend, double> pressure_;
    FaceSums<Backend, D, P> sums_{p_};
    bool converged_ = true;
};

template<class Backend, int D, class P>
bool ViscousStep<Backend, D, P>::implicit(double dt) const
{
    const PicConfig& config = p_.set.config;
    // a face close to a solid would limit an explicit step
    if (p_.sticksInside()) return true;
    return viscousSchemeOf(config.viscousScheme)
        .implicit(dt, viscousStep(p_.set.grid.h, config.viscosity/config.density, D));
}

template<class Backend, int D, class P>
ViscousFaces<D, typename P::real> ViscousStep<Backend, D, P>::view(int d, bool homogeneous)
{
    GridWalls<Backend, D, P>& walls = p_.walls;
    return {p_.set.grid, d, p_.faces.layer[d].data(),
        walls.move ? walls.velocity[d].data() : nullptr, homogeneous,
        p_.sticksInside() ? p_.cut.faceDistance[d].data() : nullptr,
        p_.sticksInside() && walls.move ? p_.cut.solidVelocity[d].data() : nullptr};
}

//- From the faces' `before` to their u
template<class Backend, int D, class P>
void ViscousStep<Backend, D, P>::diffuse(double dt)
{
    FaceVelocities<Backend, D, P>& faces = p_.faces;
    if (p_.sticksInside() && p_.walls.move) coupling_.setSolidVelocity();
    const double number = p_.set.config.viscosity/p_.set.config.density*dt
        /(p_.set.grid.h*p_.set.grid.h);
    if (implicit(dt)) { diffuseImplicitly(dt, number); return; }
    const real k = real(number), half = real(0.5);
    p_.rows.eachFace(p_.set.context,
        [&](int d)
        {
            return Diffuse<D, real>{view(d), faces.before[d].data(), faces.before[d].data(),
                faces.change[d].data(), real(0), real(1), k};
        });
    p_.rows.eachFace(p_.set.context,
        [&](int d)
        {
            return Diffuse<D, real>{view(d), faces.before[d].data(), faces.change[d].data(),
                faces.u[d].data(), half, half, half*k};
        });
}

//- What acts beside viscosity, as far as it is known: in a first step nothing
template<class Backend, int D, class P>
void ViscousStep<Backend, D, P>::setForce(double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    PicClock& clock = p_.set.clock;
    PressureFields<D, real> f = p_.pressureFields(dt);
    f.p = p_.pressure.whole().data();
    if (clock.steps) p_.pressure.step.markWet(context, f);
    if (clock.steps && p_.cut.moves)
    {
        if (pressure_.size() == 0) pressure_.allocate(context, grid.cells());
        // a solution leaves one cell around the brick right: new cells there have neighbours
        if (p_.halo) p_.halo->exchange({{p_.pressure.whole(), -1}});
        PressureOfNewCells<D> fill{grid, p_.pressure.step.wet(), f.p, pressure_.data(), {}};
        for (int d = 0; d < D; ++d) fill.weight[d] = p_.set.config.density*p_.set.gravity[d]*grid.h;
        forEach(context, grid.cells(), fill);
        f.p = pressure_.data();
    }
    for (int d = 0; d < D; ++d)
    {
        forEach(context, grid.faces(d),
            SetFaces<real>{
                nullptr, force_[d].data(), clock.steps ? real(p_.set.gravity[d]*dt) : real(0)});
        f.u[d] = force_[d].data();
        if (clock.steps)
            forEach(context, grid.faces(d), CorrectVelocity<D, real>{f, p_.pressure.step.wet(), d});
    }
}

template<class Backend, int D, class P>
void ViscousStep<Backend, D, P>::diffuseImplicitly(double dt, double number)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    FaceVelocities<Backend, D, P>& faces = p_.faces;
    const real c = real(1 - std::sqrt(0.5)), k = real(c*number);
    for (int d = 0; d < D; ++d)
        for (auto* a : {&force_[d], &source_[d], &residual_[d], &direction_[d], &product_[d]})
            if (a->size() == 0) a->allocate(context, grid.faces(d));

    // beyond the surface there is no stress: gravity, which nothing balances there, must not drag
    // the water along
    for (int d = 0; d < D; ++d)
        forEach(context, grid.faces(d), p_.markFaces(d));
    sums_.start();

    setForce(dt);
    for (int stage = 1; stage <= 2; ++stage)
    {
        for (int d = 0; d < D; ++d)
            forEach(context, grid.faces(d),
                ViscousSource<real>{faces.before[d].data(),
                    stage == 1 ? nullptr : faces.u[d].data(), force_[d].data(), source_[d].data(),
                    c});
        if (stage == 1)
            for (int d = 0; d < D; ++d)
                forEach(context, grid.faces(d),
                    SetFaces<real>{faces.before[d].data(), faces.u[d].data(), real(0)});
        solve(k);
    }
    if (p_.sticksInside() && p_.solids.bodies) coupling_.drag(dt);
    if (p_.sticksInside() && wallForces_.shearAsked()) wallForces_.keepSheared();
    for (int d = 0; d < D; ++d)
    {
        // the pressure's part off again; gravity's comes with the other forces
        forEach(context, grid.faces(d),
            FaceAdd<real>{force_[d].data(), faces.u[d].data(), real(-1), false});
    }
    if (p_.sticksInside())
    {
        for (int d = 0; d < D; ++d)
            forEach(context, grid.faces(d), StickToSolids<D, real>{view(d), faces.u[d].data()});
    }
}

//- What other ranks have beside the brick
template<class Backend, int D, class P>
void ViscousStep<Backend, D, P>::share(Array<Backend, real>* a)
{
    if (!p_.halo) return;
    std::vector<GridField> fields;
    fields.reserve(D);
    for (int d = 0; d < D; ++d) fields.emplace_back(a[d], d);
    p_.halo->exchange(fields);
}

template<class Backend, int D, class P>
void ViscousStep<Backend, D, P>::copyAround(Array<Backend, real>* a)
{
    const UniformGrid<D>& grid = p_.set.grid;
    for (int d = 0; d < D; ++d)
        if (grid.periodic[d])
            forEach(
                p_.set.context, grid.faces(d), CopyPeriodic<D, real>{grid, d, a[d].data()});
}

//- (1 - k L) u = source by conjugate gradients, from the u at hand
template<class Backend, int D, class P>
void ViscousStep<Backend, D, P>::solve(real k)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    FaceVelocities<Backend, D, P>& faces = p_.faces;
    constexpr int most = 2000;
    // of the source or the first residual
    const double tolerance = sizeof(real) == 4 ? 1e-6 : 1e-10;
    const auto dot = [&](Array<Backend, real>* a, Array<Backend, real>* b)
    { return sums_.dot([&](int d) { return view(d); }, a, b); };
    for (int d = 0; d < D; ++d)
        forEach(context, grid.faces(d),
            ViscousResidual<D, real>{view(d), source_[d].data(), faces.u[d].data(),
                residual_[d].data(), direction_[d].data(), k});
    double rr = dot(residual_, residual_);
    // from rest walls that slide are all there is
    const double enough = tolerance*tolerance*std::max(dot(source_, source_), rr);
    for (int iteration = 0; rr > enough; ++iteration)
    {
        if (iteration == most) { converged_ = false; break; }
        // so that u, which it is added to, stays right there, too
        share(direction_);
        copyAround(direction_);
        for (int d = 0; d < D; ++d)
            forEach(context, grid.faces(d),
                ViscousProduct<D, real>{
                    view(d, true), direction_[d].data(), product_[d].data(), k});
        const real alpha = real(rr/dot(direction_, product_));
        for (int d = 0; d < D; ++d)
        {
            forEach(context, grid.faces(d),
                FaceAdd<real>{direction_[d].data(), faces.u[d].data(), alpha, false});
            forEach(context, grid.faces(d),
                FaceAdd<real>{product_[d].data(), residual_[d].data(), -alpha, false});
        }
        const double next = dot(residual_, residual_);
        for (int d = 0; d < D; ++d)
            forEach(context, grid.faces(d),
                FaceAdd<real>{residual_[d].data(), direction_[d].data(), real(next/rr), true});
        rr = next;
    }
    copyAround(faces.u);
}

template<class Backend, int D, class P>
std::size_t ViscousStep<Backend, D, P>::bytes() const
{
    std::size_t sum = pressure_.bytes() + sums_.bytes();
    for (int d = 0; d < D; ++d)
        sum += force_[d].bytes() + source_[d].bytes() + residual_[d].bytes() + direction_[d].bytes()
            + product_[d].bytes();
    return sum;
}

} // namespace riprap

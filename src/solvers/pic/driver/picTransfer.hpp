/*  Velocities from particles to the grid, and back.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <initializer_list>
#include "pic/grid/extrapolate.hpp"
#include "pic/terms/forces.hpp"
#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class PicTransfer
{
public:

    using real = typename P::real;

    explicit PicTransfer(PicParts<Backend, D, P>& parts) : p_(parts) {}

    void toGrid();
    //- share: so that other ranks' parts have the result, too
    void extrapolate(
        std::initializer_list<Array<Backend, real>*> fields, int passes, bool share = false);
    void toParticles(double dt);

private:

    void share(const std::initializer_list<Array<Backend, real>*>& fields);

    PicParts<Backend, D, P>& p_;
};

//- Velocities of the particles on all faces about the water
template<class Backend, int D, class P>
void PicTransfer<Backend, D, P>::toGrid()
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    p_.toFaces.prepare(context, grid, particles.sort);
    p_.rows.find(context, grid, p_.toFaces.occupied(), p_.surface.phi.data(), particles.sort);
    for (int d = 0; d < D; ++d)
    {
        const int faces = grid.faces(d);
        withSpline(p_.set.config.splineOrder,
            [&](auto order)
            {
                p_.toFaces.template map<decltype(order)::value>(context, grid, p_.rows,
                    particles.view(), d, particles.at.affine >= 0,
                    p_.opens() ? p_.faces.u[d].data() : nullptr, p_.faces.before[d].data(),
                    p_.faces.mass[d].data());
            });
        if (grid.periodic[d])
        {
            forEach(context, faces, CopyPeriodic<D, real>{grid, d, p_.faces.before[d].data()});
            forEach(context, faces, CopyPeriodic<D, real>{grid, d, p_.faces.mass[d].data()});
        }
        p_.rows.eachFaceOfBoth(context, d,
            MarkByMass<D, real>{grid, d, p_.faces.mass[d].data(), p_.walls.aperture[d].data(),
                p_.faces.layer[d].data()});
    }
    extrapolate({p_.faces.before}, 3);
}

//- With the layers that they have
template<class Backend, int D, class P>
void PicTransfer<Backend, D, P>::share(
    const std::initializer_list<Array<Backend, real>*>& fields)
{
    std::vector<GridField> all;
    for (int d = 0; d < D; ++d)
    {
        for (Array<Backend, real>* a : fields) all.emplace_back(a[d], d);
        all.emplace_back(p_.faces.layer[d], d);
    }
    p_.halo->exchange(all);
}

//- A pass sees three faces far: two leave the brick right
template<class Backend, int D, class P>
void PicTransfer<Backend, D, P>::extrapolate(
    std::initializer_list<Array<Backend, real>*> fields, int passes, bool share)
{
    static_assert(GridBricks<D>::depth > 6, "two passes between exchanges");
    Extrapolate<D, real> f{};
    f.grid = p_.set.grid;
    for (Array<Backend, real>* a : fields)
    {
        for (int d = 0; d < D; ++d) f.field[f.fields][d] = a[d].data();
        ++f.fields;
    }
    for (int d = 0; d < D; ++d) f.layer[d] = p_.faces.layer[d].data();
    for (int pass = 1; pass <= passes; ++pass)
    {
        if (p_.halo && pass % 2 == 1) this->share(fields);
        f.pass = static_cast<unsigned char>(pass);
        p_.rows.each(p_.set.context, f);
    }
    if (p_.halo && share) this->share(fields);
}

template<class Backend, int D, class P> void PicTransfer<Backend, D, P>::toParticles(double dt)
{
    p_.particles.scheme.take(p_.set.context, p_.gridVelocities(dt), p_.toFaces.occupied(), dt);
}

} // namespace riprap

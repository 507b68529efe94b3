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

    void mapToFaces(int d);
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
    if (p_.slow.any()) p_.slow.find(context, p_.toFaces.occupied(), particles.sort);
    for (int d = 0; d < D; ++d)
    {
        const int faces = grid.faces(d);
        mapToFaces(d);
        if (grid.periodic[d])
        {
            forEach(context, faces, CopyPeriodic<D, real>{grid, d, p_.faces.before[d].data()});
            forEach(context, faces, CopyPeriodic<D, real>{grid, d, p_.faces.mass[d].data()});
        }
        p_.rows.eachFaceOfBoth(context, d,
            MarkByMass<D, real>{grid, d, p_.faces.mass[d].data(), p_.walls.aperture[d].data(),
                p_.faces.layer[d].data()});
    }
    if (p_.slow.any()) p_.slow.endSums();
    extrapolate({p_.faces.before}, 3);
}

//- Velocity and mass at the faces of direction d
template<class Backend, int D, class P>
void PicTransfer<Backend, D, P>::mapToFaces(int d)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    withSpline(p_.set.config.splineOrder, [&](auto order)
    {
        constexpr int spline = decltype(order)::value;
        const auto map = [&](const SlowSums<D, real>* slow)
        {
            p_.toFaces.template map<spline>(p_.set.context, p_.set.grid, p_.rows,
                particles.view(), d, particles.at.affine >= 0,
                p_.opens() ? p_.faces.u[d].data() : nullptr, p_.faces.before[d].data(),
                p_.faces.mass[d].data(), slow);
        };
        if (!p_.slow.any()) return map(nullptr);
        const SlowSums<D, real> slow = p_.slow.sums(
            p_.set.context, d, SeenFaces<spline>::template allOfTile<D>());
        map(&slow);
    });
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
    GridVelocities<D, real> v = p_.gridVelocities(dt);
    if (!p_.slow.any())
        return p_.particles.scheme.take(p_.set.context, v, p_.toFaces.occupied(), dt);
    v.only = p_.slow.in(currentTile);
    p_.particles.scheme.take(p_.set.context, v, p_.slow.list(currentTile), dt);
    if (!p_.slow.due()) return;
    v.only = p_.slow.in(dueTile);
    v.waited = true;
    for (int d = 0; d < D; ++d) v.du[d] = p_.slow.change[d].data();
    p_.particles.scheme.take(p_.set.context, v, p_.slow.list(dueTile), p_.slow.time);
}

} // namespace riprap

/*  Particles in a block, their maps and what these gave: of the tests of transfers and paths.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "backendTest.hpp"
#include "core/neighbours/cellSort.hpp"
#include "pic/transfer/gridToParticle.hpp"
#include "pic/transfer/moveParticles.hpp"
#include "pic/transfer/particleToGrid.hpp"
#include "pic/transfer/schemes/flip.hpp"
#include "pic/transfer/schemes/pic.hpp"

namespace riprap
{
namespace
{

template<class C> struct PicTransferCase : BackendTest {};
#ifdef __CUDACC__
template<class C> struct GpuPicTransfer : PicTransferCase<C> {};
#define PIC_TEST(name) TYPED_TEST(GpuPicTransfer, name)
TYPED_TEST_SUITE(GpuPicTransfer, AllCases, CaseNames);
#else
template<class C> struct CpuPicTransfer : PicTransferCase<C> {};
#define PIC_TEST(name) TYPED_TEST(CpuPicTransfer, name)
TYPED_TEST_SUITE(CpuPicTransfer, AllCases, CaseNames);
#endif

//- A block of cells with particles anywhere in it, sorted, on the device
template<class C>
struct Cloud
{
    static constexpr int D = C::D;
    using R = typename C::real;

    Context<Backend> context;
    UniformGrid<D> grid;
    FieldSet<Backend> set;
    CellSort<Backend> sort;
    ParticleToGrid<Backend, D, R> map;
    ActiveRows<Backend, D> rows;
    Array<Backend, PlaceInCell<R>> place;
    Array<Backend, R> water;
    int n;
    Array<Backend, R> u[D], mass[D];
    std::vector<double> x[D];

    //- velocity(x, d); margin: empty cells at the sides
    template<class F>
    Cloud(int cells, int perCell, int margin, const F& velocity, bool periodic = false)
        : grid(), n(0)
    {
        grid.h = 0.125;
        for (int d = 0; d < D; ++d)
        {
            grid.n[d] = cells + d;
            grid.origin[d] = 0;
            grid.periodic[d] = periodic;
        }
        Random random(7);
        n = perCell*grid.cells();
        std::vector<R> v[D];
        for (int i = 0; i < n; ++i)
        {
            Vec<D, double> at;
            for (int d = 0; d < D; ++d)
            {
                at.c[d] = grid.h*random(margin, grid.n[d] - margin);
                x[d].push_back(at.c[d]);
            }
            for (int d = 0; d < D; ++d) v[d].push_back(R(velocity(at, d)));
        }
        for (int d = 0; d < D; ++d) set.template add<double>("x");
        for (int d = 0; d < D; ++d) set.template add<R>("v");
        for (int d = 0; d < D*D; ++d) set.template add<R>("c");
        set.template add<std::int32_t>("id");
        for (int k = 0; k < D*mostMemory; ++k) set.template add<R>("m");
        set.allocate(context, n, true);
        sort.allocate(context, n, grid.cells());
        std::vector<std::int32_t> id(n);
        for (int i = 0; i < n; ++i) id[i] = i;
        for (int d = 0; d < D; ++d)
        {
            set.upload(context, d, x[d]);
            set.upload(context, D + d, v[d]);
        }
        for (int k = 0; k < D*D; ++k) set.upload(context, 2*D + k, std::vector<R>(n, R(0)));
        set.upload(context, 2*D + D*D, id);
        for (int k = 0; k < D*mostMemory; ++k)
            set.upload(context, 2*D + D*D + 1 + k, std::vector<R>(n, R(0)));
        order();
        for (int d = 0; d < D; ++d)
        {
            u[d].allocate(context, grid.faces(d));
            mass[d].allocate(context, grid.faces(d));
        }
    }

    PicParticles<D, R> view(bool spare = false)
    {
        const auto field = [&](auto type, int k)
        {
            using T = decltype(type);
            return spare ? set.template spare<T>(k) : set.template data<T>(k);
        };
        PicParticles<D, R> p{};
        p.count = n;
        for (int d = 0; d < D; ++d) { p.x[d] = field(double(), d); p.v[d] = field(R(), D + d); }
        for (int k = 0; k < D*D; ++k) p.affine[k] = field(R(), 2*D + k);
        p.id = field(std::int32_t(), 2*D + D*D);
        for (int k = 0; k < D*mostMemory; ++k) p.memory[k] = field(R(), 2*D + D*D + 1 + k);
        p.place = place.data();
        p.start = sort.start();
        return p;
    }

    void order()
    {
        forEach(context, n, PicCellKeys<D, R>{grid, view(), sort.keys(), sort.indices()});
        sort.sort(context, n);
        place.allocate(context, n);
        forEach(context, n,
            PutInOrder<D, R>{1/grid.h, sort.order(), view(), view(true), place.data()});
        set.takeSpares();
    }

    template<int Order>
    void toGrid(bool affine = false)
    {
        map.prepare(context, grid, sort);
        water.upload(context, std::vector<R>(grid.cells(), R(-1)));
        rows.find(context, grid, map.occupied(), water.data(), sort);
        for (int d = 0; d < D; ++d)
            map.template map<Order>(
                context, grid, rows, view(), d, affine, nullptr, u[d].data(), mass[d].data());
    }

    Vec<D, double> faceAt(int d, int i) const
    {
        const auto f = grid.faceIndex(d, i);
        Vec<D, double> at;
        for (int a = 0; a < D; ++a) at.c[a] = grid.h*(f.c[a] + (a == d ? 0.0 : 0.5));
        return at;
    }

    //- Velocity of the particles from the grid, by PIC with the affine part
    template<int Order>
    void toParticles()
    {
        Array<Backend, unsigned char> near;
        near.upload(context, std::vector<unsigned char>(grid.cells(), 1));
        GridToParticle<Order, D, R, true, TakeGrid> f{};
        f.grid = grid;
        f.inverse = 1/grid.h;
        f.particles = view();
        for (int d = 0; d < D; ++d) f.u[d] = f.du[d] = u[d].data();
        f.nearWater = near.data();
        f.affine = true;
        forEach(context, n, f);
        context.synchronise();
    }
};

template<class F> void forOrders(const F& f)
{
    f(std::integral_constant<int, 1>());
    f(std::integral_constant<int, 2>());
    f(std::integral_constant<int, 3>());
}

} // namespace
} // namespace riprap

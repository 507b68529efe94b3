/*  The water of a new run: its surface, and particles with their velocities.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/fillSolids.hpp"
#include "pic/surface/seeding.hpp"
#include "solvers/pic/driver/freeSurface.hpp"

namespace riprap
{

//- Particles in boxes no smaller than a reach, so that those about a point are soon found
template<int D>
struct ParticleBoxes
{
    int n[3] = {1, 1, 1};
    double length[D];
    std::vector<std::vector<int>> in;

    ParticleBoxes(const UniformGrid<D>& grid, double reach, const std::vector<double>& x)
    {
        for (int d = 0; d < D; ++d)
        {
            length[d] = grid.n[d]*grid.h;
            n[d] = std::max(1, int(length[d]/reach));
        }
        in.resize(std::size_t(n[0])*n[1]*n[2]);
        for (int p = 0; p < int(x.size()/D); ++p)
            in[number(at(&x[p*D], 0), at(&x[p*D], 1), D == 3 ? at(&x[p*D], D - 1) : 0)]
                .push_back(p);
    }

    int at(const double* x, int d) const
    {
        return std::max(0, std::min(int(x[d]*n[d]/length[d]), n[d] - 1));
    }
    int number(int i, int j, int k) const { return i + n[0]*(j + n[1]*k); }

    //- f(particle) for those in the box of a point and beside it
    template<class F>
    void eachAbout(const double* x, const F& f) const
    {
        int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        for (int d = 0; d < D; ++d)
        {
            const int c = at(x, d);
            low[d] = std::max(c - 1, 0);
            high[d] = std::min(c + 1, n[d] - 1);
        }
        for (int k = low[2]; k <= high[2]; ++k)
            for (int j = low[1]; j <= high[1]; ++j)
                for (int i = low[0]; i <= high[0]; ++i)
                    for (const int p : in[number(i, j, k)]) f(p);
    }
};

template<class Backend, int D, class P>
class FluidSeeding
{
public:

    using real = typename P::real;

    FluidSeeding(PicParts<Backend, D, P>& parts, ParticleAdvection<Backend, D, P>& advection,
        FreeSurface<Backend, D, P>& surface)
        : p_(parts), advection_(advection), surface_(surface)
    {}

    void fill(const FluidInput&);

private:

    void leaveDry();
    std::size_t place(const std::vector<double>& x, const std::vector<double>& v,
        const std::vector<double>& gradient, const std::vector<std::int32_t>& id);
    std::vector<double> velocitiesAt(const std::vector<double>& seeds, const std::vector<double>& x,
        const std::vector<double>& v, std::vector<double>& gradient) const;
    void dropInside(std::vector<double>& x);
    std::vector<char> clearCells(double clear);

    PicParts<Backend, D, P>& p_;
    ParticleAdvection<Backend, D, P>& advection_;
    FreeSurface<Backend, D, P>& surface_;
};

template<class T> std::vector<double> asDouble(const std::vector<T>& v)
{
    return std::vector<double>(v.begin(), v.end());
}

template<class Backend, int D, class P>
void FluidSeeding<Backend, D, P>::fill(const FluidInput& fluid)
{
    const UniformGrid<D>& grid = p_.set.whole();
    const PicConfig& config = p_.set.config;
    const real band = real(p_.set.bandCells*grid.h);
    if (fluid.size() == 0) { leaveDry(); return; }
    const std::vector<double> x = p_.set.solved(fluid.position, true),
                              v = p_.set.solved(fluid.velocity, false);
    std::vector<double> fill = fillOfBoxes<D>(grid, x, config.spacing);
    if (p_.cuts())
        fillSolids(grid, clearCells(std::min(config.spacing, p_.set.nearSolid*grid.h)),
            asDouble(p_.whole(p_.cut.open, -1)), p_.set.steepest(), fill);
    const std::vector<real> phi = surfaceOf<D, real>(grid, fill, band);
    p_.surface.phi.upload(p_.set.context, p_.halo ? p_.halo->partOf(phi, -1) : phi);
    double sums[3];
    const double total = (p_.cuts() ? surface_.waterVolume(sums)
                                    : std::accumulate(fill.begin(), fill.end(), 0.0))
        *grid.volume();
    std::size_t count = 0;
    if (config.seedsPerDirection > 0)
    {
        std::vector<double> at = seeds<D, real>(
            grid, phi.data(), config.seedsPerDirection, config.jitter);
        if (p_.cuts()) dropInside(at);
        std::vector<double> gradient;
        const std::vector<double> velocity = velocitiesAt(at, x, v, gradient);
        count = place(at, velocity, gradient, std::vector<std::int32_t>());
    }
    else
    {
        std::vector<double> gradient;
        if (p_.particles.scheme.gradient()) velocitiesAt(x, x, v, gradient);
        count = place(x, v, gradient, fluid.id);
    }
    if (count == 0) throw std::invalid_argument("the fluid fills no cell");
    p_.set.clock.particleVolume = total/double(count);
    p_.set.clock.initial = std::int64_t(count);
    advection_.sort();
    surface_.markWater();
    surface_.measure();
}

//- All that are given, of which several ranks keep those of their parts. \return how many there are
template<class Backend, int D, class P>
std::size_t FluidSeeding<Backend, D, P>::place(const std::vector<double>& x,
    const std::vector<double>& v, const std::vector<double>& gradient,
    const std::vector<std::int32_t>& id)
{
    const std::size_t count = x.size()/D;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    if (!p_.halo)
    {
        particles.fill(x, v, gradient, id);
        return count;
    }
    const UniformGrid<D>& whole = p_.set.whole();
    const GridBricks<D>& bricks = *p_.set.bricks;
    const CellBox part = bricks.part(bricks.rank());
    std::vector<double> ownX, ownV, ownGradient;
    std::vector<std::int32_t> ids(id), ownId;
    if (ids.empty()) { ids.resize(count); std::iota(ids.begin(), ids.end(), 0); }
    for (std::size_t i = 0; i < count; ++i)
    {
        int c[3] = {0, 0, 0};
        for (int d = 0; d < D; ++d)
            c[d] = std::max(0, std::min(int(x[i*D + d]/whole.h), whole.n[d] - 1));
        // a cell more: on a face rounding decides
        bool near = true;
        for (int d = 0; d < D; ++d) near = near && c[d] >= part.low[d] - 1 && c[d] <= part.high[d];
        if (!near) continue;
        ownX.insert(ownX.end(), &x[i*D], &x[i*D] + D);
        ownV.insert(ownV.end(), &v[i*D], &v[i*D] + D);
        if (!gradient.empty())
            ownGradient.insert(ownGradient.end(), &gradient[i*D*D], &gradient[i*D*D] + D*D);
        ownId.push_back(ids[i]);
    }
    particles.fill(ownX, ownV, ownGradient, ownId);
    particles.setAll(std::int64_t(count));
    p_.set.clock.nextId = count ? std::int64_t(*std::max_element(ids.begin(), ids.end())) + 1 : 0;
    return count;
}

//- Solids alone: arrays of one particle that does not count, and no surface
template<class Backend, int D, class P>
void FluidSeeding<Backend, D, P>::leaveDry()
{
    const UniformGrid<D>& grid = p_.set.grid;
    p_.surface.phi.upload(
        p_.set.context, std::vector<real>(grid.cells(), real(p_.set.bandCells*grid.h)));
    p_.particles.fill(std::vector<double>(D, 0.5*grid.h), std::vector<double>(D, 0.0),
        std::vector<double>(D*D, 0.0), std::vector<std::int32_t>());
    p_.set.clock.particleVolume = grid.volume();
    advection_.sort();
    p_.particles.n = 0;
    surface_.markWater();
}

//- Points that lie in solids are left out
template<class Backend, int D, class P>
void FluidSeeding<Backend, D, P>::dropInside(std::vector<double>& x)
{
    const std::vector<double> distance = p_.nodeDistances();
    SolidField<D, real> solids{};
    solids.grid = p_.set.whole();
    solids.distance = distance.data();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < x.size()/D; ++i)
    {
        Vec<D, double> at, normal;
        for (int d = 0; d < D; ++d) at.c[d] = x[i*D + d];
        if (solids.at(at, normal) < p_.set.wallMargin*p_.set.grid.h) continue;
        for (int d = 0; d < D; ++d) x[kept*D + d] = x[i*D + d];
        ++kept;
    }
    x.resize(kept*D);
}

//- Cells of the whole block that no solid is near, to `clear`
template<class Backend, int D, class P>
std::vector<char> FluidSeeding<Backend, D, P>::clearCells(double clear)
{
    const UniformGrid<D>& grid = p_.set.whole();
    const std::vector<double> distance = p_.nodeDistances();
    const NodeGrid<D> nodes{grid};
    std::vector<char> known(grid.cells());
    for (int i = 0; i < grid.cells(); ++i)
    {
        const int first = nodes.node(grid.cellIndex(i));
        bool far = true;
        for (int corner = 0; corner < (1 << D); ++corner)
        {
            int node = first;
            for (int d = 0; d < D; ++d) node += (corner >> d & 1)*nodes.stride(d);
            far = far && distance[node] >= clear;
        }
        known[i] = far;
    }
    return known;
}

//- Velocities of given particles at seeds, and their gradients: the weighted least-squares plane
//  through those within a cell or two spacings
template<class Backend, int D, class P>
std::vector<double> FluidSeeding<Backend, D, P>::velocitiesAt(const std::vector<double>& seeds,
    const std::vector<double>& x, const std::vector<double>& v, std::vector<double>& gradient) const
{
    std::vector<double> result(seeds.size(), 0.0);
    gradient.assign(seeds.size()*D, 0.0);
    if (std::all_of(v.begin(), v.end(), [](double u) { return u == 0; })) return result;
    constexpr int terms = D + 1;
    const double reach = std::max(p_.set.grid.h, 2*p_.set.config.spacing);
    const ParticleBoxes<D> boxes(p_.set.whole(), reach, x);
    #pragma omp parallel for
    for (std::size_t s = 0; s < seeds.size()/D; ++s)
    {
        const double* at = &seeds[s*D];
        double a[terms][terms + D] = {};
        boxes.eachAbout(at, [&](int p)
        {
            double basis[terms] = {1}, r2 = 0;
            for (int d = 0; d < D; ++d)
            {
                basis[d + 1] = (x[p*D + d] - at[d])/reach;
                r2 += basis[d + 1]*basis[d + 1];
            }
            if (r2 >= 1) return;
            const double w = (1 - r2)*(1 - r2);
            for (int r = 0; r < terms; ++r)
            {
                for (int c = 0; c < terms; ++c) a[r][c] += w*basis[r]*basis[c];
                for (int d = 0; d < D; ++d) a[r][terms + d] += w*basis[r]*v[p*D + d];
            }
        });
        if (!(a[0][0] > 0)) continue;
        // where particles do not span a plane, a little of the mean's weight does
        for (int r = 1; r < terms; ++r) a[r][r] += 1e-9*a[0][0];
        for (int c = 0; c < terms; ++c)
            for (int r = 0; r < terms; ++r)
            {
                if (r == c) continue;
                const double f = a[r][c]/a[c][c];
                for (int e = c; e < terms + D; ++e) a[r][e] -= f*a[c][e];
            }
        for (int d = 0; d < D; ++d)
        {
            result[s*D + d] = a[0][terms + d]/a[0][0];
            for (int e = 0; e < D; ++e)
                gradient[(s*D + d)*D + e] = a[e + 1][terms + d]/a[e + 1][e + 1]/reach;
        }
    }
    return result;
}

} // namespace riprap

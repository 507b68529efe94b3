/*  What water does at openings of the sides. Nothing of this is called in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <type_traits>
#include "pic/openings/openFaces.hpp"
#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class OpenBoundaries
{
public:

    using real = typename P::real;

    explicit OpenBoundaries(PicParts<Backend, D, P>& parts) : p_(parts) {}

    void set(PicWalls& walls);
    void start();
    void takeUpPending();
    void setFaces(double t);
    void writeFaces();
    void push(double dt);
    void inject(double dt);

    void keepOpenParts(int d, const std::vector<real>& aperture);
    void keepOpenParts();
    void openFully();

private:

    std::vector<double> at(Array<Backend, real>* ofFaces, const Array<Backend, real>* ofCells);
    void append(
        const std::vector<Vec<D, double>>& places, const std::vector<Vec<D, double>>& velocities);

    PicParts<Backend, D, P>& p_;
};

//- The sides with the openings' faces open, and the lists of these
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::set(PicWalls& walls)
{
    const UniformGrid<D>& grid = p_.set.grid;
    const PicConfig& config = p_.set.config;
    Context<Backend>& context = p_.set.context;
    OpenSides<Backend, D, P>& sides = p_.openings;
    double g = 0;
    for (int d = 0; d < D; ++d) g += p_.set.gravity[d]*p_.set.gravity[d];
    g = std::sqrt(g);
    Vec<D, double> up{};
    for (int d = 0; d < D; ++d) up.c[d] = g > 0 ? -p_.set.gravity[d]/g : 0.0;
    sides.faces = openFaces(grid, walls.opening, up);
    sides.in.clear();
    sides.out.clear();
    sides.volume.clear();
    for (const PicOpening& o : config.openings)
    {
        sides.in.push_back(o.before.in);
        sides.out.push_back(o.before.out);
        sides.volume.push_back(o.before.volume - o.before.pending);
    }
    sides.rate.assign(config.openings.size(), 0);
    sides.owed.assign(config.openings.size(), 0);
    for (int d = 0; d < D; ++d)
    {
        std::vector<double>& a = walls.aperture[d];
        if (a.empty())
        {
            a.assign(grid.faces(d), 1.0);
            for (int i = 0; i < grid.faces(d) && !grid.periodic[d]; ++i)
                if (atEnd(grid, d, grid.faceIndex(d, i).c[d])) a[i] = 0;
        }
        std::vector<int> face, cell;
        for (const OpenFace<D>& f : sides.faces)
        {
            if (f.direction != d) continue;
            a[f.face] = 1;
            face.push_back(f.face);
            cell.push_back(f.cell);
        }
        sides.number[d].assign(grid.faces(d), -1);
        for (const OpenFace<D>& f : sides.faces)
            if (f.direction == d) sides.number[d][f.face] = f.opening;
        sides.face[d].upload(context, face);
        sides.cell[d].upload(context, cell);
        sides.gate[d].allocate(context, grid.faces(d));
        p_.walls.velocity[d].allocate(context, grid.faces(d));
    }
    p_.walls.move = true;
}

//- After the walls were set: what obstacles leave open of each face
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::keepOpenParts(int d, const std::vector<real>& aperture)
{
    for (OpenFace<D>& f : p_.openings.faces)
        if (f.direction == d) f.open = double(aperture[f.face]);
}

//- What bodies leave open of each, and before they cut: all that walls leave
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::keepOpenParts()
{
    const std::vector<double> open = at(p_.walls.aperture, nullptr);
    for (std::size_t k = 0; k < p_.openings.faces.size(); ++k) p_.openings.faces[k].open = open[k];
}

template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::openFully()
{
    for (int d = 0; d < D; ++d)
        forEach(p_.set.context, int(p_.openings.face[d].size()),
            CopyOpenFaces<real>{p_.openings.face[d].data(), p_.cut.baseAperture[d].data(),
                p_.walls.aperture[d].data()});
}

//- A field of faces (of cells) at the openings' faces (the cells behind them), in their order
template<class Backend, int D, class P>
std::vector<double> OpenBoundaries<Backend, D, P>::at(
    Array<Backend, real>* ofFaces, const Array<Backend, real>* ofCells)
{
    OpenSides<Backend, D, P>& sides = p_.openings;
    std::vector<double> values;
    for (int d = 0; d < D; ++d)
    {
        const int count = int(sides.face[d].size());
        if (!count) continue;
        sides.buffer.allocate(p_.set.context, count);
        forEach(p_.set.context, count,
            ReadOpenFaces<real>{ofFaces ? sides.face[d].data() : sides.cell[d].data(),
                ofFaces ? ofFaces[d].data() : ofCells->data(), sides.buffer.data()});
        const std::vector<real> part = sides.buffer.download();
        values.insert(values.end(), part.begin(), part.end());
    }
    return values;
}

//- Of a new run: sides already have what is given
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::start()
{
    OpenSides<Backend, D, P>& sides = p_.openings;
    setFaces(p_.set.clock.time);
    std::size_t from = 0;
    for (int d = 0; d < D; ++d)
    {
        const std::size_t count = sides.face[d].size();
        if (!count) continue;
        sides.buffer.upload(p_.set.context,
            std::vector<real>(sides.given.begin() + from, sides.given.begin() + from + count));
        forEach(p_.set.context, int(count),
            PushOpenFaces<real>{sides.face[d].data(), sides.buffer.data(), p_.faces.u[d].data()});
        from += count;
    }
}

//- What came in before the run was continued, and is no particles yet, is kept by faces under
//  water, as much by each of their area; what went out and has not left as particles is owed
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::takeUpPending()
{
    const PicConfig& config = p_.set.config;
    OpenSides<Backend, D, P>& sides = p_.openings;
    std::vector<double> wet(config.openings.size(), 0.0);
    for (const OpenFace<D>& f : sides.faces) wet[f.opening] += f.wet*f.open;
    for (OpenFace<D>& f : sides.faces)
    {
        const double pending = config.openings[f.opening].before.pending;
        if (pending > 0 && wet[f.opening] > 0) f.kept = pending*f.wet*f.open/wet[f.opening];
    }
    for (std::size_t k = 0; k < wet.size(); ++k)
    {
        const double pending = config.openings[k].before.pending;
        if (pending < 0 || !(wet[k] > 0)) sides.owed[k] = -pending;
    }
}

//- What is given for the step that begins at t
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::setFaces(double t)
{
    const UniformGrid<D>& grid = p_.set.grid;
    const PicConfig& config = p_.set.config;
    OpenSides<Backend, D, P>& sides = p_.openings;
    const std::vector<double> phi = at(nullptr, &p_.surface.phi);
    const int count = int(config.openings.size());
    std::vector<double> area(count, 0.0), whole(count, 0.0);
    for (std::size_t k = 0; k < sides.faces.size(); ++k)
    {
        OpenFace<D>& f = sides.faces[k];
        const PicOpening& o = config.openings[f.opening];
        const bool inflowLevel = o.kind != OpeningKind::level && o.level;
        f.filled = f.underSurface(phi[k]);
        f.wet = inflowLevel ? f.under(o.level(t)) : f.filled;
        area[f.opening] += f.wet*f.open*grid.area();
        whole[f.opening] += f.open*grid.area();
    }
    for (int k = 0; k < count; ++k)
        if (config.openings[k].kind == OpeningKind::flowRate)
        {
            // through a dry opening the water falls: through all of it
            const double through = area[k] > 0 ? area[k] : whole[k];
            sides.rate[k] = through > 0 ? config.openings[k].flowRate(t)/through : 0;
            if (area[k] > 0) continue;
            for (OpenFace<D>& f : sides.faces) if (f.opening == k) f.wet = 1;
        }
    sides.open.clear();
    sides.given.clear();
    sides.leaves.clear();
    for (std::size_t k = 0; k < sides.faces.size(); ++k)
    {
        const OpenFace<D>& f = sides.faces[k];
        const PicOpening& o = config.openings[f.opening];
        double w = 0;
        if (o.kind == OpeningKind::velocity) w = o.velocity(t)[config.axes[f.direction]];
        else if (o.kind == OpeningKind::flowRate) w = f.inward(sides.rate[f.opening]);
        // nothing flows through what lies above the level; where there is no water the value
        // continues that below
        const bool wet = phi[k] < -wetDepth*grid.h;
        if (o.level && wet && !(f.wet > 0)) w = 0;
        const bool free = o.kind == OpeningKind::level;
        sides.open.push_back(free ? real(f.open) : real(0));
        sides.given.push_back(free ? real(0) : real(w*f.open));
        sides.leaves.push_back(!free && f.inward(w) < 0);
    }
    writeFaces();
}

//- Also after the walls were cut anew
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::writeFaces()
{
    Context<Backend>& context = p_.set.context;
    OpenSides<Backend, D, P>& sides = p_.openings;
    std::size_t from = 0;
    for (int d = 0; d < D; ++d)
    {
        const std::size_t count = sides.face[d].size();
        if (!count || sides.open.empty()) continue;
        const auto part = [&](const auto& all)
        { return std::decay_t<decltype(all)>(all.begin() + from, all.begin() + from + count); };
        sides.buffer.upload(context, part(sides.open));
        sides.second.upload(context, part(sides.given));
        sides.flags.upload(context, part(sides.leaves));
        forEach(context, int(count),
            SetOpenFaces<real>{sides.face[d].data(), sides.buffer.data(), sides.second.data(),
                sides.flags.data(), p_.walls.aperture[d].data(), p_.walls.velocity[d].data(),
                sides.gate[d].data()});
        from += count;
    }
}

//- By the water that stands beyond, in a kick of dt
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::push(double dt)
{
    OpenSides<Backend, D, P>& sides = p_.openings;
    double g = 0;
    for (int d = 0; d < D; ++d) g += p_.set.gravity[d]*p_.set.gravity[d];
    std::size_t k = 0;
    for (int d = 0; d < D; ++d)
    {
        std::vector<real> push;
        for (; k < sides.faces.size() && sides.faces[k].direction == d; ++k)
        {
            const OpenFace<D>& f = sides.faces[k];
            const PicOpening& o = p_.set.config.openings[f.opening];
            const double head = o.kind == OpeningKind::level
                ? std::max(0.0, o.level(p_.set.clock.time) - f.height)
                : 0;
            push.push_back(real(f.inward(2*dt*std::sqrt(g)*head/p_.set.grid.h)));
        }
        if (push.empty()) continue;
        sides.buffer.upload(p_.set.context, push);
        forEach(p_.set.context, int(push.size()),
            PushOpenFaces<real>{sides.face[d].data(), sides.buffer.data(), p_.faces.u[d].data()});
    }
}

//- Particles that have come in during the drift dt, with what the grid has for them
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::inject(double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    OpenSides<Backend, D, P>& sides = p_.openings;
    PicClock& clock = p_.set.clock;
    const std::vector<double> u = at(p_.faces.u, nullptr);
    const int vertical = p_.set.steepest(),
              perDirection = std::max(1, int(std::lround(grid.h/p_.set.particleSpacing())));
    std::vector<Vec<D, double>> places, velocities;
    std::vector<double> carried(sides.owed.size(), 0.0), wet(sides.owed.size(), 0.0);
    for (std::size_t k = 0; k < sides.faces.size(); ++k)
    {
        OpenFace<D>& f = sides.faces[k];
        const PicOpening& o = p_.set.config.openings[f.opening];
        const double along = o.kind == OpeningKind::level ? u[k] : (f.open > 0 ? u[k]/f.open : 0.0);
        const double area = f.filled*f.open*grid.area();
        wet[f.opening] += area;
        carried[f.opening] += std::max(0.0, -f.inward(along))*area*dt;
        const std::size_t before = places.size();
        enter(f, grid, f.inward(along), dt, clock.particleVolume, perDirection, vertical,
            vertical >= 0 && p_.set.gravity[vertical] < 0, p_.set.wallMargin*grid.h, places);
        sides.in[f.opening] += std::int64_t(places.size() - before);
        sides.volume[f.opening] += double(places.size() - before)*clock.particleVolume;
        Vec<D, double> v{};
        if (o.kind == OpeningKind::velocity && places.size() > before)
        {
            const Vector3 all = o.velocity(clock.time);
            for (int d = 0; d < D; ++d) v.c[d] = all[p_.set.config.axes[d]];
        }
        else v.c[f.direction] = along;
        velocities.resize(places.size(), v);
    }
    for (std::size_t k = 0; k < carried.size(); ++k)
        balance<D>(sides.owed[k], carried[k], wet[k]*grid.h/perDirection);
    append(places, velocities);
}

//- They have what the grid has for them
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::append(
    const std::vector<Vec<D, double>>& places, const std::vector<Vec<D, double>>& velocities)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    const int first = particles.n, more = int(places.size());
    if (!more) return;
    particles.append(places, velocities);
    particles.scheme.enter(p_.set.context, p_.gridVelocities(0), first, more);
}

} // namespace riprap

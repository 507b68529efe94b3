/*  What water does at openings of the sides. Nothing of this is called in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include <stdexcept>
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

    void listHere();
    //- Of values of all faces those of one direction that are here
    template<class T> std::vector<T> pick(const std::vector<T>& all, int d) const
    {
        std::vector<T> some;
        some.reserve(p_.openings.here[d].size());
        for (const int k : p_.openings.here[d]) some.push_back(all[k]);
        return some;
    }
    std::vector<double> at(Array<Backend, real>* ofFaces, const Array<Backend, real>* ofCells);
    void share(std::vector<double>& ofFaces) const;
    void append(std::vector<EnteringParticle<D>>& all, const std::vector<int>& face);

    PicParts<Backend, D, P>& p_;
};

//- The sides with the openings' faces open, and the lists of these
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::set(PicWalls& walls)
{
    const UniformGrid<D>& grid = p_.set.whole();
    const PicConfig& config = p_.set.config;
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
        sides.number[d].assign(grid.faces(d), -1);
        for (const OpenFace<D>& f : sides.faces)
        {
            if (f.direction != d) continue;
            a[f.face] = 1;
            sides.number[d][f.face] = f.opening;
        }
    }
    listHere();
    p_.walls.move = true;
}

//- Those whose cells this rank's part has, as they are numbered in its arrays
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::listHere()
{
    const UniformGrid<D>&whole = p_.set.whole(), &grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    OpenSides<Backend, D, P>& sides = p_.openings;
    std::vector<int> face[D], cell[D];
    sides.owner.clear();
    for (auto& list : sides.here) list.clear();
    for (int k = 0; k < int(sides.faces.size()); ++k)
    {
        const OpenFace<D>& f = sides.faces[k];
        auto at = whole.faceIndex(f.direction, f.face), c = whole.cellIndex(f.cell);
        if (p_.halo) sides.owner.push_back(p_.set.bricks->owner(c));
        bool in = true;
        for (int d = 0; d < D; ++d)
        {
            at.c[d] -= grid.first[d];
            c.c[d] -= grid.first[d];
            in = in && c.c[d] >= 0 && c.c[d] < grid.n[d];
        }
        if (!in) continue;
        sides.here[f.direction].push_back(k);
        face[f.direction].push_back(grid.face(f.direction, at));
        cell[f.direction].push_back(grid.cell(c));
    }
    for (int d = 0; d < D; ++d)
    {
        sides.face[d].upload(context, face[d]);
        sides.cell[d].upload(context, cell[d]);
        sides.gate[d].allocate(context, grid.faces(d));
        p_.walls.velocity[d].allocate(context, grid.faces(d));
    }
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

//- A field of faces (of cells) at the openings' faces (the cells behind them), in their order; of
//  all ranks
template<class Backend, int D, class P>
std::vector<double> OpenBoundaries<Backend, D, P>::at(
    Array<Backend, real>* ofFaces, const Array<Backend, real>* ofCells)
{
    OpenSides<Backend, D, P>& sides = p_.openings;
    std::vector<double> values(sides.faces.size());
    for (int d = 0; d < D; ++d)
    {
        const int count = int(sides.face[d].size());
        if (!count) continue;
        sides.buffer.allocate(p_.set.context, count);
        forEach(p_.set.context, count,
            ReadOpenFaces<real>{ofFaces ? sides.face[d].data() : sides.cell[d].data(),
                ofFaces ? ofFaces[d].data() : ofCells->data(), sides.buffer.data()});
        const std::vector<real> part = sides.buffer.download();
        for (int k = 0; k < count; ++k) values[sides.here[d][k]] = part[k];
    }
    if (p_.halo) share(values);
    return values;
}

//- What owners have
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::share(std::vector<double>& ofFaces) const
{
    Transport& ranks = p_.halo->ranks();
    const std::vector<int>& owner = p_.openings.owner;
    RankBytes own;
    for (std::size_t k = 0; k < owner.size(); ++k)
        if (owner[k] == ranks.rank()) putValues(own, &ofFaces[k]);
    const std::vector<RankBytes> came = toAll(ranks, own);
    std::vector<const unsigned char*> next;
    next.reserve(came.size());
    for (const RankBytes& bytes : came) next.push_back(bytes.data());
    for (std::size_t k = 0; k < owner.size(); ++k) takeValues(next[owner[k]], &ofFaces[k]);
}

//- Of a new run: sides already have what is given
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::start()
{
    OpenSides<Backend, D, P>& sides = p_.openings;
    setFaces(p_.set.clock.time);
    for (int d = 0; d < D; ++d)
    {
        const int count = int(sides.face[d].size());
        if (!count) continue;
        sides.buffer.upload(p_.set.context, pick(sides.given, d));
        forEach(p_.set.context, count,
            PushOpenFaces<real>{sides.face[d].data(), sides.buffer.data(), p_.faces.u[d].data()});
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
        const bool inflowLevel = sides.kinds[f.opening] != Given::pressure && o.level;
        f.filled = f.underSurface(phi[k]);
        f.wet = inflowLevel ? f.under(o.level(t)) : f.filled;
        area[f.opening] += f.wet*f.open*grid.area();
        whole[f.opening] += f.open*grid.area();
    }
    for (int k = 0; k < count; ++k)
        if (sides.kinds[k] == Given::discharge)
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
        const Given kind = sides.kinds[f.opening];
        double w = 0;
        switch (kind)
        {
            case Given::velocity: w = o.velocity(t)[config.axes[f.direction]]; break;
            case Given::discharge: w = f.inward(sides.rate[f.opening]); break;
            case Given::pressure: break;
        }
        // nothing flows through what lies above the level; where there is no water the value
        // continues that below
        const bool wet = phi[k] < -wetDepth*grid.h;
        if (o.level && wet && !(f.wet > 0)) w = 0;
        const bool free = kind == Given::pressure;
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
    for (int d = 0; d < D; ++d)
    {
        const int count = int(sides.face[d].size());
        if (!count || sides.open.empty()) continue;
        sides.buffer.upload(context, pick(sides.open, d));
        sides.second.upload(context, pick(sides.given, d));
        sides.flags.upload(context, pick(sides.leaves, d));
        forEach(context, count,
            SetOpenFaces<real>{sides.face[d].data(), sides.buffer.data(), sides.second.data(),
                sides.flags.data(), p_.walls.aperture[d].data(), p_.walls.velocity[d].data(),
                sides.gate[d].data()});
    }
}

//- By the water that stands beyond, in a kick of dt
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::push(double dt)
{
    OpenSides<Backend, D, P>& sides = p_.openings;
    double g = 0;
    for (int d = 0; d < D; ++d) g += p_.set.gravity[d]*p_.set.gravity[d];
    for (int d = 0; d < D; ++d)
    {
        std::vector<real> push;
        for (const int k : sides.here[d])
        {
            const OpenFace<D>& f = sides.faces[k];
            const PicOpening& o = p_.set.config.openings[f.opening];
            const double head = sides.kinds[f.opening] == Given::pressure
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

//- Particles that have come in during the drift dt, with what the grid has for them. All ranks find
//  those of all, so that ids are the same everywhere
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::inject(double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    OpenSides<Backend, D, P>& sides = p_.openings;
    PicClock& clock = p_.set.clock;
    const std::vector<double> u = at(p_.faces.u, nullptr);
    const int vertical = p_.set.steepest(),
              perDirection = std::max(1, int(std::lround(grid.h/p_.set.particleSpacing())));
    std::vector<Vec<D, double>> places;
    std::vector<EnteringParticle<D>> entering;
    std::vector<int> face;                      // through which each comes
    std::vector<double> carried(sides.owed.size(), 0.0), wet(sides.owed.size(), 0.0);
    for (std::size_t k = 0; k < sides.faces.size(); ++k)
    {
        OpenFace<D>& f = sides.faces[k];
        const PicOpening& o = p_.set.config.openings[f.opening];
        const Given kind = sides.kinds[f.opening];
        const double along = kind == Given::pressure ? u[k] : (f.open > 0 ? u[k]/f.open : 0.0);
        const double area = f.filled*f.open*grid.area();
        wet[f.opening] += area;
        carried[f.opening] += std::max(0.0, -f.inward(along))*area*dt;
        places.clear();
        enter(f, grid, f.inward(along), dt, clock.particleVolume, perDirection, vertical,
            vertical >= 0 && p_.set.gravity[vertical] < 0, p_.set.wallMargin*grid.h, places);
        sides.in[f.opening] += std::int64_t(places.size());
        sides.volume[f.opening] += double(places.size())*clock.particleVolume;
        Vec<D, double> v{};
        if (kind == Given::velocity && !places.empty())
        {
            const Vector3 all = o.velocity(clock.time);
            for (int d = 0; d < D; ++d) v.c[d] = all[p_.set.config.axes[d]];
        }
        else v.c[f.direction] = along;
        for (const Vec<D, double>& x : places)
        {
            if (clock.nextId > std::numeric_limits<std::int32_t>::max())
                throw std::runtime_error("openings have let in all particles that ids of 31 bits "
                    "tell apart: the run cannot go on with them");
            entering.push_back({x, v, std::int32_t(clock.nextId++), int(entering.size())});
            face.push_back(int(k));
        }
    }
    for (std::size_t k = 0; k < carried.size(); ++k)
        balance<D>(sides.owed[k], carried[k], wet[k]*grid.h/perDirection);
    append(entering, face);
}

//- They have what the grid has for them. Of several ranks each takes those that come to its cells;
//  ghosts of them come with the others'
template<class Backend, int D, class P>
void OpenBoundaries<Backend, D, P>::append(
    std::vector<EnteringParticle<D>>& all, const std::vector<int>& face)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    if (p_.halo)
    {
        particles.setAll(particles.all() + std::int64_t(all.size()));
        std::vector<EnteringParticle<D>> own;
        for (const EnteringParticle<D>& e : all)
            if (p_.openings.owner[face[e.number]] == p_.halo->ranks().rank()) own.push_back(e);
        all.swap(own);
        for (const EnteringParticle<D>& e : all) particles.entered.push_back(e.number);
    }
    const int first = particles.n, more = int(all.size());
    if (!more) return;
    particles.append(all);
    particles.scheme.enter(p_.set.context, p_.gridVelocities(0), first, more);
}

} // namespace riprap

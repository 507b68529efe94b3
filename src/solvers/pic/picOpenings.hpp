/*  PicSolver: openings of the sides, through which water comes and goes. Nothing of this is called
    in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <type_traits>
#include "solvers/pic/picSolver.hpp"

namespace riprap
{

//- The sides with the openings' faces open, and the lists of these
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setOpenings(PicWalls& walls)
{
    double g = 0;
    for (int d = 0; d < D; ++d) g += gravity_[d]*gravity_[d];
    g = std::sqrt(g);
    Vec<D, double> up{};
    for (int d = 0; d < D; ++d) up.c[d] = g > 0 ? -gravity_[d]/g : 0.0;
    openings_.faces = openFaces(grid_, walls.opening, up);
    openings_.in.clear();
    openings_.out.clear();
    openings_.volume.clear();
    for (const PicOpening& o : config_.openings)
    {
        openings_.in.push_back(o.before.in);
        openings_.out.push_back(o.before.out);
        openings_.volume.push_back(o.before.volume - o.before.pending);
    }
    openings_.rate.assign(config_.openings.size(), 0);
    openings_.owed.assign(config_.openings.size(), 0);
    for (int d = 0; d < D; ++d)
    {
        std::vector<double>& a = walls.aperture[d];
        if (a.empty())
        {
            a.assign(grid_.faces(d), 1.0);
            for (int i = 0; i < grid_.faces(d) && !grid_.periodic[d]; ++i)
                if (atEnd(grid_, d, grid_.faceIndex(d, i).c[d])) a[i] = 0;
        }
        std::vector<int> face, cell;
        for (const OpenFace<D>& f : openings_.faces)
        {
            if (f.direction != d) continue;
            a[f.face] = 1;
            face.push_back(f.face);
            cell.push_back(f.cell);
        }
        openings_.number[d].assign(grid_.faces(d), -1);
        for (const OpenFace<D>& f : openings_.faces)
            if (f.direction == d) openings_.number[d][f.face] = f.opening;
        openings_.face[d].upload(context_, face);
        openings_.cell[d].upload(context_, cell);
        openings_.gate[d].allocate(context_, grid_.faces(d));
        wallVelocity_[d].allocate(context_, grid_.faces(d));
    }
    wallsMove_ = true;
}

//- After the walls were set: what obstacles leave open of each face
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::keepOpenParts(int d, const std::vector<real>& aperture)
{ for (OpenFace<D>& f : openings_.faces) if (f.direction == d) f.open = double(aperture[f.face]); }

//- What bodies leave open of each, and before they cut: all that walls leave
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::keepOpenParts()
{
    const std::vector<double> open = atOpenings(aperture_, nullptr);
    for (std::size_t k = 0; k < openings_.faces.size(); ++k) openings_.faces[k].open = open[k];
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::openFully()
{
    for (int d = 0; d < D; ++d)
        forEach(context_, int(openings_.face[d].size()),
            CopyOpenFaces<real>{
                openings_.face[d].data(), baseAperture_[d].data(), aperture_[d].data()});
}

//- A field of faces (of cells) at the openings' faces (the cells behind them), in their order
template<class Backend, int D, class P>
std::vector<double> PicSolver<Backend, D, P>::atOpenings(
    Array<Backend, real>* ofFaces, const Array<Backend, real>* ofCells)
{
    std::vector<double> values;
    for (int d = 0; d < D; ++d)
    {
        const int count = int(openings_.face[d].size());
        if (!count) continue;
        openings_.buffer.allocate(context_, count);
        forEach(context_, count,
            ReadOpenFaces<real>{ofFaces ? openings_.face[d].data() : openings_.cell[d].data(),
                ofFaces ? ofFaces[d].data() : ofCells->data(), openings_.buffer.data()});
        const std::vector<real> part = openings_.buffer.download();
        values.insert(values.end(), part.begin(), part.end());
    }
    return values;
}

//- Of a new run: sides already have what is given
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::startOpenings()
{
    setOpenFaces(clock_.time);
    std::size_t from = 0;
    for (int d = 0; d < D; ++d)
    {
        const std::size_t count = openings_.face[d].size();
        if (!count) continue;
        openings_.buffer.upload(context_,
            std::vector<real>(
                openings_.given.begin() + from, openings_.given.begin() + from + count));
        forEach(context_, int(count),
            PushOpenFaces<real>{openings_.face[d].data(), openings_.buffer.data(), u_[d].data()});
        from += count;
    }
    markWater();
    takeUpPending();
}

//- What came in before the run was continued, and is no particles yet, is kept by faces under
//  water, as much by each of their area; what went out and has not left as particles is owed
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::takeUpPending()
{
    std::vector<double> wet(config_.openings.size(), 0.0);
    for (const OpenFace<D>& f : openings_.faces) wet[f.opening] += f.wet*f.open;
    for (OpenFace<D>& f : openings_.faces)
    {
        const double pending = config_.openings[f.opening].before.pending;
        if (pending > 0 && wet[f.opening] > 0) f.kept = pending*f.wet*f.open/wet[f.opening];
    }
    for (std::size_t k = 0; k < wet.size(); ++k)
    {
        const double pending = config_.openings[k].before.pending;
        if (pending < 0 || !(wet[k] > 0)) openings_.owed[k] = -pending;
    }
}

//- What is given for the step that begins at t
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setOpenFaces(double t)
{
    const std::vector<double> phi = atOpenings(nullptr, &phi_);
    const int count = int(config_.openings.size());
    std::vector<double> area(count, 0.0), whole(count, 0.0);
    for (std::size_t k = 0; k < openings_.faces.size(); ++k)
    {
        OpenFace<D>& f = openings_.faces[k];
        const PicOpening& o = config_.openings[f.opening];
        const bool inflowLevel = o.kind != OpeningKind::level && o.level;
        f.filled = f.underSurface(phi[k]);
        f.wet = inflowLevel ? f.under(o.level(t)) : f.filled;
        area[f.opening] += f.wet*f.open*grid_.area();
        whole[f.opening] += f.open*grid_.area();
    }
    for (int k = 0; k < count; ++k)
        if (config_.openings[k].kind == OpeningKind::flowRate)
        {
            // through a dry opening the water falls: through all of it
            const double through = area[k] > 0 ? area[k] : whole[k];
            openings_.rate[k] = through > 0 ? config_.openings[k].flowRate(t)/through : 0;
            if (area[k] > 0) continue;
            for (OpenFace<D>& f : openings_.faces) if (f.opening == k) f.wet = 1;
        }
    openings_.open.clear();
    openings_.given.clear();
    openings_.leaves.clear();
    for (std::size_t k = 0; k < openings_.faces.size(); ++k)
    {
        const OpenFace<D>& f = openings_.faces[k];
        const PicOpening& o = config_.openings[f.opening];
        double w = 0;
        if (o.kind == OpeningKind::velocity) w = o.velocity(t)[config_.axes[f.direction]];
        else if (o.kind == OpeningKind::flowRate) w = f.inward(openings_.rate[f.opening]);
        // nothing flows through what lies above the level; where there is no water the value
        // continues that below
        const bool wet = phi[k] < -wetDepth*grid_.h;
        if (o.level && wet && !(f.wet > 0)) w = 0;
        const bool free = o.kind == OpeningKind::level;
        openings_.open.push_back(free ? real(f.open) : real(0));
        openings_.given.push_back(free ? real(0) : real(w*f.open));
        openings_.leaves.push_back(!free && f.inward(w) < 0);
    }
    writeOpenFaces();
}

//- Also after the walls were cut anew
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::writeOpenFaces()
{
    std::size_t from = 0;
    for (int d = 0; d < D; ++d)
    {
        const std::size_t count = openings_.face[d].size();
        if (!count || openings_.open.empty()) continue;
        const auto part = [&](const auto& all)
        { return std::decay_t<decltype(all)>(all.begin() + from, all.begin() + from + count); };
        openings_.buffer.upload(context_, part(openings_.open));
        openings_.second.upload(context_, part(openings_.given));
        openings_.flags.upload(context_, part(openings_.leaves));
        forEach(context_, int(count),
            SetOpenFaces<real>{openings_.face[d].data(), openings_.buffer.data(),
                openings_.second.data(), openings_.flags.data(), aperture_[d].data(),
                wallVelocity_[d].data(), openings_.gate[d].data()});
        from += count;
    }
}

//- By the water that stands beyond, in a kick of dt
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::pushOpenFaces(double dt)
{
    double g = 0;
    for (int d = 0; d < D; ++d) g += gravity_[d]*gravity_[d];
    std::size_t k = 0;
    for (int d = 0; d < D; ++d)
    {
        std::vector<real> push;
        for (; k < openings_.faces.size() && openings_.faces[k].direction == d; ++k)
        {
            const OpenFace<D>& f = openings_.faces[k];
            const PicOpening& o = config_.openings[f.opening];
            const double head = o.kind == OpeningKind::level
                ? std::max(0.0, o.level(clock_.time) - f.height)
                : 0;
            push.push_back(real(f.inward(2*dt*std::sqrt(g)*head/grid_.h)));
        }
        if (push.empty()) continue;
        openings_.buffer.upload(context_, push);
        forEach(context_, int(push.size()),
            PushOpenFaces<real>{openings_.face[d].data(), openings_.buffer.data(), u_[d].data()});
    }
}

//- Particles that have come in during the drift dt, with what the grid has for them
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::letIn(double dt)
{
    const std::vector<double> u = atOpenings(u_, nullptr);
    const int vertical = steepest(),
              perDirection = std::max(1, int(std::lround(grid_.h/particleSpacing())));
    std::vector<Vec<D, double>> places, velocities;
    std::vector<double> carried(openings_.owed.size(), 0.0), wet(openings_.owed.size(), 0.0);
    for (std::size_t k = 0; k < openings_.faces.size(); ++k)
    {
        OpenFace<D>& f = openings_.faces[k];
        const PicOpening& o = config_.openings[f.opening];
        const double along = o.kind == OpeningKind::level ? u[k] : (f.open > 0 ? u[k]/f.open : 0.0);
        const double area = f.filled*f.open*grid_.area();
        wet[f.opening] += area;
        carried[f.opening] += std::max(0.0, -f.inward(along))*area*dt;
        const std::size_t before = places.size();
        enter(f, grid_, f.inward(along), dt, clock_.particleVolume, perDirection, vertical,
            vertical >= 0 && gravity_[vertical] < 0, wallMargin*grid_.h, places);
        openings_.in[f.opening] += std::int64_t(places.size() - before);
        openings_.volume[f.opening] += double(places.size() - before)*clock_.particleVolume;
        Vec<D, double> v{};
        if (o.kind == OpeningKind::velocity && places.size() > before)
        {
            const Vector3 all = o.velocity(clock_.time);
            for (int d = 0; d < D; ++d) v.c[d] = all[config_.axes[d]];
        }
        else v.c[f.direction] = along;
        velocities.resize(places.size(), v);
    }
    for (std::size_t k = 0; k < carried.size(); ++k)
        balance<D>(openings_.owed[k], carried[k], wet[k]*grid_.h/perDirection);
    append(places, velocities);
}

//- Volume that has come in but not as particles yet, less what has gone out but not as particles;
//  -1: through all openings
template<class Backend, int D, class P>
double PicSolver<Backend, D, P>::openBalance(int opening) const
{
    double volume = 0;
    for (const OpenFace<D>& f : openings_.faces)
        if (opening < 0 || opening == f.opening) volume += f.kept;
    for (int k = 0; k < int(openings_.owed.size()); ++k)
        if (opening < 0 || opening == k) volume -= openings_.owed[k];
    return volume;
}

//- More particles, after the others
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::append(
    const std::vector<Vec<D, double>>& places, const std::vector<Vec<D, double>>& velocities)
{
    const int more = int(places.size()), first = n_;
    if (!more) return;
    reserve(std::size_t(n_) + more);
    std::vector<double> x(more);
    std::vector<real> v(more);
    std::vector<std::int32_t> id(more);
    const auto put = [&](int field, const auto& values)
    {
        context_.toDevice(set_.bytes(field) + std::size_t(first)*sizeof(values[0]), values.data(),
            values.size()*sizeof(values[0]));
    };
    for (int d = 0; d < D; ++d)
    {
        for (int i = 0; i < more; ++i) { x[i] = places[i].c[d]; v[i] = real(velocities[i].c[d]); }
        put(xField_ + d, x);
        put(vField_ + d, v);
    }
    for (int i = 0; i < more; ++i) { id[i] = std::int32_t(clock_.nextId++); v[i] = 0; }
    put(idField_, id);
    for (int k = 0; affineField_ >= 0 && k < D*D; ++k) put(affineField_ + k, v);
    for (int k = 0; k < fromFaces_.memory(); ++k) put(memoryField_ + k, v);
    if (config_.positionCorrection > 0)
        for (int d = 0; d < D; ++d) context_.zero(shift_[d].data() + first, more*sizeof(real));
    n_ += more;
    fromFaces_.enter(context_, gridVelocities(0), first, more);
}

//- Room for so many particles; those that there are stay
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::reserve(std::size_t count)
{
    if (count <= set_.size()) return;
    const std::size_t room = count + count/4;
    std::vector<std::vector<unsigned char>> kept(set_.fields());
    for (int k = 0; k < set_.fields(); ++k)
    {
        kept[k].resize(std::size_t(n_)*set_.elementBytes(k));
        if (n_) context_.toHost(kept[k].data(), set_.bytes(k), kept[k].size());
    }
    set_.allocate(context_, room);
    for (int k = 0; k < set_.fields(); ++k)
        if (n_) context_.toDevice(set_.bytes(k), kept[k].data(), kept[k].size());
    sort_.allocate(context_, room, grid_.cells());
    enlarge(place_, room);
    // this step's, which solids that run over particles still ask for
    if (config_.positionCorrection > 0) for (int d = 0; d < D; ++d) enlarge(shift_[d], room);
}

//- With what it holds
template<class Backend, int D, class P>
template<class T>
void PicSolver<Backend, D, P>::enlarge(Array<Backend, T>& array, std::size_t room)
{
    std::vector<T> kept = array.download();
    kept.resize(room);
    array.upload(context_, kept);
}

//- The opening through which a particle has left the block; -1: none
template<class Backend, int D, class P>
int PicSolver<Backend, D, P>::leftThrough(const Vec<D, double>& x) const
{
    typename UniformGrid<D>::Index at{{0, 0, 0}};
    int direction = -1;
    for (int d = 0; d < D; ++d)
    {
        const int c = floorInt(x.c[d]/grid_.h);
        at.c[d] = std::max(0, std::min(c, grid_.n[d] - 1));
        if (c == at.c[d]) continue;
        direction = d;
    }
    if (direction < 0) return -1;
    if (x.c[direction] > 0) at.c[direction] = grid_.n[direction];
    return openings_.number[direction][grid_.face(direction, at)];
}

//- The fastest that comes in at a time [m/s]
template<class Backend, int D, class P>
double PicSolver<Backend, D, P>::openingSpeed(double t) const
{
    double speed = 0;
    for (std::size_t k = 0; k < config_.openings.size(); ++k)
    {
        const PicOpening& o = config_.openings[k];
        if (o.kind == OpeningKind::flowRate) speed = std::max(speed, std::abs(openings_.rate[k]));
        if (o.kind != OpeningKind::velocity) continue;
        double v2 = 0;
        for (int d = 0; d < D; ++d) v2 += std::pow(o.velocity(t)[config_.axes[d]], 2);
        speed = std::max(speed, std::sqrt(v2));
    }
    return speed;
}

//- What a continued run must know: of each face the volume kept and whose turn it is, of each
//  opening what has passed
template<class Backend, int D, class P>
std::vector<double> PicSolver<Backend, D, P>::openingMemory() const
{
    std::vector<double> memory;
    for (const OpenFace<D>& f : openings_.faces)
    {
        memory.push_back(f.kept);
        memory.push_back(f.turn);
    }
    for (std::size_t k = 0; k < openings_.in.size(); ++k)
    {
        memory.push_back(double(openings_.in[k]));
        memory.push_back(double(openings_.out[k]));
        memory.push_back(openings_.volume[k]);
        memory.push_back(openings_.owed[k]);
    }
    return memory;
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setOpeningMemory(const double* memory)
{
    for (OpenFace<D>& f : openings_.faces) { f.kept = *memory++; f.turn = int(*memory++); }
    for (std::size_t k = 0; k < openings_.in.size(); ++k)
    {
        openings_.in[k] = std::int64_t(*memory++);
        openings_.out[k] = std::int64_t(*memory++);
        openings_.volume[k] = *memory++;
        openings_.owed[k] = *memory++;
    }
}

} // namespace riprap

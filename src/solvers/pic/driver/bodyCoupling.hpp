/*  Solids that move with the water. Nothing of this but solve() is called in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyTerm.hpp"
#include "pic/bodies/contactArea.hpp"
#include "pic/terms/viscosity.hpp"
#include "solvers/pic/driver/openBoundaries.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class BodyCoupling
{
public:

    using real = typename P::real;

    BodyCoupling(PicParts<Backend, D, P>& parts, OpenBoundaries<Backend, D, P>& openings)
    :
        p_(parts), openings_(openings)
    {}

    void set(bool inWater);
    void cutToWater();
    void useVelocities(bool predicted);
    PressureReport solve(
        const PressureFields<D, real>& fields, bool sameWater, double tolerance = 0);
    void project(double dt, bool sameWater);
    std::vector<double> gather(const double* pressure);
    void slowBetween(double dt);
    void setSolidVelocity();
    void drag(double dt);
    bool advance(double dt, double before);

private:

    bool yields() const;
    bool counts(int component, const typename UniformGrid<D>::Index& face) const;
    PressureReport solveOnRanks(
        const PressureFields<D, real>& fields, bool sameWater, double tolerance);

    PicParts<Backend, D, P>& p_;
    OpenBoundaries<Backend, D, P>& openings_;
    Array<Backend, int> contactBoxes_;
    Array<Backend, ContactArea<D>> contactAreas_;
};

template<class Backend, int D, class P>
void BodyCoupling<Backend, D, P>::set(bool inWater)
{
    if (!p_.inside.scene) return;
    p_.solids.side = dynamic_cast<SolidSide<D, P>*>(p_.inside.scene.get());
    if (!p_.solids.side)
        throw std::invalid_argument("solids of another dimension or precision than the fluid's");
    if (inWater) p_.solids.side->external();        // forces from outside are to come
    p_.solids.bodies = std::make_unique<PicBodies<D>>(
        p_.set.config, *p_.inside.solids, *p_.inside.scene);
    p_.cut.moves = true;
}

//- Where the surface cuts the volumes of faces, bodies have what is under water
template<class Backend, int D, class P> void BodyCoupling<Backend, D, P>::cutToWater()
{
    if (p_.solids.cut.cutToWater(p_.set.context, p_.surface.phi.data(), p_.cutFields()))
        p_.solids.rest = false;
}

//- The closed parts of faces move with bodies as predicted, or as in the step before
template<class Backend, int D, class P>
void BodyCoupling<Backend, D, P>::useVelocities(bool predicted)
{
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    const std::vector<double> velocity = solids.bodies->table.velocities(predicted);
    const bool rest = std::all_of(
        velocity.begin(), velocity.end(), [](double v) { return v == 0; });
    if (rest && solids.rest) return;
    solids.rest = rest;
    solids.cut.setVelocities(p_.set.context, velocity, p_.cutFields());
    if (p_.opens()) openings_.writeFaces();
}

//- Do bodies give way in the pressure's equation? Else they are walls for it, as where all sleep
template<class Backend, int D, class P> bool BodyCoupling<Backend, D, P>::yields() const
{
    return p_.solids.bodies && !p_.solids.bodies->set.weak && p_.solids.bodies->table.yield();
}

//- Light bodies bring slow modes, which a solver on the host takes away; it may also be the better
//  for knowing where walls stand (pic/bodies/hats.hpp)
template<class Backend, int D, class P>
PressureReport BodyCoupling<Backend, D, P>::solve(
    const PressureFields<D, real>& fields, bool sameWater, double tolerance)
{
    Context<Backend>& context = p_.set.context;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    PressureOfWater<Backend, D, P>& pressure = p_.pressure;
    if (p_.halo) return solveOnRanks(fields, sameWater, tolerance);
    const MultigridControls* own = pressure.solver.onDevice();
    if (!yields())
    {
        std::vector<BodyTerm> walls;
        if (solids.bodies && !own) walls = solids.cut.terms();
        for (BodyTerm& t : walls) t.modes = 0;
        return pressure.step.project(
            context, fields, pressure.solver, &walls, sameWater, &p_.rows, nullptr, tolerance);
    }
    const BodyTable<D>& table = solids.bodies->table;
    if (own
        && !table.anyLighter(solids.cut.volumes(),
            pressure.step.heavyFrom(table.bodies.size(), sameWater)*p_.set.config.density))
    {
        const std::vector<double> roots = solids.bodies->table.roots();
        const BodiesOnGrid<Backend, D> onGrid{solids.cut, roots};
        return pressure.step.project(
            context, fields, pressure.solver, nullptr, sameWater, &p_.rows, &onGrid, tolerance);
    }
    std::vector<BodyTerm> terms = solids.cut.terms();
    solids.bodies->table.fill(terms);
    return pressure.step.project(
        context, fields, pressure.solver, &terms, sameWater, &p_.rows, nullptr, tolerance);
}

//- Slow modes of light bodies cost iterations here: nothing takes them away
template<class Backend, int D, class P>
PressureReport BodyCoupling<Backend, D, P>::solveOnRanks(
    const PressureFields<D, real>& fields, bool sameWater, double tolerance)
{
    if (!yields()) return p_.projectOnRanks(fields, sameWater, tolerance);
    const std::vector<double> roots = p_.solids.bodies->table.roots();
    const BodiesOnGrid<Backend, D> onGrid{p_.solids.cut, roots};
    return p_.projectOnRanks(fields, sameWater, tolerance, &onGrid);
}

//- J^T p of all bodies, of all ranks
template<class Backend, int D, class P>
std::vector<double> BodyCoupling<Backend, D, P>::gather(const double* pressure)
{
    std::vector<double> sums = p_.solids.cut.gather(p_.set.context, pressure);
    if (p_.halo) addByRank(p_.halo->ranks(), sums);
    return sums;
}

//- The impulse by which particles are left ahead is known before
template<class Backend, int D, class P>
void BodyCoupling<Backend, D, P>::project(double dt, bool sameWater)
{
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    PressureOfWater<Backend, D, P>& pressure = p_.pressure;
    if (p_.set.config.reflection > 0)
        solids.bodies->forces.foresee(
            yields() ? gather(pressure.ahead.data()) : std::vector<double>());
    useVelocities(true);
    pressure.last = solve(p_.pressureFields(dt), sameWater);
    solids.bodies->forces.move(gather(pressure.p.data()), dt);
}

//- Of solids at the faces about their surfaces, as in the step before: bodies' rigid motion, else
//  that of the closed part of a face
template<class Backend, int D, class P>
void BodyCoupling<Backend, D, P>::setSolidVelocity()
{
    const UniformGrid<D>& grid = p_.set.grid;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    constexpr double about = 1.5;               // cells
    for (int component = 0; component < D; ++component)
    {
        std::vector<real> w = p_.walls.velocity[component].download();
        if (solids.bodies)
        {
            const auto moving = solids.bodies->table.withVelocities(false);
            std::vector<double> nearest(w.size(), about*grid.h);
            solids.bodies->table.eachFaceNear(grid, component, about,
                [&](int body, const typename UniformGrid<D>::Index& f, const Vec<D, double>& x)
                {
                    const int i = grid.face(component, f);
                    const double distance = moving[body].shape.distance(x);
                    if (!(distance < nearest[i])) return;
                    nearest[i] = distance;
                    double v = 0;
                    for (int m = 0; m < bodyModes<D>; ++m)
                        v += modeVelocity(m, component, x - moving[body].centre)
                            *moving[body].velocity[m];
                    w[i] = real(v);
                });
        }
        p_.cut.solidVelocity[component].upload(p_.set.context, w);
    }
}

//- Is a face this rank's to count?
template<class Backend, int D, class P>
bool BodyCoupling<Backend, D, P>::counts(
    int component, const typename UniformGrid<D>::Index& face) const
{
    if (!p_.halo) return true;
    typename UniformGrid<D>::Index f = face;
    for (int d = 0; d < D; ++d) f.c[d] += p_.set.grid.first[d];
    return p_.set.bricks->facesOfBrick(p_.halo->ranks().rank(), component).has(f.c);
}

//- What viscosity has taken from the water beside bodies in a step dt, they have got: across each
//  pair of faces of which one lies in the water and one in the body mu (u - w)/theta h^(D - 2)
template<class Backend, int D, class P>
void BodyCoupling<Backend, D, P>::drag(double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    const double stress = p_.set.config.viscosity*(D == 2 ? 1.0 : grid.h);
    solids.bodies->forces.startDrag();
    for (int component = 0; component < D; ++component)
    {
        const std::vector<real> u = p_.faces.u[component].download(),
                                w = p_.cut.solidVelocity[component].download();
        const std::vector<real> distance = p_.cut.faceDistance[component].download();
        const std::vector<unsigned char> layer = p_.faces.layer[component].download();
        const ViscousFaces<D, real> faces{
            grid, component, layer.data(), nullptr, false, distance.data(), w.data()};
        // the mean of a face's corners, by which faces are told, differs from the distance of its
        // middle by the bend of the surface
        solids.bodies->table.eachFaceNear(grid, component, 0.1,
            [&](int body, const typename UniformGrid<D>::Index& f, const Vec<D, double>& x)
            {
                const int i = grid.face(component, f);
                if (!faces.inSolid(i) || !counts(component, f)) return;
                for (int d = 0; d < D; ++d)
                    for (int offset = -1; offset <= 1; offset += 2)
                    {
                        typename UniformGrid<D>::Index at = f;
                        at.c[d] += offset;
                        if (at.c[d] < 0 || at.c[d] >= grid.layers(component, d)) continue;
                        const int j = grid.face(component, at);
                        if (!faces.open(j)) continue;
                        const real theta = faces.theta(j, i);
                        Vec<D, double> surface = x;
                        surface[d] += offset*(1 - theta)*grid.h;
                        solids.bodies->forces.drag(body, component,
                            stress*(double(u[j]) - faces.onSurface(j, i, theta))/theta,
                            surface);
                    }
            });
    }
    if (p_.halo)
    {
        std::vector<double> sums = solids.bodies->forces.drags();
        addByRank(p_.halo->ranks(), sums);
        solids.bodies->forces.setDrags(sums);
    }
    solids.bodies->forces.endDrag(dt, p_.set.config.viscosity, solids.cut.volumes());
}

//- Eq. 20
template<class Backend, int D, class P>
void BodyCoupling<Backend, D, P>::slowBetween(double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    const std::vector<ContactArea<D>> areas = solids.bodies->table.contacts(grid);
    if (areas.empty()) return;
    const ContactBoxes<D> boxes(p_.set.whole());
    std::vector<std::pair<int, int>> order;
    order.reserve(areas.size());
    for (int k = 0; k < int(areas.size()); ++k) order.push_back({boxes.number(areas[k].point), k});
    std::sort(order.begin(), order.end());
    std::vector<int> box;
    std::vector<ContactArea<D>> sorted;
    for (const auto& [b, k] : order)
    {
        box.push_back(b);
        sorted.push_back(areas[k]);
    }
    contactBoxes_.upload(context, box);
    contactAreas_.upload(context, sorted);
    SlowBetweenSolids<D, real> slow{grid, p_.particles.view(), boxes, int(box.size()),
        contactBoxes_.data(), contactAreas_.data(), solids.bodies->set.contactVelocity,
        solids.bodies->set.contactTimes(dt), {}};
    for (int d = 0; d < D; ++d)
        slow.u[d] = (p_.set.config.reflection > 0 ? p_.faces.after : p_.faces.u)[d].data();
    forEach(context, p_.particles.n, slow);
}

//- \return false when a guard of the solids has fired
template<class Backend, int D, class P>
bool BodyCoupling<Backend, D, P>::advance(double dt, double before)
{
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    const double from = p_.set.clock.time;
    if (!solids.bodies->forces.finite()) return false;
    // a clump feels a force from outside a step of its own later
    constexpr int leastOfClumps = 8;
    // K of paper 2, Eqs. 21 to 25
    const int steps = std::max(
        solids.side->subcycles(dt), solids.bodies->set.clumps ? leastOfClumps : 1);
    const double first = dt/steps;
    // leapfrog's velocities are behind by half the last step, and get the new force for it
    const double lag = solids.bodies->set.verlet
        ? 0
        : 2*(solids.side->kickTime(dt, steps) - dt) + first;
    solids.bodies->forces.push(before, lag, solids.side->kickTime(first, 1));
    if (!solids.side->advanceTo(steps == 1 ? from + dt : from + first, first, 1)) return false;
    solids.bodies->forces.hold();
    if (steps > 1 && !solids.side->advanceTo(from + dt, dt - first, steps - 1)) return false;
    solids.subcycles = steps;
    return true;
}

} // namespace riprap

/*  Solids in the water of a PIC scene, on the host: the rigid bodies that the particles and clumps
    of a DemScene are, what they are about to do when the pressure is solved, and what the water
    does to them.

    Velocities of the water stand half a step behind positions (leapfrog); so do those at which
    bodies displace it, W. With V the velocity at the time of the positions, F the water's force and
    G what else accelerates, of the step before (') and the one at hand,

        W* = V - dt'/2 F'/M + dt/2 (g + G),     W = W* + k F/M,     k = (dt' + dt)/2

    where W and F come from the pressure equation together (pic/bodies/bodyTerm.hpp; paper 2, Eqs. 5
    and 6); a body that then moves by dt under F + M (g + G) from V + dt'/2 (F - F')/M has W for its
    mean velocity: it goes where the water has made way for it. Weakly coupled, W = W* + k F'/M, and
    F is what the pressure about such walls does.

    G is the prediction for contacts. Paper 2 takes the force of the moment, over the whole step; a
    stiff collision, over in a small part of it, would hit the water many times as hard as the body.
    Here it is the smaller of that force and the mean over the step before, 0 where they do not
    agree in direction: contacts that last are foreseen, blows are not.

    Solids at rest sleep, where they may (dem/passes/sleep.hpp): the water sees them as walls, and
    they feel the force under which they fell asleep until the water's differs from it by what would
    set them in motion faster than v_s within the time after which they sleep. Who sleeps has
    velocity 0 to the bit, which nobody has who is pushed.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyShape.hpp"
#include "pic/bodies/contactArea.hpp"
#include "pic/bodies/bodyTerm.hpp"
#include "pic/bodies/freeBody.hpp"
#include "api/picScene.hpp"

namespace riprap
{

template<int D>
class PicBodies
{
public:

    static constexpr int modes = bodyModes<D>;
    using Modes = std::array<double, modes>;
    using Shape = BodyShape<D>;

    PicBodies(const PicConfig&, const PicSolids&, DemScene&);

    //- Where they are, how fast, and what acts on them. \return has any moved since the last call,
    //  or is about to?
    bool read();

    //- W* of a step dt that follows one of `before`
    void predict(double dt, double before);

    //- Those that are there
    const std::vector<FreeBody<D, Shape>>& bodies() const { return bodies_; }
    // else W of the step before
    std::vector<FreeBody<D, Shape>> withVelocities(bool predicted) const;
    // of all, one after the other: W*, or W of the step before less what was foreseen in it
    std::vector<double> velocities(bool predicted) const;
    void fill(std::vector<BodyTerm>&) const;                                // inverse masses and W*
    // L of each, M^-1 = L L^T
    std::vector<double> roots() const;
    bool anyLighter(const std::vector<double>& volume, double density) const;

    //- What follows is given J^T p of all, one after the other, for some p: W* with an impulse of
    //  the pressure that is known already [Pa s]. Empty: there is none
    void foresee(const std::vector<double>& against);

    //- W from W* and the pressure of a kick dt that was solved for
    void move(const std::vector<double>& against, double dt);

    //- F from the pressure
    void act(const std::vector<double>& against);

    //- Hands F to the solids; blow: [s] part of the change of F that is added for one kick of this
    //  length, 0: none
    void push(double before, double lag, double kick);
    void hold();

    bool empty() const { return bodies_.empty(); }
    // does any give way to the water? Else they are walls
    bool yield() const;
    bool verlet() const { return verlet_; }
    bool clumps() const { return clumps_; }
    bool weak() const { return weak_; }
    //- f(body, face, its middle) for the faces of a direction whose middle is no farther than so
    //  many cells from a body
    template<class F>
    void eachFaceNear(const UniformGrid<D>& grid, int component, double cells, const F& f) const
    {
        for (int b = 0; b < int(bodies_.size()); ++b)
        {
            int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
            for (int d = 0; d < D; ++d)
            {
                low[d] = std::max(0,
                    int(std::floor(
                        (bodies_[b].centre[d] - bodies_[b].reach - grid.origin[d])/grid.h
                        - cells))
                        - 1);
                high[d] = std::min(grid.layers(component, d) - 1,
                    int(std::ceil(
                        (bodies_[b].centre[d] + bodies_[b].reach - grid.origin[d])/grid.h
                        + cells))
                        + 1);
            }
            typename UniformGrid<D>::Index at{{0, 0, 0}};
            for (at.c[2] = low[2]; at.c[2] <= high[2]; ++at.c[2])
                for (at.c[1] = low[1]; at.c[1] <= high[1]; ++at.c[1])
                    for (at.c[0] = low[0]; at.c[0] <= high[0]; ++at.c[0])
                    {
                        Vec<D, double> x;
                        for (int d = 0; d < D; ++d)
                            x[d] = grid.origin[d]
                                + grid.h*(at.c[d] + (d == component ? 0.0 : 0.5));
                        if (bodies_[b].shape.distance(x) < cells*grid.h) f(b, at, x);
                    }
        }
    }

    //- Viscous forces on bodies, added up, and then what they do to W*. The grid's viscosity is mu
    //  lap u, the stress mu (grad u + grad u^T): the second term does nothing within the water, and
    //  on a body that turns it is the moment -2 mu V w, whatever its shape
    void startDrag();
    void drag(int body, int component, double force, const Vec<D, double>& at);
    void endDrag(double dt, double viscosity, const std::vector<double>& volume);

    double fastest() const;                     // [m/s], the turning surface's
    // does one reach across a periodic side? The grid would see a part of it alone
    bool acrossPeriodic(const UniformGrid<D>&) const;
    bool finite() const { return finite_; }     // is the water's force on all of them a number?
    double contactVelocity() const { return beta_; }
    // how many of those that beta is meant for are in dt
    double contactTimes(double dt) const { return betaTime_ > 0 ? dt/betaTime_ : 1; }
    std::vector<ContactArea<D>> contacts(const UniformGrid<D>&) const;
    Vector3 force() const;                      // of the water on all of them [N]
    std::vector<FluidForce> forces() const;     // on each, at its centre of mass

    //- For a saved state
    std::vector<double> memory() const;
    bool setMemory(const std::vector<double>&);

private:

    struct Body
    {
        std::vector<int> ids;
        int clump = -1, group = 0, shape = -1;
        double mass = 0;
        Vec<3, double> inertia{{0, 0, 0}};      // principal; 2D: the last
    };

    //- Of a body between two steps
    //  given: to the solid, last; drag: of force; ahead: of middle, what foresee() has added
    struct Memory
    {
        Modes force{}, old{}, start{}, middle{}, given{}, drag{}, ahead{};
        bool begun = false;
    };

    //- Of those that are there
    struct Now
    {
        int body = 0;
        Modes velocity{}, total{}, predicted{}, moved{}, drag{};
        std::array<double, modes*modes> inverse{};
        // from the centre to the particle that carries the force
        Vec<3, double> arm{{0, 0, 0}};
        bool asleep = false;
    };

    Modes times(const Now& n, const Modes& force) const;
    void setInverse(Now&, const double* orientation, const Vec<D, double>& centre) const;
    void directions(const DemGroup&, double along[D][D]) const;
    Modes axisOf(const Now&, const double* orientation, double& about) const;
    void setHinge(Now&, const double* orientation, const Vec<D, double>& centre) const;
    SampledShape<D> placed(
        int shape, const Vec<D, double>& centre, const double* orientation) const;
    Modes modesOf(const double* vector, const double* turn) const;
    Modes gravityOf(const Now&) const;
    double spinSign() const;
    std::vector<double> forces_, moments_;
    void put(const Now&, const Modes& force);
    bool sleeps(const Now&) const;
    bool stirred(const Now&) const;
    void send();

    int axes_[3];
    double gravity_[D];
    DemScene& scene_;
    std::vector<DemGroup> groups_;
    GroupMotion motion_;
    std::vector<Body> all_;
    std::vector<Memory> memory_;
    std::vector<Now> now_;
    std::vector<FreeBody<D, Shape>> bodies_;
    bool verlet_ = false, clumps_ = false, weak_ = false, finite_ = true;
    double beta_ = 1, betaTime_ = 0;
    std::vector<PicShape> shapes_;
    // [m/s2] change of acceleration that wakes; 0: nobody sleeps
    double stir_ = 0;
    std::vector<Ball<D>> ballOfId_;
    std::vector<SampledShape<D>> unplaced_;     // of shapes_
    std::vector<double> reachOf_;
    int largestId_ = 0;
};

} // namespace riprap

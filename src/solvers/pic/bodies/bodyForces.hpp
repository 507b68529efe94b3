/*  How bodies are about to move, what the pressure does to them, and what of it is handed to the
    solids.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/bodies/bodyTable.hpp"

namespace riprap
{

template<int D>
class BodyForces
{
public:

    static constexpr int modes = bodyModes<D>;
    using Modes = typename BodyTable<D>::Modes;
    using Body = typename BodyTable<D>::Body;
    using Memory = typename BodyTable<D>::Memory;
    using Now = typename BodyTable<D>::Now;

    BodyForces(const BodySetting<D>&, BodyTable<D>&);

    //- W* of a step dt that follows one of `before`
    void predict(double dt, double before);

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

    //- Viscous forces on bodies, added up, and then what they do to W*. The grid's viscosity is mu
    //  lap u, the stress mu (grad u + grad u^T): the second term does nothing within the water, and
    //  on a body that turns it is the moment -2 mu V w, whatever its shape
    void startDrag();
    //- What has been added up, modes values a body: of several ranks each has its share
    std::vector<double> drags() const;
    void setDrags(const std::vector<double>&);
    void drag(int body, int component, double force, const Vec<D, double>& at);
    void endDrag(double dt, double viscosity, const std::vector<double>& volume);

    bool finite() const { return finite_; }     // is the water's force on all of them a number?
    Vector3 force() const;                      // of the water on all of them [N]
    std::vector<FluidForce> forces() const;     // on each, at its centre of mass

    //- For a saved state
    std::vector<double> memory() const;
    bool setMemory(const std::vector<double>&);

private:

    void put(const Now&, const Modes& force);
    bool stirred(const Now&) const;
    void send();

    const BodySetting<D>& set_;
    BodyTable<D>& table_;
    std::vector<double> forces_, moments_;
    bool finite_ = true;
};

} // namespace riprap

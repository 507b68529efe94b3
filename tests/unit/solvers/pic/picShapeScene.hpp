/*  Scenes of PIC with a rigid body whose shape is a lattice of distances.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "picSolidScene.hpp"

namespace riprap
{

//- In a box of these half sides about the centre of mass, and a margin
template<class Distance>
PicShape shapeOf(
    int dimensions, const Vector3& half, double step, double margin, const Distance& distance)
{
    PicShape s;
    s.name = "shape";
    s.step = step;
    for (int d = 0; d < dimensions; ++d)
    {
        s.n[d] = int(2*(half[d] + margin)/step) + 2;
        s.lower[d] = -0.5*step*(s.n[d] - 1);
    }
    for (int k = 0; k < s.n[2]; ++k)
        for (int j = 0; j < s.n[1]; ++j)
            for (int i = 0; i < s.n[0]; ++i)
                s.distance.push_back(distance(s.lower[0] + i*step, s.lower[1] + j*step,
                    dimensions == 3 ? s.lower[2] + k*step : 0));
    return s;
}

class PicShapeScene : public PicSolidScene
{
protected:

    //- One body of a shape, with a small ball at its centre for contacts. turn: about the third
    //  axis
    std::shared_ptr<PicSolids> body(const PicConfig& c, const Vector3& at, const PicShape& shape,
        double mass, double inertia, double turn = 0) const
    {
        auto s = balls(c, {at}, 0.02, 1000);
        s->input.particles.clump = {0};
        s->shapes = {shape};
        DemClump k;
        k.position = at;
        k.mass = mass;
        k.inertia = {{inertia, inertia, inertia}};
        k.orientation = {{std::cos(0.5*turn), 0, 0, std::sin(0.5*turn)}};
        k.shape = 0;
        s->input.clumps = {k};
        return s;
    }
};

} // namespace riprap

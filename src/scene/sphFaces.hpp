/*  SphSolver: the faces of its walls. Nothing of this is called in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "scene/sphSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setFaces(const WallFaceInput& in)
{
    if (!in.size()) return;
    std::vector<FaceElement<D>> elements(in.size());
    for (std::size_t i = 0; i < in.size(); ++i)
    {
        FaceElement<D>& e = elements[i];
        double length2 = 0;
        for (int d = 0; d < D; ++d)
        {
            e.normal.c[d] = in.normal[3*i + config_.axes[d]];
            length2 += e.normal.c[d]*e.normal.c[d];
            for (int c = 0; c < D; ++c) e.v[c].c[d] = in.point[3*std::size_t(in.vertex[3*i + c]) + config_.axes[d]];
        }
        for (double& n : e.normal.c) n /= std::sqrt(length2);
        e.group = 1 + in.body[i];
        e.part = in.part[i];
        e.half = in.halfThickness[i];
    }
    std::vector<bool> moves(1 + nBodies_, true);
    moves[0] = false;
    const FaceTables<D> tables(std::move(elements), config_.spacing, moves);
    faces_.vertex.upload(context_, tables.vertex);
    faces_.normal.upload(context_, tables.normal);
    faces_.half.upload(context_, tables.half);
    faces_.part.upload(context_, tables.part);
    faces_.cellFirst.upload(context_, tables.cellFirst);
    faces_.cellElement.upload(context_, tables.cellElement);
    faces_.cellFirstPlane.upload(context_, tables.cellFirstPlane);
    faces_.plane.upload(context_, tables.plane);
    faces_.grid.upload(context_, tables.grid);
    faces_.pose.allocate(context_, moves.size());
    faces_.tiny = tables.tiny();
}

template<class Backend, int D, class P>
FaceContact<D, P> SphSolver<Backend, D, P>::faceContact()
{
    FaceContact<D, P> contact{};
    const int groups = int(faces_.grid.size());
    if (!groups) return contact;
    contact.faces = WallFaces<D>{faces_.vertex.data(), faces_.normal.data(), faces_.half.data(), faces_.part.data(),
        faces_.cellFirst.data(), faces_.cellElement.data(), faces_.cellFirstPlane.data(), faces_.plane.data(), faces_.grid.data(),
        faces_.pose.data(), groups, faces_.tiny};
    contact.clearance = 1e-6*config_.spacing;
    return contact;
}

//- Where the faces that move are at the end of the step
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::moveFaces()
{
    if (!nBodies_ || !faces_.grid.size()) return;
    PoseFaces<D, PoseTable> pose{PoseTable{poses_.data(), poseIntervals, poseBegin_, poseStep_}, {}, faces_.pose.data(), clock_.data()};
    for (int d = 0; d < 3; ++d) pose.axes[d] = config_.axes[d];
    forEach(context_, nBodies_, pose);
}

} // namespace riprap

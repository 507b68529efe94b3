/*  SphSolver: the faces of its walls and of rigid bodies in the fluid. Nothing of this is called in
    a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

namespace detail
{

//- Those of walls, or of bodies behind them
template<int D>
void addFaces(
    const WallFaceInput& in, const int* axes, int firstGroup, std::vector<FaceElement<D>>& elements)
{
    for (std::size_t i = 0; i < in.size(); ++i)
    {
        FaceElement<D> e;
        double length2 = 0;
        for (int d = 0; d < D; ++d)
        {
            e.normal.c[d] = in.normal[3*i + axes[d]];
            length2 += e.normal.c[d]*e.normal.c[d];
            for (int c = 0; c < D; ++c)
                e.v[c].c[d] = in.point[3*std::size_t(in.vertex[3*i + c]) + axes[d]];
        }
        for (double& n : e.normal.c) n /= std::sqrt(length2);
        e.group = firstGroup + in.body[i];
        e.part = in.part[i];
        e.half = in.halfThickness[i];
        elements.push_back(e);
    }
}

} // namespace detail

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setFaces(const WallFaceInput& in, const SolidPart& solids)
{
    if (!in.size() && !solids.faces.size()) return;
    const int bodies = solids.faces.size() ? solids.clumps : 0;
    std::vector<FaceElement<D>> elements;
    detail::addFaces(in, config_.axes, 1, elements);
    detail::addFaces(solids.faces, config_.axes, 1 + nBodies_, elements);
    std::vector<bool> moves(1 + nBodies_ + bodies, true);
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
    if (bodies) setBodies(solids);
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setBodies(const SolidPart& solids)
{
    std::vector<bool> has(solids.clumps, false);
    for (const std::int32_t body : solids.faces.body) has[body] = true;
    std::vector<int> group(solids.volume.size(), -1);
    for (std::size_t k = 0; k < solids.clump.size(); ++k)
        if (solids.clump[k] >= 0 && has[solids.clump[k]]) group[k] = 1 + nBodies_ + solids.clump[k];
    faces_.groupOfKey.upload(context_, group);
    faces_.blow.upload(
        context_, std::vector<FaceBlow>(solids.clumps, FaceBlow{{0, 0, 0}, {0, 0, 0}}));
    // on or behind a face there is a member within its radius and a spacing; either may have moved
    // by a skin since members were sorted
    const double growth = config_.variableSmoothing ? config_.maxSmoothingGrowth : 1;
    const double support = supportOf(config_)*growth;
    faces_.reach = solids.largestRadius + config_.spacing + double(grid_.radius) - support;
}

template<class Backend, int D, class P>
FaceContact<D, P> SphSolver<Backend, D, P>::faceContact()
{
    FaceContact<D, P> contact{};
    const int groups = int(faces_.grid.size() - faces_.blow.size());
    if (!groups) return contact;
    contact.faces = WallFaces<D>{faces_.vertex.data(), faces_.normal.data(), faces_.half.data(),
        faces_.part.data(), faces_.cellFirst.data(), faces_.cellElement.data(),
        faces_.cellFirstPlane.data(), faces_.plane.data(), faces_.grid.data(), faces_.pose.data(),
        groups, faces_.tiny};
    contact.clearance = 1e-6*config_.spacing;
    if (faces_.blow.size() && solidsMeet_)
        contact.bodies = BodyContact<D, P>{solidSort_.start(), grid_, solidSort_.order(),
            faces_.groupOfKey.data(), real(faces_.reach), groups, faces_.blow.data()};
    return contact;
}

//- Where the faces that move are at the end of the step
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::moveFaces()
{
    if (!faces_.grid.size()) return;
    if (nBodies_)
    {
        PoseFaces<D, PoseTable> pose{PoseTable{poses_.data(), poseIntervals, poseBegin_, poseStep_},
            {}, faces_.pose.data(), clock_.data()};
        for (int d = 0; d < 3; ++d) pose.axes[d] = config_.axes[d];
        forEach(context_, nBodies_, pose);
    }
    if (faces_.blow.size())
        forEach(context_, int(faces_.blow.size()),
            PoseBodies<D, P>{solids_->bodies(), faces_.pose.data() + 1 + nBodies_});
}

//- Bodies get what their faces took from the fluid in this step's drift
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::blowBodies()
{
    if (faces_.blow.size() && solidsMeet_)
        forEach(context_, int(faces_.blow.size()),
            BlowBodies<D, P>{solids_->bodies(), faces_.blow.data(), double(model_.mass)});
}

} // namespace riprap

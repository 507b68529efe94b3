/*  Faces of walls and of rigid bodies in the fluid, through which no particle goes.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/bodyFaces.hpp"
#include "solvers/sph/parts/coupledSolids.hpp"
#include "sph/boundary/faceContact.hpp"
#include "sph/boundary/faceTables.hpp"

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

//- Their tables on the device; empty without faces
template<class Backend, int D, class P>
class FaceArrays
{
public:

    using real = typename P::real;

    explicit FaceArrays(SphSetting<Backend, D, P>& set) : set_(set) {}

    //- Of walls, of which so many groups move, and of bodies
    void set(const WallFaceInput&, const SolidPart&, int movingWalls);

    //- What keeps the fluid out of them; nothing without faces. solids: those in the fluid
    FaceContact<D, P> contact(CoupledSolids<Backend, D, P>& solids);

    bool any() const { return grid_.size() > 0; }
    int bodies() const { return int(blow_.size()); }
    FacePose<D>* pose() { return pose_.data(); }
    FaceBlow* blow() { return blow_.data(); }

    std::size_t bytes() const
    {
        return vertex_.bytes() + normal_.bytes() + half_.bytes() + part_.bytes()
            + cellFirst_.bytes() + cellElement_.bytes() + cellFirstPlane_.bytes() + plane_.bytes()
            + grid_.bytes() + pose_.bytes() + groupOfKey_.bytes() + blow_.bytes();
    }

private:

    void setBodies(const SolidPart&, int movingWalls);

    SphSetting<Backend, D, P>& set_;
    Array<Backend, double> vertex_, normal_, half_, plane_;
    Array<Backend, int> part_, cellFirst_, cellElement_, cellFirstPlane_;
    Array<Backend, FaceGrid<D>> grid_;
    Array<Backend, FacePose<D>> pose_;
    double tiny_ = 0;
    Array<Backend, int> groupOfKey_;            // of solids
    Array<Backend, FaceBlow> blow_;             // of bodies
    double reach_ = 0;                          // [m] from a face of a body to a point of it
};

template<class Backend, int D, class P>
void FaceArrays<Backend, D, P>::set(
    const WallFaceInput& in, const SolidPart& solids, int movingWalls)
{
    if (!in.size() && !solids.faces.size()) return;
    const int bodies = solids.faces.size() ? solids.clumps : 0;
    std::vector<FaceElement<D>> elements;
    detail::addFaces(in, set_.config.axes, 1, elements);
    detail::addFaces(solids.faces, set_.config.axes, 1 + movingWalls, elements);
    std::vector<bool> moves(1 + movingWalls + bodies, true);
    moves[0] = false;
    const FaceTables<D> tables(std::move(elements), set_.config.spacing, moves);
    vertex_.upload(set_.context, tables.vertex);
    normal_.upload(set_.context, tables.normal);
    half_.upload(set_.context, tables.half);
    part_.upload(set_.context, tables.part);
    cellFirst_.upload(set_.context, tables.cellFirst);
    cellElement_.upload(set_.context, tables.cellElement);
    cellFirstPlane_.upload(set_.context, tables.cellFirstPlane);
    plane_.upload(set_.context, tables.plane);
    grid_.upload(set_.context, tables.grid);
    pose_.allocate(set_.context, moves.size());
    tiny_ = tables.tiny();
    if (bodies) setBodies(solids, movingWalls);
}

template<class Backend, int D, class P>
void FaceArrays<Backend, D, P>::setBodies(const SolidPart& solids, int movingWalls)
{
    std::vector<bool> has(solids.clumps, false);
    for (const std::int32_t body : solids.faces.body) has[body] = true;
    std::vector<int> group(solids.volume.size(), -1);
    for (std::size_t k = 0; k < solids.clump.size(); ++k)
        if (solids.clump[k] >= 0 && has[solids.clump[k]])
            group[k] = 1 + movingWalls + solids.clump[k];
    groupOfKey_.upload(set_.context, group);
    blow_.upload(
        set_.context, std::vector<FaceBlow>(solids.clumps, FaceBlow{{0, 0, 0}, {0, 0, 0}}));
    // on or behind a face there is a member within its radius and a spacing; either may have moved
    // by a skin since members were sorted
    const double growth = set_.config.variableSmoothing ? set_.config.maxSmoothingGrowth : 1;
    const double support = supportOf(set_.config)*growth;
    reach_ = solids.largestRadius + set_.config.spacing + double(set_.grid.radius) - support;
}

template<class Backend, int D, class P>
FaceContact<D, P> FaceArrays<Backend, D, P>::contact(CoupledSolids<Backend, D, P>& solids)
{
    FaceContact<D, P> contact{};
    const int groups = int(grid_.size() - blow_.size());
    if (!groups) return contact;
    contact.faces = WallFaces<D>{vertex_.data(), normal_.data(), half_.data(), part_.data(),
        cellFirst_.data(), cellElement_.data(), cellFirstPlane_.data(), plane_.data(), grid_.data(),
        pose_.data(), groups, tiny_};
    contact.clearance = 1e-6*set_.config.spacing;
    if (blow_.size() && solids.meetFluid)
        contact.bodies = BodyContact<D, P>{solids.sort.start(), set_.grid, solids.sort.order(),
            groupOfKey_.data(), real(reach_), groups, blow_.data()};
    return contact;
}

} // namespace riprap

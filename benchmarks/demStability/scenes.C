/*  SPDX-License-Identifier: GPL-3.0-or-later */
#include "scenes.hpp"

#include <cmath>

namespace riprap
{

namespace
{

// of the lattice along each axis: the domain must be some search radii long
constexpr int cells = 6;

} // namespace

LatticePoints latticePoints(Lattice lattice, double overlap)
{
    const double s = 2 - overlap, root2 = std::sqrt(2.0), root3 = std::sqrt(3.0);
    LatticePoints p;
    const auto add = [&](double x, double y, double z) {
        p.position.insert(p.position.end(), {x, y, z});
    };
    p.dimensions = lattice == Lattice::cubic || lattice == Lattice::closePacked ? 3 : 2;
    const int n = lattice == Lattice::chain ? 2*cells : cells;
    for (int i = 0; i < n; ++i)
    {
        if (lattice == Lattice::chain) { add(s*(i + 0.25), 0, 0); continue; }
        for (int j = 0; j < n; ++j)
        {
            if (lattice == Lattice::square) add(s*(i + 0.25), s*(j + 0.25), 0);
            if (lattice == Lattice::hexagonal)
                add(s*(i + 0.25 + 0.5*(j % 2)), s*root3/2*(j + 0.25), 0);
            if (p.dimensions == 3)
                for (int k = 0; k < n; ++k)
                {
                    if (lattice == Lattice::cubic) add(s*(i + 0.25), s*(j + 0.25), s*(k + 0.25));
                    else if ((i + j + k) % 2 == 0)
                        add(s/root2*(i + 0.25), s/root2*(j + 0.25), s/root2*(k + 0.25));
                }
        }
    }
    const double edge = n*s;
    p.size = Vector3{{edge, edge, edge}};
    if (lattice == Lattice::chain) p.size = Vector3{{edge, 16, 16}};
    if (lattice == Lattice::hexagonal) p.size[1] = edge*root3/2;
    if (lattice == Lattice::closePacked) p.size = Vector3{{edge/root2, edge/root2, edge/root2}};
    return p;
}

void singleScene(DemConfig& c, DemInput& in)
{
    c = DemConfig();
    in = DemInput();
    c.device = DeviceKind::cpu;
    c.precision = PrecisionKind::doubled;
    c.domainMin = Vector3{{-200, -50, -50}};
    c.domainMax = Vector3{{200, 50, 50}};
    c.normal = "linear";
    c.tangential = "none";
    c.allowLargeStep = true;
    in.materials.push_back(DemMaterial{"unit", 1, 0.25});
    DemPair p;
    p.properties.normalStiffness = 1;
    in.pairs.push_back(p);
}

void addBody(DemInput& in, Vector3 x, Vector3 v, int group)
{
    DemParticles& p = in.particles;
    p.position.insert(p.position.end(), x.begin(), x.end());
    p.velocity.insert(p.velocity.end(), v.begin(), v.end());
    p.spin.insert(p.spin.end(), 3, 0.0);
    p.radius.push_back(1);
    p.mass.push_back(1);
    p.group.push_back(group);
}

void addFloor(DemInput& in, double height, Vector3 normal)
{
    DemWall w;
    w.name = "plane";
    w.plane = true;
    w.point = Vector3{{0, 0, height}};
    w.normal = normal;
    in.walls.push_back(w);
}

void latticeScene(const LatticeOptions& o, DemConfig& c, DemInput& in)
{
    singleScene(c, in);
    const LatticePoints points = latticePoints(o.lattice, o.bonded ? 0 : o.overlap);
    c.dimensions = points.dimensions;
    const bool chain = o.lattice == Lattice::chain;
    // bonds do not reach across periodic sides: bonded lattices end there
    if (!o.bonded)
    {
        c.domainMin = Vector3{{0, chain ? -8.0 : 0, c.dimensions == 2 ? -8.0 : 0}};
        for (int d = 0; d < 3; ++d)
        {
            c.periodic[d] = d < (chain ? 1 : c.dimensions);
            c.domainMax[d] = c.domainMin[d] + points.size[d];
        }
    }
    c.normal = o.normal;
    if (o.tangential) c.tangential = "history";
    PairProperties& p = in.pairs[0].properties;
    p.friction = o.tangential ? 1e6 : 0;
    p.stiffnessRatio = o.tangential ? o.stiffnessRatio : -1;
    p.restitution = o.restitution;
    if (o.normal == "hertz")
    {
        // tangent stiffness 1 at rest: 2 E* sqrt(R* overlap), with E* = E/(2 (1 - nu^2)) of two
        // alike, R* = 1/2
        in.materials[0].poisson = 0;
        in.materials[0].young = 1/std::sqrt(0.5*o.overlap);
        p.youngA = p.youngB = in.materials[0].young;
        p.poissonA = p.poissonB = 0;
    }
    for (std::size_t i = 0; i < points.position.size()/3; ++i)
        addBody(in,
            Vector3{
                {points.position[3*i], points.position[3*i + 1], points.position[3*i + 2]}});
    if (!o.bonded) return;
    DemBondType type;                           // kn A = 1
    const double area = c.dimensions == 2 ? 2 : 3.14159265358979323846;
    type.normalStiffness = 1/area;
    type.shearStiffness = o.stiffnessRatio/area;
    in.bondTypes.push_back(type);
    in.bonds = bondsWithin(c, in.particles, 0, 1e-6);
}

} // namespace riprap

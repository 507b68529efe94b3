#include "columnScene.hpp"

#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

namespace riprap
{

namespace
{

constexpr double diameter = 0.01, density = 2500, period = 30*diameter;

std::vector<double> readBed(const std::string& file)
{
    std::FILE* in = popen(("gzip -dc '" + file + "'").c_str(), "r");
    if (!in) throw std::runtime_error("cannot read " + file);
    std::vector<double> x;
    double value;
    while (std::fscanf(in, "%lf", &value) == 1) x.push_back(value);
    if (pclose(in) != 0 || x.empty()) throw std::runtime_error("cannot read " + file);
    return x;
}

//- A rectangle of two triangles
DemWall rectangle(const Vector3& corner, const Vector3& a, const Vector3& b)
{
    DemWall w;
    for (int k = 0; k < 4; ++k)
        for (int d = 0; d < 3; ++d) w.vertices.push_back(corner[d] + (k & 1 ? a[d] : 0) + (k & 2 ? b[d] : 0));
    w.elements = {0, 1, 3, 0, 3, 2};
    return w;
}

} // namespace

void columnScene(const std::string& bed, const ColumnOptions& o, DemConfig& c, DemInput& in)
{
    const double width = period*o.copies;
    c.dimensions = 3;
    c.domainMin = Vector3{{-0.001, 0, -0.001}};
    c.domainMax = Vector3{{1.8, width, 0.6}};
    c.periodic[1] = true;
    c.gravity = Vector3{{0, 0, -9.81}};
    c.normal = NormalKind::hertz;
    c.tangential = TangentialKind::history;
    c.rolling = o.rolling ? RollingKind::spring : RollingKind::none;
    c.timeStep = 2e-5;

    in.materials.push_back(DemMaterial{"stone", 1e7, 0.25});
    DemPair pair;
    pair.properties.restitution = 0.7;
    pair.properties.friction = 0.5;
    pair.properties.rollingFriction = o.rolling ? 0.1 : 0;
    pair.properties.rollingDamping = 0.1;
    in.pairs.push_back(pair);

    const std::vector<double> x = readBed(bed);
    const std::size_t each = x.size()/3, n = each*o.copies;
    DemParticles& p = in.particles;
    p.position.resize(3*n);
    p.radius.resize(n);
    p.mass.resize(n);
    // the same sizes in every copy
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<double> radius(each, 0.5*diameter);
    if (o.sizeRatio > 1) for (double& r : radius) r *= std::pow(o.sizeRatio, -u(engine));
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t from = i % each;
        const double r = radius[from];
        for (int d = 0; d < 3; ++d) p.position[3*i + d] = x[3*from + d] + (d == 1 ? period*double(i/each) : 0);
        p.radius[i] = r;
        p.mass[i] = density*4.0/3*M_PI*r*r*r;
    }
    if (o.triangles)
    {
        // past the period on both sides: surfaces are not repeated
        const double past = 2*diameter;
        in.walls.push_back(rectangle({{-0.001, -past, 0}}, {{2, 0, 0}}, {{0, width + 2*past, 0}}));
        in.walls.push_back(rectangle({{0, -past, -0.001}}, {{0, width + 2*past, 0}}, {{0, 0, 0.7}}));
    }
    else
        for (const int d : {2, 0})
        {
            DemWall w;
            w.plane = true;
            w.normal = Vector3{{0, 0, 0}};
            w.normal[d] = 1;
            in.walls.push_back(w);
        }
    in.walls[0].name = "floor";
    in.walls[1].name = "back";
}

void bondedScene(int side, DemConfig& c, DemInput& in)
{
    const double r = 0.5*diameter, wave = 0.05;
    c.dimensions = 3;
    for (int d = 0; d < 3; ++d) { c.domainMin[d] = -0.1*side*diameter; c.domainMax[d] = 1.1*side*diameter; }
    c.normal = NormalKind::linear;
    c.tangential = TangentialKind::none;
    c.stepFraction = 0.1;
    in.materials.push_back(DemMaterial{"cement", 1e7, 0.25});
    DemPair pair;
    pair.properties.normalStiffness = 1e4;
    in.pairs.push_back(pair);
    DemBondType bond;
    bond.normalStiffness = 1e9;
    bond.shearStiffness = 4e8;
    in.bondTypes.push_back(bond);
    const std::size_t n = std::size_t(side)*side*side;
    DemParticles& p = in.particles;
    p.position.resize(3*n);
    p.velocity.resize(3*n);
    p.radius.assign(n, r);
    p.mass.assign(n, density*4.0/3*M_PI*r*r*r);
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t at[3] = {i % side, i/side % side, i/side/side};
        for (int d = 0; d < 3; ++d)
        {
            p.position[3*i + d] = (double(at[d]) + 0.5)*diameter;
            p.velocity[3*i + d] = wave*std::cos(2*M_PI*double(at[d])/side);
        }
    }
    const std::size_t stride[3] = {1, std::size_t(side), std::size_t(side)*side};
    for (std::size_t i = 0; i < n; ++i)
        for (int d = 0; d < 3; ++d)
            if (i/stride[d] % side + 1 < std::size_t(side))
            {
                in.bonds.a.push_back(std::int32_t(i));
                in.bonds.b.push_back(std::int32_t(i + stride[d]));
            }
}

} // namespace riprap

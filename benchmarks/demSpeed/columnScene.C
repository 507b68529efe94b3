// SPDX-License-Identifier: GPL-3.0-or-later

#include "columnScene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

namespace riprap
{

namespace
{

constexpr double diameter = 0.01, density = 2500, period = 30*diameter;

//- Lines of x y z, or of x y z r
struct Bed
{
    std::vector<double> position, radius;

    explicit Bed(const std::string& file)
    {
        std::FILE* in = popen(("gzip -dc '" + file + "'").c_str(), "r");
        if (!in) throw std::runtime_error("cannot read " + file);
        char line[256];
        int columns = 0;
        while (std::fgets(line, sizeof line, in))
        {
            double v[4];
            const int read = std::sscanf(line, "%lf %lf %lf %lf", v, v + 1, v + 2, v + 3);
            if (!columns) columns = read;
            if (read != columns || read < 3)
            {
                pclose(in);
                throw std::runtime_error(file + " has a line that is not x y z [r]");
            }
            position.insert(position.end(), v, v + 3);
            radius.push_back(read > 3 ? v[3] : 0.5*diameter);
        }
        if (pclose(in) != 0 || radius.empty()) throw std::runtime_error("cannot read " + file);
    }
};

//- A rectangle of two triangles
DemWall rectangle(const Vector3& corner, const Vector3& a, const Vector3& b)
{
    DemWall w;
    for (int k = 0; k < 4; ++k)
        for (int d = 0; d < 3; ++d)
            w.vertices.push_back(corner[d] + (k & 1 ? a[d] : 0) + (k & 2 ? b[d] : 0));
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
    c.normal = "hertz";
    c.tangential = "history";
    c.rolling = o.rolling ? "spring" : "none";
    in.materials.push_back(DemMaterial{"stone", 1e7, 0.25});
    DemPair pair;
    pair.properties.restitution = 0.7;
    pair.properties.friction = 0.5;
    pair.properties.rollingFriction = o.rolling ? 0.1 : 0;
    pair.properties.rollingDamping = 0.1;
    in.pairs.push_back(pair);

    Bed given(bed);
    const std::vector<double>& x = given.position;
    std::vector<double>& radius = given.radius;
    const std::size_t each = radius.size(), n = each*o.copies;
    DemParticles& p = in.particles;
    p.position.resize(3*n);
    p.radius.resize(n);
    p.mass.resize(n);
    // the same sizes in every copy
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> u(0, 1);
    if (o.sizeRatio > 1) for (double& r : radius) r *= std::pow(o.sizeRatio, -u(engine));
    c.timeStep = 2e-5*(*std::min_element(radius.begin(), radius.end())/(0.5*diameter));
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t from = i % each, copy = i/each;
        const double r = radius[from];
        for (int d = 0; d < 3; ++d)
            p.position[3*i + d] = x[3*from + d] + (d == 1 ? period*double(copy) : 0);
        p.radius[i] = r;
        p.mass[i] = density*4.0/3*M_PI*r*r*r;
    }
    if (o.triangles)
    {
        in.walls.push_back(rectangle({{-0.001, 0, 0}}, {{2, 0, 0}}, {{0, width, 0}}));
        in.walls.push_back(rectangle({{0, 0, -0.001}}, {{0, width, 0}}, {{0, 0, 0.7}}));
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
    if (o.held)
    {
        double front = 0;
        for (std::size_t i = 0; i < each; ++i) front = std::max(front, x[3*i] + radius[i]);
        DemWall w;
        w.plane = true;
        w.name = "front";
        w.point = Vector3{{front, 0, 0}};
        w.normal = Vector3{{-1, 0, 0}};
        in.walls.push_back(w);
    }
    in.walls[0].name = "floor";
    in.walls[1].name = "back";
}

void writeBed(const std::string& file, const DemState& s, int copies)
{
    std::FILE* out = popen(("gzip -9c >'" + file + "'").c_str(), "w");
    if (!out) throw std::runtime_error("cannot write " + file);
    std::vector<std::size_t> order(s.id.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
        [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
    for (std::size_t k = 0; k < order.size()/copies; ++k)
    {
        const double* x = &s.position[3*order[k]];
        std::fprintf(out, "%.7f %.7f %.7f %.7f\n", x[0], x[1], x[2], s.radius[order[k]]);
    }
    if (pclose(out) != 0) throw std::runtime_error("cannot write " + file);
}

void bondedScene(int side, DemConfig& c, DemInput& in)
{
    const double r = 0.5*diameter, wave = 0.05;
    c.dimensions = 3;
    for (int d = 0; d < 3; ++d)
    {
        c.domainMin[d] = -0.1*side*diameter;
        c.domainMax[d] = 1.1*side*diameter;
    }
    c.normal = "linear";
    c.tangential = "none";
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

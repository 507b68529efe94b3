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
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> u(0, 1);
    for (int k = 0; k < o.copies; ++k)
        for (std::size_t i = 0; i < x.size(); i += 3)
        {
            const double r = 0.5*diameter*std::pow(o.sizeRatio, -u(engine));
            in.particles.position.insert(in.particles.position.end(), {x[i], x[i + 1] + period*k, x[i + 2]});
            in.particles.radius.push_back(r);
            in.particles.mass.push_back(density*4.0/3*M_PI*r*r*r);
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

} // namespace riprap

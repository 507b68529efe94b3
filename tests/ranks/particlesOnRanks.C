/*  Particles that processes share: random walks, and scenes of solids whose particles, after many
    steps on all processes, are the bits of one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <array>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include "../unit/core/randomWalks.hpp"
#include "particlesOnRanks.H"
#include "pstreamTransport.H"
#include "api/demScene.hpp"

namespace
{

using namespace riprap;

//- Runs one; what it throws, or says, is the reason of a failure
int report(Transport& transport, const std::string& name, const std::function<std::string()>& run)
{
    std::string why;
    // an exception of one process alone would leave the others waiting: the program ends
    try { why = run(); }
    catch (const std::exception& e)
    {
        std::cout << "FAIL ranks." << transport.size() << "." << name << " process "
                  << transport.rank() << ": " << e.what() << std::endl;
        if (transport.size() == 1) return 1;
        Foam::UPstream::abort();
    }
    if (transport.rank() == 0)
        std::cout << (why.empty() ? "PASS " : "FAIL ") << "ranks." << transport.size() << "."
                  << name << (why.empty() ? "" : " " + why) << std::endl;
    return !why.empty();
}

void addSphere(DemInput& in, Vector3 x, Vector3 v, double radius)
{
    DemParticles& p = in.particles;
    p.position.insert(p.position.end(), x.begin(), x.end());
    p.velocity.insert(p.velocity.end(), v.begin(), v.end());
    p.radius.push_back(radius);
    p.mass.push_back(1e4*radius*radius*radius);
}

//- Spheres of radius 14 to 20 mm, side by side in columns; on a floor between walls, or in a box
//  without sides
DemInput spheres(int n, bool walled, double speed)
{
    DemInput in;
    in.materials.push_back(DemMaterial{"stone", 1e7, 0.25});
    DemPair pair;
    pair.properties.normalStiffness = 1e4;
    pair.properties.friction = 0.4;
    pair.properties.rollingFriction = 0.1;
    pair.properties.restitution = 0.7;
    in.pairs.push_back(pair);
    Numbers u{7};
    const int across = walled ? 7 : 12;
    const double spacing = walled ? 0.0404 : 1.0/across;
    for (int i = 0; i < n; ++i)
    {
        const int k[3] = {i % across, i/across % across, i/across/across};
        Vector3 x, v;
        for (int d = 0; d < 3; ++d)
        {
            x[d] = (walled ? -0.42 : -0.5) + spacing*(k[d] + 0.5) + 1e-3*u();
            v[d] = speed*(2*u() - 1);
        }
        addSphere(in, x, v, 0.014 + 0.006*u());
    }
    for (int d = 0; d < 3 && walled; ++d)
        for (const double side : {-1.0, 1.0})
        {
            DemWall w;
            w.name = "side";
            w.plane = true;
            w.point[d] = 0.45*side;
            w.normal = Vector3{{0, 0, 0}};
            w.normal[d] = -side;
            in.walls.push_back(w);
        }
    return in;
}

DemConfig box(PrecisionKind precision, bool walled)
{
    DemConfig c;
    c.device = DeviceKind::cpu;
    c.precision = precision;
    c.domainMin = Vector3{{-0.5, -0.5, -0.5}};
    c.domainMax = Vector3{{0.5, 0.5, 0.5}};
    c.normal = "linear";
    c.tangential = "history";
    c.rolling = "spring";
    c.stepFraction = 0.1;
    for (bool& p : c.periodic) p = !walled;
    if (walled) c.gravity = Vector3{{2, 0, -9.81}};
    return c;
}

using Row = std::array<double, 16>;

//- Particles of all processes, on process 0
std::map<std::int32_t, Row> gathered(Transport& transport, const DemState& s, std::string& why)
{
    std::vector<RankBytes> out(transport.size()), in;
    for (std::size_t i = 0; i < s.id.size(); ++i)
    {
        Row r{};
        int k = 0;
        for (const auto* v : {&s.position, &s.velocity, &s.spin, &s.force, &s.moment})
            for (int d = 0; d < 3; ++d) r[k++] = (*v)[3*i + d];
        r[k++] = s.contacts[i];
        putValues(out[0], &s.id[i]);
        putValues(out[0], r.data(), r.size());
    }
    transport.exchange(out, in);
    std::map<std::int32_t, Row> rows;
    for (const RankBytes& bytes : in)
    {
        const unsigned char* at = bytes.data();
        while (at < bytes.data() + bytes.size())
        {
            std::int32_t id;
            Row r;
            takeValues(at, &id);
            takeValues(at, r.data(), r.size());
            if (!rows.emplace(id, r).second)
                why = "particle " + std::to_string(id) + " is on two processes";
        }
    }
    return rows;
}

//- So many steps on all processes, and on process 0 alone
std::string sameBits(Transport& transport, const DemConfig& config, const DemInput& in, int steps)
{
    std::string why;
    DemConfig shared(config);
    shared.ranks = &transport;
    const auto scene = createDemScene(shared, in);
    const DemReport report = scene->advance(1e9, steps);
    std::vector<std::int64_t> arrivals(1, report.rank.arrivals);
    transport.sum(arrivals);
    const auto rows = gathered(transport, scene->particles(), why);
    if (transport.rank() != 0 || !why.empty()) return why;
    const auto alone = createDemScene(config, in);
    const DemReport one = alone->advance(1e9, steps);
    const DemState s = alone->particles();
    std::ostringstream os;
    std::size_t different = 0;
    double most = 0;
    for (std::size_t i = 0; i < s.id.size(); ++i)
    {
        const auto row = rows.find(s.id[i]);
        if (row == rows.end()) { os << "particle " << s.id[i] << " is lost; "; break; }
        const double* theirs = row->second.data();
        bool same = true;
        int k = 0;
        for (const auto* v : {&s.position, &s.velocity, &s.spin, &s.force, &s.moment})
            for (int d = 0; d < 3; ++d, ++k)
            {
                same = same && (*v)[3*i + d] == theirs[k];
                if (v == &s.position) most = std::max(most, std::abs((*v)[3*i + d] - theirs[k]));
            }
        different += !same || theirs[k] != double(s.contacts[i]);
    }
    if (rows.size() != s.id.size()) os << rows.size() << " particles, of " << s.id.size() << "; ";
    if (different)
        os << different << " of " << s.id.size() << " particles are of other bits, the farthest is "
           << most << " m off; ";
    if (report.rebuilds != one.rebuilds || report.time != one.time
        || report.maxSpeed != one.maxSpeed || report.particles != one.particles)
        os << "another report; ";
    if (transport.size() > 1 && arrivals[0] == 0) os << "no particle has changed its process; ";
    return os.str();
}

std::string millionMigrations(Transport& transport)
{
    const Tank tank(1.5, 1.2, 0.9, {{true, false, true}}, {0.03, 0.06});
    const WalkSum o = walkOnRank(
        transport, tank, 6000, transport.size() == 1 ? 10 : 450, Walk{tank, 0.6, 0}, 0.1, 100);
    if (o.leftOver != 6000) return "particles have left";
    return transport.size() == 1 || o.arrivals > 1000000
        ? ""
        : "only " + std::to_string(o.arrivals) + " particles have changed their process";
}

} // namespace

int particlesOnRanks()
{
    Foam::pstreamTransport transport;
    int failures = report(
        transport, "millionMigrations", [&] { return millionMigrations(transport); });
    for (const PrecisionKind precision : {PrecisionKind::doubled, PrecisionKind::mixed})
    {
        const std::string name = precision == PrecisionKind::doubled ? ".double" : ".mixed";
        failures += report(transport, "columnCollapse" + name, [&]
        { return sameBits(transport, box(precision, true), spheres(700, true, 0.5), 900); });
        failures += report(transport, "periodicGas" + name, [&]
        { return sameBits(transport, box(precision, false), spheres(1500, false, 1), 900); });
    }
    return failures;
}

/*  The time step of a DEM scene and the memory it takes, before it is made.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <cmath>
#include <sstream>
#include "dem/bond/parallelBond.hpp"
#include "dem/passes/packingLimit.hpp"
#include "dem/motion/clumpState.hpp"
#include "solvers/dem/demFamilies.hpp"

namespace riprap
{

namespace
{

//- Smallest mass and radius of a material's particles, and their highest speed. Of rigid bodies
//  `mass` is that of the body, and `share` what of it each contact carries where as many of its
//  members touch a plane as can
struct Lightest
{
    double mass = 1e300, share = 1e300, radius = 1e300, speed = 0;
    std::size_t count = 0;
    int together = 1;
};

//- Of a body's members the part of a radius within which they touch a plane together: more than
//  contacts should ever overlap
constexpr double touchesTogether = 0.1;

//- Directions in which a body may have flat faces: its principal axes, the axes in which it was
//  made, and half-way between two or three of either
std::vector<Vec<3, double>> faceNormals(const DemConfig& c, const DemClump& body)
{
    std::vector<Vec<3, double>> all;
    const DemPose start = body.moved ? body.start : DemPose{body.position, {{1, 0, 0, 0}}};
    for (int frame = 0; frame < 2; ++frame)
        for (int code = 14; code < 27; ++code)          // one of each pair of opposite ones
        {
            const int k[3] = {code % 3 - 1, code/3 % 3 - 1, code/9 - 1};
            Vec<3, double> n{{double(k[0]), double(k[1]), double(k[2])}};
            if (c.dimensions == 2 && n.c[c.axes[2]] != 0) continue;
            if (frame == 1 && body.moved) n = rotated(start.orientation.data(), n, true);
            if (frame == 0 || body.moved) n = rotated(body.orientation.data(), n);
            all.push_back((1/std::sqrt(squaredNorm(n)))*n);
        }
    return all;
}

//- How many members of each body can touch a plane at once
std::vector<int> touchingTogether(const DemConfig& c, const DemInput& in)
{
    const DemParticles& p = in.particles;
    std::vector<std::vector<std::size_t>> members(in.clumps.size());
    for (std::size_t i = 0; i < p.clump.size(); ++i)
        if (p.clump[i] >= 0) members[p.clump[i]].push_back(i);
    std::vector<int> most(in.clumps.size(), 1);
    for (std::size_t k = 0; k < in.clumps.size(); ++k)
        for (const Vec<3, double>& n : faceNormals(c, in.clumps[k]))
            for (const double side : {-1.0, 1.0})
            {
                const auto reach = [&](std::size_t i)
                {
                    double s = p.radius[i];
                    for (int d = 0; d < 3; ++d)
                        s += side*n.c[d]*(p.position[3*i + d] - in.clumps[k].position[d]);
                    return s;
                };
                double furthest = -1e300;
                for (const std::size_t i : members[k]) furthest = std::max(furthest, reach(i));
                int touching = 0;
                for (const std::size_t i : members[k])
                    touching += reach(i) > furthest - touchesTogether*p.radius[i];
                most[k] = std::max(most[k], touching);
            }
    return most;
}

std::vector<Lightest> lightest(
    const DemConfig& c, const DemInput& in, const std::vector<int>& together)
{
    std::vector<Lightest> r(in.materials.size());
    const DemParticles& p = in.particles;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        Lightest& l = r[p.material.empty() ? 0 : p.material[i]];
        const int clump = p.clump.empty() ? -1 : p.clump[i];
        const double mass = clump < 0 ? p.mass[i] : in.clumps[clump].mass;
        const int n = clump < 0 ? 1 : together[clump];
        ++l.count;
        l.mass = std::min(l.mass, mass);
        if (mass/n < l.share)
        {
            l.share = mass/n;
            l.together = n;
        }
        l.radius = std::min(l.radius, p.radius[i]);
        double v2 = 0;
        for (int d = 0; d < c.dimensions; ++d)
            if (!p.velocity.empty()) v2 += p.velocity[3*i + c.axes[d]]*p.velocity[3*i + c.axes[d]];
        l.speed = std::max(l.speed, std::sqrt(v2));
    }
    return r;
}

double fallSpeed(const DemConfig& c)
{
    double v2 = 0;
    for (int d = 0; d < c.dimensions; ++d)
    {
        const int axis = c.axes[d];
        if (!c.periodic[axis])
            v2 += 2*std::abs(c.gravity[axis])*(c.domainMax[axis] - c.domainMin[axis]);
    }
    return std::sqrt(v2);
}

//- With which a particle can come to the lowest corner of the domain
double impactSpeed(const DemConfig& c, const DemInput& in, std::size_t i)
{
    const DemParticles& p = in.particles;
    const int clump = p.clump.empty() ? -1 : p.clump[i];
    double v2 = 0;
    for (int d = 0; d < c.dimensions; ++d)
    {
        const int axis = c.axes[d];
        const double v = clump >= 0 ? in.clumps[clump].velocity[axis]
                                    : (p.velocity.empty() ? 0 : p.velocity[3*i + axis]);
        const double below = c.gravity[axis] > 0 ? c.domainMax[axis] - p.position[3*i + axis]
                                                 : p.position[3*i + axis] - c.domainMin[axis];
        v2 += v*v + (c.periodic[axis] ? 0 : 2*std::abs(c.gravity[axis])*std::max(0.0, below));
    }
    return std::sqrt(v2);
}

std::string words(const std::string& name, double a, const char* unit)
{
    std::ostringstream s;
    s.precision(4);
    s << name << " " << a << " " << unit;
    return s.str();
}

//- What the normal law must know of a pair
PairProperties ofMaterials(const DemInput& in, const DemPair& pair)
{
    PairProperties q = pair.properties;
    q.youngA = in.materials[pair.a].young;
    q.youngB = in.materials[pair.b].young;
    q.poissonA = in.materials[pair.a].poisson;
    q.poissonB = in.materials[pair.b].poisson;
    return q;
}

//- sqrt(m/k) of the contacts of a pair; of a rigid body sqrt(M/(n k)) with the n members that can
//  touch at once
template<class Normal>
void addContact(const DemConfig& c, const DemInput& in, const DemPair& pair,
    const std::vector<Lightest>& all, DemPlan& plan)
{
    const PairProperties q = ofMaterials(in, pair);
    const std::string between = in.materials[pair.a].name + "-" + in.materials[pair.b].name;
    for (int end = 0; end < (pair.a == pair.b ? 1 : 2); ++end)
    {
        const Lightest& l = all[end ? pair.b : pair.a];
        if (!l.count) continue;
        const double speed = std::max({l.speed, fallSpeed(c), 1e-3}),
                     k = Normal::stiffness(q, Impact{l.share, l.radius, speed});
        const std::string how = Normal::constantStiffness ? "k = "
                                                          : words("impact at", speed, "m/s, k = ");
        std::string cause = words(how, k, "N/m") + words(", m =", l.share, "kg");
        if (l.together > 1)
            cause += ", the share of each of " + std::to_string(l.together)
                + " members of a body that touch at once";
        plan.limits.push_back(StepLimit{"contact " + between, std::sqrt(l.share/k), cause});
    }
}

//- What a close packing of a material's particles stands, of sqrt(m/k), with its dashpots or by its
//  springs alone. Where stiffness is constant: that of Hertz contacts at rest is far below that of
//  the impact which limits the step
template<class Law>
PackedContact packedContact(const DemConfig& c, const PairProperties& q, bool dashpots)
{
    using Tangential = typename Law::TangentialLaw;
    PackedContact p;
    p.dimensions = c.dimensions;
    p.inertia = c.dimensions == 3 ? 0.4 : 0.5;
    p.tangentialSpring = Tangential::spring;
    // a spring of one step's slip is a dashpot
    if (q.friction > 0 && (Tangential::spring || dashpots)) p.kappa = Tangential::stiffnessRatio(q);
    if (Law::RollingLaw::spring) p.rolling = q.rollingFriction;
    p.tangentialDamping = q.tangentialDamping;
    if (!dashpots) return p;
    p.rollingDamping = q.rollingDamping;
    const NormalDashpot dashpot = Law::NormalLaw::dashpotOf(q);
    p.twoZeta = dashpot.twoZeta;
    p.plainDamping = dashpot.plain;
    return p;
}

struct PackedLimit { double springs = 1e300, all = 1e300; std::string between; };

//- Of those that are enough of their kind to surround one
template<class Law>
PackedLimit packedLimit(const DemConfig& c, const DemInput& in, const std::vector<Lightest>& all)
{
    PackedLimit least;
    for (const DemPair& pair : in.pairs)
    {
        const Lightest& l = all[pair.a];
        if (pair.a != pair.b || l.count <= (c.dimensions == 3 ? 12u : 6u)) continue;
        const PairProperties& q = pair.properties;
        const double k = Law::NormalLaw::stiffness(q, Impact{l.mass, l.radius, l.speed});
        const double unit = std::sqrt(l.mass/k),
                     limit = unit*packingLimit(packedContact<Law>(c, q, true));
        least.springs = std::min(least.springs, unit*packingLimit(packedContact<Law>(c, q, false)));
        if (limit >= least.all) continue;
        least.all = limit;
        least.between = in.materials[pair.a].name + "-" + in.materials[pair.b].name;
    }
    return least;
}

//- The step, and what sets it
void setStep(const DemConfig& c, const PackedLimit& packed, DemPlan& plan)
{
    double least = 1e300;
    for (const StepLimit& l : plan.limits)
        if (l.critical < least) { least = l.critical; plan.cause = l.name + ": " + l.cause; }
    plan.timeStep = c.timeStep > 0 ? c.timeStep : c.stepFraction*least;
    if (c.timeStep > 0) plan.cause = "given";
    else if (packed.all < plan.timeStep && !c.allowLargeStep)
    {
        plan.timeStep = packed.all;
        plan.cause = "close packing of " + packed.between + ", springs and dashpots";
    }
    if (c.maxTimeStep > 0 && c.timeStep == 0 && plan.timeStep > c.maxTimeStep)
    {
        plan.timeStep = c.maxTimeStep;
        plan.cause = "maxDeltaT";
    }
    if (plan.timeStep <= packed.all*(1 + 1e-9)) return;
    std::ostringstream s;
    s.precision(4);
    s << packed.between << ": where they are packed closely, steps above " << packed.all
      << " s make them jitter, by "
      << (plan.timeStep > packed.springs ? "their springs" : "their dashpots") << "; the step is "
      << plan.timeStep << " s";
    plan.warnings.push_back(s.str());
}

//- sqrt(m/k) of a particle's bonds together, of translation and of rotation. Without dashpots a
//  step of all of it is stable whatever the lattice: of the terms of a bond's strain, u_A, u_B, R_A
//  w_A and R_B w_B, the square of the sum is at most four times the sum of squares, so that no
//  mode's frequency is above 2 sqrt(k/m) of the worst particle, and the limit 2/w of leapfrog and
//  Verlet not below sqrt(m/k)
void addBonds(const DemConfig& c, const DemInput& in, DemPlan& plan)
{
    if (in.bonds.size() == 0) return;
    const DemParticles& p = in.particles;
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const std::size_t id = p.id.empty() ? i : p.id[i];
        if (id >= at.size()) at.resize(id + 1, 0);
        at[id] = i;
    }
    std::vector<double> stretch(p.size(), 0), turn(p.size(), 0);
    for (std::size_t k = 0; k < in.bonds.size(); ++k)
    {
        const DemBondType& t = in.bondTypes[in.bonds.type.empty() ? 0 : in.bonds.type[k]];
        const std::size_t a = at[in.bonds.a[k]], b = at[in.bonds.b[k]];
        const BondParameters<double> q{t.normalStiffness, t.shearStiffness, 0, 0, 0, t.radiusFactor,
            bondRadiusChoice(t.radiusKind), c.dimensions == 3 || t.cylinder};
        const BondSection<double> s = bondSection(q, p.radius[a], p.radius[b]);
        for (const std::size_t i : {a, b})
        {
            stretch[i] += std::max(t.normalStiffness, t.shearStiffness)*s.area;
            turn[i] += t.normalStiffness*s.inertia
                + t.shearStiffness*s.area*p.radius[i]*p.radius[i];
        }
    }
    double least = 1e300, leastTurn = 1e300;
    std::size_t worst = 0, worstTurn = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const double inertia = p.inertia.empty()
            ? (c.dimensions == 2 ? 0.5 : 0.4)*p.mass[i]*p.radius[i]*p.radius[i]
            : p.inertia[i];
        const double s = stretch[i] > 0 ? std::sqrt(p.mass[i]/stretch[i]) : 1e300,
                     r = turn[i] > 0 ? std::sqrt(inertia/turn[i]) : 1e300;
        if (s < least) { least = s; worst = i; }
        if (r < leastTurn) { leastTurn = r; worstTurn = i; }
    }
    const auto cause = [](std::size_t i) { return "all bonds of particle " + std::to_string(i); };
    const bool damped = std::any_of(in.bondTypes.begin(), in.bondTypes.end(),
        [](const DemBondType& t) { return t.dampingRatio > 0; });
    const double hard = damped ? 0.5 : 1;
    if (least < 1e300) plan.limits.push_back(StepLimit{"bond", least, cause(worst), hard});
    if (leastTurn < 1e300)
        plan.limits.push_back(StepLimit{"bond rotation", leastTurn, cause(worstTurn), hard});
}

//- Of a rigid body's springs together, as if all pulled the same way: with frequency w and damping
//  rate C, 1/(C + sqrt(C^2 + w^2)), with which half of it is well within (w dt)^2 + 2 C dt < 4
void addSprings(const DemConfig& c, const DemInput& in, DemPlan& plan)
{
    for (const DemClump& body : in.clumps)
    {
        if (in.groups.empty() || in.groups[body.group].springs.empty()) continue;
        const DemPose start = body.moved ? body.start : DemPose{body.position, body.orientation};
        const double least = c.dimensions == 2
            ? body.inertia[2]
            : std::min({body.inertia[0], body.inertia[1], body.inertia[2]});
        double w2 = 0, C = 0;
        for (const DemSpring& s : in.groups[body.group].springs)
        {
            double arm2 = 0;
            for (int d = 0; d < c.dimensions; ++d)
            {
                const double a = s.point[c.axes[d]] - start.position[c.axes[d]];
                arm2 += a*a;
            }
            const double yields = 1/body.mass + arm2/least;
            w2 += s.stiffness*yields;
            C += s.damping*yields;
        }
        plan.limits.push_back(StepLimit{"springs of " + in.groups[body.group].name,
            1/(C + std::sqrt(C*C + w2)), words("m =", body.mass, "kg")});
    }
}

void addRayleigh(const DemInput& in, const std::vector<Lightest>& all, DemPlan& plan)
{
    for (std::size_t m = 0; m < all.size(); ++m)
    {
        const double nu = in.materials[m].poisson, G = in.materials[m].young/(2*(1 + nu)),
                     R = all[m].radius;
        if (!all[m].count || !(G > 0)) continue;
        const double density = all[m].mass/(4.0/3*M_PI*R*R*R);
        plan.limits.push_back(StepLimit{"Rayleigh " + in.materials[m].name,
            M_PI*R*std::sqrt(density/G)/(0.1631*nu + 0.8766), words("R =", R, "m")});
    }
}

//- What the law itself says where bodies can fall so fast
template<class Normal>
void warnOfLaw(const DemConfig& c, const DemInput& in, DemPlan& plan)
{
    for (const DemPair& pair : in.pairs)
    {
        const std::string said = Normal::warning(ofMaterials(in, pair), fallSpeed(c));
        if (!said.empty())
            plan.warnings.push_back(
                in.materials[pair.a].name + "-" + in.materials[pair.b].name + ": " + said);
    }
}

//- Springs of constant stiffness: a particle, or a rigid body on as many members as can touch at
//  once, that sinks in by more than a member's radius goes through what it hits
void warnOfSoftness(
    const DemConfig& c, const DemInput& in, const std::vector<int>& together, DemPlan& plan)
{
    const DemParticles& p = in.particles;
    for (const DemPair& pair : in.pairs)
    {
        const double k = pair.properties.normalStiffness;
        double most = 1, mass = 0, speed = 0, radius = 0;
        for (std::size_t i = 0; i < p.size(); ++i)
        {
            const int material = p.material.empty() ? 0 : p.material[i],
                      clump = p.clump.empty() ? -1 : p.clump[i];
            if (material != pair.a && material != pair.b) continue;
            const double m = clump < 0 ? p.mass[i] : in.clumps[clump].mass/together[clump],
                         v = impactSpeed(c, in, i);
            const double deep = v*std::sqrt(m/k)/p.radius[i];
            if (!(deep > most)) continue;
            most = deep;
            mass = clump < 0 ? m : in.clumps[clump].mass;
            speed = v;
            radius = p.radius[i];
        }
        if (mass == 0) continue;
        std::ostringstream s;
        s.precision(4);
        s << in.materials[pair.a].name << "-" << in.materials[pair.b].name << ": a body of " << mass
          << " kg that meets another or a wall at " << speed
          << " m/s, as it may from where it is, sinks in by " << most*radius
          << " m, which is more than the radius of its particles, " << radius
          << " m, and comes out on the other side; stiffness " << 4*most*most*k
          << " would halve the radius";
        plan.warnings.push_back(s.str());
    }
}

} // namespace

DemPlan planDemScene(const DemConfig& c, const DemInput& in)
{
    DemPlan plan;
    plan.particles = in.particles.size();
    plan.clumps = in.clumps.size();
    plan.bonds = in.bonds.size();
    for (const DemWall& w : in.walls)
        plan.wallElements += w.plane ? 1 : w.elements.size()/c.dimensions;
    plan.together = touchingTogether(c, in);
    const std::vector<Lightest> all = lightest(c, in, plan.together);
    const LawChoice laws = lawChoice(c);
    NormalLaws::at(laws.normal,
        [&](auto law)
        {
            for (const DemPair& pair : in.pairs)
                addContact<typename decltype(law)::type>(c, in, pair, all, plan);
        });
    addBonds(c, in, plan);
    addSprings(c, in, plan);
    PackedLimit packed;
    std::size_t histories = 0;
    withLaw(laws, [&](auto law)
    {
        using Law = decltype(law);
        if constexpr (Law::NormalLaw::constantStiffness) packed = packedLimit<Law>(c, in, all);
        histories = c.dimensions == 2 ? Law::template history<2> : Law::template history<3>;
    });
    plan.hardStop = packed.springs;
    plan.hardCause = "what the springs of a close packing of " + packed.between + " stand";
    for (const StepLimit& l : plan.limits)
    {
        if (!(l.hardStop*l.critical < plan.hardStop)) continue;
        plan.hardStop = l.hardStop*l.critical;
        plan.hardCause = words("", l.hardStop, "sqrt(m/k)").substr(1) + " of " + l.name + " ("
            + l.cause + ")";
    }
    NormalLaws::at(laws.normal, [&](auto law)
    {
        using Normal = typename decltype(law)::type;
        if (Normal::elasticConstants) addRayleigh(in, all, plan);
        warnOfLaw<Normal>(c, in, plan);
        if (Normal::constantStiffness && !Normal::stiffnessByMass)
            warnOfSoftness(c, in, plan.together, plan);
    });
    setStep(c, packed, plan);

    // state twice (for sorting), records, cells; half lists with histories twice (before and after
    // a rebuild). A GPU keeps full lists once, and what touches beside them; about as much
    const std::size_t real = c.precision == PrecisionKind::mixed ? 4 : 8, D = c.dimensions,
                      S = D == 2 ? 1 : 3;
    const std::size_t neighbours = D == 2 ? 7 : 16;
    const std::size_t state = 2*(16*D + real*(D + 2*S + 3) + 12) + 12*real + 40;
    plan.bytes = plan.particles*(state + 2*neighbours*(4 + real*histories))
      + plan.bonds*(40 + real*(8 + D + 3*S)) + plan.clumps*200 + plan.wallElements*(D*12 + 64);
    return plan;
}

} // namespace riprap

/*  createDemScene: what is checked of its input, and which solver is made.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include "core/backend/device.hpp"
#include "core/ranks/transport.hpp"
#include "api/particleLimit.hpp"
#include "dem/motion/integrators.hpp"
#include "solvers/dem/demInstances.hpp"
#include "solvers/dem/demLaws.hpp"
#include "api/sphScene.hpp"

namespace riprap
{

namespace
{

void require(bool good, const std::string& why) { if (!good) throw std::invalid_argument(why); }

std::string at(const DemParticles& p, std::size_t i)
{
    std::ostringstream s;
    s << i << " at (" << p.position[3*i] << " " << p.position[3*i + 1] << " "
      << p.position[3*i + 2] << ")";
    return s.str();
}

void checkConfig(const DemConfig& c)
{
    require(c.dimensions == 2 || c.dimensions == 3, "dimensions must be 2 or 3");
    int axes = 0;
    for (const int a : c.axes)
    {
        require(a >= 0 && a < 3, "axes must be 0, 1 and 2");
        axes |= 1 << a;
    }
    require(axes == 7, "axes must be 0, 1 and 2, each once");
    require(c.dimensions == 2 || (c.axes[0] == 0 && c.axes[1] == 1), "axes are 0, 1, 2 in 3D");
    lawChoice(c);
    require(c.timeStep >= 0 && std::isfinite(c.timeStep) && c.maxTimeStep >= 0,
        "the time step must not be negative");
    require(c.sleepSpeed >= 0 && std::isfinite(c.sleepSpeed) && c.sleepAfter >= 0
            && std::isfinite(c.sleepAfter),
        "the speed below which particles sleep, and the time before they do, must not be negative");
    demIntegratorOf(c.integrator);
    require(c.stepFraction > 0, "the fraction of the critical step must be positive");
    for (int d = 0; d < c.dimensions; ++d)
    {
        require(c.domainMax[c.axes[d]] > c.domainMin[c.axes[d]], "the domain is empty");
        require(std::isfinite(c.gravity[c.axes[d]]), "gravity must be a number");
    }
}

//- What scenes on several processes cannot have yet
void checkRanks(const DemConfig& c)
{
    if (!c.ranks || c.ranks->size() < 2) return;
    require(c.device != DeviceKind::gpu, "several processes run on CPUs alone");
    require(c.sleepSpeed <= 0, "particles sleep on one process alone");
    require(c.imbalance > 0, "the imbalance that bricks may have must be positive");
}

void checkIds(const DemParticles& p)
{
    std::vector<std::size_t> order(p.id.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto before = [&](std::size_t a, std::size_t b)
    { return p.id[a] < p.id[b] || (p.id[a] == p.id[b] && a < b); };
    if (!std::is_sorted(order.begin(), order.end(), before))
        std::sort(order.begin(), order.end(), before);
    for (std::size_t k = 1; k < order.size(); ++k)
        if (p.id[order[k]] == p.id[order[k - 1]])
            throw std::invalid_argument("solid " + at(p, order[k]) + " has the id of another");
}

//- Each array has a value for each particle
void checkLengths(const DemParticles& p)
{
    const std::size_t n = p.size();
    const auto sized = [&](std::size_t size, std::size_t each, bool mayBeEmpty, const char* what)
    {
        require(size == each*n || (mayBeEmpty && size == 0),
            std::string("solids: ") + what + " of another length than positions");
    };
    sized(p.velocity.size(), 3, true, "velocity");
    sized(p.spin.size(), 3, true, "spin");
    sized(p.radius.size(), 1, false, "radius");
    sized(p.mass.size(), 1, false, "mass");
    sized(p.inertia.size(), 1, true, "inertia");
    sized(p.material.size(), 1, true, "material");
    sized(p.group.size(), 1, true, "group");
    sized(p.clump.size(), 1, true, "clump");
    sized(p.id.size(), 1, true, "id");
}

void checkParticle(const DemConfig& c, const DemInput& in, std::size_t i)
{
    const DemParticles& p = in.particles;
    const int groups = std::max<int>(1, int(in.groups.size()));
    const auto bad = [&](const std::string& why)
    { throw std::invalid_argument("solid " + at(p, i) + " " + why); };
    if (!(p.radius[i] > 0)) bad("has no radius");
    if (!(p.mass[i] > 0) || !std::isfinite(p.mass[i])) bad("has no mass");
    if (!p.inertia.empty() && !(p.inertia[i] > 0)) bad("has no inertia");
    for (int d = 0; d < 3; ++d)
    {
        const double x = p.position[3*i + d], v = p.velocity.empty() ? 0 : p.velocity[3*i + d];
        if (!std::isfinite(x) || !std::isfinite(v)) bad("has no proper position or velocity");
    }
    for (int d = 0; d < c.dimensions; ++d)
    {
        const int axis = c.axes[d];
        const double x = p.position[3*i + axis], r = p.radius[i];
        if (x < c.domainMin[axis] - c.walled[axis][0]*r
            || x > c.domainMax[axis] + c.walled[axis][1]*r)
            bad("is outside the domain");
    }
    if (!p.material.empty() && (p.material[i] < 0 || p.material[i] >= int(in.materials.size())))
        bad("is of unknown material " + std::to_string(p.material[i]));
    if (!p.group.empty() && (p.group[i] < 0 || p.group[i] >= groups))
        bad("is of unknown group " + std::to_string(p.group[i]));
    if (!p.clump.empty() && (p.clump[i] < -1 || p.clump[i] >= int(in.clumps.size())))
        bad("is of unknown clump " + std::to_string(p.clump[i]));
    if (!p.id.empty() && p.id[i] < 0) bad("has a negative id");
}

void checkParticles(const DemConfig& c, const DemInput& in)
{
    const std::size_t n = in.particles.size();
    require(n > 0, "there are no solids");
    requireCountable(double(n), mostSolidParticles, "solid particles");
    checkLengths(in.particles);
    // the first that is wrong, by as many threads as there are
    long long worst = (long long)n;
    #pragma omp parallel for schedule(static) reduction(min: worst)
    for (long long i = 0; i < (long long)n; ++i)
    {
        if (i > worst) continue;
        try
        {
            checkParticle(c, in, std::size_t(i));
        }
        catch (const std::invalid_argument&)
        {
            worst = std::min(worst, i);
        }
    }
    if (worst < (long long)n) checkParticle(c, in, std::size_t(worst));
    checkIds(in.particles);
}

//- Numbers of a pair that its laws use
void checkPair(const DemConfig& c, const DemInput& in, const DemPair& pair)
{
    const std::string name = "materials " + in.materials[pair.a].name + " and "
        + in.materials[pair.b].name + ": ";
    const PairProperties& q = pair.properties;
    const PairProperties none;
    const LawChoice laws = lawChoice(c);
    // what is not given, where there is a default or where another law has it, is as in an empty
    // struct
    const auto check = [&](const PairEntry& e, bool chosen)
    {
        if (e.yesNo || (e.value(q) == e.value(none) && !(chosen && e.required))) return;
        require(e.allows(e.value(q)), name + "the " + e.what + " must be " + e.rangeText());
    };
    for (const PairEntry& e : lawEntries(laws)) check(e, true);
    for (const PairEntry& e : allLawEntries()) check(e, false);
    std::set<std::string> names;
    for (const PairEntry& e : lawEntries(laws)) names.insert(e.name);
    for (const auto& given : q.more)
        require(
            names.count(given.first), name + given.first + " is no number of these contact laws");
    const NormalNeeds needs = normalNeeds(laws);
    require(!needs.gravity || q.gravity > 0, name + "normal law " + c.normal + " needs gravity");
    for (const int m : {pair.a, pair.b})
        require(!needs.elasticConstants
                || (in.materials[m].young > 0 && in.materials[m].poisson > -1
                    && in.materials[m].poisson <= 0.5),
            "material " + in.materials[m].name + ": normal law " + c.normal
                + " needs Young's modulus, and Poisson's ratio in (-1, 0.5]");
}

//- Every pair that can meet must be given
void checkPairs(const DemConfig& c, const DemInput& in)
{
    const int m = int(in.materials.size());
    require(m > 0, "there are no materials");
    std::set<std::pair<int, int>> given;
    for (const DemPair& p : in.pairs)
    {
        require(p.a >= 0 && p.a < m && p.b >= 0 && p.b < m, "a pair of unknown materials");
        const auto key = std::make_pair(std::min(p.a, p.b), std::max(p.a, p.b));
        require(given.insert(key).second,
            "materials " + in.materials[p.a].name + " and " + in.materials[p.b].name
                + " are paired twice");
        checkPair(c, in, p);
    }
    std::set<int> solids, walls;
    std::vector<char> used(m, 0);
    for (const std::int32_t k : in.particles.material) used[k] = 1;
    for (int k = 0; k < m; ++k) if (used[k]) solids.insert(k);
    if (in.particles.material.empty()) solids.insert(0);
    for (const DemWall& w : in.walls)
    {
        require(w.material >= 0 && w.material < m, "wall " + w.name + " is of an unknown material");
        walls.insert(w.material);
    }
    walls.insert(solids.begin(), solids.end());
    for (const int a : solids)
        for (const int b : walls)
            require(given.count(std::make_pair(std::min(a, b), std::max(a, b))),
                "nothing is said about materials " + in.materials[a].name + " and "
                    + in.materials[b].name + ", which can meet");
}

void checkGroups(const DemInput& in)
{
    for (const DemGroup& g : in.groups)
    {
        require(g.localDamping >= 0 && g.localDamping < 1,
            "group " + g.name + ": local damping must be in [0, 1)");
        require(g.viscousDamping >= 0 && g.viscousSpinDamping >= 0,
            "group " + g.name + ": viscous damping must not be negative");
        require(g.motion < 0 || bool(in.groupMotion),
            "group " + g.name + " moves as prescribed, but there is no motion");
    }
}

double lengthOf(const DemConfig& c, const Vector3& v)
{
    double sum = 0;
    for (int d = 0; d < c.dimensions; ++d) sum += v[c.axes[d]]*v[c.axes[d]];
    return std::sqrt(sum);
}

//- Constraints and springs are of rigid bodies
void checkBodies(const DemConfig& c, const DemInput& in)
{
    const DemParticles& p = in.particles;
    for (std::size_t g = 0; g < in.groups.size(); ++g)
    {
        const DemGroup& group = in.groups[g];
        const DemConstraint& s = group.constraint;
        const std::string name = "group " + group.name + ": ";
        if (!s.any() && group.springs.empty()) continue;
        const bool held = group.heldSpin || group.held[0] || group.held[1] || group.held[2];
        require(!s.any() || !held, name + "constrain and fixed exclude each other");
        require(group.motion < 0,
            name + "it moves as prescribed: neither constrain nor springs can act on it");
        std::size_t bodies = 0, loose = 0;
        for (const DemClump& q : in.clumps) bodies += std::size_t(q.group) == g;
        for (std::size_t i = 0; i < p.size(); ++i)
            loose += (p.clump.empty() || p.clump[i] < 0)
                && std::size_t(p.group.empty() ? 0 : p.group[i]) == g;
        require(loose == 0,
            name + std::to_string(loose)
                + " of its particles are of no rigid body: constrain, springs and moorings are of "
                  "rigid ones");
        const bool line = s.translation == TranslationKind::line
            || s.translation == TranslationKind::plane;
        require(!line || lengthOf(c, s.direction) > 0,
            name + "the direction of its constraint has no length");
        const bool turns = s.hinge || s.rotation == RotationKind::axis;
        require(!turns || c.dimensions == 2 || lengthOf(c, s.axis) > 0,
            name + "the axis of its constraint has no length");
        require(group.springs.empty() || bodies == 1,
            name + "springs and moorings are of one rigid body, and it has "
                + std::to_string(bodies));
        for (const DemSpring& spring : group.springs)
            require(spring.stiffness > 0 && spring.damping >= 0 && spring.length >= 0,
                name + spring.name
                    + ": the stiffness must be positive, damping and length not negative");
    }
}

void checkBonds(const DemInput& in)
{
    const DemBonds& b = in.bonds;
    if (b.size() == 0 && b.b.empty() && b.type.empty() && b.gap.empty()) return;
    require(b.a.size() == b.b.size() && (b.type.empty() || b.type.size() == b.size())
            && (b.gap.empty() || b.gap.size() == b.size()),
        "bonds: arrays of different lengths");
    require(b.size() == 0 || !in.bondTypes.empty(), "bonds without a type");
    for (const DemBondType& t : in.bondTypes)
        require(t.normalStiffness > 0 && t.shearStiffness > 0 && t.radiusFactor > 0
                && t.tensileStrength > 0 && t.shearStrength > 0 && t.dampingRatio >= 0,
            "bonds: stiffnesses, radius factor and strengths must be positive");
    std::vector<std::int32_t> ids(in.particles.id);
    std::sort(ids.begin(), ids.end());
    const auto known = [&](std::int32_t id)
    {
        return in.particles.id.empty() ? id >= 0 && std::size_t(id) < in.particles.size()
            : std::binary_search(ids.begin(), ids.end(), id);
    };
    std::vector<std::pair<int, int>> made(b.size());
    for (std::size_t k = 0; k < b.size(); ++k)
    {
        if (!known(b.a[k]) || !known(b.b[k]) || b.a[k] == b.b[k])
            throw std::invalid_argument(
                "bond " + std::to_string(k) + " has an unknown particle at an end");
        made[k] = {std::min(b.a[k], b.b[k]), std::max(b.a[k], b.b[k])};
        require(b.type.empty() || (b.type[k] >= 0 && b.type[k] < int(in.bondTypes.size())),
            "bond of an unknown type");
    }
    std::sort(made.begin(), made.end());
    const auto twice = std::adjacent_find(made.begin(), made.end());
    if (twice != made.end())
        throw std::invalid_argument("particles " + std::to_string(twice->first) + " and "
            + std::to_string(twice->second) + " are bonded twice");
}

void checkClumps(const DemConfig& c, const DemInput& in)
{
    for (std::size_t k = 0; k < in.clumps.size(); ++k)
    {
        const DemClump& q = in.clumps[k];
        const std::string name = "clump " + std::to_string(k) + ": ";
        require(q.mass > 0 && std::isfinite(q.mass), name + "the mass must be positive");
        for (int d = c.dimensions == 2 ? 2 : 0; d < 3; ++d)
            require(q.inertia[d] > 0, name + "the moments of inertia must be positive");
        double norm = 0;
        for (const double e : q.orientation) norm += e*e;
        require(std::abs(norm - 1) < 1e-6, name + "the orientation must be a unit quaternion");
        require(q.group >= 0 && q.group < std::max<int>(1, int(in.groups.size())),
            name + "unknown group");
        require(in.groups.empty() || in.groups[q.group].motion < 0,
            name + "a clump cannot be of a group that moves as prescribed");
    }
}

void checkWalls(const DemConfig& c, const DemInput& in)
{
    for (const DemWall& w : in.walls)
    {
        require(w.motion < 0 || bool(in.wallMotion),
            "wall " + w.name + " moves, but there is no motion");
        double n2 = 0;
        for (int d = 0; d < c.dimensions; ++d) n2 += w.normal[c.axes[d]]*w.normal[c.axes[d]];
        if (w.plane) { require(n2 > 0, "wall " + w.name + ": the plane has no normal"); continue; }
        require(!w.elements.empty() && w.elements.size() % c.dimensions == 0
                && w.vertices.size() % 3 == 0,
            "wall " + w.name + ": no elements, or some are not whole");
        for (const double x : w.vertices)
            require(std::isfinite(x), "wall " + w.name + ": a vertex is not a number");
        for (const std::int32_t v : w.elements)
            require(v >= 0 && std::size_t(v) < w.vertices.size()/3,
                "wall " + w.name + ": an element names a vertex that is not there");
        for (std::size_t e = 0; e < w.elements.size(); e += c.dimensions)
        {
            double a[3], b[3];
            for (int d = 0; d < 3; ++d)
            {
                const double* v = w.vertices.data();
                a[d] = v[3*w.elements[e + 1] + d] - v[3*w.elements[e] + d];
                b[d] = v[3*w.elements[e + c.dimensions - 1] + d] - v[3*w.elements[e] + d];
            }
            double length = 0;
            for (int d = 0; d < c.dimensions; ++d) length += a[c.axes[d]]*a[c.axes[d]];
            const double cx = a[1]*b[2] - a[2]*b[1], cy = a[2]*b[0] - a[0]*b[2],
                         cz = a[0]*b[1] - a[1]*b[0];
            require(c.dimensions == 2 ? length > 0 : cx*cx + cy*cy + cz*cz > 0,
                "wall " + w.name + ": element " + std::to_string(e/c.dimensions)
                    + " has no extent");
        }
    }
}

} // namespace

std::unique_ptr<DemScene> createDemScene(const DemConfig& config, const DemInput& input)
{
    checkConfig(config);
    require(!input.materials.empty(), "there are no materials");
    checkParticles(config, input);
    checkPairs(config, input);
    checkGroups(input);
    checkBonds(input);
    checkClumps(config, input);
    checkBodies(config, input);
    checkWalls(config, input);
    checkRanks(config);
    const DemPlan plan = planDemScene(config, input);
    require(plan.timeStep < 1e20, "nothing limits the time step: it must be given");
    if (plan.timeStep > plan.hardStop*(1 + 1e-9) && !config.allowLargeStep)
    {
        std::ostringstream s;
        s << "the time step of " << plan.timeStep << " s is above " << plan.hardStop << " s, "
          << plan.hardCause << "; a shorter step, or entry allowLargeStep";
        throw std::invalid_argument(s.str());
    }
    // idle lanes of packs may divide by zero, and a state that blows up is the guards' business
    fedisableexcept(FE_ALL_EXCEPT);
    const bool several = config.ranks && config.ranks->size() > 1;
    const DeviceChoice choice = chooseDevice(
        several ? DeviceKind::cpu : config.device, input.particles.size(), config.dimensions);
    const bool two = config.dimensions == 2, mixed = config.precision == PrecisionKind::mixed;
#ifdef RIPRAP_CUDA
    if (choice.device == DeviceKind::gpu)
    {
        const DemMaker make = two ? (mixed ? demGpu2Mixed : demGpu2Double)
                                  : (mixed ? demGpu3Mixed : demGpu3Double);
        return make(config, input, plan);
    }
#endif
    const DemMaker make = two ? (mixed ? demCpu2Mixed : demCpu2Double)
                              : (mixed ? demCpu3Mixed : demCpu3Double);
    return make(config, input, plan);
}

DemBonds bondsWithin(const DemConfig& c, const DemParticles& p, int group, double tolerance)
{
    double largest = 0;
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        if ((p.group.empty() ? 0 : p.group[i]) != group) continue;
        members.push_back(i);
        largest = std::max(largest, p.radius[i]);
    }
    const double size = 2*largest + tolerance;
    using Cell = std::array<long long, 3>;
    std::map<Cell, std::vector<std::size_t>> cells;
    const auto cellOf = [&](std::size_t i)
    {
        Cell r{{0, 0, 0}};
        for (int d = 0; d < c.dimensions; ++d)
            r[d] = (long long)std::floor(p.position[3*i + c.axes[d]]/size);
        return r;
    };
    DemBonds bonds;
    const auto id = [&](std::size_t i) { return p.id.empty() ? std::int32_t(i) : p.id[i]; };
    for (const std::size_t i : members)
    {
        const Cell own = cellOf(i);
        for (int k = 0; k < (c.dimensions == 2 ? 9 : 27); ++k)
        {
            const Cell other{{own[0] + k % 3 - 1, own[1] + k/3 % 3 - 1,
                c.dimensions == 2 ? 0 : own[2] + k/9 - 1}};
            const auto found = cells.find(other);
            if (found == cells.end()) continue;
            for (const std::size_t j : found->second)
            {
                double d2 = 0;
                for (int d = 0; d < c.dimensions; ++d)
                {
                    const double s = p.position[3*i + c.axes[d]] - p.position[3*j + c.axes[d]];
                    d2 += s*s;
                }
                if (std::sqrt(d2) > p.radius[i] + p.radius[j] + tolerance) continue;
                bonds.a.push_back(id(j));
                bonds.b.push_back(id(i));
            }
        }
        cells[own].push_back(i);
    }
    require(bonds.size() > 0,
        "group " + std::to_string(group) + " has no particles within " + std::to_string(tolerance)
            + " m of each other: there is nothing to bond");
    return bonds;
}

} // namespace riprap

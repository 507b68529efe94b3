/*  DemSolver: construction from a configuration and its input.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "dem/walls/repeatSurface.hpp"
#include "solvers/dem/demSolver.hpp"
#include "solvers/dem/demBodies.hpp"
#include "solvers/dem/demStill.hpp"

namespace riprap
{

template<class Backend, int D, class P>
DemSolver<Backend, D, P>::DemSolver(const DemConfig& config, const DemInput& input, const DemPlan& plan)
:
    config_(config), laws_(lawChoice(config)), plan_(plan), given_(&input)
{
    // particles and bonds go to the device: the host keeps no second copy of millions
    input_.materials = input.materials;
    input_.pairs = input.pairs;
    input_.groups = input.groups;
    input_.clumps = input.clumps;
    input_.bondTypes = input.bondTypes;
    input_.walls = input.walls;
    input_.groupMotion = input.groupMotion;
    input_.wallMotion = input.wallMotion;
    still_ = isStill(input);
    clock_.allocate(context_, 2);
    n_ = reported_ = int(input.particles.size());
    setPairs();
    setBox();
    if (config.ranks && config.ranks->size() > 1) setRanks();
    setFields();
    setGroups();
    setBonds();
    setClumps();
    setWalls();
    given_ = nullptr;
    setFrames();
    prime();
    if (others_)
    {
        // from now on there is memory for what is here
        setCapacity(others_->residents() + others_->residents()/4 + 256);
        rebuild();
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setPairs()
{
    const int m = int(input_.materials.size());
    std::vector<real> gaps(std::size_t(m)*m, real(0));
    std::vector<PairProperties> pairs(std::size_t(m)*m);
    std::vector<char> given(std::size_t(m)*m, 0);
    const std::vector<double>& radius = given_->particles.radius;
    const double largestRadius = *std::max_element(radius.begin(), radius.end());
    reaches_.assign(std::size_t(m)*m, real(0));
    for (DemPair& p : input_.pairs)
        for (const bool turned : {false, true})
        {
            const int a = turned ? p.b : p.a, b = turned ? p.a : p.b;
            PairProperties q = p.properties;
            q.largestRadius = largestRadius;
            q.youngA = input_.materials[a].young;
            q.youngB = input_.materials[b].young;
            q.poissonA = input_.materials[a].poisson;
            q.poissonB = input_.materials[b].poisson;
            const std::size_t k = std::size_t(a)*m + b;
            pairs[k] = q;
            given[k] = 1;
            NormalLaws::at(laws_.normal, [&](auto law)
            {
                using Normal = typename decltype(law)::type;
                // beside a wall R* is the particle's radius
                const double reach = Normal::reach(q, largestRadius);
                reaches_[k] = real(reach);
                gaps[k] = real(q.gap + reach);
                largestGap_ = std::max(largestGap_, q.gap + reach);
            });
        }
    gaps_.upload(context_, gaps);
    withLaw(laws_, [&](auto law)
    {
        using Law = decltype(law);
        using Parameters = typename Law::template Parameters<real>;
        std::vector<real> all;
        for (std::size_t k = 0; k < pairs.size(); ++k)
        {
            // a pair that cannot meet was not given: its numbers are never used
            const Parameters one = given[k] ? Law::template make<real>(pairs[k]) : Parameters{};
            const real* from = reinterpret_cast<const real*>(&one);
            all.insert(all.end(), from, from + sizeof(one)/sizeof(real));
        }
        parameters_.upload(context_, all);
        sole_.assign(all.begin(), all.begin() + sizeof(Parameters)/sizeof(real));
        sole_.push_back(gaps[0]);
        histories_ = Law::template history<D>;
    });
}

//- What the search adds to contact unless fast particles need more [m]
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::leastSkin() const
{ return (config_.skin >= 0 ? config_.skin : (Backend::gpu ? 0.1 : 0.15))*2*radii_.smallest; }

//- How far the search looks
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setReach(double skin)
{
    skin_ = skin;
    halfSkin_ = real(0.5*skin);
    reach_ = skin + largestGap_;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setBox()
{
    const DemConfig& c = config_;
    radii_ = RadiusClasses::of(given_->particles.radius);
    setReach(leastSkin());
    const double margin = 2*radii_.largest + reach_;
    for (int d = 0; d < D; ++d)
    {
        const int axis = c.axes[d];
        const double lo = c.domainMin[axis], hi = c.domainMax[axis];
        if (c.periodic[axis] && hi - lo < 3.001*margin)
            throw std::invalid_argument("the periodic domain is " + std::to_string(hi - lo)
              + " m long; it must be at least three times the reach of the largest particles, " + std::to_string(3.001*margin) + " m");
        // a margin, so that fixed-point differences across it are never mistaken for near ones
        if (c.periodic[axis]) box_.set(d, lo, hi - lo, true);
        else box_.set(d, lo - margin, hi - lo + 2*margin, false);
    }
    setDomain();
}

//- Where particles leave, in the box's units, and the cells
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setDomain()
{
    for (int d = 0; d < D; ++d)
    {
        const int axis = config_.axes[d];
        const bool periodic = config_.periodic[axis];
        const double below = config_.walled[axis][0]*radii_.smallest, above = config_.walled[axis][1]*radii_.smallest;
        domainMin_[d] = periodic ? std::numeric_limits<std::int64_t>::min() : box_.toFixed(d, config_.domainMin[axis] - below);
        domainMax_[d] = periodic ? std::numeric_limits<std::int64_t>::max() : box_.toFixed(d, config_.domainMax[axis] + above);
    }
    classes_.set(box_, radii_, reach_, Backend::gpu);
    if (others_) setPieces();
}

//- A field from values(i)
template<class Backend, int D, class P>
template<class T, class Values>
void DemSolver<Backend, D, P>::uploadField(int field, const Values& values)
{
    std::vector<T> all(n_);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n_; ++i) all[i] = values(i);
    fields_.upload(context_, field, all);
}

//- Components of vectors in the solver's axes, or the one spin of 2D
template<class Backend, int D, class P>
template<class T>
void DemSolver<Backend, D, P>::uploadVector(int field, int components, const std::vector<double>& from, bool spin)
{
    if (from.empty()) return;               // memory begins as zero
    for (int d = 0; d < components; ++d)
    {
        const int axis = spin && D == 2 ? config_.axes[2] : config_.axes[d];
        const double sign = spin && D == 2 ? spinSign() : 1;
        uploadField<T>(field + d, [&](int i) { return T(sign*from[3*std::size_t(i) + axis]); });
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setFields()
{
    const DemParticles& in = given_->particles;
    static const char* axis[3] = {"x", "y", "z"};
    const auto addVector = [&](const char* name, int components)
    {
        const int first = fields_.fields();
        for (int d = 0; d < components; ++d) fields_.template add<real>(std::string(name) + "." + axis[components == 1 ? 2 : d]);
        return first;
    };
    xField_ = fields_.fields();
    for (int d = 0; d < D; ++d) fields_.template add<std::int64_t>(std::string("position.") + axis[d]);
    vField_ = fields_.fields();
    for (int d = 0; d < D; ++d) fields_.template add<double>(std::string("velocity.") + axis[d]);
    wField_ = addVector("spin", S);
    fField_ = addVector("force", D);
    mField_ = addVector("moment", S);
    radiusField_ = fields_.template add<real>("radius");
    massField_ = fields_.template add<real>("mass");
    inertiaField_ = fields_.template add<real>("inverseInertia");
    materialField_ = fields_.template add<std::int32_t>("material");
    groupField_ = fields_.template add<std::int32_t>("group");
    if (!input_.clumps.empty()) clumpField_ = fields_.template add<std::int32_t>("clump");
    if (config_.orientation)
    {
        turnField_ = fields_.fields();
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k) fields_.template add<real>("orientation." + std::to_string(k));
    }
    if (sleeps() || others_) calmField_ = fields_.template add<std::int32_t>("calm");
    idField_ = fields_.template add<std::int32_t>("key");
    fields_.allocate(context_, n_);
    records_.allocate(context_, n_);
    reference_.allocate(context_, std::size_t(n_)*D);
    sort_.allocate(context_, n_, classes_.cells());
    inverse_.allocate(context_, n_);
    slotOf_.allocate(context_, n_);
    if (sleeps())
    {
        wakes_.allocate(context_, n_);
        waits_.allocate(context_, n_);
    }

    for (int d = 0; d < D; ++d)
        uploadField<std::int64_t>(xField_ + d, [&](int i) { return box_.toFixed(d, in.position[3*std::size_t(i) + config_.axes[d]]); });
    uploadVector<double>(vField_, D, in.velocity, false);
    uploadVector<real>(wField_, S, in.spin, true);
    uploadField<real>(radiusField_, [&](int i) { return real(in.radius[i]); });
    uploadField<real>(massField_, [&](int i) { return real(in.mass[i]); });
    uploadField<real>(inertiaField_, [&](int i)
    { return real(1/(in.inertia.empty() ? (D == 2 ? 0.5 : 0.4)*in.mass[i]*in.radius[i]*in.radius[i] : in.inertia[i])); });
    ids_ = in.id;
    if (ids_.empty()) for (int i = 0; i < n_; ++i) ids_.push_back(i);
    uploadField<std::int32_t>(idField_, [](int i) { return i; });
    if (!in.material.empty()) fields_.upload(context_, materialField_, in.material);
    if (!in.group.empty()) fields_.upload(context_, groupField_, in.group);
    if (clumpField_ >= 0)
        fields_.upload(context_, clumpField_, in.clump.empty() ? std::vector<std::int32_t>(n_, -1) : in.clump);
    if (turnField_ >= 0)
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k)
            fields_.upload(context_, turnField_ + k, std::vector<real>(n_, real(D == 3 && k == 0)));
    if (D == 2) emptyCoordinate_.resize(n_);
    if (D == 2) for (int i = 0; i < n_; ++i) emptyCoordinate_[i] = in.position[3*std::size_t(i) + config_.axes[2]];
}

template<class Backend, int D, class P>
GroupData<D, typename P::real> DemSolver<Backend, D, P>::groupData(const DemGroup& g) const
{
    GroupData<D, real> r{};
    for (int d = 0; d < D; ++d)
    {
        r.free[d] = real(!g.held[config_.axes[d]]);
        r.force[d] = real(g.force[config_.axes[d]]);
    }
    for (int c = 0; c < S; ++c) r.moment[c] = real(D == 2 ? spinSign()*g.moment[config_.axes[2]] : g.moment[c]);
    r.freeSpin = real(!g.heldSpin);
    r.gravity = real(g.gravity);
    r.localDamping = real(g.localDamping);
    r.viscous = real(g.viscousDamping);
    r.viscousSpin = real(g.viscousSpinDamping);
    r.damped = g.localDamping > 0 || g.viscousDamping > 0 || g.viscousSpinDamping > 0;
    r.motion = g.motion;
    return r;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setGroups()
{
    if (input_.groups.empty()) input_.groups.emplace_back();
    std::vector<GroupData<D, real>> groups;
    for (const DemGroup& g : input_.groups)
    {
        groupMotions_ = std::max(groupMotions_, g.motion + 1);
        groups.push_back(groupData(g));
    }
    groups_.upload(context_, groups);
    if (groupMotions_) motions_.allocate(context_, std::size_t(groupMotions_)*samples*rigidMotionNumbers);
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setBonds()
{
    const DemBonds& in = given_->bonds;
    nBonds_ = int(in.size());
    if (!nBonds_) return;
    const DemParticles& q = given_->particles;
    std::vector<int> keyOf;
    for (int i = 0; i < n_; ++i)
    {
        if (std::size_t(ids_[i]) >= keyOf.size()) keyOf.resize(std::size_t(ids_[i]) + 1, -1);
        keyOf[ids_[i]] = i;
    }
    std::vector<std::int32_t> end[2], type(in.type);
    std::vector<double> rest(in.gap);
    std::vector<int> first(n_ + 1, 0);
    type.resize(nBonds_, 0);
    for (int k = 0; k < nBonds_; ++k)
    {
        const int a = keyOf[in.a[k]], b = keyOf[in.b[k]];
        end[0].push_back(a);
        end[1].push_back(b);
        ++first[a + 1];
        ++first[b + 1];
        if (!in.gap.empty()) continue;
        double d2 = 0;
        for (int d = 0; d < D; ++d)
        {
            const int axis = config_.axes[d];
            const std::int64_t xa = box_.toFixed(d, q.position[3*std::size_t(a) + axis]), xb = box_.toFixed(d, q.position[3*std::size_t(b) + axis]);
            const double s = double(std::int64_t(std::uint64_t(xb) - std::uint64_t(xa)))*box_.unit[d];
            d2 += s*s;
        }
        rest.push_back(std::sqrt(d2) - double(real(q.radius[a])) - double(real(q.radius[b])));
    }
    for (int i = 0; i < n_; ++i) first[i + 1] += first[i];
    std::vector<int> next(first.begin(), first.end() - 1), reference(2*std::size_t(nBonds_));
    for (int k = 0; k < nBonds_; ++k)
        for (int e = 0; e < 2; ++e) reference[next[end[e][k]]++] = 2*k + e;
    std::vector<BondParameters<real>> types;
    for (const DemBondType& t : input_.bondTypes)
    {
        const auto strength = [](double s) { return real(std::min(s, 1e30)); };
        types.push_back(BondParameters<real>
        {
            real(t.normalStiffness), real(t.shearStiffness), strength(t.tensileStrength), strength(t.shearStrength),
            real(2*t.dampingRatio), real(t.radiusFactor), t.radiusKind == BondRadiusKind::harmonic, D == 3 || t.cylinder
        });
    }
    for (int e = 0; e < 2; ++e) bondIds_[e].upload(context_, end[e]);
    bondType_.upload(context_, type);
    bondRest_.upload(context_, rest);
    bondTypes_.upload(context_, types);
    bondBroken_.upload(context_, std::vector<std::int32_t>(nBonds_, 0));
    bondHistory_.upload(context_, std::vector<real>(std::size_t(nBonds_)*bondHistory<D>, real(0)));
    bondForce_.allocate(context_, nBonds_);
    bondFirst_.upload(context_, first);
    bondReference_.upload(context_, reference);
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setWalls()
{
    nWalls_ = int(input_.walls.size());
    if (!nWalls_) return;
    const double cell = wallCell();
    SurfaceBuilder<D> builder;
    std::vector<WallData> walls;
    for (const DemWall& in : input_.walls)
    {
        WallData w{};
        w.material = in.material;
        w.plane = in.plane;
        surfaces_ = surfaces_ || !in.plane;
        w.motion = in.motion;
        wallMotions_ = std::max(wallMotions_, in.motion + 1);
        for (int d = 0; d < 3; ++d) w.frame.R[4*d] = 1;
        double length = 0;
        for (int d = 0; d < D; ++d) length += in.normal[config_.axes[d]]*in.normal[config_.axes[d]];
        for (int d = 0; d < D; ++d)
        {
            const int axis = config_.axes[d];
            w.point[d] = in.point[axis];
            w.normal[d] = in.normal[axis]/std::sqrt(std::max(length, 1e-300));
            w.low[d] = config_.domainMin[axis];
            w.high[d] = config_.domainMax[axis];
        }
        if (!in.plane)
        {
            std::vector<double> vertices;
            for (std::size_t v = 0; v < in.vertices.size(); v += 3)
                for (int d = 0; d < D; ++d) vertices.push_back(in.vertices[v + config_.axes[d]]);
            std::vector<int> elements(in.elements.begin(), in.elements.end());
            for (int d = 0; d < D; ++d)
            {
                const int axis = config_.axes[d];
                if (!config_.periodic[axis] || in.motion >= 0) continue;
                repeatSurface<D>(vertices, elements, d, config_.domainMin[axis], config_.domainMax[axis], cell);
            }
            builder.add(vertices, elements, cell, w);
        }
        walls.push_back(w);
    }
    walls_.upload(context_, walls);
    vertices_.upload(context_, builder.vertex);
    elements_.upload(context_, builder.element);
    sharedFirst_.upload(context_, builder.sharedFirst);
    shared_.upload(context_, builder.shared);
    cellFirst_.upload(context_, builder.cellFirst);
    cellElement_.upload(context_, builder.cellElement);
    if (wallMotions_) poses_.allocate(context_, std::size_t(wallMotions_)*samples*poseNumbers);
    clearPassed();
}

//- Where steps are fused a particle's way is measured against what is around it. Who sleeps does not look where others go
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setFrames()
{
    if constexpr (Backend::gpu)
        if (fuses() && !sleeps()) parts_.frames.set(context_, box_, 3*(2*radii_.largest + reach_), 2e6);
}

//- First neighbours and forces, with a step of no length
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::prime()
{
    const int all = n_;
    context_.toDevice(const_cast<int*>(sort_.active()), &all, sizeof(int));
    host_.time = config_.startTime;
    host_.fullDt = plan_.timeStep;
    setWindow();
    host_.active = 1;
    writeClock();
    // moving walls take their places; no step has any length yet
    if (wallMotions_) forEach(context_, nWalls_, MoveWalls{walls_.data(), wallPoses(), clock_.data(), clock_.data(), 1e300, 1e300});
    rebuild(true);
    forces();
    collectForces();
    readClock();
    host_.active = 0;
    writeClock();
    // on the GPU once more: what a rebuild needs besides is loaded and has its memory before the first step
    if (Backend::gpu || host_.needRebuild) rebuild();
    context_.synchronise();
}

} // namespace riprap

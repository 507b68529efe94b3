/*  The exact state as words, so that a run continues bit for bit.

    Layout (32-bit words): magic, version, dimensions, bytes of real, backend, particles, fields,
    lanes, steps a cycle, bytes of the clock, walls, wall fields, fit of the cycle, solids; the
    clock; the energy of changes of the speed of sound; each field in the device's order; those of
    moving walls; of the solids that have not left ids, velocity, acceleration and force
    (interpolated: that of the step before, too), and the state of their own scene, its length
    before it; a checksum of all words before it.

    Of several ranks the first is sent all fields while the state is saved: the words are those of
    one process, and any number of ranks goes on with them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include "solvers/sph/driver/sphNeighbours.hpp"
#include "solvers/checkpointWords.hpp"

namespace riprap
{

namespace detail
{

static constexpr std::int32_t stateMagic = 0x72697031, stateVersion = 8;
static constexpr int stateHeader = 14;

[[noreturn]] inline void refuseState(const std::string& why)
{
    throw std::invalid_argument("saved state: " + why);
}

//- Is it a whole state of such a scene? least: words
inline void requireState(const std::vector<std::int32_t>& words, std::size_t least, int dimensions,
    std::size_t real, bool gpu)
{
    if (words.size() < least) refuseState("too short");
    if (words[0] != stateMagic) refuseState("not a riprap state");
    if (words[1] != stateVersion)
        refuseState("version " + std::to_string(words[1]) + " is not supported");
    if (!checksumFits(words))
        refuseState("checksum does not match: the data are damaged");
    if (words[2] != dimensions) refuseState("it is of " + std::to_string(words[2]) + " dimensions");
    if (words[3] != int(real)) refuseState("it was written with another precision");
    if (words[4] != int(gpu)) refuseState("it was written on another kind of device");
}

} // namespace detail

template<class Backend, int D, class P>
class SphCheckpoint
{
public:

    using real = typename P::real;

    SphCheckpoint(SphParts<Backend, D, P>& parts, SolidCoupling<Backend, D, P>& solids,
        SphNeighbours<Backend, D, P>& neighbours)
        : p_(parts), solids_(solids), neighbours_(neighbours)
    {}

    Later<std::vector<std::int32_t>> save(bool later);
    void load(const std::vector<std::int32_t>&);

private:

    static constexpr std::size_t clockWords = (sizeof(ClockData) + 3)/4;
    // the energy last
    static constexpr std::size_t headWords = detail::stateHeader + clockWords + sizeof(double)/4;

    using Words = detail::StateWords<Backend>;

    void addFields(Words&, FieldSet<Backend>&, int count, bool divided);
    std::size_t requireFit(const std::vector<std::int32_t>& words) const;
    void saveSolids(Words&, const std::vector<std::int32_t>& ids,
        const std::vector<int>& there);
    void loadSolids(const std::vector<std::int32_t>& words, std::size_t at);

    SphParts<Backend, D, P>& p_;
    SolidCoupling<Backend, D, P>& solids_;
    SphNeighbours<Backend, D, P>& neighbours_;
};

template<class Backend, int D, class P>
Later<std::vector<std::int32_t>> SphCheckpoint<Backend, D, P>::save(bool later)
{
    p_.clock.read();
    const int n = p_.ranks ? int(p_.ranks->particles().total()) : p_.fluid.active();
    double stiffening = p_.stiffening;
    if (p_.ranks) p_.ranks->sum(p_.clock.now, stiffening);
    std::vector<int> there;
    const std::vector<std::int32_t> ids = p_.solids.ids(there);
    Words words(p_.set.context, later && !p_.ranks,
        {detail::stateMagic, detail::stateVersion, D, int(sizeof(real)), int(Backend::gpu), n,
            p_.fluid.values.fields(), p_.shift, p_.cycle.steps, int(sizeof(ClockData)),
            p_.walls.bodies ? p_.walls.count : 0, p_.walls.bodies ? p_.walls.values.fields() : 0,
            int(p_.cycle.fitted) + 2*p_.cycle.full, int(there.size())});
    words.add(&p_.clock.now, sizeof(ClockData));
    words.add(&stiffening, sizeof(stiffening));
    std::size_t expected = words.size() + 1;
    for (int f = 0; f < p_.fluid.values.fields(); ++f)
        expected += (std::size_t(n)*p_.fluid.values.elementBytes(f) + 3)/4;
    const bool here = !p_.ranks || p_.ranks->first();
    if (here) words.expect(expected);
    addFields(words, p_.fluid.values, n, bool(p_.ranks));
    if (p_.walls.bodies && p_.wallRanks) p_.wallRanks->gather();
    if (p_.walls.bodies) addFields(words, p_.walls.values, p_.walls.count, false);
    if (p_.solids.side) saveSolids(words, ids, there);
    if (p_.ranks) p_.clock.read();
    if (!here) return knownWords({});
    return words.done();
}

//- Of several ranks the first has them
template<class Backend, int D, class P>
void SphCheckpoint<Backend, D, P>::addFields(
    Words& words, FieldSet<Backend>& set, int count, bool divided)
{
    const bool here = !p_.ranks || p_.ranks->first();
    for (int f = 0; f < set.fields(); ++f)
    {
        const std::size_t bytes = std::size_t(count)*set.elementBytes(f);
        if (divided) p_.ranks->gather(set, f, here ? words.room((bytes + 3)/4) : nullptr);
        else if (here) words.addOfDevice(set.bytes(f), bytes);
    }
}

template<class Backend, int D, class P>
void SphCheckpoint<Backend, D, P>::saveSolids(
    Words& words, const std::vector<std::int32_t>& ids, const std::vector<int>& there)
{
    for (const int key : there) words.add(ids[key]);
    for (const auto* a :
        {&p_.solids.velocity, &p_.solids.acceleration, &p_.solids.force, &p_.solids.forceBefore})
    {
        if (!a->size()) continue;
        const std::vector<real> all = a->download();
        std::vector<real> values;
        for (const int key : there)
            values.insert(values.end(), &all[std::size_t(key)*D], &all[std::size_t(key)*D] + D);
        words.add(values.data(), values.size()*sizeof(real));
    }
    words.addState(p_.solids.scene->savedState(words.later()));
}

//- Is it a state of this scene? \return where solids begin in it
template<class Backend, int D, class P>
std::size_t SphCheckpoint<Backend, D, P>::requireFit(const std::vector<std::int32_t>& words) const
{
    const auto fail = detail::refuseState;
    detail::requireState(words, headWords + 1, D, sizeof(real), Backend::gpu);
    if (words[6] != p_.fluid.values.fields())
        fail("it has other fields (models were switched on or off)");
    if (words[9] != int(sizeof(ClockData))) fail("it was written by another version");
    if (words[10] != (p_.walls.bodies ? p_.walls.count : 0)
        || words[11] != (p_.walls.bodies ? p_.walls.values.fields() : 0))
        fail("it has other moving walls");
    if (words[13] != p_.solids.count)
        fail("it is of " + std::to_string(words[13]) + " solid particles, the case of "
            + std::to_string(p_.solids.count));
    const int n = words[5], most = p_.ranks ? int(p_.ranks->particles().total()) : p_.fluid.n;
    if (n < 0 || n > most)
        fail("it holds " + std::to_string(n) + " particles, the case " + std::to_string(most));
    std::size_t expected = headWords + 1;
    for (int f = 0; f < p_.fluid.values.fields(); ++f)
        expected += (std::size_t(n)*p_.fluid.values.elementBytes(f) + 3)/4;
    for (int f = 0; f < words[11]; ++f)
        expected += (std::size_t(p_.walls.count)*p_.walls.values.elementBytes(f) + 3)/4;
    const std::size_t solidsAt = expected - 1,
                      solidWords = (std::size_t(p_.solids.count)*D*sizeof(real) + 3)/4;
    if (p_.solids.side)
    {
        expected += p_.solids.count + (p_.solids.forceBefore.size() ? 4 : 3)*solidWords + 1;
        if (expected > words.size()) fail("wrong length");
        expected += std::uint32_t(words[expected - 2]);
    }
    if (expected != words.size()) fail("wrong length");
    return solidsAt;
}

template<class Backend, int D, class P>
void SphCheckpoint<Backend, D, P>::load(const std::vector<std::int32_t>& given)
{
    const std::vector<std::int32_t> received = p_.ranks ? p_.ranks->ofFirst(given)
                                                        : std::vector<std::int32_t>();
    const std::vector<std::int32_t>& words = p_.ranks ? received : given;
    const std::size_t solidsAt = requireFit(words);
    const int n = words[5];
    std::size_t at = headWords;
    if (p_.solids.side) loadSolids(words, solidsAt);

    std::memcpy(static_cast<void*>(&p_.clock.now), &words[detail::stateHeader], sizeof(ClockData));
    std::memcpy(&p_.stiffening, &words[detail::stateHeader + clockWords], sizeof(p_.stiffening));
    const auto take = [&](FieldSet<Backend>& set, int count)
    {
        for (int f = 0; f < set.fields(); ++f)
        {
            const std::size_t bytes = std::size_t(count)*set.elementBytes(f);
            if (count) p_.set.context.toDevice(set.bytes(f), &words[at], bytes);
            at += (bytes + 3)/4;
        }
    };
    if (p_.ranks) neighbours_.setCapacity(n);
    take(p_.fluid.values, n);
    if (p_.walls.bodies) take(p_.walls.values, p_.walls.count);
    p_.shift = words[7];
    p_.cycle.steps = words[8];
    p_.cycle.fitted = words[12] & 1;
    p_.cycle.full = words[12]/2;
    // memory laid out by the number of particles
    p_.fluid.setLoaded(n);
    if (p_.solids.side) p_.solids.allocateAction(p_.fluid.n);
    if constexpr (Backend::gpu)
    {
        p_.memory.graphs.forget();
        neighbours_.allocateLists();
    }
    if (p_.ranks) p_.ranks->begin(p_.clock.now, p_.stiffening);
    p_.clock.write();
    neighbours_.rebuild();
    if (p_.ranks) neighbours_.fitCapacity();
    p_.set.context.synchronise();
}

template<class Backend, int D, class P>
void SphCheckpoint<Backend, D, P>::loadSolids(
    const std::vector<std::int32_t>& words, std::size_t at)
{
    std::vector<int> there;
    const std::vector<std::int32_t> ids = p_.solids.ids(there);
    std::map<std::int32_t, int> keyOf;
    for (const int key : there) keyOf[ids[key]] = key;
    std::vector<int> keys(p_.solids.count);
    for (int i = 0; i < p_.solids.count; ++i)
    {
        const auto found = keyOf.find(words[at + i]);
        if (found == keyOf.end())
            throw std::invalid_argument("saved state: it is of other solid particles");
        keys[i] = found->second;
        keyOf.erase(found);
    }
    at += p_.solids.count;
    for (auto* a :
        {&p_.solids.velocity, &p_.solids.acceleration, &p_.solids.force, &p_.solids.forceBefore})
    {
        if (!a->size()) continue;
        std::vector<real> values(std::size_t(p_.solids.count)*D), all(values.size());
        std::memcpy(values.data(), &words[at], values.size()*sizeof(real));
        for (int i = 0; i < p_.solids.count; ++i)
            std::copy_n(&values[std::size_t(i)*D], D, &all[std::size_t(keys[i])*D]);
        p_.set.context.toDevice(a->data(), all.data(), all.size()*sizeof(real));
        at += (all.size()*sizeof(real) + 3)/4;
    }
    const std::vector<std::int32_t> own(
        words.begin() + at + 1, words.begin() + at + 1 + std::uint32_t(words[at]));
    p_.solids.scene->loadState(own);
    solids_.showForces();
}

} // namespace riprap

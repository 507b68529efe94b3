/*  The exact state as words, so that a run continues bit for bit.

    Without solids it is the same on the CPU and the GPU: a run goes on from it on the other, where
    only rounding is different.

    Layout (32-bit words): magic, version, dimensions, bytes of real, backend, particles, fields
    (and whose memory of a transfer is among them), cells, bytes of the clock; the clock; each field
    of the particles in the device's order; phi, p, and the velocities of the faces, their last
    changes and what particles took, with multirate the changes and means of its interval; what
    openings remember; the states of tiles; of solids, each after its length, what
    bodies remember and the state of their own scene; a checksum of all words before it.

    Of several ranks the first has all words, those of one process; any number of ranks reads them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/driver/cellCutter.hpp"
#include "solvers/pic/driver/freeSurface.hpp"
#include "solvers/pic/driver/savedArrays.hpp"
#include "solvers/checkpointWords.hpp"

namespace riprap
{

namespace detail
{
static constexpr std::int32_t picMagic = 0x72697032, picVersion = 7;
static constexpr int picHeader = 9;
static constexpr std::size_t picClockWords = (sizeof(PicClock) + 3)/4;
}

template<class Backend, int D, class P>
class PicCheckpoint
{
public:

    using real = typename P::real;

    PicCheckpoint
    (
        PicParts<Backend, D, P>& parts,
        ParticleAdvection<Backend, D, P>& advection,
        FreeSurface<Backend, D, P>& surface,
        OpenBoundaries<Backend, D, P>& openings,
        CellCutter<Backend, D, P>& cutter
    )
    :
        p_(parts), advection_(advection), surface_(surface), openings_(openings), cutter_(cutter)
    {}

    Later<std::vector<std::int32_t>> save(bool later);
    //- Of several ranks the first's words count
    void load(const std::vector<std::int32_t>&);

private:

    //- Of a state: where what openings, slow tiles and solids remember begins, and what bodies do
    struct Found { std::size_t openingsAt, slowAt, solidsAt; std::vector<double> bodies; };

    static constexpr int withMultirate = 1 << 16;
    int clockMark() const
    {
        return int(sizeof(PicClock)) + (p_.multirate() ? withMultirate : 0);
    }

    template<class F> void forEachSaved(const F&);
    std::size_t words(const SavedArray& a, std::int64_t particles) const
    {
        return (a.each*savedCount(p_, a, particles) + 3)/4;
    }
    void readParticles(const std::vector<std::int32_t>& words);
    void check(const std::vector<std::int32_t>& words) const;
    Found find(const std::vector<std::int32_t>& words);
    void recut();

    PicParts<Backend, D, P>& p_;
    ParticleAdvection<Backend, D, P>& advection_;
    FreeSurface<Backend, D, P>& surface_;
    OpenBoundaries<Backend, D, P>& openings_;
    CellCutter<Backend, D, P>& cutter_;
};

template<class Backend, int D, class P>
template<class F>
void PicCheckpoint<Backend, D, P>::forEachSaved(const F& f)
{
    FaceVelocities<Backend, D, P>& faces = p_.faces;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    PressureOfWater<Backend, D, P>& pressure = p_.pressure;
    for (int k = 0; k < particles.values.fields(); ++k)
        f(SavedArray{particles.values.bytes(k), std::size_t(particles.values.elementBytes(k)),
            SavedArray::particles});
    const auto ofGrid = [&](auto& array, int direction)
    {
        if (array.size())
            f(SavedArray{reinterpret_cast<unsigned char*>(array.data()), sizeof(*array.data()),
                direction});
    };
    ofGrid(p_.surface.phi, -1);
    for (auto* p : {&pressure.p, &pressure.reflected, &pressure.total}) ofGrid(*p, -1);
    for (int d = 0; d < D; ++d)
        for (auto* a :
            {&faces.u[d], &faces.change[d], &faces.after[d], &p_.slow.change[d], &p_.slow.mean[d]})
            ofGrid(*a, d);
}

template<class Backend, int D, class P>
Later<std::vector<std::int32_t>> PicCheckpoint<Backend, D, P>::save(bool later)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    const std::int64_t count = particles.all();
    detail::StateWords<Backend> words(p_.set.context, later && !p_.halo,
        {detail::picMagic, detail::picVersion, D, int(sizeof(real)), int(Backend::gpu), int(count),
            particles.values.fields() + 256*particles.scheme.mark(), p_.set.whole().cells(),
            clockMark()});
    words.add(&p_.set.clock, sizeof(PicClock));
    std::size_t expected = words.size() + 1;
    forEachSaved([&](const SavedArray& a) { expected += this->words(a, count); });
    words.expect(expected);
    const std::vector<std::size_t> order = orderOfAll(p_);
    forEachSaved([&](const SavedArray& a)
    {
        if (p_.halo) saveOfRanks(p_, a, order, words.room(this->words(a, count)));
        else words.addOfDevice(a.data, a.each*savedCount(p_, a, count));
    });
    if (p_.opens())
    {
        const std::vector<double> memory = p_.openings.memory();
        words.add(memory.data(), memory.size()*sizeof(double));
    }
    if (p_.multirate())
    {
        const std::vector<double> memory = p_.slow.memory();
        words.add(memory.data(), memory.size()*sizeof(double));
    }
    if (p_.solids.bodies)
    {
        const std::vector<double> memory = p_.solids.bodies->forces.memory();
        words.add(int(memory.size()));
        words.add(memory.data(), memory.size()*sizeof(double));
        words.addState(p_.inside.scene->savedState(words.later()));
    }
    if (p_.halo && p_.halo->ranks().rank() > 0) return knownWords({});
    return words.done();
}

template<class Backend, int D, class P>
void PicCheckpoint<Backend, D, P>::check(const std::vector<std::int32_t>& words) const
{
    const auto fail = [](const std::string& why)
    { throw std::invalid_argument("saved state: " + why); };
    if (words.size() < detail::picHeader + detail::picClockWords + 1) fail("too short");
    if (words[0] != detail::picMagic) fail("not a state of PIC");
    if (words[1] != detail::picVersion)
        fail("version " + std::to_string(words[1]) + " is not supported");
    if (!detail::checksumFits(words))
        fail("checksum does not match: the data are damaged");
    if (words[2] != D) fail("it is of " + std::to_string(words[2]) + " dimensions");
    if (words[3] != int(sizeof(real))) fail("it was written with another precision");
    if (p_.solids.bodies && words[4] != int(Backend::gpu))
        fail("it was written on another kind of device, which keeps the contacts of solids in "
             "another order");
    if (words[6] != p_.particles.values.fields() + 256*p_.particles.scheme.mark())
        fail("it has other fields (the transfer was changed)");
    if (words[7] != p_.set.whole().cells())
        fail("it has " + std::to_string(words[7]) + " cells, the mesh "
            + std::to_string(p_.set.whole().cells()));
    if (words[8]/withMultirate != clockMark()/withMultirate)
        fail(std::string("it was written with") + (p_.multirate() ? "out" : "") + " multirate");
    if (words[8] != clockMark()) fail("it was written by another version");
    const int n = words[5];
    const std::size_t room = p_.halo ? std::size_t(p_.set.clock.initial)
                                     : p_.particles.values.size();
    if (n < 0 || (std::size_t(n) > room && !p_.opens()))
        fail("it holds " + std::to_string(n) + " particles, the case " + std::to_string(room));
}

//- With as many particles as it has
template<class Backend, int D, class P>
typename PicCheckpoint<Backend, D, P>::Found PicCheckpoint<Backend, D, P>::find(
    const std::vector<std::int32_t>& words)
{
    std::size_t expected = detail::picHeader + detail::picClockWords + 1;
    forEachSaved([&](const SavedArray& a) { expected += this->words(a, words[5]); });
    Found found{expected - 1, 0, 0, {}};
    if (p_.opens()) expected += 2*p_.openings.memorySize();
    found.slowAt = expected - 1;
    if (p_.multirate()) expected += 2*p_.slow.memorySize();
    found.solidsAt = expected - 1;
    if (p_.solids.bodies && words.size() > expected)
    {
        const std::size_t count = std::size_t(std::max(words[found.solidsAt], 0));
        expected += 1 + 2*count;
        if (words.size() > expected)
        {
            found.bodies.resize(count);
            std::memcpy(found.bodies.data(), &words[found.solidsAt + 1], count*sizeof(double));
            expected += 1 + std::size_t(std::uint32_t(words[expected - 1]));
        }
    }
    if (expected != words.size()) throw std::invalid_argument("saved state: wrong length");
    return found;
}

//- Particles and grid
template<class Backend, int D, class P>
void PicCheckpoint<Backend, D, P>::readParticles(const std::vector<std::int32_t>& words)
{
    const std::size_t first = detail::picHeader + detail::picClockWords;
    std::vector<std::size_t> own;
    if (p_.halo)
    {
        std::vector<const std::int32_t*> fields;
        std::size_t at = first;
        forEachSaved([&](const SavedArray& a)
        {
            fields.push_back(&words[at]);
            at += this->words(a, words[5]);
        });
        own = seenOf(p_, fields, words[5]);
        p_.particles.n = 0;
        p_.particles.reserve(own.size());
        p_.particles.n = int(own.size());
        p_.particles.setAll(words[5]);
    }
    std::size_t at = first;
    forEachSaved([&](const SavedArray& a)
    {
        loadArray(p_, a, own, &words[at], words[5]);
        at += this->words(a, words[5]);
    });
}

template<class Backend, int D, class P>
void PicCheckpoint<Backend, D, P>::load(const std::vector<std::int32_t>& ofFirst)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    const std::vector<std::int32_t> words = p_.halo ? wordsOfFirst(p_.halo->ranks(), ofFirst)
                                                    : ofFirst;
    check(words);
    const int n = words[5], before = particles.n;
    if (p_.opens()) particles.reserve(n);
    particles.n = n;
    Found found;
    try
    {
        found = find(words);
        if (p_.solids.bodies && !p_.solids.bodies->forces.setMemory(found.bodies))
            throw std::invalid_argument("saved state: it has other solids");
    }
    catch (...)
    {
        particles.n = before;
        throw;
    }
    if (p_.solids.bodies)
    {
        const std::size_t at = found.solidsAt + 1 + 2*found.bodies.size();
        p_.inside.scene->loadState(
            std::vector<std::int32_t>(words.begin() + at + 1, words.end() - 1));
        p_.solids.bodies->reader.read();
        p_.solids.loaded = true;
    }
    std::memcpy(static_cast<void*>(&p_.set.clock), &words[detail::picHeader], sizeof(PicClock));
    readParticles(words);
    if (p_.opens())
    {
        std::vector<double> memory(p_.openings.memorySize());
        std::memcpy(memory.data(), &words[found.openingsAt], memory.size()*sizeof(double));
        p_.openings.setMemory(memory.data());
    }
    recut();
    if (p_.multirate())
    {
        std::vector<double> memory(p_.slow.memorySize());
        std::memcpy(memory.data(), &words[found.slowAt], memory.size()*sizeof(double));
        p_.slow.setMemory(p_.set.context, memory.data(), particles.sort);
    }
    p_.set.context.synchronise();
}

//- The grid, and the order of particles, as the state has them
template<class Backend, int D, class P>
void PicCheckpoint<Backend, D, P>::recut()
{
    PicClock& clock = p_.set.clock;
    if (p_.cuts())
    {
        cutter_.cut(clock.time, clock.lastStep > 0 ? clock.lastStep : 1);
        p_.cut.forStep = p_.cut.moves && clock.steps > 0;
    }
    if (p_.opens()) openings_.setFaces(clock.time);
    advection_.sort();
    p_.rows.forget();
    surface_.markWater();
    surface_.measure();
}

} // namespace riprap

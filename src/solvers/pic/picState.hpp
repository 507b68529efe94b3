/*  PicSolver: the exact state as words, so that a run continues bit for bit.

    Without solids it is the same on the CPU and the GPU: a run goes on from it on the other, where
    only rounding is different.

    Layout (32-bit words): magic, version, dimensions, bytes of real, backend, particles, fields
    (and whose memory of a transfer is among them), cells, bytes of the clock; the clock; each field
    of the particles in the device's order; phi, p, and the velocities of the faces, their last
    changes and what particles took; what openings remember; of solids, each after its length, what
    bodies remember and the state of their own scene; a checksum (FNV-1a over all words before it).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/picSolver.hpp"
#include "solvers/checkpointWords.hpp"

namespace riprap
{

namespace detail
{
static constexpr std::int32_t picMagic = 0x72697032, picVersion = 7;
static constexpr int picHeader = 9;
}

template<class Backend, int D, class P>
template<class F>
void PicSolver<Backend, D, P>::forEachSaved(const F& f)
{
    for (int k = 0; k < set_.fields(); ++k) f(set_.bytes(k), std::size_t(n_)*set_.elementBytes(k));
    f(reinterpret_cast<unsigned char*>(phi_.data()), phi_.size()*sizeof(real));
    for (auto* p : {&pressure_, &reflected_, &whole_})
        f(reinterpret_cast<unsigned char*>(p->data()), p->size()*sizeof(double));
    for (int d = 0; d < D; ++d)
        for (auto* a : {&u_[d], &change_[d], &after_[d]})
            f(reinterpret_cast<unsigned char*>(a->data()), a->size()*sizeof(real));
}

template<class Backend, int D, class P>
std::vector<std::int32_t> PicSolver<Backend, D, P>::saveState()
{
    std::vector<std::int32_t> words{detail::picMagic, detail::picVersion, D, int(sizeof(real)),
        int(Backend::gpu), n_, set_.fields() + 256*fromFaces_.mark(), grid_.cells(),
        int(sizeof(PicClock))};
    detail::appendBytes(words, &clock_, sizeof(PicClock));
    std::size_t expected = words.size() + 1;
    forEachSaved([&](unsigned char*, std::size_t size) { expected += (size + 3)/4; });
    words.reserve(expected);
    forEachSaved([&](unsigned char* data, std::size_t size)
    {
        const std::size_t at = words.size();
        words.resize(at + (size + 3)/4, 0);
        if (size) context_.toHost(&words[at], data, size);
    });
    if (opens())
    {
        const std::vector<double> memory = openingMemory();
        detail::appendBytes(words, memory.data(), memory.size()*sizeof(double));
    }
    if (bodies_)
    {
        const std::vector<double> memory = bodies_->memory();
        words.push_back(int(memory.size()));
        detail::appendBytes(words, memory.data(), memory.size()*sizeof(double));
        const std::vector<std::int32_t> solids = inside_.scene->saveState();
        words.push_back(std::int32_t(std::uint32_t(solids.size())));
        words.insert(words.end(), solids.begin(), solids.end());
    }
    words.push_back(detail::checksum(words, words.size()));
    return words;
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::loadState(const std::vector<std::int32_t>& words)
{
    const auto fail = [](const std::string& why)
    { throw std::invalid_argument("saved state: " + why); };
    const std::size_t clockWords = (sizeof(PicClock) + 3)/4;
    if (words.size() < detail::picHeader + clockWords + 1) fail("too short");
    if (words[0] != detail::picMagic) fail("not a state of PIC");
    if (words[1] != detail::picVersion)
        fail("version " + std::to_string(words[1]) + " is not supported");
    if (detail::checksum(words, words.size() - 1) != words.back())
        fail("checksum does not match: the data are damaged");
    if (words[2] != D) fail("it is of " + std::to_string(words[2]) + " dimensions");
    if (words[3] != int(sizeof(real))) fail("it was written with another precision");
    if (bodies_ && words[4] != int(Backend::gpu))
        fail("it was written on another kind of device, which keeps the contacts of solids in "
             "another order");
    if (words[6] != set_.fields() + 256*fromFaces_.mark())
        fail("it has other fields (the transfer was changed)");
    if (words[7] != grid_.cells())
        fail("it has " + std::to_string(words[7]) + " cells, the mesh "
            + std::to_string(grid_.cells()));
    if (words[8] != int(sizeof(PicClock))) fail("it was written by another version");
    const int n = words[5];
    if (n < 0 || (std::size_t(n) > set_.size() && !opens()))
        fail("it holds " + std::to_string(n) + " particles, the case "
            + std::to_string(set_.size()));
    const int before = n_;
    if (opens()) reserve(n);
    n_ = n;
    std::size_t at = detail::picHeader + clockWords, expected = at + 1;
    forEachSaved([&](unsigned char*, std::size_t size) { expected += (size + 3)/4; });
    const std::size_t openingsAt = expected - 1;
    if (opens()) expected += 2*openingMemorySize();
    const std::size_t solidsAt = expected - 1;
    std::vector<double> memory;
    if (bodies_ && words.size() > expected)
    {
        const std::size_t count = std::size_t(std::max(words[solidsAt], 0));
        expected += 1 + 2*count;
        if (words.size() > expected)
        {
            memory.resize(count);
            std::memcpy(memory.data(), &words[solidsAt + 1], count*sizeof(double));
            expected += 1 + std::size_t(std::uint32_t(words[expected - 1]));
        }
    }
    if (expected != words.size()) { n_ = before; fail("wrong length"); }
    if (bodies_)
    {
        if (!bodies_->setMemory(memory)) { n_ = before; fail("it has other solids"); }
        const std::size_t at = solidsAt + 1 + 2*memory.size();
        inside_.scene->loadState(
            std::vector<std::int32_t>(words.begin() + at + 1, words.end() - 1));
        bodies_->read();
        bodiesLoaded_ = true;
    }
    std::memcpy(static_cast<void*>(&clock_), &words[detail::picHeader], sizeof(PicClock));
    forEachSaved([&](unsigned char* data, std::size_t size)
    {
        if (size) context_.toDevice(data, &words[at], size);
        at += (size + 3)/4;
    });
    if (opens())
    {
        std::vector<double> memory(openingMemorySize());
        std::memcpy(memory.data(), &words[openingsAt], memory.size()*sizeof(double));
        setOpeningMemory(memory.data());
    }
    if (cuts())
    {
        cutGrid(clock_.time, clock_.lastStep > 0 ? clock_.lastStep : 1);
        cutForStep_ = insideMoves_ && clock_.steps > 0;
    }
    if (opens()) setOpenFaces(clock_.time);
    sortParticles();
    rows_.forget();
    markWater();
    double sums[3];
    volume_ = waterVolume(sums);
    flying_ = sumOverWater<1>(CountFlying<D, real>{grid_, particles(), near_.data()})[0];
    context_.synchronise();
}

} // namespace riprap

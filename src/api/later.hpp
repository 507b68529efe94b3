/*  What a scene has now, for one who takes it while the scene moves on.

        const Later<FluidState> asItWas = scene.fluidLater();
        scene.advance(...);                     // meanwhile, on a thread of its own:
        const FluidState state = asItWas.take();

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace riprap
{

template<class T>
struct Later
{
    std::size_t size = 0;           // particles, of a state words
    //- Called once at most, by any thread, while the scene is there
    std::function<T()> take;
};

//- Of what is there already
template<class T>
Later<T> known(T value, std::size_t size)
{
    const auto kept = std::make_shared<T>(std::move(value));
    return {size, [kept] { return std::move(*kept); }};
}

//- Of particles: where it may not wait, it is taken at once
template<class T>
Later<T> takenOf(bool mayWait, std::size_t size, std::function<T()> take)
{
    if (mayWait) return {size, std::move(take)};
    T there = take();
    const std::size_t n = there.id.size();
    return known(std::move(there), n);
}

inline Later<std::vector<std::int32_t>> knownWords(std::vector<std::int32_t> words)
{
    const std::size_t size = words.size();
    return known(std::move(words), size);
}

} // namespace riprap

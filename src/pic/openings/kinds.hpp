/*  What is given at an opening (openFaces.hpp, inflow.hpp), each by the function of time of its
    name.

        given       by what the velocity of its faces is known; pressure: it is not, and water
                    stands beyond up to a level

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/models.hpp"

namespace riprap
{

enum class Given {velocity, discharge, pressure};

struct VelocityOpening
{
    static constexpr const char* word = "velocity";
    static constexpr const char* text = "the velocity of what flows";
    static constexpr Given given = Given::velocity;
};

struct FlowRateOpening
{
    static constexpr const char* word = "flowRate";
    static constexpr const char* text = "a discharge, evenly over the part under water";
    static constexpr Given given = Given::discharge;
};

struct LevelOpening
{
    static constexpr const char* word = "level";
    static constexpr const char* text = "the height of the water that stands beyond";
    static constexpr Given given = Given::pressure;
};

using OpeningKinds = Models<VelocityOpening, FlowRateOpening, LevelOpening>;

struct OpeningKind
{
    const char* word;
    const char* text;
    Given given;

    template<class M>
    explicit OpeningKind(Model<M>) : word(M::word), text(M::text), given(M::given) {}
};

//- By its word; std::invalid_argument with the valid ones if there is none
inline Given givenAt(const std::string& word)
{ return cardOf<OpeningKind, OpeningKinds>("type", word).given; }

} // namespace riprap

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Numbers as text, the same characters as an ostream with that precision
    gives, without its cost: files of particles are mostly numbers.
\*---------------------------------------------------------------------------*/

#ifndef numberText_H
#define numberText_H

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace riprap
{

//- Characters that a number may take
inline std::size_t numberSize(int precision)
{
    return (precision > 17 ? precision : 17) + 16;
}


inline char* putNumber(char* to, double value, int precision)
{
    const std::size_t room = numberSize(precision);
    #ifdef __cpp_lib_to_chars
    return std::to_chars
    (
        to, to + room, value, std::chars_format::general, precision
    ).ptr;
    #else
    return to + std::snprintf(to, room, "%.*g", precision, value);
    #endif
}


inline char* putNumber(char* to, float value, int precision)
{
    return putNumber(to, double(value), precision);
}


inline char* putNumber(char* to, std::int64_t value, int)
{
    return std::to_chars(to, to + numberSize(0), value).ptr;
}


inline char* putNumber(char* to, std::int32_t value, int)
{
    return std::to_chars(to, to + numberSize(0), value).ptr;
}

} // End namespace riprap

#endif

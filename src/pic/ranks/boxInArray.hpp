/*  A box of an array of the grid, packed for a message and unpacked from one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"
#include "pic/ranks/gridBricks.hpp"

namespace riprap
{

struct BoxInArray
{
    int first = 0, n[2] = {1, 1}, stride[3] = {0, 0, 0};

    //- origin: the cell that value 0 of the array is of; strides: of the array
    BoxInArray(const CellBox& box, const int* origin, const int* strides)
    {
        for (int d = 0; d < 3; ++d)
        {
            stride[d] = strides[d];
            first += (box.low[d] - origin[d])*stride[d];
            if (d < 2) n[d] = box.high[d] - box.low[d];
        }
    }

    //- Of an array whose values stand x first
    BoxInArray(const CellBox& box, const CellBox& array)
        : BoxInArray(box, array.low, Strides(array).of)
    {}

    //- Number in the array of value i of the box
    HD int at(int i) const
    {
        return first + i % n[0]*stride[0] + i/n[0] % n[1]*stride[1] + i/(n[0]*n[1])*stride[2];
    }

private:

    struct Strides
    {
        int of[3];

        explicit Strides(const CellBox& array) : of{1, 0, 0}
        {
            of[1] = array.high[0] - array.low[0];
            of[2] = of[1]*(array.high[1] - array.low[1]);
        }
    };
};

template<class T>
struct PackBox
{
    static constexpr const char* name = "packHalo";
    BoxInArray box;
    const T* from;
    T* to;

    HD void operator()(int i) const { to[i] = from[box.at(i)]; }
};

template<class T>
struct UnpackBox
{
    static constexpr const char* name = "unpackHalo";
    BoxInArray box;
    const T* from;
    T* to;

    HD void operator()(int i) const { to[box.at(i)] = from[i]; }
};

} // namespace riprap

/*  The splines there are, and from an order to a type.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <type_traits>
#include "api/models.hpp"

namespace riprap
{

struct LinearBSpline
{
    static constexpr const char* word = "linear";
    static constexpr int order = 1;
};
struct QuadraticBSpline
{
    static constexpr const char* word = "quadratic";
    static constexpr int order = 2;
};
struct CubicBSpline
{
    static constexpr const char* word = "cubic";
    static constexpr int order = 3;
};

using Splines = Models<LinearBSpline, QuadraticBSpline, CubicBSpline>;

//- f(std::integral_constant<int, order>)
template<class F>
void withSpline(int order, const F& f)
{
    bool found = false;
    Splines::each([&](auto spline)
    {
        constexpr int own = decltype(spline)::type::order;
        if (own != order) return;
        found = true;
        f(std::integral_constant<int, own>());
    });
    if (!found) throw std::logic_error("no splines of order " + std::to_string(order));
}

} // namespace riprap

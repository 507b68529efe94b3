// SPDX-License-Identifier: GPL-3.0-or-later
/*  The furthest particle along a direction that belongs to the fluid rather than to the spray.

    A particle counts when at least minNeighbours others lie within the kernel's support of it: with
    1, single particles that fly ahead do not move the front, and the thin tip of a surge, a file of
    particles, still does. Only the particles near the far end are looked at: a window behind the
    furthest one, doubled until it holds a particle that counts.
*/
#ifndef fluidFront_hpp
#define fluidFront_hpp

#include "api/sphScene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace riprap
{

inline double along(const double* x, const Vector3& origin, const Vector3& direction)
{
    return
        (x[0] - origin[0])*direction[0]
      + (x[1] - origin[1])*direction[1]
      + (x[2] - origin[2])*direction[2];
}

struct FrontRule
{
    Vector3 origin{{0, 0, 0}};
    Vector3 direction{{1, 0, 0}};           // unit
    Vector3 up{{0, 1, 0}};                  // unit
    double maxHeight = std::numeric_limits<double>::infinity();     // [m] above origin along up
    double support = 0;                     // [m]
    int minNeighbours = 0;
};

//- Of particles on the host: see FluidScene::farEnd
inline FluidEnd farEnd(const std::vector<double>& position, const Vector3& direction, double reach)
{
    const Vector3 zero{{0, 0, 0}};
    double first = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < position.size(); i += 3)
        first = std::max(first, along(&position[i], zero, direction));

    FluidEnd end;
    end.particles = position.size()/3;
    for (std::size_t i = 0; i < position.size(); i += 3)
    {
        if (along(&position[i], zero, direction) >= first - reach)
            end.position.insert(end.position.end(), &position[i], &position[i] + 3);
    }
    return end;
}

struct FrontCandidate
{
    double s;                   // (x - origin).direction [m]
    std::size_t particle;
};

//- Furthest first. What is not a number is in no window
inline std::vector<FrontCandidate> frontWindow(
    const std::vector<double>& position, const FrontRule& rule)
{
    std::vector<FrontCandidate> window;
    for (std::size_t i = 0; 3*i < position.size(); ++i)
    {
        const double s = along(&position[3*i], rule.origin, rule.direction);
        if (s > -std::numeric_limits<double>::infinity()) window.push_back({s, i});
    }
    std::sort
    (
        window.begin(), window.end(),
        [](const FrontCandidate& a, const FrontCandidate& b) { return a.s > b.s; }
    );
    return window;
}

//- Of candidate c, counted up to what the rule needs
inline int frontNeighbours
(
    const std::vector<FrontCandidate>& window,
    std::size_t c,
    const std::vector<double>& position,
    const FrontRule& rule
)
{
    const double s = window[c].s;
    const double* x = &position[3*window[c].particle];
    const auto near = [&](std::size_t other)
    {
        const double* y = &position[3*window[other].particle];
        const double dx = x[0] - y[0], dy = x[1] - y[1], dz = x[2] - y[2];
        return dx*dx + dy*dy + dz*dz < rule.support*rule.support;
    };

    int neighbours = 0;
    for (std::size_t o = c; o-- > 0 && window[o].s - s < rule.support;)
    {
        neighbours += near(o);
    }
    for
    (
        std::size_t o = c + 1;
        o < window.size() && s - window[o].s < rule.support
     && neighbours < rule.minNeighbours;
        ++o
    )
    {
        neighbours += near(o);
    }
    return neighbours;
}

//- The particles no further than a reach behind the furthest one, and those of them in order
struct FrontEnd
{
    FluidEnd end;
    std::vector<FrontCandidate> window;

    //- rule: its origin and direction alone
    FrontEnd(FluidEnd&& particles, const FrontRule& rule)
        : end(std::move(particles)), window(frontWindow(end.position, rule))
    {}
};

//- (x - origin).direction of the front particle's centre [m]; -infinity when no particle counts.
//  farEnd(reach): a FrontEnd
template<class FarEnd>
double fluidFrontOf(const FarEnd& farEnd, const FrontRule& rule)
{
    for (double reach = 4*rule.support;; reach *= 2)
    {
        const FrontEnd& far = farEnd(reach);
        const FluidEnd& end = far.end;
        const std::vector<double>& position = end.position;
        const std::vector<FrontCandidate>& window = far.window;
        if (window.empty()) break;

        const double first = window[0].s;
        const bool all = 3*end.particles == position.size();

        for (std::size_t c = 0; c < window.size(); ++c)
        {
            const double s = window[c].s;
            if (!all && s < first - reach + rule.support) break;    // neighbours may lie outside

            if (along(&position[3*window[c].particle], rule.origin, rule.up) >= rule.maxHeight)
                continue;
            if (frontNeighbours(window, c, position, rule) >= rule.minNeighbours) return s;
        }

        if (all || !std::isfinite(reach)) break;
    }

    return -std::numeric_limits<double>::infinity();
}

inline double fluidFront(const std::vector<double>& position, const FrontRule& rule)
{
    return fluidFrontOf(
        [&](double reach) { return FrontEnd(farEnd(position, rule.direction, reach), rule); },
        rule);
}

} // namespace riprap

#endif

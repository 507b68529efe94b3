/*  Viscosity on the grid, du/dt = nu lap u + F, over a step, both ways of second order in time.
    With d = nu dt/h^2, L = h^2 lap:

    explicit (Heun)      s = u + d L u, u' = (u + s + d L s)/2, stable for d <= 1/(2 D)
    implicit (Alexander 1977, SIAM J. Numer. Anal. 14: SDIRK of order 2, stable for any d, and stiff
    parts decay), c = 1 - 1/sqrt 2
        (1 - c d L) s  = u + c F dt
        (1 - c d L) u' = u + (1 - c) (d L s + F dt) + c F dt

    F, in the implicit one, is gravity and the last pressure's: what is left between walls is then
    no more than what they do not balance. The pressure's part is taken off again, for the
    projection to find it anew. L u is the sum of differences to the faces about of the same
    direction; beyond a side that water sticks to it is what makes the wall's velocity at the wall;
    beyond the surface the explicit one finds the extended velocity, the implicit one nothing. Sides
    that water slides along and faces without a velocity are no neighbours. Faces whose middle lies
    in a solid that water sticks to have its velocity w; between one of those and a face in the
    water the surface lies at the part theta of h, and the difference is (w - u)/theta (ghost
    fluid).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/extrapolate.hpp"
#include "pic/cutCells/apertures.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

//- Of the way from a face in the water to one in a solid: no less than this part is water
static constexpr double nearestSolid = 0.05;

//- Distance of the middle of faces to solids: the mean of their corners'
template<int D, class R>
struct FaceDistances
{
    static constexpr const char* name = "faceDistances";
    NodeGrid<D> nodes;
    int component;
    const double* distance;     // nodes
    R* to;

    HD void operator()(int i) const
    {
        const int n = nodes.node(nodes.grid.faceIndex(component, i));
        if constexpr (D == 2)
            to[i] = R(0.5*(distance[n] + distance[n + nodes.stride(1 - component)]));
        else
        {
            const int a = nodes.stride(component == 0 ? 1 : 0),
                      b = nodes.stride(component == 2 ? 1 : 2);
            to[i] = R(0.25*(distance[n] + distance[n + a] + distance[n + b] + distance[n + a + b]));
        }
    }
};

//- The faces of one direction as viscosity sees them
template<int D, class R>
struct ViscousFaces
{
    UniformGrid<D> grid;
    int component;
    const unsigned char* layer;
    const R* wallVelocity;      // nullptr: walls rest
    bool homogeneous;           // as if all walls rested
    const R* distance;          // to solids that water sticks to; nullptr: there are none
    // of those, at faces on either side of their surfaces; nullptr: they rest
    const R* solidVelocity;

    HD bool inSolid(int i) const { return distance && !(distance[i] > R(0)); }
    HD R velocityOfWall(int i) const
    {
        return wallVelocity && !homogeneous ? wallVelocity[i] : R(0);
    }
    HD R velocityOfSolid(int i) const
    {
        return solidVelocity && !homogeneous ? solidVelocity[i] : R(0);
    }

    //- Part of the way from face i in the water to face j in a solid
    HD R theta(int i, int j) const
    {
        return maximum(distance[i]/(distance[i] - distance[j]), R(nearestSolid));
    }

    //- Velocity of the solid where that way ends
    HD R onSurface(int i, int j, R theta) const
    {
        return velocityOfSolid(i) + theta*(velocityOfSolid(j) - velocityOfSolid(i));
    }

    //- Does the equation hold there? The last layer along a periodic direction is a copy
    HD bool open(int i) const
    {
        if (layer[i] == unknownFace || layer[i] == closedFace || inSolid(i)) return false;
        return !grid.periodic[component]
            || grid.faceIndex(component, i).c[component] < grid.n[component];
    }

    //- L u
    HD R laplacian(const R* u, int i) const
    {
        return laplacian(u, i, grid.faceIndex(component, i));
    }

    HD R laplacian(const R* u, int i, const typename UniformGrid<D>::Index& f) const
    {
        R sum = 0;
        for (int d = 0; d < D; ++d)
            for (int offset = -1; offset <= 1; offset += 2)
            {
                typename UniformGrid<D>::Index at = f;
                at.c[d] += offset;
                R value;
                if (at.c[d] >= 0 && at.c[d] < grid.layers(component, d))
                {
                    const int j = grid.face(component, at);
                    if (inSolid(j))
                    {
                        const R part = theta(i, j);
                        if (!inSolid(i)) sum += (onSurface(i, j, part) - u[i])/part;
                        continue;
                    }
                    if (layer[j] == unknownFace) continue;
                    value = layer[j] == closedFace ? velocityOfWall(j) : u[j];
                }
                else if (grid.periodic[d]) value = faceValue(grid, u, component, at);
                else if (d == component || !grid.sticks[d][offset > 0]) continue;
                else
                    value = (homogeneous ? R(0) : 2*R(grid.slide[d][offset > 0][component]))
                        - u[i];
                sum += value - u[i];
            }
        return sum;
    }
};

//- to = a u + b from + c L from
template<int D, class R>
struct Diffuse
{
    static constexpr const char* name = "diffuse";
    ViscousFaces<D, R> faces;
    const R* u;
    const R* from;
    R* to;
    R a, b, c;

    HD void operator()(int i, const typename UniformGrid<D>::Index& f) const
    {
        const unsigned char layer = faces.layer[i];
        const R own = a*u[i] + b*from[i];
        to[i] = layer == unknownFace || layer == closedFace ? own
                                                            : own + c*faces.laplacian(from, i, f);
    }
};

//- The right-hand sides of the implicit stages; stage 2 finds d L s = (s - u - c F dt)/c
template<class R>
struct ViscousSource
{
    static constexpr const char* name = "viscousSource";
    const R* u;
    const R* s;                 // nullptr: stage 1
    const R* force;             // F dt
    R* to;
    R c;

    HD void operator()(int i) const
    {
        const R f = force[i];
        to[i] = u[i] + c*f;
        if (s) to[i] += (1 - c)*((s[i] - u[i] - c*f)/c + f);
    }
};

//- r = b - (1 - k L) x and p = r, where the equation holds
template<int D, class R>
struct ViscousResidual
{
    static constexpr const char* name = "viscousResidual";
    ViscousFaces<D, R> faces;
    const R* b;
    const R* x;
    R* r;
    R* p;
    R k;

    HD void operator()(int i) const
    {
        p[i] = r[i] = faces.open(i) ? b[i] - x[i] + k*faces.laplacian(x, i) : R(0);
    }
};

//- q = (1 - k L) p
template<int D, class R>
struct ViscousProduct
{
    static constexpr const char* name = "viscousProduct";
    ViscousFaces<D, R> faces;
    const R* p;
    R* q;
    R k;

    HD void operator()(int i) const
    {
        q[i] = faces.open(i) ? p[i] - k*faces.laplacian(p, i) : R(0);
    }
};

//- Faces in solids that water sticks to have the solid's velocity
template<int D, class R>
struct StickToSolids
{
    static constexpr const char* name = "stickToSolids";
    ViscousFaces<D, R> faces;
    R* u;

    HD void operator()(int i) const { if (faces.inSolid(i)) u[i] = faces.velocityOfSolid(i); }
};

//- What drags solids, for those who ask after the step
template<class R>
struct KeepSheared
{
    static constexpr const char* name = "keepSheared";
    const R* u;
    const unsigned char* layer;
    R* keptU;
    unsigned char* keptLayer;

    HD void operator()(int i) const
    {
        keptU[i] = u[i];
        keptLayer[i] = layer[i];
    }
};

template<int D, class R>
struct FaceDot
{
    static constexpr const char* name = "viscousDot";
    ViscousFaces<D, R> faces;
    const R* a;
    const R* b;

    HD void add(int i, double* sums) const
    {
        if (faces.open(i)) sums[0] += double(a[i])*double(b[i]);
    }
};

//- The last pressure in cells that have become wet since, which have none: that of their neighbours
//  and what rests between
template<int D>
struct PressureOfNewCells
{
    static constexpr const char* name = "pressureOfNewCells";
    UniformGrid<D> grid;
    const int* wet;
    const double* from;
    double* to;
    double weight[D];           // rho g h along each direction [Pa]

    HD void operator()(int i) const
    {
        to[i] = from[i];
        if (!wet[i] || from[i] != 0) return;
        const typename UniformGrid<D>::Index c = grid.cellIndex(i);
        double sum = 0;
        int count = 0;
        for (int d = 0; d < D; ++d)
            for (int offset = -1; offset <= 1; offset += 2)
            {
                const int n = grid.neighbour(c, d, offset);
                if (n < 0 || from[n] == 0) continue;
                sum += from[n] - offset*weight[d];
                ++count;
            }
        if (count) to[i] = sum/count;
    }
};

//- to = from + value; from may be nullptr: 0
template<class R>
struct SetFaces
{
    static constexpr const char* name = "setFaces";
    const R* from;
    R* to;
    R value;

    HD void operator()(int i) const { to[i] = (from ? from[i] : R(0)) + value; }
};

//- y = y + a x (or x + a y)
template<class R>
struct FaceAdd
{
    static constexpr const char* name = "viscousAdd";
    const R* x;
    R* y;
    R a;
    bool scaleY;

    HD void operator()(int i) const { y[i] = scaleY ? x[i] + a*y[i] : y[i] + a*x[i]; }
};

} // namespace riprap

/*  The true faces of walls, which no particle passes: segments (2D) or triangles (3D) in groups
    that move rigidly.

    A point is behind a surface if the vector to it from the surface's closest point has a negative
    component along the normal there. On edges and vertices that is the sum of the faces' normals
    weighted by their angles, with which the sign is right (Baerentzen & Aanaes 2005, IEEE Trans.
    Vis. Comput. Graph. 11(3), 243); on the rim of an open surface there is none, and nothing is
    behind it. A plate has a thickness: what is nearer to it than half of that is in it, whichever
    side it came from; at its rim it ends flat. Each part (the mesh's patches, each body) is asked
    for itself: a point is in the walls if it is in any of them.

    Cells of a grid in each group's frame list the elements of each part that can be the closest one
    to a point behind it, and the planes of these elements. What is in front of all planes of its
    cell is in front of the walls, since the normals on edges and vertices are positive sums of
    those of the faces there; so closest points are sought for the few particles that are behind a
    plane.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/closestPoint.hpp"
#include "core/simd/macros.hpp"

namespace riprap
{

//- The grid of a group's faces in its own frame
template<int D>
struct FaceGrid
{
    double low[D], inverseCell;
    int n[D], firstCell;
    bool moves;
};

//- Where a group is and how it moves: x = R X + t, and the rates of change; the solver's axes
template<int D>
struct FacePose
{
    double R[D][D], t[D], rateR[D][D], rateT[D];
};

//- A point behind a face: by how much [m], the way out, and which element it is
template<int D>
struct FaceHit
{
    double depth = 0;
    Vec<D, double> normal{};
    Vec<D, double> nearest{};   // on the face
    int group = -1;
    // of a plate, where the way out over its rim is shorter: that way. Whether it is open is for
    // the caller to see: plates stand on floors
    double overRim = 0;
    Vec<D, double> rimNormal{}, rimNearest{};
};

template<int D>
struct WallFaces
{
    // of an element: its own, those of its features
    static constexpr int normals = 1 + featureCount<D>;

    const double* vertex;       // D*D an element [m]
    const double* normal;       // normals*D an element; zero on a rim
    const double* half;         // of an element: half the thickness of a plate, 0: solid behind [m]
    const int* part;            // of an element
    const int* cellFirst;
    const int* cellElement;     // by part within a cell
    const int* cellFirstPlane;
    // D + 2 a plane: normal, the least n.X in front of it, and how far behind it the wall ends (0:
    // it does not)
    const double* plane;
    const FaceGrid<D>* grid;
    const FacePose<D>* pose;
    // 0: there are no faces; those of bodies in the fluid come behind them and are asked by name
    int groups;
    double tiny;                // [m] nearer to a face there is no direction from it

    //- Are there any faces that x (in space) may be behind? Quick, and no for nearly all
    HD bool near(const Vec<D, double>& x) const
    {
        for (int g = 0; g < groups; ++g) if (near(g, x)) return true;
        return false;
    }

    //- The same of one group
    HD bool near(int g, const Vec<D, double>& x) const
    {
        const Vec<D, double> X = inFrame(g, x);
        const int cell = cellOf(g, X);
        if (cell < 0) return false;
        const int last = cellFirstPlane[cell + 1];
        for (int k = cellFirstPlane[cell]; k < last; ++k)
        {
            const double* p = plane + (D + 2)*k;
            const double above = dot(X, read(p)) - p[D];
            if (above < 0 && (p[D + 1] == 0 || above > -p[D + 1])) return true;
        }
        return false;
    }

    //- The deepest face that x (in space) is behind, of walls and of some other groups; depth 0:
    //  none
    HD FaceHit<D> find(const Vec<D, double>& x, const int* others = nullptr, int count = 0) const
    {
        FaceHit<D> hit;
        for (int g = 0; g < groups; ++g) deepest(g, x, hit);
        for (int k = 0; k < count; ++k) deepest(others[k], x, hit);
        return hit;
    }

    //- Velocity of a group's material at x
    HD Vec<D, double> velocity(int g, const Vec<D, double>& x) const
    {
        Vec<D, double> u = filled<D>(0.0);
        if (!grid[g].moves) return u;
        const FacePose<D>& p = pose[g];
        for (int d = 0; d < D; ++d)
        {
            u.c[d] = p.rateT[d];
            for (int e = 0; e < D; ++e)
            {
                double X = 0;
                for (int k = 0; k < D; ++k) X += p.R[k][e]*(x.c[k] - p.t[k]);
                u.c[d] += p.rateR[d][e]*X;
            }
        }
        return u;
    }

    //- The same for a point in the frame of group g and the parts of it before this one
    HD void before(int g, int thisPart, const Vec<D, double>& X, FaceHit<D>& hit) const
    {
        search(g, X, hit, thisPart);
    }

private:

    HD void deepest(int g, const Vec<D, double>& x, FaceHit<D>& hit) const
    {
        const double before = hit.depth;
        search(g, inFrame(g, x), hit);
        if (!grid[g].moves || !(hit.depth > before)) return;
        toSpace(g, hit);
        if (hit.overRim > 0) rimToSpace(g, hit);
    }

    HD Vec<D, double> inFrame(int g, const Vec<D, double>& x) const
    {
        if (!grid[g].moves) return x;
        Vec<D, double> X;
        for (int d = 0; d < D; ++d)
        {
            X.c[d] = 0;
            for (int e = 0; e < D; ++e) X.c[d] += pose[g].R[e][d]*(x.c[e] - pose[g].t[e]);
        }
        return X;
    }

    //- Its number among those of all groups, -1: outside the group's grid
    HD int cellOf(int g, const Vec<D, double>& X) const
    {
        const FaceGrid<D>& cells = grid[g];
        int cell = 0;
        for (int d = D - 1; d >= 0; --d)
        {
            const double at = (X.c[d] - cells.low[d])*cells.inverseCell;
            if (!(at >= 0) || at >= cells.n[d]) return -1;
            cell = cell*cells.n[d] + int(at);
        }
        return cells.firstCell + cell;
    }

    HD void toSpace(int g, FaceHit<D>& hit) const
    {
        const FacePose<D>& p = pose[g];
        Vec<D, double> n, c;
        for (int d = 0; d < D; ++d)
        {
            n.c[d] = 0;
            c.c[d] = p.t[d];
            for (int e = 0; e < D; ++e)
            {
                n.c[d] += p.R[d][e]*hit.normal.c[e];
                c.c[d] += p.R[d][e]*hit.nearest.c[e];
            }
        }
        hit.normal = n;
        hit.nearest = c;
    }

    HD void rimToSpace(int g, FaceHit<D>& hit) const
    {
        FaceHit<D> rim;
        rim.normal = hit.rimNormal;
        rim.nearest = hit.rimNearest;
        toSpace(g, rim);
        hit.rimNormal = rim.normal;
        hit.rimNearest = rim.nearest;
    }

    HD Vec<D, double> read(const double* from) const
    {
        Vec<D, double> v;
        for (int d = 0; d < D; ++d) v.c[d] = from[d];
        return v;
    }

    //- Parts below `parts` alone
    HD void search(int g, const Vec<D, double>& X, FaceHit<D>& hit, int parts = 0x7fffffff) const
    {
        const int cell = cellOf(g, X);
        if (cell < 0) return;
        const int first = cellFirst[cell], last = cellFirst[cell + 1];
        for (int k = first; k < last;)
        {
            // the closest element of a part
            const int own = part[cellElement[k]], from = k;
            if (own >= parts) return;
            double least = 1e300;
            int element = -1, feature = insideElement;
            Vec<D, double> nearest{};
            for (; k < last && part[cellElement[k]] == own; ++k)
            {
                const int e = cellElement[k];
                Vec<D, double> v[D];
                for (int c = 0; c < D; ++c) v[c] = read(vertex + (e*D + c)*D);
                int f;
                const Vec<D, double> p = closestPoint(v, X, f);
                const double distance2 = squaredNorm(X - p);
                if (distance2 < least) { least = distance2; element = e; feature = f; nearest = p; }
            }
            if (!consider(g, X, element, feature, nearest, sqrt(least), hit)) continue;
            hit.overRim = 0;
            if (half[element] > 0)
                for (int j = from; j < k; ++j) considerRim(X, cellElement[j], nearest, hit);
        }
    }

    //- Is X deeper behind element e than behind those before?
    HD bool consider(int g, const Vec<D, double>& X, int e, int feature, const Vec<D, double>& p,
        double distance, FaceHit<D>& hit) const
    {
        const Vec<D, double> own = read(normal + (e*normals + feature + 1)*D);
        if (squaredNorm(own) == 0) return false;
        const bool plate = half[e] > 0;
        const double along = dot(X - p, own),
                     depth = plate ? half[e] - distance : (along < 0 ? distance : 0.0);
        if (!(depth > hit.depth)) return false;
        hit.depth = depth;
        hit.group = g;
        // straight out where that is well defined
        const double sign = plate ? 1 : -1;
        const bool clear = distance > tiny;
        hit.normal = clear ? (sign/distance)*(X - p) : own;
        hit.nearest = plate ? p + half[e]*hit.normal : p;
        return true;
    }

    //- The way out over the rims of element e of a plate whose closest point is p. They are flat:
    //  as far from p as p from the rim
    HD void considerRim(
        const Vec<D, double>& X, int e, const Vec<D, double>& p, FaceHit<D>& hit) const
    {
        for (int f = 0; f < D; ++f)
        {
            if (squaredNorm(read(normal + (e*normals + f + 1)*D)) != 0) continue;
            const Vec<D, double> a = read(vertex + (e*D + f)*D),
                                 b = read(vertex + (e*D + (f + 1)%D)*D);
            Vec<D, double> way = a - p, out = a - b;
            if constexpr (D == 3)
            {
                const Vec<D, double> along = b - a, c = read(vertex + (e*D + (f + 2)%D)*D);
                const double length2 = squaredNorm(along);
                const double at = fmin(1.0, fmax(0.0, dot(p - a, along)/length2));
                way = a + at*along - p;
                out = a - c - (dot(a - c, along)/length2)*along;
            }
            const double distance = sqrt(squaredNorm(way));
            if (!(distance < hit.depth) || (hit.overRim > 0 && distance >= hit.overRim)) continue;
            hit.overRim = fmax(distance, tiny);
            hit.rimNormal = distance > tiny ? (1/distance)*way : (1/sqrt(squaredNorm(out)))*out;
            hit.rimNearest = X + way;
        }
    }
};

} // namespace riprap

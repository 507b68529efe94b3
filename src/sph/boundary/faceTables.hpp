/*  Makes the tables of sph/boundary/wallFaces.hpp, on the host: normals of edges and vertices, the
    cells of each group's grid and their planes.

    Faces of a later part that lie wholly in the solid of an earlier one of the same group (a box's
    bottom on a floor) are left out: there the way out would be through the other solid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>
#include "sph/boundary/wallFaces.hpp"

namespace riprap
{

template<int D>
struct FaceElement
{
    Vec<D, double> v[D];
    Vec<D, double> normal;      // unit, out of the wall
    int group, part;
    double half;                // [m]
};

template<int D>
class FaceTables
{
public:
    std::vector<double> vertex{}, normal{}, half{};
    std::vector<int> part{}, cellFirst{}, cellElement{}, cellFirstPlane{};
    std::vector<double> plane{};
    std::vector<FaceGrid<D>> grid{};

    //- reach: how deep behind a face particles are looked for [m]; moves: of each group
    FaceTables(std::vector<FaceElement<D>> elements, double spacing, const std::vector<bool>& moves)
        : elements_(std::move(elements)), reach_(spacing), cell_(2*spacing),
          weld_(1e-6*spacing), moves_(moves)
    {
        order();
        fill();
        if (dropBuried()) fill();
    }

    WallFaces<D> view(const FacePose<D>* poses = nullptr) const
    {
        return WallFaces<D>{vertex.data(), normal.data(), half.data(), part.data(),
            cellFirst.data(), cellElement.data(), cellFirstPlane.data(), plane.data(), grid.data(),
            poses, int(grid.size()), tiny()};
    }

    double tiny() const { return 1e-9*reach_; }

private:

    static constexpr int normals = WallFaces<D>::normals;
    using Point = Vec<D, double>;
    using Key = std::array<std::int64_t, D>;

    std::vector<FaceElement<D>> elements_;
    double reach_, cell_, weld_;
    std::vector<bool> moves_;

    void order()
    {
        std::stable_sort(elements_.begin(), elements_.end(), [](const auto& a, const auto& b)
        { return std::make_pair(a.group, a.part) < std::make_pair(b.group, b.part); });
    }

    void fill()
    {
        for (auto* a : {&vertex, &normal, &half}) a->clear();
        for (auto* a : {&part, &cellFirst, &cellElement}) a->clear();
        grid.clear();
        for (const auto& e : elements_)
        {
            for (const Point& p : e.v) for (const double x : p.c) vertex.push_back(x);
            half.push_back(e.half);
            part.push_back(e.part);
        }
        setNormals();
        cellFirst.push_back(0);
        std::size_t at = 0;
        for (int g = 0; g < int(moves_.size()); ++g)
        {
            const std::size_t begin = at;
            while (at < elements_.size() && elements_[at].group == g) ++at;
            makeGrid(begin, at, moves_[g]);
        }
        setPlanes();
    }

    // * * * planes

    using Plane = std::array<double, D + 2>;

    //- Rounding, and not the shape, decides nearer than this [m]
    double margin() const { return 1e-7*reach_; }

    Plane planeOf(const FaceElement<D>& e) const
    {
        Plane p;
        for (int d = 0; d < D; ++d) p[d] = e.normal.c[d];
        p[D] = dot(e.normal, e.v[0]) + e.half + margin();
        p[D + 1] = e.half > 0 ? 2*(e.half + margin()) : 0;
        return p;
    }

    bool same(const Plane& a, const Plane& b) const
    {
        for (int d = 0; d < D; ++d) if (std::abs(a[d] - b[d]) > 1e-12) return false;
        return std::abs(a[D] - b[D]) < 0.01*margin()
            && std::abs(a[D + 1] - b[D + 1]) < 0.01*margin();
    }

    //- The planes of each cell's elements, those that coincide once
    void setPlanes()
    {
        cellFirstPlane.assign(1, 0);
        plane.clear();
        std::vector<Plane> own;
        for (std::size_t c = 0; c + 1 < cellFirst.size(); ++c)
        {
            own.clear();
            for (int k = cellFirst[c]; k < cellFirst[c + 1]; ++k)
            {
                const Plane p = planeOf(elements_[cellElement[k]]);
                if (std::none_of(
                        own.begin(), own.end(), [&](const Plane& q) { return same(p, q); }))
                    own.push_back(p);
            }
            for (const Plane& p : own) plane.insert(plane.end(), p.begin(), p.end());
            cellFirstPlane.push_back(int(plane.size()/(D + 2)));
        }
    }

    // * * * normals

    Key key(const Point& p) const
    {
        Key k;
        for (int d = 0; d < D; ++d) k[d] = std::int64_t(std::llround(p.c[d]/weld_));
        return k;
    }

    //- The vertices of a feature: in 3D edges 01, 12, 20 and vertices 0, 1, 2; in 2D vertices 0, 1
    static std::vector<int> cornersOf(int feature)
    {
        if (D == 2) return {feature};
        return feature < 3 ? std::vector<int>{feature, (feature + 1)%3}
                           : std::vector<int>{feature - 3};
    }

    //- The angle at which a face meets a feature
    static double weight(const FaceElement<D>& e, int feature)
    {
        if constexpr (D == 3)
        {
            if (feature < 3) return 1;
            const int c = feature - 3;
            const Point a = e.v[(c + 1)%3] - e.v[c], b = e.v[(c + 2)%3] - e.v[c];
            const double cosine = dot(a, b)/std::sqrt(squaredNorm(a)*squaredNorm(b));
            return std::acos(std::min(1.0, std::max(-1.0, cosine)));
        }
        else return 1;
    }

    void setNormals()
    {
        struct Sum { Point normal = filled<D>(0.0); int faces = 0; bool rim = false; };
        std::map<std::pair<std::pair<int, int>, std::vector<Key>>, Sum> sums;
        const auto name = [&](const FaceElement<D>& e, int f)
        {
            std::vector<Key> corners;
            for (const int c : cornersOf(f)) corners.push_back(key(e.v[c]));
            std::sort(corners.begin(), corners.end());
            return std::make_pair(std::make_pair(e.group, e.part), corners);
        };
        for (const auto& e : elements_)
            for (int f = 0; f < featureCount<D>; ++f)
            {
                Sum& s = sums[name(e, f)];
                s.normal = s.normal + weight(e, f)*e.normal;
                s.faces += 1;
            }
        // an edge (2D: a vertex) of a single face is the rim of an open surface, and so are the
        // vertices at its ends
        std::vector<std::pair<std::pair<int, int>, Key>> rim;
        for (auto& s : sums)
        {
            if (int(s.first.second.size()) != D - 1 || s.second.faces > 1) continue;
            s.second.rim = true;
            if (D == 3) for (const Key& k : s.first.second) rim.emplace_back(s.first.first, k);
        }
        for (const auto& r : rim)
            sums[std::make_pair(r.first, std::vector<Key>{r.second})].rim = true;

        const auto add = [&](const Point& n, bool none)
        {
            const double length = std::sqrt(squaredNorm(n));
            for (int d = 0; d < D; ++d)
                normal.push_back(none || !(length > 1e-12) ? 0 : n.c[d]/length);
        };
        for (const auto& e : elements_)
        {
            add(e.normal, false);
            for (int f = 0; f < featureCount<D>; ++f)
            {
                const Sum& s = sums[name(e, f)];
                add(s.normal, s.rim);
            }
        }
    }

    // * * * cells

    struct Candidate { int cell, part, element; double distance; };

    void makeGrid(std::size_t begin, std::size_t end, bool moves)
    {
        FaceGrid<D> g{};
        g.moves = moves;
        g.firstCell = int(cellFirst.size()) - 1;
        Point low = filled<D>(1e300), high = filled<D>(-1e300);
        double thickest = 0;
        for (std::size_t i = begin; i < end; ++i)
        {
            thickest = std::max(thickest, elements_[i].half);
            for (const Point& p : elements_[i].v)
                for (int d = 0; d < D; ++d)
                {
                    low.c[d] = std::min(low.c[d], p.c[d]);
                    high.c[d] = std::max(high.c[d], p.c[d]);
                }
        }
        if (begin == end)
        {
            for (int d = 0; d < D; ++d)
            {
                g.low[d] = 0;
                g.n[d] = 0;
            }
            g.inverseCell = 1;
            grid.push_back(g);
            return;
        }
        double cell = cell_, cells;
        for (;; cell *= 1.5)
        {
            cells = 1;
            for (int d = 0; d < D; ++d)
            {
                g.low[d] = low.c[d] - reach_ - thickest;
                g.n[d] = int((high.c[d] - low.c[d] + 2*(reach_ + thickest))/cell) + 1;
                cells *= g.n[d];
            }
            if (cells <= 2e7) break;
        }
        g.inverseCell = 1/cell;
        grid.push_back(g);
        listCells(begin, end, g, cell);
    }

    Point centre(const FaceGrid<D>& g, double cell, const int* c) const
    {
        Point x;
        for (int d = 0; d < D; ++d) x.c[d] = g.low[d] + (c[d] + 0.5)*cell;
        return x;
    }

    Point closest(int e, const Point& x, int& feature) const
    {
        return closestPoint(elements_[e].v, x, feature);
    }

    //- Elements near each cell, then of each part those that may be the closest one to a point of
    //  the cell that is behind the part
    void listCells(std::size_t begin, std::size_t end, const FaceGrid<D>& g, double cell)
    {
        const double radius = 0.5*std::sqrt(double(D))*cell;
        std::vector<Candidate> found;
        for (std::size_t i = begin; i < end; ++i)
        {
            const double within = reach_ + elements_[i].half + radius;
            int from[3] = {0, 0, 0}, to[3] = {0, 0, 0}, c[3];
            for (int d = 0; d < D; ++d)
            {
                double lo = 1e300, hi = -1e300;
                for (const Point& p : elements_[i].v)
                {
                    lo = std::min(lo, p.c[d]);
                    hi = std::max(hi, p.c[d]);
                }
                from[d] = std::max(0, int((lo - within - g.low[d])/cell));
                to[d] = std::min(g.n[d] - 1, int((hi + within - g.low[d])/cell));
            }
            for (c[2] = from[2]; c[2] <= to[2]; ++c[2])
                for (c[1] = from[1]; c[1] <= to[1]; ++c[1])
                    for (c[0] = from[0]; c[0] <= to[0]; ++c[0])
                    {
                        const Point x = centre(g, cell, c);
                        int feature;
                        const double distance = std::sqrt(
                            squaredNorm(x - closest(int(i), x, feature)));
                        if (distance > within) continue;
                        const int index = (c[2]*g.n[1] + c[1])*g.n[0] + c[0];
                        found.push_back(Candidate{index, elements_[i].part, int(i), distance});
                    }
        }
        std::sort(found.begin(), found.end(),
            [](const Candidate& a, const Candidate& b)
            {
                return std::make_pair(std::make_pair(a.cell, a.part), a.element)
                    < std::make_pair(std::make_pair(b.cell, b.part), b.element);
            });
        keep(found, g, cell, radius);
    }

    void keep(const std::vector<Candidate>& found, const FaceGrid<D>& g, double cell, double radius)
    {
        int cells = 1, next = 0;
        for (int d = 0; d < D; ++d) cells *= g.n[d];
        for (std::size_t k = 0; k < found.size();)
        {
            std::size_t last = k, nearest = k;
            for (; last < found.size() && found[last].cell == found[k].cell
                 && found[last].part == found[k].part;
                 ++last)
                if (found[last].distance < found[nearest].distance) nearest = last;
            for (; next < found[k].cell; ++next) cellFirst.push_back(int(cellElement.size()));
            if (meetsSolid(found[nearest], g, cell, radius))
                for (std::size_t j = k; j < last; ++j)
                    if (found[j].distance <= furthest(found[nearest], found[j], radius))
                        cellElement.push_back(found[j].element);
            k = last;
        }
        for (; next < cells; ++next) cellFirst.push_back(int(cellElement.size()));
    }

    //- Of a plate also those whose rim may be the nearest way out
    double furthest(const Candidate& nearest, const Candidate& c, double radius) const
    {
        const double half = elements_[c.element].half;
        return std::max(
            nearest.distance + 2*radius, half > 0 && hasRim(c.element) ? half + radius : 0.0);
    }

    bool hasRim(int e) const
    {
        for (int f = 0; f < D; ++f)
        {
            const double* n = &normal[(std::size_t(e)*normals + f + 1)*D];
            if (std::all_of(n, n + D, [](double x) { return x == 0; })) return true;
        }
        return false;
    }

    //- May a point of the cell be behind the part? Not if its centre is in front by more than the
    //  cell reaches
    bool meetsSolid(
        const Candidate& nearest, const FaceGrid<D>& g, double cell, double radius) const
    {
        if (nearest.distance <= radius + elements_[nearest.element].half) return true;
        if (elements_[nearest.element].half > 0) return false;
        int c[3] = {0, 0, 0}, rest = nearest.cell;
        for (int d = 0; d < D; ++d) { c[d] = rest%g.n[d]; rest /= g.n[d]; }
        const Point x = centre(g, cell, c);
        int feature;
        const Point p = closest(nearest.element, x, feature);
        const double* n = &normal[(std::size_t(nearest.element)*normals + feature + 1)*D];
        double along = 0;
        for (int d = 0; d < D; ++d) along += (x.c[d] - p.c[d])*n[d];
        return along < 0;
    }

    // * * * buried faces

    //- Is a point just outside this face, at a corner or in the middle, behind an earlier part of
    //  its group?
    bool buried(const FaceElement<D>& e) const
    {
        Point middle = filled<D>(0.0);
        for (const Point& p : e.v) middle = middle + (1.0/D)*p;
        const auto in = [&](const Point& p)
        {
            FaceHit<D> hit;
            auto faces = view();
            faces.before(e.group, e.part, p + (1e-3*reach_)*e.normal, hit);
            return hit.depth > 0;
        };
        for (const Point& p : e.v) if (!in(p + 0.01*(middle - p))) return false;
        return in(middle);
    }

    bool dropBuried()
    {
        std::vector<FaceElement<D>> left;
        for (const auto& e : elements_)
            if (e.half > 0 || !buried(e)) left.push_back(e);
        if (left.size() == elements_.size()) return false;
        elements_ = std::move(left);
        return true;
    }
};

} // namespace riprap

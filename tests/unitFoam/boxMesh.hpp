// SPDX-License-Identifier: GPL-3.0-or-later
/*  Meshes made in memory: blocks of hexahedra between nodes along x, y and z, with cells left out.

        BoxMesh box;
        box.divide(0, 0, 1, 10);                            // x from 0 to 1 in 10 cells
        box.type[5] = "patch";                              // the side zMax is open
        box.there = [](int i, int, int k) { return i < 5 || k > 2; };
        const auto mesh = box.make(time);

    Patches: xMin xMax yMin yMax zMin zMax (walls at first), then inner: faces of cells that are
    left out.
*/
#pragma once

#include "Time.H"
#include "polyMesh.H"

#include <array>
#include <functional>
#include <type_traits>
#include <vector>

struct BoxMesh
{
    std::vector<double> nodes[3] = {{0, 1}, {0, 1}, {0, 1}};
    std::array<std::string, 7> name{
        {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax", "inner"}};
    std::array<std::string, 7> type{{"wall", "wall", "wall", "wall", "wall", "wall", "wall"}};
    std::function<bool(int, int, int)> there = [](int, int, int) { return true; };
    //- Where a node goes: turns, shears, bends the block
    std::function<Foam::point(const Foam::point&)> map = [](const Foam::point& p) { return p; };

    void divide(int axis, double low, double high, int n)
    {
        nodes[axis].resize(n + 1);
        for (int i = 0; i <= n; ++i) nodes[axis][i] = low + (high - low)*i/n;
    }

    //- Both sides of an axis: empty, cyclic ..
    void sides(int axis, const std::string& kind) { type[2*axis] = type[2*axis + 1] = kind; }

    int cells(int axis) const { return int(nodes[axis].size()) - 1; }

    //- Number of each cell of the block, -1: left out
    std::vector<int> numbers() const
    {
        std::vector<int> number;
        int n = 0;
        for (int k = 0; k < cells(2); ++k)
            for (int j = 0; j < cells(1); ++j)
                for (int i = 0; i < cells(0); ++i) number.push_back(there(i, j, k) ? n++ : -1);
        return number;
    }

    //- polyMesh or fvMesh
    template<class Mesh = Foam::polyMesh>
    Foam::autoPtr<Mesh> make(const Foam::Time& time, const char* region = "region0") const
    {
        Faces faces;
        collect(faces);
        Foam::labelList owner(Foam::label(faces.size())), neighbour(faces.internal);
        Foam::faceList shapes(owner.size());
        for (int i = 0; i < owner.size(); ++i)
        {
            shapes[i] = faces.shape[i];
            owner[i] = faces.owner[i];
            if (i < faces.internal) neighbour[i] = faces.neighbour[i];
        }
        auto mesh = Foam::autoPtr<Mesh>::New
        (
            Foam::IOobject(region, time.constant(), time, Foam::IOobject::NO_READ,
                Foam::IOobject::NO_WRITE),
            points(), std::move(shapes), std::move(owner), std::move(neighbour), false
        );
        Foam::PtrList<Foam::polyPatch> list(patches(mesh(), faces));
        if constexpr (std::is_same_v<Mesh, Foam::polyMesh>) mesh->addPatches(list);
        else mesh->addFvPatches(list);
        return mesh;
    }

private:

    struct Faces
    {
        std::vector<Foam::face> shape;
        std::vector<int> owner, neighbour;
        int internal = 0;
        int start[8] = {};

        std::size_t size() const { return shape.size(); }
    };

    int node(int i, int j, int k) const
    {
        return i + int(nodes[0].size())*(j + int(nodes[1].size())*k);
    }

    Foam::pointField points() const
    {
        Foam::DynamicList<Foam::point> p;
        for (const double z : nodes[2])
            for (const double y : nodes[1])
                for (const double x : nodes[0]) p.append(map(Foam::point(x, y, z)));
        return Foam::pointField(std::move(p));
    }

    //- Of cell c its side towards axis, up or down, its normal outwards
    Foam::face side(const int (&c)[3], int axis, bool up) const
    {
        const int b = (axis + 1) % 3, e = (axis + 2) % 3;
        Foam::face f(4);
        for (int v = 0; v < 4; ++v)
        {
            int at[3] = {c[0], c[1], c[2]};
            at[axis] += up;
            at[b] += v == 1 || v == 2;
            at[e] += v == 2 || v == 3;
            f[up ? v : 3 - v] = node(at[0], at[1], at[2]);
        }
        return f;
    }

    void collect(Faces& faces) const
    {
        const std::vector<int> number(numbers());
        const int n[3] = {cells(0), cells(1), cells(2)}, step[3] = {1, n[0], n[0]*n[1]};
        // Pass -1: between cells; then a patch each
        for (int pass = -1; pass < 7; ++pass)
        {
            if (pass >= 0) faces.start[pass] = int(faces.size());
            for (int c = 0; c < int(number.size()); ++c)
            {
                if (number[c] < 0) continue;
                const int at[3] = {c % n[0], c/n[0] % n[1], c/(n[0]*n[1])};
                for (int axis = 0; axis < 3; ++axis)
                    for (int up = 0; up < 2; ++up)
                    {
                        const bool last = at[axis] == (up ? n[axis] - 1 : 0);
                        const int other = last ? -1 : number[c + (up ? 1 : -1)*step[axis]];
                        const int of = last ? 2*axis + up : other < 0 ? 6 : -1;
                        if (of != pass || (of < 0 && !up)) continue;
                        faces.shape.push_back(side(at, axis, up));
                        faces.owner.push_back(number[c]);
                        if (of < 0) faces.neighbour.push_back(other);
                    }
            }
            if (pass < 0) faces.internal = int(faces.size());
        }
        faces.start[7] = int(faces.size());
    }

    Foam::PtrList<Foam::polyPatch> patches(const Foam::polyMesh& mesh, const Faces& faces) const
    {
        Foam::PtrList<Foam::polyPatch> all(faces.start[7] > faces.start[6] ? 7 : 6);
        for (int p = 0; p < all.size(); ++p)
        {
            Foam::dictionary dict;
            dict.add("type", Foam::word(type[p]));
            dict.add("nFaces", faces.start[p + 1] - faces.start[p]);
            dict.add("startFace", faces.start[p]);
            if (type[p] == "cyclic") dict.add("neighbourPatch", Foam::word(name[p ^ 1]));
            all.set(p, Foam::polyPatch::New(Foam::word(name[p]), dict, p, mesh.boundaryMesh()));
        }
        return all;
    }
};

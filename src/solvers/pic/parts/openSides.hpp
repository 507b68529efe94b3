/*  Openings of the sides, through which water comes and goes: their faces, in the order of their
    directions, what is given at each in this step, and what has passed through each opening. Empty
    in a scene that has none.

    Of several ranks each has all faces of the block, and does the same with them; in its arrays are
    those that its part has.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"
#include "pic/openings/inflow.hpp"
#include "pic/openings/kinds.hpp"
#include "solvers/pic/parts/picSetting.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class OpenSides
{
public:

    using real = typename P::real;

    std::vector<Given> kinds;               // of openings
    std::vector<OpenFace<D>> faces;
    std::vector<int> number[D];             // of a face's opening, -1: none
    std::vector<int> here[D];               // which of `faces` are in this rank's arrays
    std::vector<int> owner;                 // the ranks of the faces' cells; empty: there is one
    std::vector<real> open, given;
    std::vector<unsigned char> leaves;
    // of openings: velocity inward that the flow makes [m/s]
    std::vector<double> rate;
    std::vector<double> owed;               // volume that has gone out but not as particles [m^D]
    std::vector<std::int64_t> in, out;      // particles
    std::vector<double> volume;             // that they stand for, in less out [m^D]
    Array<Backend, int> face[D], cell[D];
    Array<Backend, unsigned char> gate[D], flags;
    Array<Backend, real> buffer, second;

    explicit OpenSides(PicSetting<Backend, D, P>& set) : set_(set)
    { for (const PicOpening& o : set.config.openings) kinds.push_back(givenAt(o.kind)); }

    bool takeLeft(const Vec<D, double>& x);
    double speed(double t) const;
    double balance(int opening = -1) const;

    //- For a saved state
    std::size_t memorySize() const { return 2*faces.size() + 4*in.size(); }
    std::vector<double> memory() const;
    void setMemory(const double*);

private:

    int leftThrough(const Vec<D, double>& x) const;

    PicSetting<Backend, D, P>& set_;
};

//- A particle has left the block. \return through an opening? Then it counts as that
template<class Backend, int D, class P>
bool OpenSides<Backend, D, P>::takeLeft(const Vec<D, double>& x)
{
    const int through = faces.empty() ? -1 : leftThrough(x);
    if (through < 0) return false;
    ++out[through];
    volume[through] -= set_.clock.particleVolume;
    owed[through] -= set_.clock.particleVolume;
    return true;
}

//- The opening through which a particle has left the block; -1: none
template<class Backend, int D, class P>
int OpenSides<Backend, D, P>::leftThrough(const Vec<D, double>& x) const
{
    const UniformGrid<D>& grid = set_.whole();
    typename UniformGrid<D>::Index at{{0, 0, 0}};
    int direction = -1;
    for (int d = 0; d < D; ++d)
    {
        const int c = floorInt(x.c[d]/grid.h);
        at.c[d] = std::max(0, std::min(c, grid.n[d] - 1));
        if (c == at.c[d]) continue;
        direction = d;
    }
    if (direction < 0) return -1;
    if (x.c[direction] > 0) at.c[direction] = grid.n[direction];
    return number[direction][grid.face(direction, at)];
}

//- The fastest that comes in at a time [m/s]
template<class Backend, int D, class P>
double OpenSides<Backend, D, P>::speed(double t) const
{
    double most = 0;
    for (std::size_t k = 0; k < set_.config.openings.size(); ++k)
    {
        const PicOpening& o = set_.config.openings[k];
        if (kinds[k] == Given::discharge) most = std::max(most, std::abs(rate[k]));
        if (kinds[k] != Given::velocity) continue;
        double v2 = 0;
        for (int d = 0; d < D; ++d) v2 += std::pow(o.velocity(t)[set_.config.axes[d]], 2);
        most = std::max(most, std::sqrt(v2));
    }
    return most;
}

//- Volume that has come in but not as particles yet, less what has gone out but not as particles;
//  -1: through all openings
template<class Backend, int D, class P>
double OpenSides<Backend, D, P>::balance(int opening) const
{
    double all = 0;
    for (const OpenFace<D>& f : faces) if (opening < 0 || opening == f.opening) all += f.kept;
    for (int k = 0; k < int(owed.size()); ++k) if (opening < 0 || opening == k) all -= owed[k];
    return all;
}

//- What a continued run must know: of each face the volume kept and whose turn it is, of each
//  opening what has passed
template<class Backend, int D, class P>
std::vector<double> OpenSides<Backend, D, P>::memory() const
{
    std::vector<double> all;
    for (const OpenFace<D>& f : faces) { all.push_back(f.kept); all.push_back(f.turn); }
    for (std::size_t k = 0; k < in.size(); ++k)
    {
        all.push_back(double(in[k]));
        all.push_back(double(out[k]));
        all.push_back(volume[k]);
        all.push_back(owed[k]);
    }
    return all;
}

template<class Backend, int D, class P>
void OpenSides<Backend, D, P>::setMemory(const double* from)
{
    for (OpenFace<D>& f : faces) { f.kept = *from++; f.turn = int(*from++); }
    for (std::size_t k = 0; k < in.size(); ++k)
    {
        in[k] = std::int64_t(*from++);
        out[k] = std::int64_t(*from++);
        volume[k] = *from++;
        owed[k] = *from++;
    }
}

} // namespace riprap

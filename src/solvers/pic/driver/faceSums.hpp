/*  Products of fields of the faces, summed over those where the equation of viscosity holds.

    Of several ranks: by rank, each adds up its brick's faces. Or, where each solves for the
    pressure of the whole grid, in the order of one process: of fields that ranks have gathered, by
    the kernel of one process, so that the bits are the same.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/terms/viscosity.hpp"
#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<int D, class R>
struct FaceDotOfBrick
{
    static constexpr const char* name = "viscousDot";
    FaceDot<D, R> of;
    CellBox brick;              // its faces of this direction

    HD void add(int i, double* sums) const
    {
        const UniformGrid<D>& grid = of.faces.grid;
        typename UniformGrid<D>::Index f = grid.faceIndex(of.faces.component, i);
        for (int d = 0; d < D; ++d) f.c[d] += grid.first[d];
        if (brick.has(f.c)) of.add(i, sums);
    }
};

template<class Backend, int D, class P>
class FaceSums
{
public:

    using real = typename P::real;

    explicit FaceSums(PicParts<Backend, D, P>& parts) : p_(parts) {}

    //- Once it is known where the equation holds
    void start();
    //- faces: of direction d
    template<class View>
    double dot(const View& faces, Array<Backend, real>* a, Array<Backend, real>* b);

    std::size_t bytes() const;

private:

    double dotInOrder(Array<Backend, real>* a, Array<Backend, real>* b);

    PicParts<Backend, D, P>& p_;
    // of the whole block
    Array<Backend, unsigned char> layer_[D];
    Array<Backend, real> distance_[D], first_, second_;
};

template<class Backend, int D, class P>
void FaceSums<Backend, D, P>::start()
{
    for (int d = 0; d < D && p_.gathered; ++d)
    {
        layer_[d].upload(p_.set.context, p_.whole(p_.faces.layer[d], d));
        if (p_.sticksInside())
            distance_[d].upload(p_.set.context, p_.whole(p_.cut.faceDistance[d], d));
    }
}

template<class Backend, int D, class P>
double FaceSums<Backend, D, P>::dotInOrder(Array<Backend, real>* a, Array<Backend, real>* b)
{
    Context<Backend>& context = p_.set.context;
    const UniformGrid<D>& whole = p_.set.whole();
    double sum = 0;
    for (int d = 0; d < D; ++d)
    {
        first_.upload(context, p_.whole(a[d], d));
        if (a != b) second_.upload(context, p_.whole(b[d], d));
        const ViscousFaces<D, real> faces{whole, d, layer_[d].data(), nullptr, false,
            p_.sticksInside() ? distance_[d].data() : nullptr, nullptr};
        sum += sumOver<1>(context, whole.faces(d),
            FaceDot<D, real>{faces, first_.data(), (a != b ? second_ : first_).data()})[0];
    }
    return sum;
}

template<class Backend, int D, class P>
template<class View>
double FaceSums<Backend, D, P>::dot(
    const View& faces, Array<Backend, real>* a, Array<Backend, real>* b)
{
    if (p_.gathered) return dotInOrder(a, b);
    Context<Backend>& context = p_.set.context;
    double sum = 0;
    for (int d = 0; d < D; ++d)
    {
        const FaceDot<D, real> all{faces(d), a[d].data(), b[d].data()};
        const int count = p_.set.grid.faces(d);
        if (!p_.halo) sum += sumOver<1>(context, count, all)[0];
        else
            sum += sumOver<1>(context, count,
                FaceDotOfBrick<D, real>{
                    all, p_.set.bricks->facesOfBrick(p_.set.bricks->rank(), d)})[0];
    }
    if (!p_.halo) return sum;
    std::vector<double> sums(1, sum);
    addByRank(p_.halo->ranks(), sums);
    return sums[0];
}

template<class Backend, int D, class P>
std::size_t FaceSums<Backend, D, P>::bytes() const
{
    std::size_t sum = first_.bytes() + second_.bytes();
    for (int d = 0; d < D; ++d) sum += layer_[d].bytes() + distance_[d].bytes();
    return sum;
}

} // namespace riprap

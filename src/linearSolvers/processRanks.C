/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "processRanks.H"
#include "foamVersions/foamVersions.H"
#include "IPstream.H"
#include "OPstream.H"

namespace
{

template<class T, class V, class Op>
void combine(std::vector<V>& values, const Op& op, Foam::label comm)
{
    using namespace Foam;
    List<T> list(static_cast<label>(values.size()));
    std::copy(values.begin(), values.end(), list.begin());
    combineLists(list, op, comm);
    std::copy(list.begin(), list.end(), values.begin());
}

}

void Foam::processRanks::sum(std::vector<double>& values) const
{
    combine<scalar>(values, plusEqOp<scalar>(), comm_);
}


void Foam::processRanks::least(std::vector<int>& values) const
{
    combine<label>(values, minEqOp<label>(), comm_);
}


void Foam::processRanks::swap(
    const std::vector<std::vector<double>>& out, std::vector<std::vector<double>>& in) const
{
    const label begin = UPstream::nRequests();
    const auto nonBlocking = UPstream::commsTypes::nonBlocking;
    const int tag = UPstream::msgType();
    for (std::size_t b = 0; b < in.size(); ++b)
        if (!in[b].empty())
            UIPstream::read(nonBlocking, system_.borders[b].rank,
                reinterpret_cast<char*>(in[b].data()), in[b].size()*sizeof(double), tag, comm_);
    for (std::size_t b = 0; b < out.size(); ++b)
        if (!out[b].empty())
            UOPstream::write(nonBlocking, system_.borders[b].rank,
                reinterpret_cast<const char*>(out[b].data()), out[b].size()*sizeof(double), tag,
                comm_);
    UPstream::waitRequests(begin);
}

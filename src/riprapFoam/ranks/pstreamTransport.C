/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pstreamTransport.H"
#include "foamVersions/foamVersions.H"
#include "IPstream.H"
#include "OPstream.H"
#include <limits>

namespace
{

template<class T, class Op>
void combine(std::vector<T>& values, const Op& op, Foam::label comm)
{
    Foam::List<T> list(static_cast<Foam::label>(values.size()));
    std::copy(values.begin(), values.end(), list.begin());
    Foam::combineLists(list, op, comm);
    std::copy(list.begin(), list.end(), values.begin());
}

}


void Foam::pstreamTransport::post(
    const std::vector<riprap::RankMessage>& out, std::vector<riprap::RankMessage>& in) const
{
    const label begin = UPstream::nRequests();
    const auto nonBlocking = UPstream::commsTypes::nonBlocking;
    const int tag = UPstream::msgType();
    for (riprap::RankMessage& m : in)
        if (m.size)
            UIPstream::read(
                nonBlocking, m.rank, reinterpret_cast<char*>(m.bytes), m.size, tag, comm_);
    for (const riprap::RankMessage& m : out)
        if (m.size)
            UOPstream::write(
                nonBlocking, m.rank, reinterpret_cast<const char*>(m.bytes), m.size, tag, comm_);
    UPstream::waitRequests(begin);
}


void Foam::pstreamTransport::exchange(
    const std::vector<riprap::RankBytes>& out, std::vector<riprap::RankBytes>& in)
{
    const Call call(*this);
    const int me = rank(), n = size();
    labelList send(n, 0), receive(n, 0);
    std::vector<riprap::RankMessage> to, from;
    for (int r = 0; r < n; ++r)
    {
        if (out[r].size() > std::size_t(std::numeric_limits<int>::max()))
        {
            FatalErrorInFunction << "Process " << me << " has " << out[r].size()
                                << " bytes for process " << r << ", and MPI takes "
                                << std::numeric_limits<int>::max()
                                << " in a message: use more processes" << exit(FatalError);
        }
        send[r] = static_cast<label>(out[r].size());
        // what is sent is only read
        if (r != me && send[r])
            to.push_back(riprap::RankMessage{
                r, const_cast<unsigned char*>(out[r].data()), out[r].size()});
    }
    UPstream::allToAll(send, receive, comm_);
    in.assign(n, riprap::RankBytes());
    in[me] = out[me];
    for (int r = 0; r < n; ++r)
    {
        if (r == me || !receive[r]) continue;
        in[r].resize(receive[r]);
        from.push_back(riprap::RankMessage{r, in[r].data(), in[r].size()});
    }
    post(to, from);
}


void Foam::pstreamTransport::sum(std::vector<std::int64_t>& values)
{
    const Call call(*this);
    combine(values, plusEqOp<std::int64_t>(), comm_);
}


void Foam::pstreamTransport::largest(std::vector<double>& values)
{
    const Call call(*this);
    combine(values, maxEqOp<double>(), comm_);
}

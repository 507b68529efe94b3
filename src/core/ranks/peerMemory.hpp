/*  Memory of a rank's GPU that kernels of other ranks write to, past their hosts: CUDA's memory
    that processes of one machine share.

    Not where ranks are threads of one process, on several machines, or on one GPU: processes take
    turns there, and one that waits in a kernel would hold the GPU until its turn ends.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#ifdef __CUDACC__

#include <array>
#include <cstdint>
#include <string>
#include <vector>
#include "core/backend/backend.hpp"
#include "core/ranks/transport.hpp"

namespace riprap
{

class PeerMemory
{
public:

    using Words = std::vector<std::array<std::int64_t, 2>>;     // by rank

    //- Why ranks cannot, nothing where they can; alike on all of them, which all ask
    static std::string whyNot(Transport&);

    PeerMemory() = default;
    PeerMemory(const PeerMemory&) = delete;
    PeerMemory& operator=(const PeerMemory&) = delete;
    ~PeerMemory();

    //- Room for so many bytes at least, of which each rank names its own number. All ranks call;
    //  words[r] goes to rank r, and is what came from there afterwards. Kernels of before must have
    //  ended. Contents are lost where memory grows: it is zero then.
    //  \throw std::runtime_error where CUDA does not share it
    void fit(Transport&, std::size_t bytes, Words& words);

    unsigned char* own() const { return own_; }
    unsigned char* of(int rank) const { return of_[rank]; }

private:

    void closeOthers();
    cudaError_t exportNew(cudaIpcMemHandle_t& handle);

    unsigned char* own_ = nullptr;
    std::size_t room_ = 0;
    std::vector<unsigned char*> of_;        // null: never opened, or one's own
};

} // namespace riprap

#endif

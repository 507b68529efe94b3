/*  A recorded sequence of launches, replayed without the host: what makes small scenes fast on the
    GPU.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"

#ifdef __CUDACC__

namespace riprap
{

class Graph
{
public:
    Graph() = default;
    Graph(const Graph&) = delete;
    ~Graph() { clear(); }

    bool recorded() const { return executable_ != nullptr; }

    //- Record what `work` launches. No allocation and no copy to the host may happen in it.
    template<class Work>
    void record(Context<Gpu>& context, Work work)
    {
        clear();
        context.profile.capturing = true;
        cudaGraph_t graph = nullptr;
        checkCuda(
            cudaStreamBeginCapture(context.stream, cudaStreamCaptureModeThreadLocal), "capture");
        work();
        checkCuda(cudaStreamEndCapture(context.stream, &graph), "capture");
        context.profile.capturing = false;
        kernels_ = context.profile.takeCaptured();
        checkCuda(cudaGraphInstantiate(&executable_, graph, 0), "graph");
        checkCuda(cudaGraphDestroy(graph), "graph");
    }

    void replay(Context<Gpu>& context)
    {
        checkCuda(cudaGraphLaunch(executable_, context.stream), "graph launch");
        context.profile.countReplay(kernels_);
    }

    void clear()
    {
        if (executable_) cudaGraphExecDestroy(executable_);
        executable_ = nullptr;
    }

private:
    cudaGraphExec_t executable_ = nullptr;
    std::vector<std::size_t> kernels_;
};

} // namespace riprap

#endif

/*  A loop whose end the device decides: body(condition) launches one pass, which sets *again and
    tells the condition; it is repeated while *again is not zero.

    On the GPU the pass is recorded once, and a graph with a conditional node repeats it without the
    host (CUDA 12.4 and later; before, or where RIPRAP_HOST_LOOPS is set in the environment, the
    host reads *again after each pass: compute-sanitizer does not see into such a node, and reports
    errors of its own). It is recorded anew after forget(): whoever changes what the pass launches
    must call it. No allocation and no copy to the host may happen in body().

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdlib>
#include "core/backend/graph.hpp"
#include "core/backend/launch.hpp"

namespace riprap
{

//- For the kernel of a pass that sets *again
struct LoopCondition
{
    unsigned long long handle = 0;  // cudaGraphConditionalHandle
    bool recorded = false;          // else the host reads *again

    HD void set(int again) const
    {
#if defined(__CUDA_ARCH__) && CUDART_VERSION >= 12040
        if (recorded) cudaGraphSetConditional(handle, again != 0);
#else
        (void)again;
#endif
    }
};

template<class Backend> class DeviceLoop;

template<>
class DeviceLoop<Cpu>
{
public:
    void forget() {}

    template<class Body>
    void run(Context<Cpu>&, const int* again, const Body& body)
    {
        do body(LoopCondition()); while (*again);
    }
};

#ifdef __CUDACC__

template<>
class DeviceLoop<Gpu>
{
public:
    DeviceLoop() = default;
    DeviceLoop(const DeviceLoop&) = delete;
    ~DeviceLoop() { forget(); }

    void forget()
    {
        pass_.clear();
        if (executable_) cudaGraphExecDestroy(executable_);
        executable_ = nullptr;
    }

    template<class Body>
    void run(Context<Gpu>& context, const int* again, const Body& body)
    {
        // a graph's kernels cannot be timed one by one
        static const bool onHost = std::getenv("RIPRAP_HOST_LOOPS") != nullptr;
        if (context.profile.timing || onHost) { plain(context, again, body); return; }
#if CUDART_VERSION >= 12040
        if (!executable_) record(context, body);
        checkCuda(cudaGraphLaunch(executable_, context.stream), "graph launch");
        // of the first pass: how many there were, the device knows
        context.profile.countReplay(kernels_);
#else
        if (!pass_.recorded()) pass_.record(context, [&] { body(LoopCondition()); });
        plain(context, again, [&](const LoopCondition&) { pass_.replay(context); });
#endif
    }

private:

    template<class Body>
    void plain(Context<Gpu>& context, const int* again, const Body& body)
    {
        int more = 1;
        while (more)
        {
            body(LoopCondition());
            context.toHost(&more, again, sizeof(int));
        }
    }

#if CUDART_VERSION >= 12040
    template<class Body>
    void record(Context<Gpu>& context, const Body& body)
    {
        cudaGraph_t whole = nullptr;
        checkCuda(cudaGraphCreate(&whole, 0), "graph");
        cudaGraphConditionalHandle handle;
        checkCuda(cudaGraphConditionalHandleCreate(&handle, whole, 1, cudaGraphCondAssignDefault),
            "graph condition");
        cudaGraphNodeParams loop = {};
        loop.type = cudaGraphNodeTypeConditional;
        loop.conditional.handle = handle;
        loop.conditional.type = cudaGraphCondTypeWhile;
        loop.conditional.size = 1;
        cudaGraphNode_t node;
    #if CUDART_VERSION >= 13000
        checkCuda(cudaGraphAddNode(&node, whole, nullptr, nullptr, 0, &loop), "graph loop");
    #else
        checkCuda(cudaGraphAddNode(&node, whole, nullptr, 0, &loop), "graph loop");
    #endif
        cudaGraph_t pass = loop.conditional.phGraph_out[0];
        context.profile.capturing = true;
        checkCuda(cudaStreamBeginCaptureToGraph(
                      context.stream, pass, nullptr, nullptr, 0, cudaStreamCaptureModeThreadLocal),
            "capture");
        LoopCondition condition;
        condition.handle = handle;
        condition.recorded = true;
        body(condition);
        checkCuda(cudaStreamEndCapture(context.stream, &pass), "capture");
        context.profile.capturing = false;
        kernels_ = context.profile.takeCaptured();
        checkCuda(cudaGraphInstantiate(&executable_, whole, 0), "graph");
        checkCuda(cudaGraphDestroy(whole), "graph");
    }
#endif

    Graph pass_;
    cudaGraphExec_t executable_ = nullptr;
    std::vector<std::size_t> kernels_;
};

#endif

} // namespace riprap

/*  Host/device qualifiers: the only spelling of them outside core is HD.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#ifdef __CUDACC__
    #define HD __host__ __device__ __forceinline__
    //- What is rarely called and large: it stands apart, and its registers do not burden who calls
    //  it
    #define HD_APART __host__ __device__ __noinline__
    //- What is large and the same for many: on the CPU there is one of it
    #define HD_SHARED HD
    //- Of a kernel's parameter: its functions that stand apart are given its place, and no thread
    //  makes a copy of it in its own memory
    #if __CUDACC_VER_MAJOR__ >= 12 && (!defined(__CUDA_ARCH__) || __CUDA_ARCH__ >= 700)
        #define OF_THE_GRID __grid_constant__
    #else
        #define OF_THE_GRID
    #endif
    //- Before a short loop over arrays that are to stay in registers. (nvcc hands the host's copy
    //  of the code to a compiler that warns of it.)
    #ifdef __CUDA_ARCH__
        #define UNROLL _Pragma("unroll")
    #else
        #define UNROLL
    #endif
    //- Before an HD template whose arguments may be of one side alone
    #define EITHER_SIDE _Pragma("nv_exec_check_disable")
#else
    #define HD inline __attribute__((always_inline))
    #define HD_APART inline __attribute__((noinline))
    #define HD_SHARED inline __attribute__((noinline))
    #define UNROLL
    #define EITHER_SIDE
#endif

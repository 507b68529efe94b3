/*  Host/device qualifiers: the only spelling of them outside core is HD. */
#pragma once

#ifdef __CUDACC__
    #define HD __host__ __device__ __forceinline__
#else
    #define HD inline __attribute__((always_inline))
#endif

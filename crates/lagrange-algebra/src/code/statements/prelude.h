#ifndef LAGRANGE_PRELUDE
#define LAGRANGE_PRELUDE

#if defined(__OPENCL_VERSION__)
#if !LAGRANGE_SINGLE && defined(cl_khr_fp64)
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif
#define LAGRANGE_FUNCTION static inline
#define LAGRANGE_OF(name) name
#define LAGRANGE_SIN_COS(x, sine, cosine) (sine) = sincos(x, &(cosine))
#elif defined(__CUDACC__)
#define LAGRANGE_FUNCTION static __device__ __forceinline__
#define LAGRANGE_SIN_COS(x, sine, cosine) LAGRANGE_OF(sincos)(x, &(sine), &(cosine))
#else
#include <math.h>
#if defined(__GNUC__)
#define LAGRANGE_FUNCTION static inline __attribute__((unused))
#else
#define LAGRANGE_FUNCTION static inline
#endif
#define LAGRANGE_SIN_COS(x, sine, cosine) ((sine) = LAGRANGE_OF(sin)(x), (cosine) = LAGRANGE_OF(cos)(x))
#endif

/* The name of a function for numbers of this kind; in OpenCL C it is the same for all. */
#ifndef LAGRANGE_OF
#if LAGRANGE_SINGLE
#define LAGRANGE_OF(name) name##f
#else
#define LAGRANGE_OF(name) name
#endif
#endif

/* FUNCTIONS */

/* What is not a number stays so: a sum is none where one of its terms is. Arguments are variables and numbers. */
#define LAGRANGE_SIGN(x) ((x) > 0 ? (REAL)1 : (x) < 0 ? (REAL)-1 : (x))
#define LAGRANGE_MIN(a, b) ((a) <= (b) ? (a) : (b) < (a) ? (b) : (a) + (b))
#define LAGRANGE_MAX(a, b) ((a) >= (b) ? (a) : (b) > (a) ? (b) : (a) + (b))
#define LAGRANGE_POWF(a, b) ((a) == (a) && (b) == (b) ? LAGRANGE_OF(pow)(a, b) : (a) + (b))

/* Rounded once where that is no slower than twice. */
#if defined(__CUDACC__) || (LAGRANGE_SINGLE ? defined(FP_FAST_FMAF) : defined(FP_FAST_FMA))
#define LAGRANGE_MULTIPLY_ADD(a, b, c) LAGRANGE_OF(fma)(a, b, c)
#else
#define LAGRANGE_MULTIPLY_ADD(a, b, c) ((a) * (b) + (c))
#endif

/* Repeated squaring from the lowest bit of the exponent. */
LAGRANGE_FUNCTION REAL lagrange_powi(REAL base, int exponent)
{
    REAL product = 1, square = base;
    unsigned int remaining = exponent < 0 ? 0u - (unsigned int)exponent : (unsigned int)exponent;
    for (; remaining > 0; remaining /= 2) {
        if (remaining % 2 == 1)
            product *= square;
        if (remaining > 1)
            square *= square;
    }
    return exponent < 0 ? 1 / product : product;
}

#endif

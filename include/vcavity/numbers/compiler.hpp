// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// All that is not standard C++: attributes, which stand for nothing where a compiler does not know them. GCC and
/// Clang are tested; with others results are the same, but packs are computed number by number.

/// Marks the small functions of the innermost loops.
///
/// All that a direction needs, Fresnel's formula included, is meant to become one loop whose numbers stay in
/// registers. By themselves compilers do that in small programs only: in large ones they stop at a limit, and
/// calls and memory then take as much time again. Under Clang's sanitizers, where speed does not matter, such loops would
/// take minutes to compile.
#if defined(__clang__)
#if __has_feature(address_sanitizer)
#define VCAVITY_INLINE inline
#else
#define VCAVITY_INLINE [[gnu::always_inline]] inline
#endif
#elif defined(__GNUC__)
#define VCAVITY_INLINE [[gnu::always_inline]] inline
#elif defined(_MSC_VER)
#define VCAVITY_INLINE __forceinline
#else
#define VCAVITY_INLINE inline
#endif

/// Marks a function that is called seldom and must not swell the loops that call it.
#if defined(__GNUC__)
#define VCAVITY_NOINLINE [[gnu::noinline]]
#else
#define VCAVITY_NOINLINE
#endif

/// Marks a function of which everything that it calls becomes part: a call would write its packs to memory and read
/// them again.
#if defined(__GNUC__)
#define VCAVITY_FLATTEN __attribute__((flatten))
#else
#define VCAVITY_FLATTEN
#endif

/// Turns the number type of a typedef into a vector of so many bytes, of which the usual operators do all
/// components at once.
#if defined(__GNUC__)
#define VCAVITY_VECTOR(bytes) __attribute__((vector_size(bytes), may_alias))
#else
#define VCAVITY_VECTOR(bytes)
#endif

/// Makes a compiler forget what it knows of a vector. To GCC the smaller and the larger one of two vectors, or of a vector
/// and a constant, are comparisons and choices; it takes the one instruction that each is if it knows of nothing to share.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define VCAVITY_FORGET(x) asm("" : "+x"(x))
#else
#define VCAVITY_FORGET(x) static_cast<void>(0)
#endif

/// Defined while code for a GPU is compiled. There are no exceptions, and no memory that is filled when it is first used.
#if defined(__CUDA_ARCH__)
#define VCAVITY_ON_GPU
#endif

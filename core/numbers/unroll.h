/* Hints to the compiler; they change no bit. One that is not like gcc has none. ISO_UNROLL before a loop: unroll it if
 * its count is known; clang would warn where it is not, and a build for which speed does not matter may define it as
 * nothing; ISO_UNROLL_LONG: likewise, where a round is a few instructions and there may be more than 16. ISO_INLINE
 * before a function: inline it, so that constants of its callers are constants in it. ISO_FLAT before a function:
 * inline all that it calls. ISO_APART before a function: inline it nowhere, since its bytes count and its time does
 * not; ISO_RARE: it runs once, compile it small. */
#ifndef ISO_CORE_NUMBERS_UNROLL_H
#define ISO_CORE_NUMBERS_UNROLL_H

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed"
#endif

#ifndef ISO_UNROLL
#ifdef __clang__
#define ISO_UNROLL _Pragma("clang loop unroll(full)")
#define ISO_UNROLL_LONG ISO_UNROLL
#elif __GNUC__ >= 8
#define ISO_UNROLL _Pragma("GCC unroll 16")
#define ISO_UNROLL_LONG _Pragma("GCC unroll 64")
#else
#define ISO_UNROLL
#define ISO_UNROLL_LONG
#endif
#else
#define ISO_UNROLL_LONG ISO_UNROLL
#endif

#ifdef __GNUC__
#define ISO_INLINE static inline __attribute__((always_inline))
#define ISO_FLAT __attribute__((flatten))
#define ISO_APART __attribute__((noinline))
#define ISO_RARE __attribute__((cold))
#else
#define ISO_INLINE static inline
#define ISO_FLAT
#define ISO_APART
#define ISO_RARE
#endif

#endif

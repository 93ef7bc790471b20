/* Hints for speed; they change no bit. ISO_UNROLL before a loop: unroll it as far as its count is known. ISO_INLINE
 * before a function: make it part of its callers, so that what they know at compile time is known in it. ISO_FLAT
 * before a function: make all that it calls part of it. */
#ifndef ISO_CORE_NUMBERS_UNROLL_H
#define ISO_CORE_NUMBERS_UNROLL_H

#ifdef __clang__
#define ISO_UNROLL _Pragma("clang loop unroll_count(16)")
#else
#define ISO_UNROLL _Pragma("GCC unroll 16")
#endif

#define ISO_INLINE static inline __attribute__((always_inline))
#define ISO_FLAT __attribute__((flatten))

#endif

/* ISO_UNROLL before a loop: unroll it as far as its count is known. A hint for speed; it changes no bit. */
#ifndef ISO_CORE_UNROLL_H
#define ISO_CORE_UNROLL_H

#ifdef __clang__
#define ISO_UNROLL _Pragma("clang loop unroll_count(16)")
#else
#define ISO_UNROLL _Pragma("GCC unroll 16")
#endif

#endif

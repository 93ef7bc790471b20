/* The root of a plant that is compiled without a port, for any core: where the compiler has no instruction for it, the
 * one of this folder stands in the place of that of the C library. isoc --standalone writes this file beside the plant,
 * which includes it before core/numbers/sqrt.h. */
#ifndef ISO_PORT_SOFT_OWN_ROOT_H
#define ISO_PORT_SOFT_OWN_ROOT_H

/* Of Arm the bit of __ARM_FP for this number type (Arm C Language Extensions, 6.5.1), of RISC-V the bits of a register
 * for it. */
#ifdef ISO_REAL_DOUBLE
#define ISO_ROOT_OF_ARM 8
#define ISO_ROOT_OF_RISCV 64
#else
#define ISO_ROOT_OF_ARM 4
#define ISO_ROOT_OF_RISCV 32
#endif

#if defined __GNUC__ && (defined __SSE2__ || defined __s390x__ || (defined __mips_hard_float && __mips >= 2) ||        \
                         (defined __ARM_FP && (__ARM_FP & ISO_ROOT_OF_ARM) != 0) ||                                    \
                         (defined __riscv_fsqrt && __riscv_flen >= ISO_ROOT_OF_RISCV))
#define ISO_HAS_ROOT
#endif

#ifndef ISO_HAS_ROOT
#define SOFT_PORTABLE
#ifdef __AVR__
#define SOFT_STAGES
#endif
#ifdef ISO_REAL_DOUBLE
#include "port/soft/binary64.h"
#define ISO_ROOT_OF_BITS soft64_root
#else
#include "port/soft/binary32.h"
#define ISO_ROOT_OF_BITS soft_root
#endif
#endif

#endif

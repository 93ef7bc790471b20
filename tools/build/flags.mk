# The flags with which everything is compiled.

WARNINGS := -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes \
    -Wmissing-prototypes -Wvla -Werror

# The flags of the user. With these a warning is no error: gcc has other ones with each optimisation.
given_flags = $(if $(strip $(1)),-Wno-error $(1))

# The same bits everywhere: no fused multiply-add, no vectoriser (which fuses in spite of the flag: GCC PR 106902), no
# call of libm for the sake of errno.
NUMERICS := -ffp-contract=off -fno-math-errno -fno-tree-vectorize -fno-tree-slp-vectorize

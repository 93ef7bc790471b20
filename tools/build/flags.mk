# What all rules share: the flags with which everything is compiled, and files of text that change when the text does.
.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: always
MAKEFLAGS += --no-builtin-rules
quote = '$(subst ','\'',$(1))'
remember = printf '%s\n' $(1) | cmp -s - $@ || printf '%s\n' $(1) >$@

WARNINGS := -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes \
    -Wmissing-prototypes -Wvla -Werror

# The flags of the user. With these a warning is no error: gcc has other ones with each optimisation.
given_flags = $(if $(strip $(1)),-Wno-error $(1))

# The same bits everywhere, by the lines of tools/build/numerics: no fused multiply-add; no call of libm for the sake of
# errno; no vectoriser (which fuses in spite of the first: GCC PR 106902). isoc has the file too, for what it exports.
NUMERICS := $(strip $(file <tools/build/numerics))

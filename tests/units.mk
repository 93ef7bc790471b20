# The programs of the unit tests and of whole domains in one VARIANT, plain, asan or m4f, and one REAL:
#
#     make -f tests/units.mk VARIANT=plain REAL=float [build/tests/plain/float/runtime/loop]
#
# tests/core/ROOM/NAME.c is a freestanding program; tests/core/ROOM/NAME/ has further parts of it.
# tests/core/numbers/exhaustive/NAME.c is one of the host. Everything made stands in build/tests/VARIANT/REAL/.
include tools/build/flags.mk

DIR := build/tests/$(VARIANT)/$(REAL)
HOST_PORT := $(wildcard port/host/*.c) port/unix/console.c
REAL_float :=
REAL_double := -DISO_REAL_DOUBLE

# Of debug information valgrind and the sanitizers want lines; all of it takes gcc a third of its time, and so does -O2,
# with which the board's are compiled.
CC_plain := $(CC)
FLAGS_plain := -O1 -g1
LINK_plain :=
PORT_plain := $(HOST_PORT)

# Without optimisation nothing is left out before it is checked; of the compilers clang takes half of the time for that.
CC_asan := clang
FLAGS_asan := -O0 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
LINK_asan := $(FLAGS_asan)
PORT_asan := $(HOST_PORT)

CPU_m4f := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
CC_m4f := arm-none-eabi-gcc
FLAGS_m4f := $(CPU_m4f) -ffunction-sections -fdata-sections
LINK_m4f := $(CPU_m4f) -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections
PORT_m4f := $(wildcard port/mps2/*.c)

COMPILE := $(CC_$(VARIANT)) $(WARNINGS) -O2 $(NUMERICS) -I. $(FLAGS_$(VARIANT)) $(REAL_$(REAL))
SHARED := $(patsubst %.c,$(DIR)/%.o,tests/tap.c $(PORT_$(VARIANT)))
UNITS := $(wildcard tests/core/*/*.c)
PROGRAMS := $(UNITS:tests/core/%.c=$(DIR)/%)
ifeq ($(VARIANT),plain)
PROGRAMS += $(patsubst tests/core/%.c,$(DIR)/%,$(wildcard tests/core/numbers/exhaustive/*.c))
endif

.PHONY: programs
.DELETE_ON_ERROR:
.SECONDARY:
programs: $(PROGRAMS)

$(DIR)/%.o: %.c tests/units.mk tools/build/flags.mk tools/build/numerics
	@mkdir -p $(@D)
	@$(COMPILE) -MMD -MP -c $< -o $@

# -lm has the root of a double for the board, which has no instruction for it.
.SECONDEXPANSION:
$(DIR)/methods/method: $(DIR)/tests/general.o
$(DIR)/numbers/exhaustive/%: $(DIR)/tests/core/numbers/exhaustive/%.o
	@mkdir -p $(@D)
	@$(COMPILE) $^ -lm -o $@
$(DIR)/%: $(DIR)/tests/core/%.o $$(addprefix $(DIR)/,$$(addsuffix .o,$$(basename $$(wildcard tests/core/$$*/*.c)))) $(SHARED)
	@mkdir -p $(@D)
	@$(CC_$(VARIANT)) $(LINK_$(VARIANT)) $^ -lm -o $@

-include $(shell test ! -d $(DIR) || find $(DIR) -name '*.d')

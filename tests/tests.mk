# The tests. Included by the Makefile; everything made here stands in build/tests/.
#
# tests/unit/NAME.c        freestanding program: runs in every variant below, in float and in double; tests/unit/NAME/
#                          has further parts of it
# tests/exhaustive/NAME.c  host program, in float and in double: the whole domain of a function
# tests/check/NAME.sh      checker of the tree or of the build, each with a planted violation that it must find
# tests/DIR/test_NAME.py   properties, in Python with pytest; those of tests/python are run by its scripts
# tests/DIR/NAME.t         other host tests: shell scripts
# All print TAP; `prove` collects. A new file in one of these places is a new test.
#
# A test compiles what it wants by the plain name of a compiler: `make`, `$CC` or `program` of tests/host/test.sh. Under
# `make test` each source is then compiled once for all tests and runs, with the objects in build/tests/once/store.

TEST_UNITS := $(sort $(basename $(notdir $(wildcard tests/unit/*.c))))
TEST_UNIT_PARTS := $(sort $(wildcard tests/unit/*/*.c))
TEST_EXHAUSTIVE := $(sort $(basename $(notdir $(wildcard tests/exhaustive/*.c))))
TEST_REALS := float double
TEST_SCRIPTS := $(sort $(wildcard tests/check/*.sh tests/*.t tests/*/*.t)) \
    $(sort $(filter-out tests/python/%,$(wildcard tests/*/test_*.py)))

# Seconds of processor time, by tests/times: what took longer `make check` leaves to `make test`.
TEST_QUICK := 1.5

# One more than processors: some tests wait for a peer or for a clock.
TEST_JOBS ?= $(shell echo $$(($$(nproc 2>/dev/null || echo 1) + 1)))

TEST_FLAGS := $(WARNINGS) -O2 $(NUMERICS) -I.
TEST_REAL_float :=
TEST_REAL_double := -DISO_REAL_DOUBLE

# A variant of the unit tests: compiler, flags, sources of its port, flags of its link. Of debug information valgrind
# and the sanitizers want lines; all of it takes gcc a third of its time.
TEST_HOST_PORT := $(wildcard port/host/*.c) port/unix/console.c
TEST_CC_plain = $(CC)
TEST_FLAGS_plain := -g1
TEST_PORT_plain := $(TEST_HOST_PORT)
TEST_LINK_plain :=

# Without optimisation nothing is left out before it is checked; of the compilers clang takes half of the time for that.
TEST_CC_asan := clang
TEST_FLAGS_asan := -O0 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
TEST_PORT_asan := $(TEST_HOST_PORT)
TEST_LINK_asan := $(TEST_FLAGS_asan)

TEST_M4F_CPU := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
TEST_CC_m4f := arm-none-eabi-gcc
TEST_FLAGS_m4f := $(TEST_M4F_CPU) -ffunction-sections -fdata-sections
TEST_PORT_m4f := $(wildcard port/mps2/*.c)
TEST_LINK_m4f := $(TEST_M4F_CPU) -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections

TEST_OBJECTS :=

# -lm has the root of a double for the board, which has no instruction for it.
# Objects and programs of one variant $(1) in one real $(2). A change of a command rebuilds: it is kept in a file.
define TEST_VARIANT
TEST_DIR := build/tests/$(1)/$(2)
TEST_COMMAND := $$(TEST_CC_$(1)) $$(TEST_FLAGS) $$(TEST_FLAGS_$(1)) $$(TEST_REAL_$(2))
TEST_PORT_OBJECTS := $$(patsubst %.c,$$(TEST_DIR)/%.o,tests/tap.c $$(TEST_PORT_$(1)))

build/tests/$(1)/$(2)/command: private TEST_COMMAND := $$(TEST_COMMAND)
build/tests/$(1)/$(2)/command: always
	$$(call remember,$$(TEST_COMMAND) $$(TEST_LINK_$(1)))

build/tests/$(1)/$(2)/%.o: private TEST_COMMAND := $$(TEST_COMMAND)
build/tests/$(1)/$(2)/%.o: %.c build/tests/$(1)/$(2)/command
	$$(call folders,$$(@D))
	@$$(TEST_COMMAND) -MMD -MP -c $$< -o $$@

# The programs of several parts.
build/tests/$(1)/$(2)/method: build/tests/$(1)/$(2)/tests/general.o
$(foreach part,$(TEST_UNIT_PARTS),$(eval build/tests/$(1)/$(2)/$(notdir $(patsubst %/,%,$(dir $(part)))): \
    build/tests/$(1)/$(2)/$(part:.c=.o)))

build/tests/$(1)/$(2)/%: private TEST_PORT_OBJECTS := $$(TEST_PORT_OBJECTS)
build/tests/$(1)/$(2)/%: build/tests/$(1)/$(2)/tests/unit/%.o $$(TEST_PORT_OBJECTS) $$(wildcard port/mps2/*.ld)
	$$(call link,$$(TEST_CC_$(1)) $$(TEST_LINK_$(1)) $$(filter %.o,$$^) -lm)

TEST_OBJECTS += $$(TEST_PORT_OBJECTS) $$(TEST_DIR)/tests/general.o $$(TEST_UNITS:%=$$(TEST_DIR)/tests/unit/%.o) $$(TEST_UNIT_PARTS:%.c=$$(TEST_DIR)/%.o)
TEST_PROGRAMS_$(1) += $$(TEST_UNITS:%=build/tests/$(1)/$(2)/%)
endef
TEST_PROGRAMS_plain :=
TEST_PROGRAMS_asan :=
TEST_PROGRAMS_m4f :=
$(foreach variant,plain asan m4f,$(foreach real,$(TEST_REALS),$(eval $(call TEST_VARIANT,$(variant),$(real)))))

# Under memcheck run the very programs that run plainly; the name of the folder tells tests/exec.sh.
TEST_PROGRAMS_memcheck := $(TEST_PROGRAMS_plain:build/tests/plain/%=build/tests/memcheck/%)
build/tests/memcheck/%: build/tests/plain/%
	$(call folders,$(@D))
	@ln -f $< $@

# Of the numbers of a domain some are tried, with TEST_WHOLE every one: tests/exec.sh, and the head of each program.
TEST_PROGRAMS_exhaustive := $(foreach real,$(TEST_REALS),$(TEST_EXHAUSTIVE:%=build/tests/exhaustive/$(real)/%))
build/tests/exhaustive/float/%: tests/exhaustive/%.c $(wildcard core/*/*.h tests/exhaustive/*.h) build/tests/plain/float/command
	$(call folders,$(@D))
	$(call link,$(CC) $(TEST_FLAGS) $< -lm)
build/tests/exhaustive/double/%: tests/exhaustive/%.c $(wildcard core/*/*.h tests/exhaustive/*.h) build/tests/plain/double/command
	$(call folders,$(@D))
	$(call link,$(CC) $(TEST_FLAGS) -DISO_REAL_DOUBLE $< -lm)

-include $(TEST_OBJECTS:.o=.d)

# What tests compile, they compile once: in their PATH a program stands before each compiler that keeps the objects
# (tests/host/once.c). Objects, lists and plans that were not used for two days go. Python stands there as what it is: a
# python3 that is a script, and looks for one each time, starts twenty processes. Valgrind runs programs with the libc
# of the machine less the note by which it finds its debug information: to read that takes it longer than most programs
# run.
TEST_ONCE := build/tests/once
TEST_COMPILERS := cc gcc clang arm-none-eabi-gcc riscv64-unknown-elf-gcc avr-gcc
TEST_LIBC = $(shell $(CC) -print-file-name=libc.so.6)
build/tests/libc: always
	$(call remember,$(shell stat -L -c '%n %s %Y' $(TEST_LIBC)))

$(TEST_ONCE)/once: tests/host/once.c $(wildcard tests/host/*.h) build/tests/plain/float/command build/tests/libc
	@rm -rf $(TEST_ONCE) && mkdir -p $(TEST_ONCE)/real $(TEST_ONCE)/store
	@for compiler in $(TEST_COMPILERS); do \
	    ln -s once $(TEST_ONCE)/$$compiler && ln -s "$$(command -v $$compiler)" $(TEST_ONCE)/real/$$compiler; done
	@ln -s "$$(python3 -c 'import sys; print(sys.executable)')" $(TEST_ONCE)/python3
	@mkdir $(TEST_ONCE)/libc && objcopy --remove-section=.note.gnu.build-id $(TEST_LIBC) $(TEST_ONCE)/libc/libc.so.6
	@printf '#!/bin/sh\nLD_LIBRARY_PATH=%s exec %s "$$@"\n' "$(CURDIR)/$(TEST_ONCE)/libc" "$$(command -v valgrind)" >$(TEST_ONCE)/valgrind
	@chmod +x $(TEST_ONCE)/valgrind
	@$(CC) $(WARNINGS) -O2 $(NUMERICS) $< -o $@

# The objects that programs of the host and of the Cortex-M4F share, for copies of the project that build some
# (tests/host/project.sh). They are no part of build/obj/, where a test may compile while another copies.
TEST_SHARED := build/tests/shared
$(TEST_SHARED): always
	@for target in host cortex-m4f; do \
	    $(MAKE) -s --no-print-directory shared 'SHARED=$$(OBJECTS)' TARGET=$$target REAL=float || exit; done
	@rm -rf $@ && mkdir -p $@ && cp -a --parents build/obj/host/float build/obj/cortex-m4f/float $@

# isoc for tests that call it often: its objects, with another main.
TEST_REQUESTS := build/tests/requests
$(TEST_REQUESTS): tests/host/requests.c $(ISOC_OBJECTS) $(EMBEDDED) build/obj/tools/flags
	$(call folders,$(@D))
	$(call link,$(TOOL_COMPILE) -g1 $< $(filter-out %/isoc/main.o,$(filter %.o,$^)) -lm)

.PRECIOUS: $(TEST_OBJECTS)
.PHONY: test check test-run check-run test-times

TEST_FAST := $(filter build/tests/plain/float/% build/tests/m4f/float/%,$(TEST_PROGRAMS_plain) $(TEST_PROGRAMS_m4f))
TEST_ALL := $(TEST_PROGRAMS_plain) $(TEST_PROGRAMS_m4f) $(TEST_PROGRAMS_exhaustive) $(TEST_PROGRAMS_memcheck) $(TEST_PROGRAMS_asan)
TEST_PROVE = find $(TEST_ONCE)/store \( -name '*.o' -o -name '*.list' -o -name '*.plan' \) -mtime +2 -delete; rm -rf build/tests/takes; \
    TEST_BUILT=yes TEST_TAKES=$(CURDIR)/build/tests/takes TEST_KEPT=$(CURDIR)/build/tests/passed \
    PERL5LIB=tests prove --harness Tally --merge --jobs $(TEST_JOBS) --exec tests/exec.sh

# What make builds first it compiles by that program too: tests that build the tools in a copy of the project have their
# objects. The state is that of the compilers themselves.
define TEST_RUN
@tests/tools.sh
+@$(MAKE) -s --no-print-directory $(TEST_ONCE)/once
+@export TEST_STATE=$$(sh tests/host/state.sh) PATH="$(CURDIR)/$(TEST_ONCE):$$PATH"; $(MAKE) --no-print-directory -j$(TEST_JOBS) $(1)
endef

# All tests, but for those that passed and follow from nothing that has changed: the unit tests in every variant, whole
# domains, checkers, models: 10 minutes on two cores.
test: ## run all tests, but for those that passed before and follow from nothing that has changed; 10 minutes on two cores
	$(call TEST_RUN,test-run)

# The fast part: units in float, and the checkers that are quick.
check: ## run the fast tests
	$(call TEST_RUN,check-run)

test-run: $(TEST_ALL) $(TOOLS) $(TEST_REQUESTS) $(TEST_SHARED) build/simavr_trace build/import
	@export TEST_STRIDE=1; $(TEST_PROVE) $(TEST_ALL) $(TEST_SCRIPTS)

check-run: $(TEST_FAST) $(TOOLS) $(TEST_REQUESTS) $(TEST_SHARED) build/simavr_trace build/import
	@export TEST_STRIDE=11 TALLY_MOST=$(TEST_QUICK); $(TEST_PROVE) $(TEST_FAST) $(TEST_SCRIPTS)

# What each test of the last `make test` took. `make test-times >tests/times` keeps it: an order, and what is quick.
test-times: ## print the processor time of each test of the last make test
	@cat build/tests/takes.txt

# Isochron: from the description of a mechanism to a plant that runs in real time.
#
#     scene --build/isoc--> plant.c --compiler--> program --build/trace--> trace.csv and a summary
#
# Everything made stands in build/: what belongs to one scene in build/TARGET/REAL/NAME/, objects that scenes share
# in build/obj/, the tools build/isoc, build/trace and build/plot. Files named `flags`, `choice` and `link` there hold the command that made
# their neighbours, and change when it does.

## Usage: make TARGET [VARIABLE=VALUE...]
##
# What to run and how; set on the command line.
##     SCENE=models/double_pendulum.scene  what to run: a scene, or a plant in C (core/runtime/plant.h)
##     METHOD=rk4                          in place of the scene's
##     STEP=1ms                            in place of the scene's
##     TOLERANCE=1e-9                      of adams, which then takes as many sub-steps as it needs
##     SECONDS=10                          how long, in the plant's time; 5 for report and bench, 600 for drift
##     TARGET=host|cortex-m4f              where: this machine, or the board in QEMU
##     REAL=float|double                   the type of its numbers
##     SCRIPT=FILE                         what goes wrong with the ticks, on the host (port/sim/script.h)
##     V=1                                 shows the commands
SCENE = models/$(if $(filter drift,$(MAKECMDGOALS)),four_bar,double_pendulum).scene
METHOD =
STEP =
SECONDS = $(if $(filter report bench,$(MAKECMDGOALS)),5,$(if $(filter drift,$(MAKECMDGOALS)),600,10))
TARGET = $(if $(filter size,$(MAKECMDGOALS)),cortex-m4f,host)
REAL = float
SCRIPT =
V =

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules

.PHONY: help run plot size stack cost report bench drift digits clean
help: ## say what can be made; the same as make alone
	@sed -n -e 's/^##$$//p' -e 's/^## //p' Makefile
	@echo
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/\1 \2/p' $(MAKEFILE_LIST) | while read -r target text; do \
	    printf '    make %-6s %s\n' $$target "$$text"; done

# --- Helpers -----------------------------------------------------------------------------------------------------

empty :=
space := $(empty) $(empty)
quote = '$(subst ','\'',$(1))'
Q := $(if $(filter 1,$(V)),,@)
say = @printf '  %-4s %s\n' $(1) $(call quote,$(2))

# A recipe that leaves its target alone if it holds these words (of the shell) already, so that only a change makes
# others follow.
remember = @mkdir -p $(@D); text=$$(printf '%s\n' $(1)); \
    printf '%s\n' "$$text" | cmp -s - $@ || printf '%s\n' "$$text" >$@

# A recipe that stops if a tool is missing; TOOL:FILE is a file that the compiler TOOL must find.
require = @for tool in $(1); do \
        case $$tool in \
        *:*) file=$${tool\#*:}; test "$$($${tool%:*} -print-file-name=$$file)" != $$file ;; \
        *) command -v $$tool >/dev/null 2>&1 ;; \
        esac || { echo "$$tool is missing. Install it with: $(2)" >&2; exit 1; }; \
    done

.PHONY: always
always:

# --- What was chosen ---------------------------------------------------------------------------------------------

PORT_OF_host := port/sim
PORT_OF_cortex-m4f := port/mps2
PORT := $(PORT_OF_$(strip $(TARGET)))
# The methods, by the list that has their names. Their step is fixed; adams has one that varies within the tick, and is
# for scenes only.
FIXED_METHODS := $(filter-out adams,$(shell sed -n 's/^ *X(ISO_[A-Z0-9_]*, "\(.*\)").*/\1/p' core/methods/method.h))
METHODS = $(FIXED_METHODS) $(if $(filter %.c,$(SCENE_FILE)),,adams)
REAL_FLAGS_float :=
REAL_FLAGS_double := -DISO_REAL_DOUBLE

ifeq ($(PORT),)
$(error TARGET=$(TARGET) is unknown; it can be host or cortex-m4f)
endif
ifeq ($(filter float double,$(REAL)),)
$(error REAL=$(REAL) is unknown; it can be float or double)
endif
ifneq ($(METHOD),)
ifeq ($(filter $(FIXED_METHODS) adams,$(METHOD)),)
$(error METHOD=$(METHOD) is unknown; it can be one of: $(FIXED_METHODS) adams)
endif
endif

# The name of a scene is that of its file; what make could misread in a path of ours becomes a line.
SCENE_FILE := $(subst $(space),_,$(SCENE))
NAME := $(shell printf %s $(call quote,$(basename $(notdir $(SCENE_FILE)))) | tr -c 'A-Za-z0-9_.-' _)
OUT := build/$(TARGET)/$(REAL)/$(NAME)

# Times come as a number with a unit. The step of a plant in C is checked here, that of a scene by build/isoc.
nanoseconds = $(shell awk -v text=$(call quote,$(1)) -v least=$(2) -v most=$(3) -v as=$(4) \
    -f tools/build/nanoseconds.awk)
NANOSECONDS := $(call nanoseconds,$(SECONDS),1,1e18)
ifeq ($(NANOSECONDS),)
$(error SECONDS=$(SECONDS) is no time to run; it could be 10 or 0.5)
endif

ifeq ($(suffix $(SCENE_FILE)),.c)
ifneq ($(STEP),)
STEP_SECONDS := $(call nanoseconds,$(STEP),1000,1e9,seconds)
ifeq ($(STEP_SECONDS),)
$(error STEP=$(STEP) is no step; it could be 1ms, 500us or 0.001, from 1us to 1s in whole nanoseconds)
endif
endif
METHOD_MACRO := $(shell printf %s '$(METHOD)' | tr a-z A-Z)
CHOICE := $(METHOD:%=-DISO_METHOD=ISO_$(METHOD_MACRO) -DISO_METHOD_NAME=%) $(STEP_SECONDS:%=-DISO_STEP=%)
PLANT := $(SCENE)
else
CHOICE := $(METHOD:%=--method %) $(if $(STEP),--step $(call quote,$(STEP))) \
    $(if $(TOLERANCE),--tolerance $(call quote,$(TOLERANCE))) --real $(REAL)
PLANT := $(OUT)/plant.c
endif

include $(PORT)/port.mk

# --- How everything is compiled ----------------------------------------------------------------------------------

WARNINGS := -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes \
    -Wmissing-prototypes -Wvla -Werror

# The same bits everywhere: no fused multiply-add, no vectoriser (which fuses in spite of the flag: GCC PR 106902), no call
# of libm for the sake of errno.
NUMERICS := -O2 -ffp-contract=off -fno-math-errno -fno-tree-vectorize -fno-tree-slp-vectorize

# --- Tools on the host -------------------------------------------------------------------------------------------

TOOL_COMPILE := $(CC) $(WARNINGS) $(NUMERICS) -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE -I. $(CFLAGS)
TOOL_OBJECTS := $(patsubst %.c,build/obj/%.o,$(wildcard tools/*/*.c tools/*/*/*.c))

build/obj/tools/flags: always
	$(call remember,$(call quote,$(TOOL_COMPILE) $(TOOL_OBJECTS)))

build/obj/tools/%.o: tools/%.c build/obj/tools/flags
	$(call require,$(firstword $(CC)),apt-get install gcc)
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(TOOL_COMPILE) -MMD -MP -c $< -o $@

build/isoc: $(filter build/obj/tools/isoc/%,$(TOOL_OBJECTS)) build/obj/tools/flags
build/trace: $(filter build/obj/tools/trace/%,$(TOOL_OBJECTS)) build/obj/tools/flags
build/plot: $(filter build/obj/tools/plot/% build/obj/tools/table/%,$(TOOL_OBJECTS)) build/obj/tools/flags
build/isoc build/trace build/plot:
	$(call say,LINK,$@)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -o $@ -lm

# --- The program -------------------------------------------------------------------------------------------------

COMPILE := $(PORT_CC) $(WARNINGS) $(NUMERICS) $(PORT_FLAGS) $(REAL_FLAGS_$(REAL)) -I. $(CFLAGS)
OBJ := build/obj/$(TARGET)/$(REAL)
OBJECTS := $(patsubst %.c,$(OBJ)/%.o,$(wildcard core/*/*.c $(PORT)/*.c))
PROGRAM := $(OUT)/$(NAME)$(PORT_SUFFIX)

$(OBJ)/flags: always
	$(call require,$(PORT_TOOLS),$(PORT_INSTALL))
	$(call remember,$(call quote,$(COMPILE)))

$(OBJ)/%.o: %.c $(OBJ)/flags
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -MMD -MP -c $< -o $@

# The scene by its path and by what it says; not by its date, since its path may hold what make cannot.
$(OUT)/choice: always
	@test -e $(call quote,$(SCENE)) || { printf 'there is no scene %s; models/ has:\n' $(call quote,$(SCENE)) >&2; \
	    ls models >&2; exit 1; }
	$(call remember,$(call quote,$(SCENE) $(CHOICE)) "$$(cksum <$(call quote,$(SCENE)))")

$(OUT)/plant.c: $(OUT)/choice build/isoc
	$(call say,ISOC,$(SCENE))
	$(Q)build/isoc $(call quote,$(SCENE)) -o $(OUT) $(CHOICE) >$(OUT)/plant.txt

$(OUT)/plant.o: $(OUT)/choice $(OBJ)/flags $(if $(filter %/plant.c,$(PLANT)),$(PLANT))
	$(call say,CC,$(PLANT))
	$(Q)$(COMPILE) $(filter -D%,$(CHOICE)) -MMD -MP -c $(call quote,$(PLANT)) -o $@

LINK := $(PORT_CC) $(PORT_FLAGS) $(CFLAGS) $(PORT_LINK) $(OUT)/plant.o $(OBJECTS) -o $(PROGRAM)

$(OUT)/link: always
	$(call remember,$(call quote,$(LINK)))

$(PROGRAM): $(OUT)/plant.o $(OBJECTS) $(OUT)/link $(wildcard $(PORT)/*.ld)
	$(call say,LINK,$@)
	$(Q)$(LINK)

-include $(TOOL_OBJECTS:.o=.d) $(OBJECTS:.o=.d) $(OUT)/plant.d

RUN = build/trace -o $(OUT) --clock $(PORT_CLOCK) -- $(PORT_EXEC)

run: $(PROGRAM) build/trace ## run the scene: build/TARGET/REAL/NAME/trace.csv and a summary
	$(call require,$(PORT_EXEC_TOOLS),$(PORT_INSTALL))
	$(Q)$(RUN)

plot: $(PROGRAM) build/trace build/plot ## run the scene and draw it with gnuplot: trace.svg, path.svg and the same as png, beside the trace
	$(call require,gnuplot,apt-get install gnuplot-nox)
	$(call require,$(PORT_EXEC_TOOLS),$(PORT_INSTALL))
	$(Q)$(RUN) >$(OUT)/summary.txt
	$(Q)sh tools/plot/plot.sh $(OUT)

# --- What it costs -----------------------------------------------------------------------------------------------

size: $(PROGRAM) ## show the size of the firmware and of its parts; the double pendulum's must keep its limits
	@$(PORT_SIZE) $(OUT)/plant.o $(OBJECTS) $(PROGRAM)
	@{ $(PORT_SIZE) $(PROGRAM); $(PORT_NM) -S $(PROGRAM); } | awk -v limits=$(LIMITS) -f tools/build/size.awk

# The limits were set for this one, with its own method.
LIMITED := cortex-m4f float models/double_pendulum.scene
LIMITS := $(if $(findstring $(LIMITED),$(TARGET) $(REAL) $(SCENE)),$(if $(filter-out rk4,$(METHOD)),no,yes),no)

# GCC writes the call graph with the frame of every function into plant.ci.
stack: $(OUT)/plant.o ## show the deepest stack of a step; recursion and frames without a bound fail
	@mkdir -p $(OUT)/stack
	$(Q)$(COMPILE) $(filter -D%,$(CHOICE)) -fcallgraph-info=su $(PORT_STACK) -c $(call quote,$(PLANT)) \
	    -o $(OUT)/stack/plant.o || { echo 'make stack needs gcc, version 10 or later' >&2; exit 1; }
	@awk -v root=step -f tools/build/stack.awk $(OUT)/stack/plant.ci

# Prints the tables and nothing else, so that they can be held against README.md.
cost: build/isoc ## price the models and the effects: instructions, operations, bytes; on the Cortex-M4F in float
	$(call require,valgrind,apt-get install valgrind)
	@MAKE=$(call quote,$(MAKE)) METHODS=$(call quote,$(filter-out adams,$(METHODS))) sh tools/build/cost.sh

LENGTHS = 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16
chains: build/isoc ## price chains of rods by their LENGTHS: operations, instructions, bytes; on the Cortex-M4F in float
	$(call require,valgrind,apt-get install valgrind)
	@MAKE=$(call quote,$(MAKE)) LENGTHS=$(call quote,$(LENGTHS)) sh tools/build/chains.sh

# Both measure the methods of METHODS, all unless told.
REPORT = MAKE=$(call quote,$(MAKE)) SCENE=$(call quote,$(SCENE)) NAME=$(NAME) NANOSECONDS=$(NANOSECONDS) \
    METHODS=$(call quote,$(METHODS)) STEP=$(call quote,$(if $(filter %.c,$(SCENE_FILE)),$(STEP_SECONDS),$(STEP))) \
    COMPILE=$(call quote,$(CC) $(WARNINGS) $(NUMERICS) -D_POSIX_C_SOURCE=200809L -I. $(CFLAGS))
REPORT_TOOLS := arm-none-eabi-gcc arm-none-eabi-gcc:nano.specs qemu-system-arm
REPORT_INSTALL := apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm

report: build/isoc build/trace build/plot ## error of every method over its price and its step: build/report/NAME/
	$(call require,gnuplot valgrind,apt-get install gnuplot-nox valgrind)
	$(call require,$(REPORT_TOOLS),$(REPORT_INSTALL))
	@$(REPORT) sh tools/report/report.sh

bench: build/isoc build/trace ## compare the methods at equal step and at equal error, as a table
	$(call require,$(REPORT_TOOLS),$(REPORT_INSTALL))
	@$(REPORT) sh tools/report/bench.sh

drift: build/isoc build/trace build/plot ## how far the loops of a scene come apart with every stabilisation: table, picture in build/drift/NAME/
	$(call require,gnuplot,apt-get install gnuplot-nox)
	$(call require,$(REPORT_TOOLS),$(REPORT_INSTALL))
	@$(REPORT) sh tools/drift/drift.sh

digits: build/isoc ## how many digits of reference solutions are met
	@sh tests/reference/table.sh

clean: ## remove all that was made
	rm -rf build

include tests/tests.mk

# Isochron: from the description of a mechanism to a plant that runs in real time.
#
#     scene --build/isoc--> plant.c --compiler--> program --build/trace--> trace.csv and a summary
#
# Everything made stands in build/: what belongs to one scene in build/TARGET/REAL/NAME/, objects that scenes share
# in build/obj/, the tools build/isoc and build/trace. Files named `flags`, `choice` and `link`
# there hold the command that made their neighbours, and change when it does. NAME is that of the file of a scene in
# models/; of any other scene it ends with a number made of the file's path, so that no two share a folder. Makes that
# run at once lock the folder they work in.

## Usage: make TARGET [VARIABLE=VALUE...]
##
# Variables are set on the command line; of the environment, only CC and CFLAGS have an effect.
##     SCENE=models/double_pendulum.scene  what to run: a scene, or a plant in C (core/runtime/plant.h)
##     METHOD=rk4                          the method, instead of that of the scene
##     STEP=1ms                            the step, instead of that of the scene
##     TOLERANCE=1e-9                      largest local error of METHOD=adams in a state x: TOLERANCE (1 + |x|)
##     SET='rod_mass = 0.3 kg; drag = 2'   values of constants and tunables, instead of those of the scene
##     WITHOUT='drive; bearing'            effects of the scene that are left out
##     CHECKED=yes  COMPENSATED=yes        options of the method of a plant in C; a scene has a statement for each
##     INPUTS=held|smooth                  the reading of all inputs, instead of that of the scene
##     AT=2s                               for linear: about the state that the run has then, instead of the start
##     TRIM='pole = 0; free force'         for linear: about the equilibrium with these values, or `rest`, the nearest (tools/linear)
##     FORMAT=text|latex                   for equations: as text, or as LaTeX
##     BODE='force to pole'                for linear: draws the frequency response, and measures it on the plant
##     ERROR='1 mm of tip; 1 deg of theta' for choose: how far outputs may be from the exact motion; LOAD=50%: what it may take of the chip
##     RECORDED=FILE                       for report, bench and choose: inputs of a controller, a line for each tick
##     OUTPUTS=speed,current               for plot: what to draw over time, instead of all
##     AGAINST='REAL=double | WITHOUT=rub' for show: further runs beside the first; what is other in each, or the name of a kept run
##     STILL=1.5                           for show: a picture of this time, show.svg, instead of the page
##     SECONDS=10                          simulated time; default of report and bench: 5, of drift: 600, of hil: 60, of conform: 0.02; link: 0 is without an end
##     TARGET=host|posix|cortex-m4f|...    where to run: on this machine in virtual time or in real time, or on a board in QEMU: port/README.md
##     REAL=float|double                   the type of the numbers
##     FMI=3|2                             for fmu: the version of the standard, 3.0 or 2.0
##     EXCHANGE=yes                        for fmu: not without model exchange
##     XCP=open|LOCK                       for a2l and link: who may write and measure, all or who has the key of an iso_xcp_lock (core/xcp)
##     CLOCK=168MHz  BOARD=stm32f405       for cycles and choose: the clock, and the board; CORE=cortex-m0-small: another table of the TARGET
##     BOARD=/dev/ttyACM0                  the serial line of a real board: runs there instead of in QEMU (port/stm32f4)
##     SCRIPT=FILE                         late, lost and slow ticks, on the host (port/host/script.h)
##     CONTROLLER='./ctl'                  for link and hil: a command; it connects where ISOCHRON_LINK says
##     MODE=lockstep|free                  for link and hil: whether the plant waits for the controller, instead of what that asks for
##     SNAPSHOT=N                          for run: takes a snapshot of tick N, build/TARGET/REAL/NAME/snapshot.bin
##     RESTORE=FILE                        for run: goes on from a snapshot, of any target; SECONDS is of the whole run
##     OF='max tip; hash'  RUNS=1000 SEED=1 for sweep: what its table shows; how many random values, and which (tools/sweep)
##     ENGINE=local|parallel|slurm LANES=16 for sweep: here, by GNU parallel on HOSTS='a 4/b' over ssh, or by Slurm; runs side by side
##     KEEP=NAME                           for run, link and hil: keeps it in build/runs/NAME; for choose KEEP=yes: writes it into the scene
##     RUNS='NAME NAME'                    for compare: two runs that were kept
##     ON='host clang cortex-m4f'           for determinism: the targets; clang is the host by clang
##     TICKS=100000                        for determinism: how many, of each of MODELS with each of METHODS
##     V=1                                 show the commands
SCENE = models/$(if $(filter hil,$(MAKECMDGOALS)),hil/cart_pole,$(if $(filter drift,$(MAKECMDGOALS)),four_bar,double_pendulum)).scene
METHOD =
STEP =
TOLERANCE =
INPUTS =
RECORDED =
ERROR =
LOAD = 50%
SET =
WITHOUT =
OUTPUTS =
AGAINST =
STILL =
AT =
TRIM =
BODE =
FORMAT = text
CHECKED =
COMPENSATED =
SECONDS = $(if $(filter report bench,$(MAKECMDGOALS)),5,$(if $(filter drift,$(MAKECMDGOALS)),600,$(if $(filter hil,$(MAKECMDGOALS)),60,$(if $(filter conform,$(MAKECMDGOALS)),0.02,10))))
TARGET = $(if $(filter size ticks cycles choose cost chains functions hil,$(MAKECMDGOALS)),cortex-m4f,host)
REAL = float
FMI = 3
EXCHANGE =
CORE =
CLOCK =
BOARD =
SCRIPT =
XCP = $(if $(filter a2l,$(MAKECMDGOALS)),open)
CONTROLLER =
MODE =
SNAPSHOT =
RESTORE =
KEEP =
RUNS =
SEED =
OF = $(if $(filter sweep,$(MAKECMDGOALS)),hash)
ENGINE = local
HOSTS =
LANES =
MODELS = $(wildcard models/*.scene)
METHODS = $(FIXED_METHODS) $(if $(filter %.c,$(SCENE_FILE)),,adams)
PARTS = models methods restarts effects
TICKS = 100000
ON = host clang $(sort $(filter-out host posix,$(TARGETS)))
LENGTHS = 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16
TABLES = models/costs.md models/cycles.md models/README.md models/chains.md models/drift.md core/methods.md core/README.md tests/digits.md
V =

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules

# Numbers have a point and names one order: an awk writes and reads them as the language of its user does.
export LC_ALL := C

# The goals that build and run plants; each works in one folder.
GOALS := run plot show link hil python flash size stack ticks cycles choose a2l conform cost chains flags report bench drift linear sweep batch fmu equations

.PHONY: help shared digits functions determinism tables pictures compare monitor import clean $(GOALS)
help: ## list the commands and the variables; the same as make without a command
	@sed -n -e 's/^##$$//p' -e 's/^## //p' Makefile
	@echo
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/\1 \2/p' $(MAKEFILE_LIST) | while read -r target text; do \
	    printf '    make %-10s %s\n' $$target "$$text"; done

# --- Helpers -----------------------------------------------------------------------------------------------------

empty :=
comma := ,
space := $(empty) $(empty)
HASH := \#
quote = '$(subst ','\'',$(1))'
Q := $(if $(filter 1,$(V)),,@)
say = $(info $(space) $(1)$(if $(filter CC,$(1)),$(space)$(space),$(if $(filter A2L,$(1)),$(space))) $(2))

# What make can see itself starts no process: a recipe that has nothing to do is empty.
# Whether two texts are the same.
same = $(and $(findstring =$(1)=,=$(2)=),$(findstring =$(2)=,=$(1)=))

# The characters of a text as words, if it is one word and has these alone; else nothing. They are in SPELLED then.
spelled = $(if $(call same,$(1),$(firstword $(1))),$(eval SPELLED := $$(1))$(strip $(foreach letter,$(2),$(eval SPELLED := $$(subst \
    $(letter),$(letter) ,$$(SPELLED))))$(if $(filter-out $(2),$(SPELLED)),,$(SPELLED))))
DIGITS := 0 1 2 3 4 5 6 7 8 9
LETTERS := a b c d e f g h i j k l m n o p q r s t u v w x y z A B C D E F G H I J K L M N O P Q R S T U V W X Y Z $(DIGITS) _ . -
# $(call is_plain,TEXT,COUNT,MORE): whether a text has only letters and these more, and fewer than COUNT.
is_plain = $(and $(call spelled,$(1),$(LETTERS) $(3)),$(if $(word $(2),$(SPELLED)),,yes))
# $(call is_decimal,TEXT,WHOLE,FRACTION): whether a text is a number of at most nine digits, and a fraction.
is_decimal = $(and $(call same,$(1),$(2)$(3:%=.%)),$(call spelled,$(2),$(DIGITS)),$(if $(word 10,$(SPELLED)),,yes),$(if $(3),$(call \
    spelled,$(3),$(DIGITS)),yes))

# A recipe that leaves its target alone if it holds these lines already, so that only a change makes others follow. Make
# 4.3 does not always leave out the end of the last line that it reads.
remember = $(if $(and $(wildcard $@),$(call same,$(call unbroken,$(1)),$(call unbroken,$(file <$@)))),,$(call folders,$(@D))$(if \
    $(IS_DRY),@printf '%s\n' $(subst $(newline),' ',$(call quote,$(1))) >$@,$(file >$@,$(1))))
unbroken = $(subst $(newline),,$(1))

# Makes the folders that are missing. As text that is no recipe it is nothing.
folders = $(call make_folders,$(strip $(foreach folder,$(sort $(1)),$(if $(wildcard $(folder)/.),,$(folder)))))
make_folders = $(if $(1),$(if $(IS_DRY),,$(shell mkdir -p $(1))))

# What a script has that calls make. A recipe that has the word MAKE itself would be executed by make -n.
CALLS_MAKE = MAKE=tools/build/make.sh

# Whether make only says what it would do: with -n.
IS_DRY = $(findstring n,$(filter-out -%,$(firstword $(MAKEFLAGS))))

# The files in PATH of this command, of which a shell runs the first; none where PATH has spaces.
files_of = $(wildcard $(if $(findstring /,$(1)),$(1),$(addsuffix /$(1),$(subst :, ,$(PATH)))))

# A recipe that stops if a tool is missing; TOOL:FILE is a file that the compiler TOOL must find, which is asked until
# it has compiled something.
require = $(if $(strip $(foreach tool,$(1),$(if $(call files_of,$(firstword $(subst :, ,$(tool)))),$(if \
    $(findstring :,$(tool)),$(if $(wildcard build/obj/$(TARGET)/*),,$(tool))),$(tool)))),$(call require_each,$(1),$(2)))
require_each = @for tool in $(1); do \
        case $$tool in \
        *:*) file=$${tool\#*:}; test "$$($${tool%:*} -print-file-name=$$file)" != $$file ;; \
        *) command -v $$tool >/dev/null 2>&1 ;; \
        esac || { echo "$$tool is missing. Install it with: $(2)" >&2; exit 1; }; \
    done

# Whether the compiler is gcc: by the name of its file, behind what may stand before it in PATH and keep objects; asked
# for an option that only gcc has where no name says it.
compiler_names = $(foreach file,$(call files_of,$(firstword $(1))),$(notdir $(realpath $(file))))
compiler_kind = $(firstword $(foreach name,$(compiler_names),$(if $(findstring clang,$(name)),clang,$(if $(findstring gcc,$(name)),gcc))))
is_gcc = $(filter gcc,$(or $(compiler_kind),$(shell echo | $(1) -Werror -fno-tree-ter -E - >/dev/null 2>&1 && echo gcc)))

# Links into the target: beside it, then in its place, so that a run meanwhile is of the old or the new one, whole.
link = $(Q)$(1) -o $@.$$$$ && mv -f $@.$$$$ $@ || { rm -f $@.$$$$; exit 1; }

.PHONY: always
always:

# --- What was asked for ------------------------------------------------------------------------------------------

SET_BY_USER := $(foreach name,$(.VARIABLES),$(if $(findstring command line,$(origin $(name))),$(name)))

# The text of a variable as it was typed: a `$$` in a path is no reference of make.
TEXTS := AGAINST STILL SCENE METHOD STEP TOLERANCE INPUTS RECORDED SET WITHOUT OUTPUTS SECONDS SCRIPT CONTROLLER SNAPSHOT RESTORE KEEP RUNS CORE CLOCK BOARD ERROR LOAD AT TRIM BODE OF SEED ENGINE HOSTS LANES
$(foreach name,$(filter $(SET_BY_USER),$(TEXTS)),$(eval override $(name) := $$(value $(name))))
define newline


endef
$(foreach name,$(TEXTS),$(if $(findstring $(newline),$($(name))), \
    $(error $(name) has a line break, which make cannot pass on)))

# What has an effect on which goal. A goal that is a file, and a make that another make calls, may be given anything.
EFFECTS_run = $(OF_A_RUN) SNAPSHOT RESTORE
OF_A_RUN := SCENE METHOD STEP TOLERANCE INPUTS SET WITHOUT CHECKED COMPENSATED SECONDS TARGET BOARD REAL SCRIPT KEEP OUT PORT_CC PORT_FLAGS PORT_OPTIMISE PORT_CYCLE_NS PORT_EXEC
EFFECTS_plot := $(filter-out KEEP,$(OF_A_RUN)) OUTPUTS
EFFECTS_show := SCENE METHOD STEP TOLERANCE INPUTS SET WITHOUT SECONDS REAL AGAINST STILL
EFFECTS_link := $(OF_A_RUN) XCP CONTROLLER MODE
EFFECTS_hil := $(filter-out SCENE SCRIPT XCP CHECKED COMPENSATED OUT,$(EFFECTS_link))
EFFECTS_python := SCENE METHOD STEP TOLERANCE INPUTS SET WITHOUT REAL OUT
EFFECTS_size := $(filter-out SECONDS SCRIPT KEEP,$(OF_A_RUN))
EFFECTS_stack := $(EFFECTS_size)
EFFECTS_a2l := $(filter-out CHECKED COMPENSATED,$(EFFECTS_size)) XCP
EFFECTS_flash := $(filter-out SCRIPT KEEP,$(OF_A_RUN))
EFFECTS_conform := BOARD TARGET REAL SECONDS PORT_CC PORT_FLAGS PORT_OPTIMISE PORT_EXEC
EFFECTS_ticks := SCENE METHOD STEP TOLERANCE INPUTS SET WITHOUT CHECKED COMPENSATED TARGET REAL
OF_ONE_SCENE := $(and $(filter cost cycles,$(MAKECMDGOALS)),$(filter SCENE,$(SET_BY_USER)))
EFFECTS_cycles := $(if $(OF_ONE_SCENE),SCENE METHOD STEP INPUTS SET WITHOUT TARGET CORE CLOCK BOARD OUT)
EFFECTS_choose := SCENE STEP INPUTS RECORDED SET WITHOUT METHODS SECONDS ERROR LOAD KEEP TARGET CORE CLOCK BOARD
EFFECTS_cost := $(if $(OF_ONE_SCENE),SCENE METHOD STEP INPUTS SET SECONDS,PARTS METHODS) TARGET REAL
$(foreach name,$(if $(OF_ONE_SCENE),$(filter PARTS METHODS,$(SET_BY_USER))),$(error $(name) has no effect on `make cost \
    SCENE=...`, which is of one scene; it has one on `make cost`))
EFFECTS_chains := LENGTHS TARGET REAL
EFFECTS_flags := TARGET REAL MODELS
EFFECTS_report := SCENE METHODS STEP SECONDS RECORDED
EFFECTS_bench := $(EFFECTS_report)
EFFECTS_linear := SCENE METHOD STEP TOLERANCE SET WITHOUT AT TRIM BODE
EFFECTS_sweep := SCENE METHOD STEP TOLERANCE INPUTS SET WITHOUT SECONDS REAL OF RUNS SEED ENGINE HOSTS LANES
EFFECTS_batch := SCENE METHOD STEP INPUTS SET WITHOUT REAL
EFFECTS_equations := SCENE METHOD STEP TOLERANCE INPUTS SET WITHOUT REAL FORMAT
EFFECTS_drift := SCENE STEP SECONDS
EFFECTS_fmu := SCENE METHOD STEP TOLERANCE INPUTS SET WITHOUT REAL FMI EXCHANGE
EFFECTS_test := TEST_JOBS
EFFECTS_check := TEST_JOBS
EFFECTS_tables := TABLES
EFFECTS_compare := RUNS
EFFECTS_determinism := MODELS METHODS ON TICKS REAL
EFFECTS := V CC CFLAGS $(sort $(foreach goal,$(GOALS) test check tables compare determinism,$(EFFECTS_$(goal))))

nearest = $(shell mkdir -p build && $(CC) -I. tools/build/nearest.c tools/isoc/base/nearest.c -o build/nearest.$$$$ && \
    build/nearest.$$$$ $(1) $(EFFECTS); rm -f build/nearest.$$$$)
unknown = $(error $(1) is not known$(if $(2), (did you mean $(2)?)); `make help` lists what can be set)
no_effect = $(error $(1) has no effect on `make $(2)`; it has one on: $(strip $(foreach goal,$(GOALS) test \
    check tables compare determinism,$(if $(filter $(1),$(EFFECTS_$(goal))),$(goal)))))
ifeq ($(MAKELEVEL),0)
$(foreach name,$(filter-out $(EFFECTS) MAKEFLAGS SHELL,$(SET_BY_USER)),$(call unknown,$(name),$(call nearest,$(name))))
ifeq ($(filter-out $(GOALS) test check tables compare determinism pictures help clean digits functions monitor import,$(or $(MAKECMDGOALS),help)),)
$(foreach name,$(filter $(SET_BY_USER),$(filter-out V CC CFLAGS,$(EFFECTS))),$(if $($(name)),$(if $(filter $(name),$(foreach \
    goal,$(MAKECMDGOALS),$(EFFECTS_$(goal)))),,$(call no_effect,$(name),$(or $(MAKECMDGOALS),help)))))
endif
endif


# A target is a folder of port/ with a port.mk; the other folders have what ports share.
TARGETS := $(patsubst port/%/port.mk,%,$(wildcard port/*/port.mk))
PORT := $(patsubst %,port/%,$(filter $(strip $(TARGET)),$(TARGETS)))
# The methods, by the list that has their names. Their step is fixed; adams has one that varies within the tick, and is
# for scenes only.
FIXED_METHODS := $(filter-out adams,$(patsubst "core/methods/%.h",%,$(filter "core/methods/%,$(file <core/methods/all.h))))
REAL_FLAGS_float :=
REAL_FLAGS_double := -DISO_REAL_DOUBLE

ifeq ($(PORT),)
$(error TARGET=$(TARGET) is unknown; it can be one of: $(sort $(TARGETS)))
endif
ifeq ($(filter float double,$(REAL)),)
$(error REAL=$(REAL) is unknown; it can be float or double)
endif
ifeq ($(filter 2 3,$(FMI)),)
$(error FMI=$(FMI) is unknown; it can be 3 or 2)
endif
ifneq ($(filter-out yes,$(EXCHANGE)),)
$(error EXCHANGE=$(EXCHANGE) is unknown; it can be yes)
endif
ifneq ($(filter $(if $(OF_ONE_SCENE),,cost) chains ticks,$(MAKECMDGOALS)),)
ifneq ($(TARGET) $(REAL),cortex-m4f float)
$(error make $(MAKECMDGOALS) is of the cortex-m4f in float; TARGET and REAL cannot be others)
endif
endif
ifneq ($(filter flags,$(MAKECMDGOALS)),)
ifeq ($(filter host cortex-m4f,$(TARGET)),)
$(error make flags is of the host or the cortex-m4f; TARGET cannot be another)
endif
endif
ifneq ($(SCRIPT),)
ifneq ($(TARGET),host)
$(error SCRIPT has no effect on TARGET=$(TARGET), which has ticks of its own; it is for TARGET=host)
endif
endif
ifneq ($(KEEP),)
ifneq ($(if $(call is_plain,$(KEEP),256),,no)$(filter . ..,$(KEEP)),)
$(error KEEP=$(KEEP) is no name for a run; it can have letters, digits, _ . and -)
endif
endif
ifneq ($(SNAPSHOT),)
ifeq ($(and $(call spelled,$(SNAPSHOT),$(DIGITS)),$(if $(word 19,$(SPELLED)),,yes)),)
$(error SNAPSHOT=$(SNAPSHOT) is no tick; it could be 12345)
endif
endif
ifneq ($(RESTORE),)
ifneq ($(shell { head -c 4 <$(call quote,$(RESTORE)) | grep -aqx ISOS; } 2>/dev/null || echo no),)
$(error RESTORE=$(RESTORE) is no snapshot; make run SNAPSHOT=N writes one)
endif
endif
ifneq ($(MODE),)
ifeq ($(filter lockstep free,$(MODE)),)
$(error MODE=$(MODE) is unknown; it can be lockstep or free)
endif
ifeq ($(MODE) $(TARGET),free host)
$(error MODE=free needs time that is real; TARGET=host has none, the others have)
endif
endif
IS_IN_C := $(filter .c,$(suffix $(subst $(space),_,$(SCENE))))
ifneq ($(INPUTS),)
ifeq ($(filter held smooth,$(INPUTS)),)
$(error INPUTS=$(INPUTS) is unknown; it can be held or smooth)
endif
ifneq ($(IS_IN_C),)
$(error INPUTS has no effect on a plant in C; it is for scenes)
endif
endif
ifneq ($(and $(SNAPSHOT)$(RESTORE),$(IS_IN_C)),)
$(error a plant in C has no snapshots of its runs: they are for scenes)
endif
ifneq ($(and $(filter show,$(MAKECMDGOALS)),$(IS_IN_C)),)
$(error make show is of scenes; $(SCENE) is a plant in C, of whose bodies nothing is known)
endif
ifneq ($(and $(filter fmu,$(MAKECMDGOALS)),$(IS_IN_C)),)
$(error make fmu is of scenes; $(SCENE) is a plant in C, of whose quantities too little is known)
endif
ifneq ($(STILL),)
# A point may end it.
STILL_TIME := $(if $(findstring .,$(STILL:%.=%)),$(STILL),$(STILL:%.=%))
ifeq ($(call is_decimal,$(STILL_TIME),$(word 1,$(subst ., ,$(STILL_TIME))),$(word 2,$(subst ., ,$(STILL_TIME)))),)
$(error STILL=$(STILL) is no time in seconds; it could be 1.5)
endif
endif
ifneq ($(and $(OF_ONE_SCENE),$(IS_IN_C)),)
$(error make $(MAKECMDGOALS) is of scenes; $(SCENE) is a plant in C)
endif
ifneq ($(and $(filter choose ticks,$(MAKECMDGOALS)),$(IS_IN_C)),)
$(error make $(MAKECMDGOALS) is of scenes)
endif
ifneq ($(filter choose,$(MAKECMDGOALS))$(and $(OF_ONE_SCENE),$(filter cycles,$(MAKECMDGOALS))),)
MACHINE := $(shell sh tools/measure/cycles/machine.sh $(TARGET) $(call quote,$(CORE)) $(call quote,$(BOARD)) $(call quote,$(CLOCK)))
ifeq ($(firstword $(MACHINE)),error)
$(error $(wordlist 2,999,$(MACHINE)))
endif
endif
$(if $(TOLERANCE),$(if $(filter-out adams,$(METHOD))$(if $(METHOD),,$(IS_IN_C)),\
    $(error TOLERANCE has no effect on METHOD=$(or $(METHOD),rk4); it is of METHOD=adams)))
$(foreach name,CHECKED COMPENSATED,$(if $($(name)),$(if $(filter yes no,$($(name))),,$(error $(name)=$($(name)) is \
    unknown; it can be yes or no))$(if $(IS_IN_C),,$(error $(name) is of a plant in C; a scene says it itself: $(if \
    $(filter CHECKED,$(name)),checked,compensated) yes))))
$(if $(METHOD),$(if $(filter $(FIXED_METHODS) adams,$(METHOD)),,\
    $(error METHOD=$(METHOD) is unknown; it can be one of: $(FIXED_METHODS) adams)))

# What make could misread in a path of ours becomes a line. The folder of a scene outside of models/ is its path with +
# for /; of an unusual or long path, its name with a checksum of the path.
SCENE_FILE := $(subst $(space),_,$(SCENE))
SCENE_PATH := $(patsubst $(CURDIR)/%,%,$(abspath $(SCENE_FILE)))
NAME := $(basename $(notdir $(SCENE_FILE)))
IS_PLAIN := $(call is_plain,$(NAME),65)
ifeq ($(IS_PLAIN),)
NAME := $(shell printf %s $(call quote,$(NAME)) | tr -c 'A-Za-z0-9_.-' _ | cut -c 1-64)
endif
ifeq ($(patsubst .%,,$(NAME)),)
$(error SCENE=$(SCENE) has no name before its ending)
endif
IS_MODEL := $(and $(IS_PLAIN),$(call same,$(SCENE),$(SCENE_FILE)),$(filter models/$(NAME).scene models/$(NAME).c,$(SCENE)),\
    $(wildcard $(SCENE_FILE)))
# A make that this one calls has the folder in ISOCHRON_FOLDER, with the scene that it is of. One of the environment
# would be asked for by every process.
unexport FOLDER
ifneq ($(IS_MODEL),)
FOLDER := $(NAME)
else ifneq ($(call same,$(value ISOCHRON_FOLDER),$(firstword $(value ISOCHRON_FOLDER)) $(SCENE)),)
FOLDER := $(firstword $(value ISOCHRON_FOLDER))
else ifneq ($(and $(call same,$(SCENE) 1,$(SCENE_FILE) $(words $(SCENE_PATH))),$(IS_PLAIN),$(call is_plain,$(SCENE_PATH),161,/)),)
FOLDER := $(if $(call same,$(basename $(SCENE_PATH)),models/$(NAME)),$(NAME),+$(subst /,+,$(SCENE_PATH)))
else
FOLDER = $(eval FOLDER := $$(shell path=$$$$(realpath -m --relative-to=. -- $$(call quote,$$(SCENE))); test "$$$${path%.*}" = models/$$(NAME) \
    && echo $$(NAME) || { printf '$$(NAME)-' && printf %s "$$$$path" | cksum | cut -d ' ' -f 1; }))$(FOLDER)
endif
# Nothing asks for the folder where OUT is given.
ifneq ($(origin OUT),command line)
OUT := $(if $(filter hil conform,$(MAKECMDGOALS)),build/$(filter hil conform,$(MAKECMDGOALS))/$(TARGET)/$(REAL),build/$(TARGET)/$(REAL)/$(FOLDER))
OF_SCENE := ISOCHRON_FOLDER=$(call quote,$(FOLDER) $(SCENE))
else
OF_SCENE :=
endif

include $(PORT)/port.mk

# A port that does not say which number types it computes with has both.
ifeq ($(filter $(REAL),$(or $(PORT_REALS),float double)),)
$(error REAL=$(REAL) is refused on TARGET=$(TARGET): its compiler has no double of 64 bits; take REAL=float there)
endif

ifneq ($(filter link hil a2l,$(MAKECMDGOALS)),)
$(if $(PORT_CHANNEL),,$(error make $(MAKECMDGOALS) needs channels (port/channel.h), and TARGET=$(TARGET) has none))
$(if $(filter 1,$(if $(XCP),$(PORT_CHANNELS))),$(error TARGET=$(TARGET) has one channel, that of a controller, and none for measurement \
    and calibration over XCP))
endif

$(if $(filter flash,$(MAKECMDGOALS))$(if $(filter cycles choose shared,$(MAKECMDGOALS)),,$(BOARD)),$(if $(PORT_FLASH),,\
    $(error TARGET=$(TARGET) is no real board; stm32f407 and stm32f446 are)))

# --- How everything is compiled ----------------------------------------------------------------------------------

include tools/build/flags.mk

# A script that calls make for many plants (tools/build/alone.sh) lists in ISOCHRON_MADE each TARGET/REAL whose shared
# objects and tools are up to date. A make that has the lock of its folder then has no rules for these.
IS_MADE := $(and $(filter $(strip $(TARGET))/$(strip $(REAL)),$(value ISOCHRON_MADE)),$(filter $(firstword $(value \
    ISOCHRON_LOCKED)),$(firstword $(MAKECMDGOALS))))
ifeq ($(IS_MADE),)
include tools/build/tools.mk
endif

# --- Objects that programs share ---------------------------------------------------------------------------------

# PORT_CYCLE_NS: what a cycle of a board in QEMU stands for, if not what its port says. Portable sources do not refer to
# it.
COMPILE_PORTABLE := $(PORT_CC) $(WARNINGS) $(PORT_OPTIMISE) $(NUMERICS) $(PORT_FLAGS) $(REAL_FLAGS_$(REAL)) -I. $(call given_flags,$(CFLAGS))
COMPILE := $(COMPILE_PORTABLE) $(PORT_CYCLE_NS:%=-DBOARD_CYCLE_NS=%)
OBJ := build/obj/$(TARGET)/$(REAL)
CONTROL := core/runtime/control.c core/runtime/snapshot.c
OBJECTS := $(patsubst %,$(OBJ)/%.o,$(basename $(filter-out $(CONTROL),$(wildcard $(addsuffix /*.c,core/numbers core/runtime core/application))) \
    $(filter-out $(PORT_CHANNEL),$(wildcard $(PORT)/*.c)) $(PORT_SHARED)))

# What a plant with a link has besides, and its own main.
CALIBRATION := $(wildcard core/xcp/*.c)
LINKED_OBJECTS := $(filter-out $(OBJ)/core/application/main.o,$(OBJECTS)) \
    $(patsubst %.c,$(OBJ)/%.o,$(wildcard core/link/*.c) $(CONTROL) $(PORT_CHANNEL) $(if $(XCP),$(CALIBRATION)))

# What the library of a plant in Python has of core, beside its own source: no link, but what a link is asked.
LIBRARY_OBJECTS := $(patsubst %.c,$(OBJ)/library/%.o,core/numbers/self_check.c core/runtime/loop.c $(CONTROL) core/link/command.c \
    core/link/frame.c tools/python/instance.c)

# What the program that tries a port has besides, and its own main.
CONFORM_OBJECTS := $(filter-out $(OBJ)/core/application/%,$(OBJECTS)) $(OBJ)/core/conform/main.o $(patsubst %.c,$(OBJ)/%.o,$(PORT_CHANNEL) \
    core/conform/$(if $(PORT_CHANNEL),,no_)channel.c)

# What a run with a snapshot has besides, and its own main.
RECORDED_OBJECTS := $(filter-out $(OBJ)/core/application/main.o,$(OBJECTS)) $(OBJ)/core/runtime/snapshot.o $(OBJ)/core/record/main.o

# What the program of a sweep has besides its plants; side.c has the lanes of these.
SWEEP_OBJECTS := $(filter-out $(OBJ)/core/application/%,$(OBJECTS)) $(patsubst %.c,$(OBJ)/%.o,$(filter-out %/side.c,$(wildcard tools/sweep/*.c)) tools/table/table.c tools/file/file.c tools/trace/decimal.c)

ifeq ($(IS_MADE),)
$(OBJ)/flags: always
	$(call require,$(PORT_TOOLS),$(PORT_INSTALL))
	$(call folders,$(patsubst %/,%,$(dir $(OBJECTS) $(LINKED_OBJECTS) $(RECORDED_OBJECTS) $(CONFORM_OBJECTS) $(LIBRARY_OBJECTS) $(CALIBRATION:%=$(OBJ)/%) $(OBJ)/tools/a2l/places.o $(SWEEP_OBJECTS))))
	$(call remember,$(COMPILE))

$(OBJ)/%.o: %.c $(OBJ)/flags
	$(call say,CC,$<)
	$(Q)$(if $(filter port/%,$<),$(COMPILE),$(COMPILE_PORTABLE)) -MMD -MP -c $< -o $@
$(OBJ)/%.o: %.S $(OBJ)/flags; $(Q)$(COMPILE) -MMD -MP -c $< -o $@

$(OBJ)/library/%.o: %.c $(OBJ)/flags
	$(call say,CC,$<)
	$(Q)$(COMPILE) -fPIC -fvisibility=hidden -MMD -MP -c $< -o $@

-include $(TOOL_OBJECTS:.o=.d) build/obj/tools/core/link/frame.d build/obj/tools/core/xcp/transport.d $(sort $(OBJECTS:.o=.d) $(LINKED_OBJECTS:.o=.d) $(RECORDED_OBJECTS:.o=.d) $(CONFORM_OBJECTS:.o=.d) $(LIBRARY_OBJECTS:.o=.d) $(SWEEP_OBJECTS:.o=.d)) \
    $(OBJ)/tools/a2l/places.d
endif

# --- Goals -------------------------------------------------------------------------------------------------------

run: ## run the scene: write build/TARGET/REAL/NAME/trace.csv and print a summary
plot: ## run the scene and draw it with gnuplot: trace.svg, path.svg and histogram.svg, and all as png, beside the trace
show: ## run the scene and write show.html beside the trace: a page with the mechanism in motion and its outputs; AGAINST: other runs beside it
link: ## connect the scene with a CONTROLLER: trace.csv with inputs and outputs, a summary, and how long exchanges took
hil: ## the worked example: a cart with its pole on the board, balanced by a controller in a process of its own; draw it
python: ## make a package of Python with the scene's plant in it, build/host/REAL/NAME/python, for pip or PYTHONPATH
flash: ## write the program into a real board and start it there: TARGET=stm32f407 or stm32f446
a2l: ## build the plant with a link and with measurement and calibration over XCP; write its A2L: addresses, types, units, ranges
choose: ## advise the cheapest method, step and sub-steps of SCENE for an ERROR on a TARGET: what it takes of the chip
report: ## measure the error of every method over its cost and its step, and more: a page, tables and pictures in build/report/NAME/
bench: ## compare the methods at equal step and at equal error, as a table
fmu: ## write SCENE as an FMU for co-simulation by FMI=3 or 2, with sources and a library: build/fmu/NAME/NAME.fmu (tools/fmu)
linear: ## the linear model of SCENE: A, B, C, D, equilibria (TRIM), modes in words, Bode plots (BODE), in build/linear/NAME/
sweep: ## make many runs of SCENE, with the values of SET: a table of what OF says, in build/sweep/NAME/; it goes on where it was ended
equations: ## write the equations of SCENE for a reader, with the names of plant.c: build/equations/NAME/equations.txt, or .tex of FORMAT=latex
drift: ## measure the drift of closed loops with every stabilisation: a table, and a picture in build/drift/NAME/

# Makes that run at once do not meet. A goal first makes what all share, with build/lock; then make calls itself for
# that goal, with the folder locked that the goal works in, and says so in ISOCHRON_LOCKED. That make has the goal's
# recipe.
folder_of = $(if $(filter run plot show link hil python flash size stack ticks a2l conform $(OF_ONE_SCENE:%=cycles),$(1)),$(OUT),$(if $(filter cost cycles,$(1)),build/cost$(OF_ONE_SCENE:%=/$(FOLDER)),$(if \
    $(filter chains,$(1)),build/cost,$(if $(filter flags,$(1)),build/flags,build/$(1)/$(FOLDER)))))
shared = $(or $(TOOLS_OF_$(1)),$(TOOLS)) $(if $(filter python,$(1)),$(LIBRARY_OBJECTS),$(if $(filter $(OUT),$(call folder_of,$(1)))$(filter cost chains choose,$(1)),$(OBJECTS))) $(if $(filter link hil a2l,$(1)),$(sort $(LINKED_OBJECTS) \
    $(OBJ)/tools/a2l/places.o)) $(if $(filter conform,$(1)),$(CONFORM_OBJECTS)) $(if $(filter sweep,$(1)),$(SWEEP_OBJECTS)) $(if $(filter run,$(1)),$(if $(SNAPSHOT)$(RESTORE),$(RECORDED_OBJECTS)))
# What scripts that measure many plants on one target are told: all that these share is made.
HAS_MADE = ISOCHRON_MADE=$(TARGET)/$(REAL)
# Of goals that need few of them; the others have all.
TOOLS_OF_run := $(addprefix build/,isoc trace duration)
TOOLS_OF_plot := $(TOOLS_OF_run)
TOOLS_OF_show := $(TOOLS_OF_run) build/show
TOOLS_OF_python := build/isoc build/duration
TOOLS_OF_link := $(TOOLS_OF_run) build/link
TOOLS_OF_linear := build/isoc build/duration
TOOLS_OF_sweep := $(TOOLS_OF_linear)
TOOLS_OF_equations := build/isoc
TOOLS_OF_fmu := build/isoc build/duration
TOOLS_OF_hil := $(TOOLS_OF_link)
TOOLS_OF_conform := $(TOOLS_OF_run) build/duties
LOCK_TOOLS := flock realpath
LOCK_INSTALL := apt-get install util-linux coreutils
# The status of flock where another has the lock; make ends with none above 2.
LOCKED := 75

shared: $(SHARED)
	@:

ifeq ($(ISOCHRON_LOCKED),$(if $(filter $(GOALS),$(MAKECMDGOALS)),$(MAKECMDGOALS) $(call folder_of,$(MAKECMDGOALS)),no goal))
include tools/build/goals.mk
else
# The shared files are made with as many jobs as there are processors for them, unless make has a number of jobs.
JOBS = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(or $(strip $(ALLOWED)),$(shell nproc)))
$(GOALS):
	$(call require,$(LOCK_TOOLS),$(LOCK_INSTALL))
	$(call folders,$(call folder_of,$@))
	@$(if $(IS_DRY),,flock -F build/lock) $(MAKE) -f tools/build/old.mk --no-print-directory $(JOBS) shared SHARED='$(call shared,$@)' TARGET=$(TARGET) REAL=$(REAL) OUT=
	@export ISOCHRON_LOCKED='$@ $(call folder_of,$@)' $(OF_SCENE); \
	    $(if $(IS_DRY),$(MAKE) -f tools/build/old.mk --no-print-directory $@,flock -F -n -E $(LOCKED) $(call folder_of,$@)/lock $(MAKE) -f tools/build/old.mk --no-print-directory $@; \
	    status=$$?; test $$status -eq $(LOCKED) || exit $$status; \
	    echo '  WAIT until another make is done in $(call folder_of,$@)' >&2; \
	    exec flock -F $(call folder_of,$@)/lock $(MAKE) -f tools/build/old.mk --no-print-directory $@)

# The bits of the mask that Linux tells; nproc says it elsewhere.
ALLOWED = $(eval BITS := $(subst $(comma),,$(patsubst Cpus_allowed:%,%,$(filter Cpus_allowed:%,$(subst Cpus_allowed: ,Cpus_allowed:,$(strip \
    $(file </proc/self/status)))))))$(foreach digit,0 1x 2x 3xx 4x 5xx 6xx 7xxx 8x 9xx axx bxxx cxx dxxx exxx fxxxx,$(eval BITS := \
    $(subst $(subst x,,$(digit)),$(subst $(subst x,,$(digit)),,$(digit)),$(BITS))))$(filter-out 0,$(words $(subst x,x ,$(BITS))))
endif

monitor: build/monitor ## build the terminal of measurement and calibration; then: build/monitor A2L tcp:127.0.0.1:5555 (core/xcp)

import: build/import ## build the import of robots; then: build/import ROBOT.urdf -o ROBOT.scene (tools/import)

compare: ## draw two runs that were kept, one over the other, in build/compare/, and print their differences
	$(call require,gnuplot,apt-get install gnuplot-nox)
	@test $(words $(RUNS)) = 2 || { echo "RUNS='$(RUNS)' are not two runs; it could be RUNS='a b', after make run KEEP=a \
and make run KEEP=b" >&2; exit 1; }
	@for name in $(RUNS); do test -e build/runs/$$name/trace.csv || { \
	    echo "there is no run $$name; make run KEEP=$$name keeps one" >&2; exit 1; }; done
	@mkdir -p build/compare
	$(Q)sh tools/plot/picture.sh differences $(RUNS:%=build/runs/%)
	$(Q)sh tools/plot/draw.sh build/compare/$(subst $(space),-,$(strip $(RUNS))).gnuplot compare $(RUNS:%=build/runs/%)

digits: build/isoc build/tests/requests ## print a table of errors against reference solutions
	@sh tests/reference/table.sh

# What they call makes the tools first, so that a table has no line of the compiler.
tables: $(TOOLS) ## write the generated tables again, in the Markdown files TABLES
	@$(CALLS_MAKE) exec sh tools/build/tables.sh $(TABLES)

determinism: $(TOOLS) ## compare the hash of TICKS of MODELS with METHODS ON targets with that of the host, and count their steps; in REAL
	@$(CALLS_MAKE) MODELS=$(call quote,$(MODELS)) METHODS=$(call quote,$(METHODS)) ON=$(call quote,$(ON)) TICKS=$(TICKS) REAL=$(REAL) \
	    exec sh tools/measure/determinism.sh

pictures: $(TOOLS) ## draw the pictures of models/README.md again
	$(call require,gnuplot dot,apt-get install gnuplot-nox graphviz)
	@$(CALLS_MAKE) exec sh tools/plot/pictures.sh models/pictures



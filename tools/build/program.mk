# The rules of a program: the sources that isoc wrote into the folder OUT, with what core and a port have for its KIND.
#
#     make -f tools/build/program.mk BUILD=build OUT=FOLDER KIND=run TARGET=host REAL=float program
#
# tools/lab/build.py decides the folder, has isoc write there, and calls this from the root of the project. BUILD has
# the objects that programs share. What a command was is in a file `flags` beside what it made, which changes with it.
BUILD = build
OUT =
KIND = run
TARGET = host
REAL = float
# Where commands of a port find its scripts: from the root, unless told.
FROM =
# Further flags of the plant's own sources, and of the link.
PLANT_FLAGS =
LINK_FLAGS =
is_gcc = $(findstring Free Software Foundation,$(shell $(1) --version 2>/dev/null))
include tools/build/flags.mk
PORT := port/$(TARGET)
include $(PORT)/port.mk

COMPILE = $(PORT_CC) $(WARNINGS) $(PORT_OPTIMISE) $(NUMERICS) $(PORT_FLAGS) $(if $(filter double,$(REAL)),-DISO_REAL_DOUBLE) \
    -I. $(call given_flags,$(CFLAGS))
LINK = $(PORT_CC) $(PORT_FLAGS) $(CFLAGS) $(PORT_LINK) $(LINK_FLAGS)
OBJ = $(BUILD)/obj/$(TARGET)/$(REAL)/$(KIND_FOLDER)
PROGRAM = $(OUT)/program$(PORT_SUFFIX)

# --- What is linked with a plant, by the kind of its program ------------------------------------------------------

CONTROL := core/runtime/control.c core/runtime/snapshot.c
BASE := $(filter-out $(CONTROL) core/application/main.c,$(wildcard $(addsuffix /*.c,core/numbers core/runtime core/application))) \
    $(filter-out $(PORT_CHANNEL),$(wildcard $(PORT)/*.c)) $(PORT_SHARED)
LINKED := $(BASE) $(CONTROL) $(wildcard core/link/*.c) $(PORT_CHANNEL)
SOURCES_run = $(BASE) core/application/main.c
SOURCES_linked = $(LINKED)
SOURCES_calibrated = $(LINKED) $(wildcard core/xcp/*.c)
SOURCES_recorded = $(BASE) core/runtime/snapshot.c core/snapshots/main.c
SOURCES_conform = $(filter-out core/application/%,$(BASE)) core/conform/main.c $(PORT_CHANNEL) core/conform/$(if $(PORT_CHANNEL),,no_)channel.c
SOURCES_sweep = $(filter-out core/application/%,$(BASE)) $(filter-out %/alone.c %/side.c,$(wildcard tools/sweep/*.c)) tools/table/table.c \
    tools/file/file.c tools/trace/decimal.c
# No program but a library: the plant in a process of Python.
SOURCES_python = core/numbers/self_check.c core/runtime/loop.c $(CONTROL) core/link/command.c core/link/frame.c tools/python/instance.c
LIBRARIES_sweep = -lm
SOURCES_none =
ifeq ($(KIND),python)
COMPILE += -fPIC -fvisibility=hidden
LINK += -shared
KIND_FOLDER = python/
PROGRAM = $(OUT)/plant.so
endif
ifneq ($(filter linked calibrated recorded,$(KIND)),)
LINK += $(PORT_LINK_LINKED)
endif
# The serial lines of a board are then joined to a controller.
ifneq ($(filter linked calibrated conform,$(KIND)),)
PORT_SERIAL = $(PORT_SERIAL_LINKED)
endif
COMPILE_PORT = $(COMPILE) $(PORT_CYCLE_NS:%=-DBOARD_CYCLE_NS=%)

LIBRARIES = $(PORT_LIBRARIES) $(LIBRARIES_$(KIND))
SOURCES := $(sort $(SOURCES_$(KIND)))
OBJECTS := $(patsubst %,$(OBJ)%.o,$(basename $(SOURCES)))
OWN := $(patsubst %.c,%.o,$(wildcard $(OUT)/*.c))

# --- Rules ---------------------------------------------------------------------------------------------------------

.PHONY: program objects print
program: $(PROGRAM)
objects: $(OBJECTS)

$(OBJ)flags: always
	@mkdir -p $(sort $(dir $(OBJECTS)))
	@$(call remember,$(call quote,$(COMPILE_PORT)))
$(OUT)/flags: always
	@$(call remember,$(call quote,$(COMPILE) $(PLANT_FLAGS) $(LINK) $(SOURCES) $(LIBRARIES)))

$(OBJ)%.o: %.c $(OBJ)flags
	@echo '  CC   $<'
	@$(if $(filter port/%,$<),$(COMPILE_PORT),$(COMPILE)) -MMD -MP -c $< -o $@
$(OBJ)%.o: %.S $(OBJ)flags
	@$(COMPILE_PORT) -MMD -MP -c $< -o $@
$(OWN): %.o: %.c $(OUT)/flags
	@echo '  CC   $<'
	@$(COMPILE) $(PLANT_FLAGS) -MMD -MP -c $< -o $@

# A run meanwhile is of the old program or of the new one, whole.
$(PROGRAM): $(OWN) $(OBJECTS) $(OUT)/flags $(wildcard port/*/*.ld)
	@echo '  LINK $@'
	@$(LINK) $(OWN) $(OBJECTS) $(LIBRARIES) -o $@.new && mv -f $@.new $@

# What lab.build asks of a port.
print:
	@:
ifneq ($(filter print,$(MAKECMDGOALS)),)
$(foreach name,$(filter PORT_%,$(.VARIABLES)) COMPILE COMPILE_PORT LINK OBJECTS SOURCES PROGRAM CC WARNINGS NUMERICS,$(info $(name)=$($(name))))
endif

-include $(OBJECTS:.o=.d) $(OWN:.o=.d)

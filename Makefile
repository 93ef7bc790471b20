# Isochron: what make builds, tests and installs.
#
#     make run [SCENE=models/arm6.scene]   runs a scene on this machine for 10 s; needs cc and make alone
#     make test                            all tests, 16 minutes on two cores; make check: the fast ones
#     make tools                           the tools of this machine, in build/
#     make install [PREFIX=/usr/local] [DESTDIR=]   the command isochron, and all that it needs
#     make clean                           removes build/
#
# All else is said by tools/isochron: `tools/isochron --help`.
SCENE = models/double_pendulum.scene
PREFIX = /usr/local
DESTDIR =

.DEFAULT_GOAL := help
# With as many jobs as there are processors, unless make was told or is called by make.
JOBS := $(if $(MAKELEVEL:0=)$(findstring -j,$(MAKEFLAGS)),,-j$(shell nproc 2>/dev/null || echo 1))
MAKEFLAGS += --no-print-directory $(JOBS)
export LC_ALL := C

.PHONY: help run tools install clean
help:
	@sed -n 's/^#     //p' Makefile

include tools/build/flags.mk

# --- A run of a scene ------------------------------------------------------------------------------------------------

OUT = build/host/float/$(basename $(notdir $(SCENE)))
run: build/isoc build/trace
	$(if $(word 2,$(SCENE)),$(error make cannot read a path with spaces: tools/isochron run '$(SCENE)'))
	@mkdir -p $(OUT)
	@build/isoc '$(SCENE)' -o $(OUT) >$(OUT)/plant.txt
	@$(MAKE) -f tools/build/program.mk OUT=$(OUT) program
	@sed -n -e '/^assembled /p' -e '/^dead_position /p' $(OUT)/plant.txt
	@build/trace -o $(OUT) -- $(OUT)/program 10000000000
	@build/isoc '$(SCENE)' --ended $(OUT)/last.txt

# All else is a command of its own, with options in place of variables.
OTHER := $(foreach name,$(filter-out SCENE CC CFLAGS PREFIX DESTDIR MAKEFLAGS,$(.VARIABLES)),$(if $(filter command,$(firstword $(origin \
    $(name)))),$(name)))
$(foreach name,$(filter-out MAKE%,$(OTHER:-%=)),$(error $(name)= is no variable of make; it may be an option of a command: \
    tools/isochron run $(SCENE) --$(shell echo $(name) | tr A-Z a-z) '$(value $(name))'))
.DEFAULT:
	@echo 'make has no goal and no file $@; it may be a command: tools/isochron $@, tools/isochron --help' >&2; exit 1

# --- The tools of this machine ---------------------------------------------------------------------------------------

# With little optimisation: -O1 takes a compiler a third to a half longer, and isoc a seventh fewer instructions.
TOOL_COMPILE = $(CC) $(WARNINGS) -Og $(NUMERICS) -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE -I. $(call given_flags,$(CFLAGS))
TOOLS := $(addprefix build/,isoc trace link duties monitor show cycles)
TOOL_OBJ := build/obj
objects_of = $(patsubst %.c,$(TOOL_OBJ)/%.o,$(wildcard $(addsuffix /*.c,$(1))))
tools: $(TOOLS)

# A folder of isoc is compiled as one file that includes all of it: most of the work of a compiler is the same for each.
# A name that stands at the top of one may be a local name of another; tests/check/warnings.t compiles each alone.
ISOC_FOLDERS := $(sort $(patsubst tools/isoc/%/,%,$(dir $(wildcard tools/isoc/*/*.c))))
ISOC_PARTS := $(ISOC_FOLDERS:%=$(TOOL_OBJ)/tools/isoc/%)
# It has every kernel, to find the map of a step of a linear plant: their loops stay rolled, and unoptimised. In the
# graph and in eigenvalues isoc takes most of its time.
FLAGS_method := -O0 -DISO_UNROLL=
FLAGS_graph := -O2
FLAGS_base := -O2

# The text of core, of effects and of templates is in isoc, which works alone.
EMBEDDED_core := $(filter-out core/runtime/loop.%,$(wildcard core/numbers/*.[ch] core/methods/*.[ch] core/runtime/*.[ch])) \
    $(wildcard port/soft/*.h)
EMBEDDED_effect := $(sort $(wildcard models/effects/*.scene))
EMBEDDED_client := $(wildcard tools/client/* tools/package/* tools/fmu/*.in) tools/build/numerics
EMBEDDED_help := tools/isoc/help.txt
EMBEDDED := $(patsubst %,$(TOOL_OBJ)/tools/isoc/%_files,core effect client help)

OBJECTS_isoc := $(ISOC_PARTS:=.o) $(EMBEDDED:=.o) $(call objects_of,tools/isoc)
TABLES := $(call objects_of,tools/file tools/table)
OBJECTS_trace := $(call objects_of,tools/trace tools/file)
OBJECTS_link := $(call objects_of,tools/link tools/file) $(TOOL_OBJ)/tools/trace/decimal.o $(TOOL_OBJ)/tools/core/link/frame.o
OBJECTS_duties := $(call objects_of,tools/conform) $(TOOL_OBJ)/tools/link/child.o $(TOOL_OBJ)/tools/file/file.o
OBJECTS_monitor := $(call objects_of,tools/monitor) $(TABLES) $(TOOL_OBJ)/tools/trace/decimal.o $(TOOL_OBJ)/tools/core/xcp/transport.o
OBJECTS_show := $(call objects_of,tools/show) $(TABLES) \
    $(addprefix $(TOOL_OBJ)/tools/,trace/stream.o trace/decimal.o isoc/base.o isoc/scene.o isoc/effect_files.o)
OBJECTS_cycles := $(call objects_of,tools/measure/cycles) $(TABLES)
OBJECTS_regions := $(addprefix $(TOOL_OBJ)/tools/,measure/regions.o isoc/method.o isoc/base.o)
TOOL_OBJECTS := $(sort $(foreach tool,$(notdir $(TOOLS)) regions,$(OBJECTS_$(tool))))

$(TOOL_OBJ)/tools/flags: always
	@mkdir -p $(sort $(dir $(TOOL_OBJECTS)))
	@$(call remember,$(call quote,$(TOOL_COMPILE)))
$(ISOC_PARTS:=.c): $(TOOL_OBJ)/tools/isoc/%.c: always | $(TOOL_OBJ)/tools/flags
	@$(call remember,$(patsubst %,'#include "%"',$(sort $(wildcard tools/isoc/$*/*.c))))
$(EMBEDDED:=.list): $(TOOL_OBJ)/tools/isoc/%_files.list: always | $(TOOL_OBJ)/tools/flags
	@$(call remember,$(EMBEDDED_$*))
.SECONDEXPANSION:
$(EMBEDDED:=.c): $(TOOL_OBJ)/tools/isoc/%_files.c: $(TOOL_OBJ)/tools/isoc/%_files.list tools/build/embed.awk $$(EMBEDDED_$$*)
	@awk -f tools/build/embed.awk $*_files $(EMBEDDED_$*) >$@

$(ISOC_PARTS:=.o): $(TOOL_OBJ)/tools/isoc/%.o: $(TOOL_OBJ)/tools/isoc/%.c $(TOOL_OBJ)/tools/flags
	@echo '  CC   tools/isoc/$*/*.c'
	@$(TOOL_COMPILE) $(FLAGS_$*) -Wno-shadow -MMD -MP -c $< -o $@
$(EMBEDDED:=.o): %.o: %.c $(TOOL_OBJ)/tools/flags
	@$(TOOL_COMPILE) -MMD -MP -c $< -o $@
# The tools read and write frames by the code of the plant.
$(TOOL_OBJ)/tools/core/%.o: core/%.c $(TOOL_OBJ)/tools/flags
	@$(TOOL_COMPILE) -MMD -MP -c $< -o $@
$(TOOL_OBJ)/tools/%.o: tools/%.c $(TOOL_OBJ)/tools/flags
	@echo '  CC   $<'
	@$(TOOL_COMPILE) -MMD -MP -c $< -o $@

$(TOOLS) build/regions: build/%: $$(OBJECTS_%) $(TOOL_OBJ)/tools/flags
	@echo '  LINK $@'
	@$(CC) $(CFLAGS) $(filter %.o,$^) -lm -o $@.new && mv -f $@.new $@
# A simulator as a library, for the cycles of one port.
build/simavr_trace: tools/measure/simavr/main.c $(TOOL_OBJ)/tools/flags
	@test -e /usr/include/simavr/sim_avr.h || { echo 'simavr/sim_avr.h is missing. Install it with: apt-get install libsimavr-dev' >&2; exit 1; }
	@$(TOOL_COMPILE) $< -lsimavr -o $@
# An emulator as a package, for the port rp2040.
build/rp2040js: port/rp2040/package.json port/rp2040/package-lock.json
	@command -v npm >/dev/null || { echo 'npm is missing. Install it with: apt-get install nodejs npm' >&2; exit 1; }
	@rm -rf $@ $@.new && mkdir -p $@.new && cp $^ $@.new && npm ci --loglevel=error --no-audit --no-fund --prefix $@.new && mv $@.new $@
# Where each method is stable: a table of pictures.
build/regions.tsv: build/regions
	@$< >$@.new && mv $@.new $@
-include $(TOOL_OBJECTS:.o=.d)

# --- Installation, tests ---------------------------------------------------------------------------------------------

# The sources that programs of plants are made of, and the commands, without those of the tools.
LIBRARY = $(DESTDIR)$(PREFIX)/lib/isochron
install: tools build/regions.tsv
	@mkdir -p $(LIBRARY)/build $(addprefix $(DESTDIR)$(PREFIX)/,bin share/man/man1 share/bash-completion/completions)
	@tar -cf - --exclude=__pycache__ --exclude=tools/isoc --exclude='*.svg' core port models tools | tar -xf - -C $(LIBRARY)
	@cp $(TOOLS) build/regions.tsv $(LIBRARY)/build
	@[ ! -d build/rp2040js ] || cp -R build/rp2040js $(LIBRARY)/build
	@ln -sf ../lib/isochron/tools/isochron $(DESTDIR)$(PREFIX)/bin/isochron
	@ln -sf ../lib/isochron/build/isoc $(DESTDIR)$(PREFIX)/bin/isoc
	@tools/isochron --man >$(DESTDIR)$(PREFIX)/share/man/man1/isochron.1
	@tools/isochron --completion >$(DESTDIR)$(PREFIX)/share/bash-completion/completions/isochron

clean:
	rm -rf build

include tests/tests.mk

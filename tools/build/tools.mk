# The tools on the host: isoc, a folder of which is compiled as one, with the texts that it has in it; and the others.

# A file that CFLAGS include, as a table of pins, is of the plant's program: the tools are not compiled again for it.
TOOL_CFLAGS := $(filter-out included:%,$(subst -include ,included:,$(strip $(CFLAGS))))
# With little optimisation: -O1 takes a compiler a third to a half longer, and isoc a seventh fewer instructions.
TOOL_COMPILE := $(CC) $(WARNINGS) -Og $(NUMERICS) -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE -I. $(call given_flags,$(TOOL_CFLAGS))

# A folder of isoc is compiled as one file that includes all of it: most of the work of a compiler is the same for each.
# A name that stands at the top of one may be a local name of another; tests/check/warnings.t compiles each alone.
ISOC_FOLDERS := $(sort $(patsubst tools/isoc/%/,%,$(dir $(wildcard tools/isoc/*/*.c))))
ISOC_OBJECTS := $(ISOC_FOLDERS:%=build/obj/tools/isoc/%.o) $(patsubst %.c,build/obj/%.o,$(wildcard tools/isoc/*.c))
TOOL_OBJECTS := $(patsubst %.c,build/obj/%.o,$(wildcard tools/*/*.c tools/measure/cycles/*.c)) $(ISOC_FOLDERS:%=build/obj/tools/isoc/%.o)

build/obj/tools/flags: always
	$(call folders,$(patsubst %/,%,$(dir $(TOOL_OBJECTS))))
	$(call remember,$(TOOL_COMPILE) $(TOOL_OBJECTS) $(foreach folder,$(ISOC_FOLDERS),$(TOOL_FLAGS_$(folder))))

build/obj/tools/%.o: tools/%.c build/obj/tools/flags
	$(call require,$(firstword $(CC)),apt-get install gcc)
	$(call say,CC,$<)
	$(Q)$(TOOL_COMPILE) -MMD -MP -c $< -o $@

# It has every kernel, to find the map of a step of a linear plant: their loops stay rolled, whichever file includes
# them first (tools/isoc/method/step_map.c), and unoptimised, with which isoc is as fast.
TOOL_FLAGS_method := -O0 -DISO_UNROLL=

# In the graph, and in eigenvalues, isoc takes most of its time.
TOOL_FLAGS_graph := -O2
TOOL_FLAGS_base := -O2

$(ISOC_FOLDERS:%=build/obj/tools/isoc/%.c): build/obj/tools/isoc/%.c: always
	$(call remember,$(foreach file,$(sort $(wildcard tools/isoc/$*/*.c)),$(HASH)include "$(file)"$(newline)))

$(ISOC_FOLDERS:%=build/obj/tools/isoc/%.o): build/obj/tools/isoc/%.o: build/obj/tools/isoc/%.c build/obj/tools/flags
	$(call require,$(firstword $(CC)),apt-get install gcc)
	$(call say,CC,tools/isoc/$*/*.c)
	$(Q)$(TOOL_COMPILE) $(TOOL_FLAGS_$*) -Wno-shadow -MMD -MP -c $< -o $@

# The tools read and write frames by the code of the plant.
build/obj/tools/core/%.o: core/%.c build/obj/tools/flags
	$(call folders,$(@D))
	$(call say,CC,$<)
	$(Q)$(TOOL_COMPILE) -MMD -MP -c $< -o $@

# Isoc has the text of core in it, for plants that stand alone; they need no loop.
PLANT_CORE := $(filter-out core/runtime/loop.%,$(wildcard core/numbers/*.[ch] core/methods/*.[ch] core/runtime/*.[ch]))
EMBEDDED_core := $(PLANT_CORE) $(wildcard port/soft/*.h)
EMBEDDED_effect := $(sort $(wildcard models/effects/*.scene))
EMBEDDED_client := $(wildcard tools/client/*) $(wildcard tools/package/*) $(wildcard tools/fmu/*.in) tools/build/numerics
EMBEDDED_help := tools/isoc/help.txt
EMBEDDED := $(addprefix build/obj/tools/isoc/,core_files.o effect_files.o client_files.o help_files.o)
build/obj/tools/isoc/core_files.c: $(EMBEDDED_core)
build/obj/tools/isoc/effect_files.c: $(EMBEDDED_effect)
build/obj/tools/isoc/client_files.c: $(EMBEDDED_client)
build/obj/tools/isoc/help_files.c: $(EMBEDDED_help)
$(EMBEDDED:.o=.list): build/obj/tools/isoc/%_files.list: always
	$(call remember,$(EMBEDDED_$*))
$(EMBEDDED:.o=.c): build/obj/tools/isoc/%_files.c: build/obj/tools/isoc/%_files.list tools/build/embed.awk | build/obj/tools/flags
	$(Q)awk -f tools/build/embed.awk $*_files $(EMBEDDED_$*) >$@

$(EMBEDDED): %.o: %.c build/obj/tools/flags
	$(Q)$(TOOL_COMPILE) -MMD -MP -c $< -o $@

build/isoc: $(ISOC_OBJECTS) $(EMBEDDED) build/obj/tools/flags
build/trace: $(filter build/obj/tools/trace/% build/obj/tools/file/%,$(TOOL_OBJECTS)) build/obj/tools/flags
build/show: $(filter build/obj/tools/show/% build/obj/tools/table/% build/obj/tools/file/%,$(TOOL_OBJECTS)) build/obj/tools/trace/stream.o \
    build/obj/tools/trace/decimal.o $(addprefix build/obj/tools/isoc/,base.o scene.o effect_files.o) build/obj/tools/flags
build/duration: build/obj/tools/build/duration.o build/obj/tools/flags
build/cycles: $(filter build/obj/tools/measure/cycles/% build/obj/tools/table/% build/obj/tools/file/%,$(TOOL_OBJECTS)) build/obj/tools/flags
build/link: $(filter build/obj/tools/link/% build/obj/tools/file/%,$(TOOL_OBJECTS)) build/obj/tools/trace/decimal.o \
    build/obj/tools/core/link/frame.o build/obj/tools/flags
build/duties: $(filter build/obj/tools/conform/%,$(TOOL_OBJECTS)) build/obj/tools/link/child.o build/obj/tools/file/file.o build/obj/tools/flags
build/monitor: $(filter build/obj/tools/monitor/% build/obj/tools/table/% build/obj/tools/file/%,$(TOOL_OBJECTS)) build/obj/tools/trace/decimal.o \
    build/obj/tools/core/xcp/transport.o build/obj/tools/flags
# The import of robots: one file, of Python alone.
build/import: $(wildcard tools/import/*.py)
	$(call folders,$(@D))
	$(call say,ZIP,$@)
	$(Q)python3 -c 'import sys, zipapp; zipapp.create_archive("tools/import", sys.argv[1], "/usr/bin/env python3", \
	    filter=lambda path: path.suffix == ".py")' $@.$$$$ && chmod +x $@.$$$$ && mv -f $@.$$$$ $@

# A simulator as a library, for the traces of one port.
build/simavr_trace: tools/measure/simavr/main.c build/obj/tools/flags
	@test -e /usr/include/simavr/sim_avr.h || { echo 'simavr/sim_avr.h is missing. Install it with: apt-get install libsimavr-dev' >&2; exit 1; }
	$(call say,CC,$<)
	$(call link,$(TOOL_COMPILE) $< -lsimavr)

TOOLS := build/isoc build/trace build/link build/duties build/monitor build/show build/duration build/cycles
.PHONY: tools
tools: $(TOOLS)
	@:

# Where each method is stable: a table of pictures.
build/regions: build/obj/tools/measure/regions.o build/obj/tools/isoc/method.o build/obj/tools/isoc/base.o build/obj/tools/flags
build/regions.tsv: build/regions
	$(Q)$< >$@.new && mv $@.new $@

$(TOOLS) build/regions:
	$(call say,LINK,$@)
	$(call link,$(CC) $(TOOL_CFLAGS) $(filter %.o,$^) -lm)

# The recipes of the goals that build and run plants; read by a make that has their folder locked.

# Variables for the environment of a script: those of these names; the compiler of programs on the host, with more
# flags; how a plant is linked.
given = $(foreach word,$(1),$(word)=$(call quote,$($(word))))
HOST_COMPILE = COMPILE=$(call quote,$(CC) $(WARNINGS) -O2 $(NUMERICS) -D_POSIX_C_SOURCE=200809L -I. $(call given_flags,$(CFLAGS)) $(1))
PROGRAM_LINK = LINK=$(call quote,$(PORT_CC) $(PORT_FLAGS) $(PORT_LINK))

# --- The choices -------------------------------------------------------------------------------------------------

# Times come as a number with a unit. The step of a plant in C is checked here, that of a scene by build/isoc.
# With -n the tool may not be there yet.
duration = $(if $(wildcard build/duration),$(shell build/duration $(1) $(call quote,$(2)) $(3) $(4)),$(2))

# The nanoseconds of a time. Plain seconds, as 10 or 0.5, make joins itself: the digits, and zeros behind them.
nanoseconds = $(or $(call plain_nanoseconds,$(1),$(word 1,$(subst ., ,$(1))),$(word 2,$(subst ., ,$(1)))),$(call duration,ns,$(1),1,1e18))
plain_nanoseconds = $(if $(call same,$(1),$(2)$(3:%=.%)),$(call joined,$(call spelled,$(2),$(DIGITS)),$(call spelled,$(3),$(DIGITS)),$(3)))
joined = $(if $(and $(1),$(if $(3),$(2),yes)),$(if $(word 10,$(1))$(word 10,$(2)),,$(call without_zeros,$(subst $(space),,$(1) $(2) \
    $(wordlist $(words x $(2)),9,0 0 0 0 0 0 0 0 0)))))
without_zeros = $(if $(filter 0%,$(1)),$(call without_zeros,$(1:0%=%)),$(1))
# A run of `make link` with SECONDS=0 has no end: 292 years.
WITHOUT_END := $(and $(filter link,$(MAKECMDGOALS)),$(call same,$(SECONDS),0))
NANOSECONDS := $(if $(WITHOUT_END),9223372036854775807,$(call nanoseconds,$(SECONDS)))
ifeq ($(NANOSECONDS),)
$(error SECONDS=$(SECONDS) is no time to run; it could be 10 or 0.5)
endif

ifneq ($(AT),)
AT_NANOSECONDS := $(call nanoseconds,$(AT))
ifeq ($(AT_NANOSECONDS),)
$(error AT=$(AT) is no time; it could be 2s or 0.5)
endif
endif

ifeq ($(suffix $(SCENE_FILE)),.c)
$(foreach word,SET WITHOUT,$(if $($(word)),$(error $(word) has no effect on a plant in C, which has no scene)))
ifneq ($(STEP),)
STEP_SECONDS := $(call duration,s,$(STEP),1000,1e9)
ifeq ($(STEP_SECONDS),)
$(error STEP=$(STEP) is no step; it could be 1ms, 500us or 0.001, from 1us to 1s in whole nanoseconds)
endif
endif
METHOD_MACRO := $(if $(METHOD),$(shell printf %s '$(METHOD)' | tr a-z A-Z))
ifneq ($(TOLERANCE),)
TOLERANCE_NUMBER := $(shell printf '%s\n' $(call quote,$(TOLERANCE)) | \
    awk '/^([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$$/ && $$1 > 1e-30 && $$1 < 1e30 { printf "%.16e", $$1 }')
ifeq ($(TOLERANCE_NUMBER),)
$(error TOLERANCE=$(TOLERANCE) is no tolerance; it could be 1e-6)
endif
endif
CHOICE := $(METHOD:%=-DISO_METHOD=ISO_$(METHOD_MACRO) -DISO_METHOD_NAME=%) $(STEP_SECONDS:%=-DISO_STEP=%) \
    $(TOLERANCE_NUMBER:%=-DISO_TOLERANCE=%) $(if $(filter yes,$(CHECKED)),-DISO_CHECK) \
    $(if $(filter yes,$(COMPENSATED)),-DISO_COMPENSATE)
PLANT := $(SCENE)
else
CHOICE := $(METHOD:%=--method %) $(INPUTS:%=--inputs %) $(if $(STEP),--step $(call quote,$(STEP))) \
    $(if $(TOLERANCE),--tolerance $(call quote,$(TOLERANCE))) $(if $(SET),--set $(call quote,$(SET))) \
    $(if $(WITHOUT),--without $(call quote,$(WITHOUT))) --real $(REAL)
PLANT := $(OUT)/plant.c
endif

# --- The program -------------------------------------------------------------------------------------------------

PROGRAM := $(OUT)/$(NAME)$(PORT_SUFFIX)

# The text of a scene and the files that it includes, or of a plant in C, on one line, if make can read all of it; else
# checksums. No scene has a word of ours: a comment begins with its first character.
texts_of = $(foreach file,$(1),$(subst $(newline),$(HASH)newline$(HASH),$(file <$(file))))
is_readable = $(and $(1),$(call same,$(1),$(wildcard $(1))))
says = $(if $(call is_readable,$(SCENE)),$(call says_more,$(call texts_of,$(SCENE))),$(sums))
says_more = $(if $(filter %.c,$(SCENE_FILE))$(if $(findstring include,$(1)),,yes),$(1),$(call says_all,$(FILES)))
says_all = $(if $(call is_readable,$(1)),$(call texts_of,$(1)),$(sums))
FILES = $(if $(wildcard build/isoc),$(shell build/isoc $(call quote,$(SCENE)) --files))
sums = $(shell test ! -e $(call quote,$(SCENE)) || $(if $(filter %.c,$(SCENE_FILE)),cksum <$(call quote,$(SCENE)),test ! -e build/isoc || \
    build/isoc $(call quote,$(SCENE)) --files | while IFS= read -r file; do cksum <"$$file" 2>&1; done))

# The scene by its path and its text; not by its date, since make cannot handle every path.
$(OUT)/choice: always
	$(if $(call is_readable,$(SCENE)),,@test -e $(call quote,$(SCENE)) || { \
	    printf 'there is no scene %s; models/ has:\n' $(call quote,$(SCENE)) >&2; ls models >&2; exit 1; })
	$(call remember,$(SCENE) $(CHOICE) $(says))

# With `exec`, a shell that is started for the redirection after `>`, or for the variables before a script, becomes the
# program.
EXEC = $(if $(IS_DRY),,exec )

$(OUT)/plant.c: $(OUT)/choice build/isoc
	$(call say,ISOC,$(SCENE))
	$(Q)$(EXEC)build/isoc $(call quote,$(SCENE)) -o $(OUT) $(CHOICE) >$(OUT)/plant.txt

$(OUT)/plant.o: $(OUT)/choice $(OBJ)/flags $(if $(filter %/plant.c,$(PLANT)),$(PLANT))
	$(call say,CC,$(PLANT))
	$(Q)$(COMPILE_PORTABLE) $(filter -D%,$(CHOICE)) -MMD -MP -c $(call quote,$(PLANT)) -o $@

# The command that links objects.
of_objects = $(PORT_CC) $(PORT_FLAGS) $(CFLAGS) $(PORT_LINK) $(1) $(PORT_LIBRARIES)
LINK := $(call of_objects,$(OUT)/plant.o $(OBJECTS))

$(OUT)/link: always
	$(call remember,$(LINK))

# No other process links into the folder, which is locked.
$(PROGRAM): $(OUT)/plant.o $(OBJECTS) $(OUT)/link $(wildcard port/*/*.ld)
	$(call say,LINK,$@)
	$(Q)$(LINK) -o $@

# The same plant with a link, in a folder of its own: with interface.c, and NAME_link.h and NAME_link.py for a
# controller. On the host its addresses are below 4 GB, as those of a board are. With XCP it has measurement and
# calibration too.
LINKED := $(OUT)/$(if $(XCP),calibrated,linked)
LINKED_PROGRAM := $(LINKED)/$(NAME)$(PORT_SUFFIX)

$(LINKED)/choice: always
	$(call remember,$(XCP))

$(LINKED)/interface.c: $(OUT)/choice $(LINKED)/choice build/isoc
	$(if $(filter %.c,$(SCENE_FILE)),$(error a plant in C has no link: it is for scenes))
	$(call say,ISOC,$(SCENE) --link)
	$(Q)$(EXEC)build/isoc $(call quote,$(SCENE)) -o $(LINKED) $(CHOICE) --link $(XCP:%=--xcp %) >$(LINKED).txt

$(LINKED)/plant.o $(LINKED)/interface.o: $(LINKED)/%.o: $(LINKED)/interface.c $(OBJ)/flags
	$(call say,CC,$(@:.o=.c))
	$(Q)$(COMPILE) -MMD -MP -c $(@:.o=.c) -o $@

$(LINKED_PROGRAM): $(LINKED)/plant.o $(LINKED)/interface.o $(LINKED_OBJECTS)
$(LINKED_PROGRAM): LINKED_FLAGS := $(PORT_LINK_LINKED)

# The A2L, beside the program: the template of isoc, with the addresses of the linked program.
A2L := $(OUT)/$(NAME).a2l

$(A2L): $(LINKED_PROGRAM) $(OBJ)/tools/a2l/places.o tools/a2l/a2l.sh
	$(call say,A2L,$@)
	$(Q)$(EXEC)sh tools/a2l/a2l.sh $(PORT_NM) $(LINKED_PROGRAM) $(OBJ)/tools/a2l/places.o $(LINKED)/plant.a2l.in $(REAL) >$@

a2l: $(A2L)
	@echo program $(LINKED_PROGRAM)
	@echo a2l $(A2L)

# The plant in Python: a package with a library, of position-independent objects with hidden symbols.
PACKAGE := $(OUT)/python
LIBRARY_COMPILE := $(COMPILE) -fPIC -fvisibility=hidden

$(PACKAGE)/pyproject.toml: $(OUT)/choice build/isoc
	$(if $(filter %.c,$(SCENE_FILE)),$(error a plant in C is no package: it is for scenes))
	$(call say,ISOC,$(SCENE) --python)
	$(Q)rm -rf $(PACKAGE)
	$(Q)$(EXEC)build/isoc $(call quote,$(SCENE)) -o $(PACKAGE) $(CHOICE) --python >$(PACKAGE).txt

$(PACKAGE)/plant.o: $(PACKAGE)/pyproject.toml $(OBJ)/flags
	$(call say,CC,$(PACKAGE)/plant.c)
	$(Q)$(LIBRARY_COMPILE) -MMD -MP -c $(PACKAGE)/plant.c -o $@

# The library is of the scene alone: its folder has it by the name of the scene's module.
$(PACKAGE)/plant.so: $(PACKAGE)/plant.o $(LIBRARY_OBJECTS)
	$(call say,LINK,$@)
	$(call link,$(PORT_CC) $(PORT_FLAGS) $(CFLAGS) -shared $^)

python: $(PACKAGE)/plant.so
	$(Q)for module in $(PACKAGE)/*_plant; do ln -f $< $$module/plant.so; done
	@echo package $(PACKAGE)

-include $(PACKAGE)/plant.d $(OUT)/plant.d $(LINKED)/plant.d $(LINKED)/interface.d

RUN = build/trace -o $(OUT) --clock $(PORT_CLOCK) -- $(PORT_EXEC)

# What the end of a run tells: joints that are too fast for the step, sums that rounding holds, an energy that is wrong.
# Nothing for a plant in C, and for one that goes on from a snapshot, whose tunables isoc does not know.
ENDED = $(if $(filter $(OUT)/plant.c,$(PLANT)),$(if $(RESTORE),,build/isoc $(call quote,$(SCENE)) --ended $(OUT)/last.txt $(CHOICE)))

# A run that is kept under a name, for make compare.
KEEP_RUN = $(if $(KEEP),mkdir -p build/runs/$(KEEP) && cp $(OUT)/trace.csv $(OUT)/units.csv $(OUT)/summary.txt build/runs/$(KEEP)/)

# The start values that isoc found for joints of closed loops without one in the scene; nothing for a plant in C.
ASSEMBLED = $(if $(filter $(OUT)/plant.c,$(PLANT)),$(if $(IS_DRY)$(filter assembled dead_position,$(file <$(SUMMARY))), \
    sed -n -e '/^assembled /p' -e '/^dead_position /p' $(SUMMARY)))
SUMMARY = $(if $(SNAPSHOT)$(RESTORE),$(LINKED).txt,$(OUT)/plant.txt)

# A run with a snapshot: the plant as with a link, and the request, with the snapshot at which the run begins.
RECORDED_PROGRAM := $(OUT)/recorded/$(NAME)$(PORT_SUFFIX)
RECORDED_FROM = $(if $(RESTORE),$(shell cksum <$(call quote,$(RESTORE))))

$(OUT)/recorded/choice: always
	$(call remember,$(SNAPSHOT) $(RECORDED_FROM))

$(OUT)/recorded/request.c: $(OUT)/recorded/choice tools/build/request.sh
	$(Q)$(EXEC)sh tools/build/request.sh $(call quote,$(SNAPSHOT)) $(call quote,$(RESTORE)) >$@

$(OUT)/recorded/request.o: $(OUT)/recorded/request.c $(OBJ)/flags
	$(Q)$(COMPILE) -c $< -o $@

$(RECORDED_PROGRAM): $(LINKED)/plant.o $(LINKED)/interface.o $(OUT)/recorded/request.o $(RECORDED_OBJECTS)

RUN_PROGRAM := $(if $(SNAPSHOT)$(RESTORE),$(RECORDED_PROGRAM),$(PROGRAM))

run: PROGRAM := $(RUN_PROGRAM)
run: build/trace $(RUN_PROGRAM)
	$(call require,$(PORT_EXEC_TOOLS),$(PORT_INSTALL))
	$(if $(ASSEMBLED),$(Q)$(ASSEMBLED))
	$(Q)$(RUN)$(if $(KEEP), >$(OUT)/summary.txt && cat $(OUT)/summary.txt)
	$(if $(ENDED),$(Q)$(EXEC)$(ENDED))
	$(Q)$(KEEP_RUN)

flash: $(PROGRAM)
	$(call require,openocd,$(PORT_INSTALL))
	$(Q)$(PORT_FLASH)

# --- With a controller -------------------------------------------------------------------------------------------

# Finds its end of the wire at descriptor 3 (tools/link/main.c). A controller in Python finds the plant's module.
link hil: PROGRAM := $(LINKED_PROGRAM)
link hil: PORT_SERIAL = $(PORT_SERIAL_LINKED)
CONNECT = PYTHONPATH=$(LINKED)$${PYTHONPATH:+:$$PYTHONPATH} build/link -o $(OUT) --header "$$(ls $(LINKED)/*_link.h)" $(MODE:%=--mode %) $(if $(WITHOUT_END),--end controller) \
    $(if $(CONTROLLER),--controller $(call quote,$(CONTROLLER))) -- $(RUN)

link: $(LINKED_PROGRAM) $(if $(XCP),$(A2L)) build/trace build/link
	$(call require,$(PORT_EXEC_TOOLS),$(PORT_INSTALL))
	$(if $(XCP),@echo a2l $(A2L))
	$(Q)$(CONNECT)$(if $(KEEP), >$(OUT)/summary.txt && cat $(OUT)/summary.txt)
	$(Q)$(KEEP_RUN)

$(OUT)/controller: models/hil/controller.c $(LINKED)/interface.c build/obj/tools/flags
	$(call say,CC,$<)
	$(call link,$(CC) $(WARNINGS) -O2 $(NUMERICS) -I$(LINKED) $(call given_flags,$(CFLAGS)) $< -lm)

hil: CONTROLLER := $(or $(CONTROLLER),$(OUT)/controller)
hil: $(LINKED_PROGRAM) $(OUT)/controller build/trace build/link
	$(call require,gnuplot,apt-get install gnuplot-nox)
	$(call require,$(PORT_EXEC_TOOLS),$(PORT_INSTALL))
	$(Q)$(CONNECT) >$(OUT)/summary.txt && cat $(OUT)/summary.txt
	$(Q)$(KEEP_RUN)
	$(Q)sh tools/plot/plot.sh $(OUT) counts volts pole
	$(Q)awk -F, -f models/hil/stood.awk $(OUT)/trace.csv

plot: $(PROGRAM) build/trace
	$(call require,gnuplot,apt-get install gnuplot-nox)
	$(call require,$(PORT_EXEC_TOOLS),$(PORT_INSTALL))
	$(Q)$(EXEC)$(RUN) >$(OUT)/summary.txt
	$(if $(ENDED),$(Q)$(EXEC)$(ENDED))
	$(Q)sh tools/plot/plot.sh $(OUT) $(foreach name,$(subst $(comma), ,$(OUTPUTS)),$(call quote,$(name)))

# The programs of the runs that are shown stand apart: they have the poses of all bodies among their outputs.
show: build/show
	@$(CALLS_MAKE) $(call given,SCENE NAME NANOSECONDS METHOD STEP TOLERANCE INPUTS SET WITHOUT REAL AGAINST STILL COMPILE OBJECTS) \
	    FOLDER=$(OUT)/show $(PROGRAM_LINK) exec sh tools/show/show.sh

# Both measure the methods of METHODS; default: all.
REPORT = $(CALLS_MAKE) $(call given,SCENE NAME FOLDER NANOSECONDS METHODS RECORDED) \
    STEP=$(call quote,$(if $(filter %.c,$(SCENE_FILE)),$(STEP_SECONDS),$(STEP))) $(HOST_COMPILE)
REPORT_TOOLS := arm-none-eabi-gcc arm-none-eabi-gcc:nano.specs qemu-system-arm
REPORT_INSTALL := apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm

report: build/isoc build/trace build/regions.tsv
	$(call require,gnuplot valgrind,apt-get install gnuplot-nox valgrind)
	$(call require,$(REPORT_TOOLS),$(REPORT_INSTALL))
	@$(REPORT) exec sh tools/measure/report.sh

bench: build/isoc build/trace
	$(call require,$(REPORT_TOOLS),$(REPORT_INSTALL))
	@$(REPORT) exec sh tools/measure/bench.sh

choose: build/isoc build/trace build/cycles $(PORT_TRACER)
	$(call require,$(PORT_TOOLS) $(PORT_EXEC_TOOLS),$(PORT_INSTALL))
	@$(HAS_MADE) $(REPORT) $(call given,MACHINE TARGET CORE CLOCK BOARD ERROR LOAD INPUTS SET WITHOUT KEEP) exec sh tools/measure/choose/choose.sh

drift: build/isoc build/trace
	$(call require,gnuplot,apt-get install gnuplot-nox)
	$(call require,$(REPORT_TOOLS),$(REPORT_INSTALL))
	@$(REPORT) exec sh tools/measure/drift.sh

# Its plants are double: its points and its slopes are as exact as that.
linear: build/isoc
	$(if $(filter %.c,$(SCENE_FILE)),$(error a plant in C has no linear model: it is for scenes))
	$(if $(BODE),$(call require,gnuplot,apt-get install gnuplot-nox))
	@$(call given,SCENE NAME FOLDER TRIM BODE) AT=$(AT_NANOSECONDS) $(HOST_COMPILE) \
	    exec sh tools/linear/linear.sh $(filter-out --real float double,$(CHOICE)) --real double

equations: build/isoc
	$(if $(filter %.c,$(SCENE_FILE)),$(error a plant in C is its own equations: it is for scenes))
	@file=build/equations/$(FOLDER)/equations.$(if $(filter latex,$(FORMAT)),tex,txt) && build/isoc $(call quote,$(SCENE)) $(CHOICE) \
	    --equations $(call quote,$(FORMAT)) -o "$$file" && echo "equations $$file"

sweep: build/isoc
	$(if $(filter %.c,$(SCENE_FILE)),$(error a plant in C has no sweep: it is for scenes))
	$(if $(SET),,$(error SET says what varies, such as SET='mass = 0.1 .. 0.3 kg by 21'))
	$(call require,sha256sum xargs,apt-get install coreutils findutils)
	@$(call given,SCENE NAME NANOSECONDS SECONDS SET OF RUNS SEED METHOD STEP TOLERANCE INPUTS WITHOUT REAL ENGINE HOSTS LANES COMPILE) \
	    FOLDER=build/sweep/$(FOLDER) $(PROGRAM_LINK) OBJECTS=$(call quote,$(SWEEP_OBJECTS)) exec sh tools/sweep/sweep.sh

fmu: build/isoc
	$(call require,python3,apt-get install python3)
	@$(call given,SCENE FOLDER FMI EXCHANGE) COMPILE=$(call quote,$(CC) $(WARNINGS) -O2 $(NUMERICS) $(call given_flags,$(CFLAGS))) exec sh tools/fmu/fmu.sh $(CHOICE)

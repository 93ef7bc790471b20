# A line for each port to a target that is not this machine, and the one to be copied: its folder, its compiler, its
# flags, and behind `--` its C files and those of other ports that it uses, as its port.mk says; as `make -s -f
# tests/host/ports.mk` prints it. With double they have the files for that as well.
REAL := double
PORTS := $(filter-out port/host port/posix,$(patsubst %/port.mk,%,$(wildcard port/*/port.mk))) port/template

.PHONY: ports
ports: ; @:

$(foreach port,$(PORTS),$(eval include $(wildcard $(port)/port.mk $(port)/port.mk.in))$(info $(port) $(PORT_CC) $(strip $(PORT_FLAGS)) \
    -- $(sort $(filter %.c,$(wildcard $(port)/*.c) $(PORT_SHARED)))))

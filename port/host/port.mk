# Building for the host and running there, on a simulated tick.
PORT_CC = $(CC)
PORT_TOOLS = $(firstword $(CC))
PORT_INSTALL = apt-get install gcc
# Where the compiler is gcc: the equations stay in the order in which isoc writes them, which keeps few values alive,
# and with more registers in use fewer are copied: some 5 % fewer instructions, the median over all models.
PORT_FLAGS := $(if $(call is_gcc,$(PORT_CC)),-fno-tree-ter -frename-registers)
# By `tools/isochron flags --target host --real double`: no other takes a twentieth less.
PORT_OPTIMISE = -O2
# Sources that this port shares with others, and those of links.
PORT_SHARED = port/unix/console.c
PORT_CHANNEL = port/unix/channel.c port/unix/datagrams.c
# On x86-64 a leaf function may use 128 bytes below its stack that its frame does not count.
PORT_STACK = $(shell echo | $(CC) -mno-red-zone -E - >/dev/null 2>&1 && echo -mno-red-zone)
# What a table of pins can have, by a script.
PORT_PINS = voltage, duty, level, edges in, quadrature
PORT_CLOCK = ns
PORT_EXEC = $(PROGRAM) $(NANOSECONDS) $(if $(SCRIPT),$(call quote,$(SCRIPT)))
PORT_NM = nm
PORT_SIZE = size
# A program with a link has its addresses below 4 GB, where calibration finds them.
PORT_LINK_LINKED = -no-pie

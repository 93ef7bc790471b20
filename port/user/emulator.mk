# Building for Linux on another processor, and running in QEMU's emulator of programs, in virtual time as on the host.
# The port.mk of a processor sets PORT_MACHINE and PORT_EMULATOR.
include port/host/port.mk
PORT_CC = $(PORT_MACHINE)-linux-gnu-gcc
PORT_TOOLS = $(PORT_CC)
PORT_INSTALL = apt-get install gcc-$(PORT_MACHINE)-linux-gnu qemu-user
PORT_FLAGS = -fno-tree-ter
PORT_SHARED = $(addprefix port/host/,sim.c script.c pins.c wires.c) port/unix/console.c
PORT_LINK = -static
PORT_PINS =
PORT_STACK =
PORT_EXEC_TOOLS = qemu-$(PORT_EMULATOR)
PORT_EXEC = qemu-$(PORT_EMULATOR) $(PROGRAM) $(NANOSECONDS)
PORT_NM = $(PORT_MACHINE)-linux-gnu-nm
PORT_SIZE = $(PORT_MACHINE)-linux-gnu-size
# No channels.
PORT_CHANNEL =
PORT_LINK_LINKED =

# Building for Linux and running there in real time, as the host is built.
include port/sim/port.mk
PORT_EXEC = $(PROGRAM) $(NANOSECONDS)

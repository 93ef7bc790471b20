# Building for Linux and running there in real time, as the host is built.
include port/host/port.mk
PORT_EXEC = $(PROGRAM) $(NANOSECONDS)
PORT_PINS =

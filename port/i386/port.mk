# An x86 processor of 32 bits, with SSE2: the x87 would keep more bits.
include port/user/emulator.mk
PORT_MACHINE = i686
PORT_EMULATOR = i386
PORT_FLAGS += -msse2 -mfpmath=sse

# A MIPS processor of 32 bits: the bytes of a number begin with the highest.
include port/user/emulator.mk
PORT_MACHINE = mips
PORT_EMULATOR = mips

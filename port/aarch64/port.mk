# A 64-bit Arm processor: it fuses products with sums where a compiler may.
include port/user/emulator.mk
PORT_MACHINE = aarch64
PORT_EMULATOR = aarch64

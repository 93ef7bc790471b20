# Building for a RISC-V core of 32 bits with a floating-point unit for float.
include port/virt/port.mk
PORT_CHIP = -march=rv32imafc -mabi=ilp32f
PORT_SHARED = port/virt/port.c port/virt/start.c port/mps2/console.c port/mps2/semihosting.c $(PORT_DOUBLE)

# Building for a RISC-V core of 32 bits with a floating-point unit for float.
include port/virt/board.mk
PORT_CHIP = -march=rv32imafc -mabi=ilp32f

# Building for a RISC-V core of 32 bits without a floating-point unit.
include port/virt/board.mk
PORT_CHIP = -march=rv32imac -mabi=ilp32
PORT_SOFT = port/soft/gcc.c port/soft/gcc_sum.c port/soft/root.c

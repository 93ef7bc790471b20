# Building for a RISC-V core of 32 bits without a floating-point unit.
include port/virt/port.mk
PORT_CHIP = -march=rv32imac -mabi=ilp32
PORT_SHARED = port/virt/port.c port/virt/start.c port/mps2/console.c port/mps2/semihosting.c port/soft/gcc.c port/soft/gcc_sum.c port/soft/root.c $(PORT_DOUBLE)

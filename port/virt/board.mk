# Building for QEMU's RISC-V board `virt` and running in QEMU: 2^10 ns of its time for one instruction. The port.mk of a
# target sets PORT_CHIP, and PORT_SOFT if it has no floating-point unit. Variables that are not set here are as for the
# boards of Arm.
include port/mps2/board.mk
PORT_CC = riscv64-unknown-elf-gcc
PORT_TOOLS = riscv64-unknown-elf-gcc
PORT_INSTALL = apt-get install gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc
PORT_FLAGS = $(PORT_CHIP) -misa-spec=2.2 -mcmodel=medany -msmall-data-limit=0 --specs=picolibc.specs -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
# Double by integers: the compiler's library has a time that follows from the state.
PORT_DOUBLE = $(if $(filter double,$(REAL)),port/soft/gcc_double.c port/soft/root_double.c)
PORT_SOFT =
PORT_SHARED = port/virt/port.c port/virt/start.c port/mps2/console.c port/mps2/semihosting.c $(PORT_SOFT) $(PORT_DOUBLE)
PORT_LINK = -nostartfiles -T port/virt/virt.ld -Wl,--gc-sections -Wl,--no-warn-rwx-segments
PORT_EXEC_TOOLS = qemu-system-riscv32
PORT_EXEC = qemu-system-riscv32 -M virt -bios none -icount shift=10,align=off,sleep=$(if $(filter free,$(MODE)),on,off) -display none -monitor none $(PORT_SERIAL) \
    -semihosting-config enable=on,target=native,arg=plant,arg=$(NANOSECONDS) -kernel $(PROGRAM)
PORT_TRACE =
PORT_NM = riscv64-unknown-elf-nm
PORT_SIZE = riscv64-unknown-elf-size
# The serial line, for a plant with a link: that of the controller.
PORT_SERIAL_LINKED = -chardev socket,id=controller,fd=3 -serial chardev:controller
PORT_CHANNEL = port/virt/channel.c
PORT_CHANNELS = 1

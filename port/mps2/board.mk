# What the boards of Arm in QEMU share; the port.mk of a target says what is other on it. As it stands it is for a
# Cortex-M4F. An instruction lasts 2^10 ns of the time of QEMU.
PORT_CC = arm-none-eabi-gcc
PORT_TOOLS = arm-none-eabi-gcc arm-none-eabi-gcc:nano.specs
PORT_INSTALL = apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm
# isoc writes the equations in an order that keeps few values alive. In gcc's own order before register allocation, many
# more go to the stack and back: with it a Stewart platform takes a quarter more instructions (`isochron flags` without
# -fno-schedule-insns). -flive-range-shrinkage saves 2 % of the cycles, the median over all models. So does
# -frename-registers: a result that does not reuse a register at once lets gcc put other instructions before the one
# that waits for it.
PORT_FLAGS = -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
# By `tools/isochron flags --target cortex-m4f`. -Os takes a third to a half more cycles than -O2: multiply-accumulate
# is among its instructions, at 3 cycles for the 2 of a product and a sum. -O3 does not take a twentieth less.
PORT_OPTIMISE = -O2
# Double by integers, where there is no unit for it: the compiler's library has another last bit, or a time that follows
# from the state.
PORT_DOUBLE = $(if $(filter double,$(REAL)),port/soft/aeabi_double.c port/soft/root_double.c)
# Float by integers, on a core without a floating-point unit.
PORT_SOFT =
PORT_SHARED = $(addprefix port/mps2/,port.c console.c semihosting.c start.c) $(PORT_SOFT) $(PORT_DOUBLE)
# With double a step takes some 150 times as many instructions: one stands for a nanosecond, so that it ends within its
# tick.
PORT_CYCLE_NS = $(if $(filter double,$(REAL)),1)
PORT_LINK = -nostartfiles --specs=nano.specs -T port/mps2/mps2.ld -Wl,--gc-sections
# The root of a double, which this processor has no instruction for.
PORT_LIBRARIES = -lm
PORT_SUFFIX = .elf
PORT_CLOCK = instructions
PORT_EXEC_TOOLS = qemu-system-arm
PORT_MACHINE = mps2-an386
PORT_EXEC = qemu-system-arm -M $(PORT_MACHINE) -icount shift=10,align=off,sleep=$(if $(filter free,$(MODE)),on,off) -display none -monitor none \
    $(PORT_SERIAL) \
    -semihosting-config enable=on,target=native,arg=plant,arg=$(NANOSECONDS) -kernel $(PROGRAM)
# Each instruction that it executes, for tools/measure/cycles.
PORT_TRACE = $(PORT_EXEC) -singlestep -d nochain,exec 2>&1 >/dev/null
# The serial lines: of a plant with a link, the first is the controller's.
PORT_SERIAL = -serial none
PORT_SERIAL_LINKED = -chardev socket,id=controller,fd=3 -serial chardev:controller $(if $(XCP),-serial $(PORT_CALIBRATION))
# The second is that of a tool that measures and calibrates, at an address as on the host.
PORT_CALIBRATION = "$$(echo "$${ISOCHRON_CALIBRATION:-null}" | \
    sed -e 's/^tcp:\([0-9]*\)$$/tcp:127.0.0.1:\1/' -e '/^tcp:/s/$$/,server=on,wait=off/' -e '/^unix:/s/$$/,server=on,wait=off/')"
PORT_NM = arm-none-eabi-nm
PORT_SIZE = arm-none-eabi-size
# The serial lines, for a plant with a link.
PORT_CHANNEL = port/mps2/channel.c

# A port, to be copied: here for a Cortex-M4 with a floating-point unit. A variable that a port leaves out is empty.
#
# The compiler, the tools that it needs, and the command that installs these.
PORT_CC = arm-none-eabi-gcc
PORT_TOOLS = arm-none-eabi-gcc arm-none-eabi-gcc:nano.specs
PORT_INSTALL = apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi
# The processor. -mfloat-abi=soft where it has no floating-point unit: then PORT_SHARED has port/soft/aeabi.c and
# port/soft/root.c besides. The last three options keep the order in which isoc writes the equations, which needs few
# registers.
PORT_FLAGS = -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
# The number types: float, or float double, with PORT_DOUBLE of port/mps2 in PORT_SHARED where there is no unit for
# that.
PORT_REALS = float
# By `make flags`, which measures each on the Cortex-M4F and on the host.
PORT_OPTIMISE = -O2
PORT_LINK = -nostartfiles --specs=nano.specs -T port/template/template.ld -Wl,--gc-sections
PORT_LIBRARIES = -lm
# Files that the port takes from others: the start of every Cortex-M.
PORT_SHARED = port/mps2/start.c
PORT_SUFFIX = .elf
PORT_STACK =
# The unit of the clock: instructions or cycles if every step takes the same number of them; else another word.
PORT_CLOCK = counts
# How to run $(PROGRAM) for $(NANOSECONDS), with its console as the standard output. It could call a script that writes
# the program into the chip and then reads the serial line.
PORT_EXEC_TOOLS =
PORT_EXEC = false
# How to show each instruction that it executes, for make cycles (tools/measure/cycles/trace.c), and a tool of build/
# for that.
PORT_TRACE =
PORT_TRACER =
PORT_NM = arm-none-eabi-nm
PORT_SIZE = arm-none-eabi-size
# The C files of the channels (port/channel.h), if the port has some; and the part of the command line for them.
PORT_CHANNEL =
PORT_SERIAL_LINKED =
PORT_LINK_LINKED =

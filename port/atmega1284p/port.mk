# Building for the ATmega1284P and running in simavr, which counts cycles. Its int has 16 bits, and its compiler is an
# old one: it warns of some code that the others accept, and does not know `GCC unroll`, in whose place all loops with a
# known count are unrolled; CFLAGS=--param=max-completely-peeled-insns=200 unrolls small ones alone, for a plant that
# does not fit into 128 KB (quadrotor with bdf4 does not, and takes 118 with it). METHOD=adams has a constant that does
# not fit.
PORT_CC = avr-gcc
PORT_TOOLS = avr-gcc
PORT_INSTALL = apt-get install gcc-avr avr-libc simavr
PORT_FLAGS = -mmcu=atmega1284p -DSOFT_STAGES -ffunction-sections -fdata-sections -fno-tree-ter -frename-registers \
    -fpeel-loops --param=max-completely-peeled-insns=12000 --param=max-peel-branches=1000 \
    -Wno-unknown-pragmas -Wno-conversion -Wno-pedantic -Wno-shift-count-overflow
# Its compiler has no double of 64 bits.
PORT_REALS = float
PORT_OPTIMISE = -O2
PORT_LINK = -Wl,--gc-sections
PORT_LIBRARIES = -lm
PORT_SHARED = port/soft/avr_sum.S port/soft/avr_product.S port/soft/gcc.c port/soft/root.c
PORT_SUFFIX = .elf
# Its compiler writes no call graph: that is read from the program.
PORT_FRAMES = avr-objdump -d
PORT_CLOCK = cycles
PORT_EXEC_TOOLS = simavr perl
PORT_EXEC = sh $(FROM)port/atmega1284p/run.sh $(PROGRAM) $(NANOSECONDS)
# Each instruction that it executes, for tools/measure/cycles.
PORT_TRACE = $(FROM)build/simavr_trace $(PROGRAM) $(NANOSECONDS)
PORT_TRACER = build/simavr_trace
PORT_NM = avr-nm
PORT_SIZE = avr-size
# No channels.
PORT_CHANNEL =

# The Raspberry Pi Pico, by an emulator of its RP2040 with pins, or, with BOARD=TTY, on the board whose serial line that
# is. Compiler and calibration are those of the boards in QEMU; float is computed by integers.
include port/mps2/board.mk
PORT_INSTALL = apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi nodejs npm
PORT_FLAGS = -mcpu=cortex-m0plus -mthumb -mfloat-abi=soft -masm-syntax-unified -DSOFT_PIECES -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
# On silicon the program has no command line: it contains the duration of the run. 0 is until reset.
PORT_RUN_NS = $(or $(RUN_NS),0)
PORT_LINK = -nostartfiles --specs=nano.specs -T port/rp2040/rp2040.ld -Wl,--gc-sections -Wl,--no-warn-rwx-segments \
    -Wl,--defsym=run_ns_high=$(shell echo $$(($(PORT_RUN_NS) / 4294967296))) -Wl,--defsym=run_ns_low=$(shell echo $$(($(PORT_RUN_NS) % 4294967296)))
PORT_SOFT = port/soft/aeabi.c port/soft/root.c
PORT_SHARED = port/rp2040/boot2.S $(PORT_SOFT) $(PORT_DOUBLE)
PORT_CYCLE_NS =
# In the emulator each instruction takes one cycle; on silicon loads and branches take more.
PORT_CLOCK = $(if $(BOARD),core_cycles,instructions)
PORT_EXEC_TOOLS = $(if $(BOARD),openocd stty,node)
PORT_EXEC = $(if $(BOARD),sh $(FROM)port/stm32f4/board.sh $(BOARD) $(FROM)port/rp2040/openocd.cfg $(PROGRAM),$(PORT_EMULATOR))
PORT_EMULATOR = node $(FROM)port/rp2040/emulator.mjs $(PORT_SERIAL) $(if $(filter free,$(MODE)),--free) $(PROGRAM) $(NANOSECONDS)
PORT_TRACE =
# The line of UART1, for a plant with a link, is the file 3 of the emulator.
PORT_SERIAL =
PORT_SERIAL_LINKED = --line 3
PORT_CHANNEL = port/rp2040/channel.c
PORT_CHANNELS = 1
PORT_PINS = voltage in, duty, level, edges in, quadrature
# A board in its loader is a drive, with the folder BOARD.
PORT_FLASH_TOOLS = python3
PORT_FLASH = python3 $(FROM)port/rp2040/uf2.py $(PROGRAM) $(if $(BOARD),$(BOARD)/,"$$(dirname $(PROGRAM))"/)program.uf2

# Building for an STM32F4, and running in QEMU's board netduinoplus2, or, with BOARD=TTY, on the board whose serial line
# that is. The port.mk of a chip sets PORT_BOARD and PORT_OPENOCD. Compiler and calibration are those of the boards in
# QEMU.
include port/mps2/board.mk
PORT_INSTALL = apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm openocd
PORT_FLAGS = -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 $(PORT_BOARD) -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
# On silicon the program has no command line: it contains the duration of the run. 0 is until reset.
PORT_RUN_NS = $(or $(RUN_NS),0)
PORT_LINK = -nostartfiles --specs=nano.specs -T port/stm32f4/stm32f4.ld -Wl,--gc-sections \
    -Wl,--defsym=run_ns_high=$(shell echo $$(($(PORT_RUN_NS) / 4294967296))) -Wl,--defsym=run_ns_low=$(shell echo $$(($(PORT_RUN_NS) % 4294967296)))
PORT_SHARED = $(addprefix port/stm32f4/,clock.c console.c pins.c port.c) port/mps2/semihosting.c port/mps2/start.c $(PORT_DOUBLE)
PORT_CYCLE_NS =
# On silicon the caches of the flash make a step take some cycles more or less: their number varies.
PORT_CLOCK = $(if $(BOARD),core_cycles,instructions)
PORT_EXEC_TOOLS = $(if $(BOARD),openocd stty,qemu-system-arm)
PORT_EXEC = $(if $(BOARD),sh $(FROM)port/stm32f4/board.sh $(BOARD) $(PORT_OPENOCD) $(PROGRAM),$(PORT_QEMU))
# Its serial lines in their order: USART1 to 3, UART4 and 5, USART6.
PORT_QEMU = qemu-system-arm -M netduinoplus2 -icount shift=10,align=off,sleep=$(if $(filter free,$(MODE)),on,off) -display none -monitor none \
    -serial null -chardev stdio,id=console,signal=off -serial chardev:console -serial null $(PORT_SERIAL) \
    -semihosting-config enable=on,target=native,arg=plant,arg=$(NANOSECONDS) -kernel $(PROGRAM)
PORT_SERIAL =
PORT_TRACE =
PORT_SERIAL_LINKED = -serial $(if $(XCP),$(PORT_CALIBRATION),null) -serial null -chardev socket,id=controller,fd=3 -serial chardev:controller
PORT_PINS = voltage, duty out
PORT_FLASH_TOOLS = openocd
PORT_FLASH = openocd -f $(PORT_OPENOCD) -c "program $(PROGRAM) verify reset exit"
PORT_CHANNEL = port/stm32f4/channel.c

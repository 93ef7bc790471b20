# Building for a Cortex-M3 and running on the board AN385 in QEMU, which is in all else that of the Cortex-M4F. An
# instruction stands for one cycle of 100 MHz, so that a step in software ends within its tick.
include port/mps2/board.mk
PORT_FLAGS = -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
PORT_MACHINE = mps2-an385
PORT_SOFT = port/soft/aeabi.c port/soft/root.c
PORT_CYCLE_NS = $(if $(filter double,$(REAL)),1,10)

# Building for a Cortex-M0 and running in QEMU on the Cortex-M3 of the board AN385, which executes that code as well and
# has the memory that the trace needs. An instruction stands for one cycle of 100 MHz, so that a step in software ends
# within its tick.
include port/mps2/board.mk
PORT_FLAGS = -mcpu=cortex-m0 -mthumb -mfloat-abi=soft -masm-syntax-unified -DSOFT_PIECES -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
PORT_MACHINE = mps2-an385
PORT_SOFT = port/soft/aeabi.c port/soft/root.c
PORT_CYCLE_NS = $(if $(filter double,$(REAL)),1,10)

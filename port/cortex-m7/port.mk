# Building for a Cortex-M7 with a floating-point unit for float and double, and running on the board AN500 in QEMU,
# which is in all else that of the Cortex-M4F.
include port/mps2/board.mk
PORT_FLAGS = -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16 -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
PORT_MACHINE = mps2-an500
PORT_DOUBLE =
PORT_CYCLE_NS =

# Building for a Cortex-M33 with a floating-point unit for float, and running on the board AN505 in QEMU, in the secure
# state.
include port/mps2/board.mk
PORT_FLAGS = -mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16 -DBOARD_AN505 -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
PORT_LINK = -nostartfiles --specs=nano.specs -T port/cortex-m33/an505.ld -Wl,--gc-sections
PORT_MACHINE = mps2-an505

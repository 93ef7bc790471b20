# Building for a Cortex-M55 with a floating-point unit for float and double, and running on the board AN547 in QEMU, in
# the secure state.
include port/mps2/board.mk
PORT_FLAGS = -mcpu=cortex-m55 -mthumb -mfloat-abi=hard -DBOARD_AN547 -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-ter -frename-registers -flive-range-shrinkage
PORT_LINK = -nostartfiles --specs=nano.specs -T port/cortex-m55/an547.ld -Wl,--gc-sections
PORT_MACHINE = mps3-an547
PORT_DOUBLE =
PORT_CYCLE_NS =

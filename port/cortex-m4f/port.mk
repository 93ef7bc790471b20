# A Cortex-M4F on the board AN386 in QEMU.
include port/mps2/board.mk

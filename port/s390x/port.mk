# A processor of IBM Z: the bytes of a number begin with the highest, and compilers may fuse products with sums.
include port/user/emulator.mk
PORT_MACHINE = s390x
PORT_EMULATOR = s390x
PORT_FLAGS += -fexcess-precision=fast

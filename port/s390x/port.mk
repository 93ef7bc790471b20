# A processor of IBM Z: the bytes of a number begin with the highest, and it fuses too.
include port/user/port.mk
PORT_MACHINE = s390x
PORT_EMULATOR = s390x
PORT_FLAGS += -fexcess-precision=fast

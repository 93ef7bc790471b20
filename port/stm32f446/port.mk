# The STM32F446 on the Nucleo-F446RE.
PORT_BOARD = -DBOARD_NUCLEO_F446RE
PORT_OPENOCD = board/st_nucleo_f4.cfg
include port/stm32f4/board.mk

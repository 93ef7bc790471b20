# The STM32F407 on the Discovery STM32F4; the STM32F405 differs in unused units only.
PORT_BOARD =
PORT_OPENOCD = board/stm32f4discovery.cfg
include port/stm32f4/board.mk

#include "tests/port/soft/timer.h"

void timer_start(void)
{
}

uint16_t timer_now(void)
{
    return 0;
}

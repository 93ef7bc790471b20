#include "core/conform/report.h"

bool conform_channel(void)
{
    conform_text("channel has none\n");
    return true;
}

#include "tests/unit/xcp/channel.h"

#include "core/xcp/service.c"

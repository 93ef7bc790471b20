#include "tests/core/xcp/xcp/channel.h"

#include "core/xcp/service.c"

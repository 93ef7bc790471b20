#include "core/xcp/transport.c"

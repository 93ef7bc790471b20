#include "core/xcp/daq.c"

#include "core/xcp/example_lock.c"

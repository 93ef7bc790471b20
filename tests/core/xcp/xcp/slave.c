#include "core/xcp/slave.c"

#include "core/xcp/measure.c"

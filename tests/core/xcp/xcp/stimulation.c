#include "core/xcp/stimulation.c"

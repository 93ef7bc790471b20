#include "core/xcp/access.c"

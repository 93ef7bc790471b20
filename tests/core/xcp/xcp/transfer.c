#include "core/xcp/transfer.c"

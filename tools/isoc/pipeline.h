/* The compiler, pass by pass. */
#ifndef ISOC_PIPELINE_H
#define ISOC_PIPELINE_H

#include "tools/isoc/request.h"

/* Compiles a scene, or prints the answer to a request about it. Returns false after an error on stderr. */
bool compile(arena *memory, const request *r);

#endif

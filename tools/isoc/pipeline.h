/* The compiler, pass by pass. */
#ifndef ISOC_PIPELINE_H
#define ISOC_PIPELINE_H

#include "tools/isoc/request.h"

/* Compiles a scene, or prints what is asked of it. Returns false after saying on stderr what is wrong. */
bool compile(arena *memory, const request *r);

#endif

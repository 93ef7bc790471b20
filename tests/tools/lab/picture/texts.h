/* No text leaves the picture or lies on another one. */
#ifndef ISO_TESTS_PICTURE_TEXTS_H
#define ISO_TESTS_PICTURE_TEXTS_H

#include "tests/tools/lab/picture/svg.h"

/* Whether that is so; a line for each text that is not. */
bool check_texts(const drawing *d);

#endif

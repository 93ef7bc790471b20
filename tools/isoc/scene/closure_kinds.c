#include "tools/isoc/scene/closure_kinds.h"

#define CLOSURE_ROW(kind, word, traits, holds) {word, ANY_CLOSURE | (traits), holds},
const closure_row closure_rows[CLOSURE_ROWS] = {CLOSURE_KINDS(CLOSURE_ROW)};
#undef CLOSURE_ROW

unsigned closure_traits(size_t kind)
{
    return closure_rows[kind].traits;
}

bool acts_along_joints(closure_kind kind)
{
    return (closure_rows[kind].traits & ALONG_JOINTS) != 0;
}

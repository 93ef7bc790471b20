#include "tools/isoc/graph/graph.h"

#include <string.h>

void *list_copy(arena *memory, const void *all, size_t count, size_t size)
{
    void *result = arena_take(memory, count + 1, size);
    if (count > 0) {
        memcpy(result, all, count * size);
    }
    return result;
}

node *zero_nodes(graph *g, size_t count)
{
    const node zero = constant(g, 0.0);
    node *result = arena_take(g->memory, count, sizeof *result);
    for (size_t i = 0; i < count; i++) {
        result[i] = zero;
    }
    return result;
}

node *all_nodes(const graph *g)
{
    node *result = arena_take(g->memory, g->count, sizeof *result);
    for (size_t i = 0; i < g->count; i++) {
        result[i] = (node)i;
    }
    return result;
}

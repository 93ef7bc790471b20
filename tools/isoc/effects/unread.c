/* A memory that no equation, output or other memory reads is left out, and a function of time that only such memories
 * read is not computed: only values that are read cost. Each component of a vector counts by itself. */
#include "tools/isoc/effects/effects.h"

/* Marks the inputs and memories that are read. */
static void mark_read(graph *g, node *roots, size_t count, void *context)
{
    mark_leaves(g, roots, count, OP_INPUT, context);
}

static void renumber(graph *g, node *roots, size_t count, void *context)
{
    replace_more_leaves(g, roots, count, context);
}

/* A memory that is read reads all that it follows from. */
static bool *find_read(builder *b)
{
    mechanism *m = &b->mechanism;
    const size_t count = (size_t)m->effects.memory_count + 1;
    bool *read = arena_take(b->s->memory, (size_t)held_count(m) + 1, sizeof *read);
    bool *is_done = arena_take(b->s->memory, count, sizeof *is_done);
    for_roots(b->g, m, false, mark_read, read);
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < m->effects.memory_count; i++) {
            if (read[m->inputs.count + i] && !is_done[i]) {
                is_done[i] = more = true;
                mark_read(b->g, &m->effects.memories[i].begin, 1, read);
                mark_read(b->g, &m->effects.memories[i].next, 1, read);
            }
        }
    }
    return read;
}

void drop_unread(builder *b)
{
    mechanism *m = &b->mechanism;
    m->inputs.is_read = b->whole != NULL ? b->whole->inputs.is_read : find_read(b);
    for (int i = (int)b->written->inputs.count; i < m->inputs.count; i++) {
        m->inputs.driven[i] = m->inputs.driven[i] && m->inputs.is_read[i];
    }
    node *to = arena_take(b->s->memory, (size_t)held_count(m) + 1, sizeof *to);
    int kept = 0;
    for (int i = 0; i < m->inputs.count; i++) {
        to[i] = leaf(b->g, OP_INPUT, i);
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        to[m->inputs.count + i] = leaf(b->g, OP_INPUT, m->inputs.count + kept);
        if (m->inputs.is_read[m->inputs.count + i]) {
            m->effects.memories[kept++] = m->effects.memories[i];
        }
    }
    if (kept < m->effects.memory_count) {
        m->effects.memory_count = kept;
        replacement all = {.op = OP_INPUT, .by = to};
        for_roots(b->g, m, false, renumber, &all);
        for (int i = 0; i < kept; i++) {
            renumber(b->g, &m->effects.memories[i].begin, 1, &all);
            renumber(b->g, &m->effects.memories[i].next, 1, &all);
        }
    }
}

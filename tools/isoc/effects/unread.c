/* A memory that no equation, output or other memory reads is not there, and a function of time that only such ones read is
 * not computed: only what is read costs. Of a vector each component counts by itself. */
#include "tools/isoc/mechanism/builder.h"

/* Does something to each list of roots that can read a memory, but for the memories themselves. */
static void for_roots(builder *b, void (*visit)(builder *b, node *roots, size_t count, void *context), void *context)
{
    mechanism *m = &b->mechanism;
    visit(b, m->effects.efforts, (size_t)m->dof_count, context);
    for (int i = 0; i < m->effects.push_count; i++) {
        visit(b, &m->effects.pushes[i].effort, 1, context);
    }
    for (int i = 0; i < m->forces.applied_count; i++) {
        if (m->forces.applied[i].drive < 0) {
            visit(b, m->forces.applied[i].force.at, 3, context);
            visit(b, m->forces.applied[i].moment.at, 3, context);
        }
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        visit(b, &m->effects.states[i].begin, 1, context);
        visit(b, &m->effects.states[i].next, 1, context);
    }
    for (int i = 0; i < m->effects.count; i++) {
        visit(b, &m->effects.accounts[i].power, 1, context);
        visit(b, &m->effects.accounts[i].stored, 1, context);
        visit(b, &m->effects.accounts[i].loss, 1, context);
        visit(b, &m->effects.accounts[i].work, 1, context);
    }
    for (size_t i = 0; i < m->output_count; i++) {
        visit(b, m->outputs[i].formula.parts, (size_t)m->outputs[i].formula.count, context);
    }
}

/* Marks the inputs and memories that are read. */
static void mark_read(builder *b, node *roots, size_t count, void *context)
{
    mark_leaves(b->g, roots, count, OP_INPUT, context);
}

static void renumber(builder *b, node *roots, size_t count, void *context)
{
    replace_leaves(b->g, roots, count, OP_INPUT, context);
}

/* A memory that is read reads all that it follows from. */
static bool *find_read(builder *b)
{
    mechanism *m = &b->mechanism;
    const size_t count = (size_t)m->effects.memory_count + 1;
    bool *read = arena_take(b->s->memory, (size_t)held_count(m) + 1, sizeof *read);
    bool *is_done = arena_take(b->s->memory, count, sizeof *is_done);
    for_roots(b, mark_read, read);
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < m->effects.memory_count; i++) {
            if (read[m->inputs.count + i] && !is_done[i]) {
                is_done[i] = more = true;
                mark_read(b, &m->effects.memories[i].begin, 1, read);
                mark_read(b, &m->effects.memories[i].next, 1, read);
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
        for_roots(b, renumber, to);
        for (int i = 0; i < kept; i++) {
            renumber(b, &m->effects.memories[i].begin, 1, to);
            renumber(b, &m->effects.memories[i].next, 1, to);
        }
    }
}

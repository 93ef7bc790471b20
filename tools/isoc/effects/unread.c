/* A memory that no equation, output or other memory reads is not there, and a function of time that only such ones read is
 * not computed: only what is read costs. Of a vector each component counts by itself. */
#include "tools/isoc/graph/differentiate.h"
#include "tools/isoc/mechanism/builder.h"

/* Does something to each list of roots that can read a memory, but for the memories themselves. */
static void for_roots(builder *b, void (*visit)(builder *b, node *roots, size_t count, void *of), void *of)
{
    mechanism *made = &b->made;
    visit(b, made->efforts, (size_t)made->dof_count, of);
    for (int i = 0; i < made->effort_part_count; i++) {
        visit(b, &made->effort_parts[i].effort, 1, of);
    }
    for (int i = 0; i < made->applied_force_count; i++) {
        if (made->applied_forces[i].drive < 0) {
            visit(b, made->applied_forces[i].force.at, 3, of);
            visit(b, made->applied_forces[i].moment.at, 3, of);
        }
    }
    for (int i = 0; i < made->effect_state_count; i++) {
        visit(b, &made->effect_states[i].begin, 1, of);
        visit(b, &made->effect_states[i].next, 1, of);
    }
    for (int i = 0; i < made->effect_count; i++) {
        visit(b, &made->accounts[i].power, 1, of);
        visit(b, &made->accounts[i].stored, 1, of);
        visit(b, &made->accounts[i].loss, 1, of);
        visit(b, &made->accounts[i].work, 1, of);
    }
    for (size_t i = 0; i < made->output_count; i++) {
        if (made->outputs[i].kind == OUTPUT_FORMULA) {
            visit(b, &made->outputs[i].formula, 1, of);
        }
    }
}

/* Marks the inputs and memories that are read. */
static void mark(builder *b, node *roots, size_t count, void *of)
{
    const graph *g = b->g;
    bool *marked = of, *needed = arena_take(g->memory, g->count, sizeof *needed);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        if (needed[i] && g->nodes[i].op == OP_INPUT) {
            marked[g->nodes[i].index] = true;
        }
    }
    arena_return(g->memory, needed, g->count, sizeof *needed);
}

static void renumber(builder *b, node *roots, size_t count, void *of)
{
    replace_leaves(b->g, roots, count, OP_INPUT, of);
}

/* What a memory that is read follows from is read too. */
static bool *find_read(builder *b)
{
    mechanism *made = &b->made;
    const size_t count = (size_t)made->memory_count + 1;
    bool *read = arena_take(b->s->memory, (size_t)held_count(made) + 1, sizeof *read);
    bool *is_done = arena_take(b->s->memory, count, sizeof *is_done);
    for_roots(b, mark, read);
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < made->memory_count; i++) {
            if (read[made->input_count + i] && !is_done[i]) {
                is_done[i] = more = true;
                mark(b, &made->memories[i].begin, 1, read);
                mark(b, &made->memories[i].next, 1, read);
            }
        }
    }
    return read;
}

void drop_unread(builder *b)
{
    mechanism *made = &b->made;
    made->is_read = b->whole != NULL ? b->whole->is_read : find_read(b);
    for (int i = (int)b->written->input_count; i < made->input_count; i++) {
        made->driven[i] = made->driven[i] && made->is_read[i];
    }
    node *to = arena_take(b->s->memory, (size_t)held_count(made) + 1, sizeof *to);
    int kept = 0;
    for (int i = 0; i < made->input_count; i++) {
        to[i] = leaf(b->g, OP_INPUT, i);
    }
    for (int i = 0; i < made->memory_count; i++) {
        to[made->input_count + i] = leaf(b->g, OP_INPUT, made->input_count + kept);
        if (made->is_read[made->input_count + i]) {
            made->memories[kept++] = made->memories[i];
        }
    }
    if (kept < made->memory_count) {
        made->memory_count = kept;
        for_roots(b, renumber, to);
        for (int i = 0; i < kept; i++) {
            renumber(b, &made->memories[i].begin, 1, to);
            renumber(b, &made->memories[i].next, 1, to);
        }
    }
}

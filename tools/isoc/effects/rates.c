/* Blocks of a rate: every PERIOD [at PHASE] { ... }. What stands in one is computed in the rows that are due. Formulas
 * of the same rate read it as it is computed; all others read memories that keep it. */
#include "tools/isoc/effects/effects.h"

#include <math.h>

#include "tools/isoc/formula/ticks.h"
#include "tools/isoc/scene/names.h"

static const double slowest = 16777215.0; /* ticks, of iso_tick_modulo */

/* A time as a whole number of ticks within these limits; the lower one after noting a problem. */
static double whole_ticks(effect_scope *w, const formula *f, const char *what, double least, double most)
{
    source *s = w->b->s;
    const size_t before = s->problem_count;
    const double ticks = value_constant(&w->b->values, f, second, what, 0.0) / w->b->mechanism.method.step;
    if (s->problem_count == before && !(is_whole_tick(ticks) && round(ticks) >= least && round(ticks) <= most)) {
        source_problem(s, f->at, "%s is a whole number of steps, from %.0f to %.0f; this is %.6g", what, least, most,
                       ticks);
    }
    return s->problem_count == before ? round(ticks) : least;
}

row_rate rate_of_block(effect_scope *w, const instance *in, const rate_block *block)
{
    if (block == NULL || block->period == NULL) {
        return each_row;
    }
    const instance *before = enter(w, in);
    row_rate found = each_row;
    found.every = whole_ticks(w, block->period, "the period of a rate", 1.0, slowest);
    if (block->phase != NULL) {
        found.phase = whole_ticks(w, block->phase, "the phase of a rate", 0.0, found.every - 1.0);
    }
    enter(w, before);
    return found;
}

row_rate rate_of_use(effect_scope *w, const instance *in)
{
    while (in->outer != NULL && in->use->block == NULL) {
        in = in->outer;
    }
    return rate_of_block(w, in->outer, in->use->block);
}

row_rate rate_of_line(effect_scope *w, const instance *in, const effect_line *line)
{
    bound_line *bound = &in->bound[line - in->kind->lines];
    if (bound->rate.every < 1.0) {
        bound->rate = line->block != NULL ? rate_of_block(w, in, line->block) : rate_of_use(w, in);
    }
    return bound->rate;
}

row_rate pace(effect_scope *w, row_rate rate)
{
    const row_rate before = w->rate;
    w->rate = rate;
    return before;
}

/* Whether a number stays what it is between the rows of a rate by itself: a constant, or a memory of this rate. */
static bool stays(const effect_scope *w, node n, row_rate rate)
{
    const graph_node *is = &w->b->g->nodes[n];
    const mechanism *m = &w->b->mechanism;
    const int memory = is->op == OP_INPUT ? is->index - m->inputs.count : -1;
    return is_constant(w->b->g, n) || (memory >= 0 && is_same_rate(m->effects.memories[memory].rate, rate));
}

value held_value(effect_scope *w, const instance *in, const value *inner, row_rate rate, const char *called, name owner,
                 value *held)
{
    builder *b = w->b;
    effect_set *all = &b->mechanism.effects;
    if (held->count > 0 || inner->count == 0 || (in != NULL && in->use->left_out)) {
        return held->count > 0 ? *held : *inner;
    }
    value found = *inner;
    for (int i = 0; i < found.count; i++) {
        if (stays(w, found.parts[i], rate)) {
            continue;
        }
        if (all->memory_count + b->mechanism.inputs.count >= MOST_MEMORIES) {
            return REFUSED(b->s, owner.at, "too many inputs and memories: a plant has at most %d", MOST_MEMORIES);
        }
        effect_quantity kept = {
            .begin = inner->parts[i], .next = inner->parts[i], .at = owner.at, .kept = KEPT_SAMPLE, .rate = rate};
        kept.about = unlimited(arena_format(b->s->memory, "%s%s", called, effect_endings[found.count == 3 ? i : 3]),
                               dimension_unit(b->s->memory, found.dim), source_quote(b->s, owner.at));
        kept.effect = in == NULL ? 0 : (int)(in - w->all);
        found.parts[i] = leaf(b->g, OP_INPUT, b->mechanism.inputs.count + all->memory_count);
        ADD_TO(b->s->memory, all->memories, all->memory_count, b->memory_room, kept);
    }
    *held = found;
    return found;
}

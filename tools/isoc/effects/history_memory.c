/* The past of formulas: previous(x), sample(x, every 5 ms), delay(x, 5 ms), and shares of a step. Each is a memory that
 * no effect declares; its formula is evaluated after all lines, so that a formula may need its own past. */
#include "tools/isoc/effects/effects.h"
#include "tools/isoc/formula/ticks.h"
#include <math.h>

enum { LONGEST_DELAY = 65535 };

static const double longest_sample = 16777215.0; /* ticks, of core/numbers/waveform.h */

/* The whole ticks of the time that a call has; 1 of previous; 0 after noting a problem, and of a share. */
static double ticks_of(effect_scope *w, const formula *f, keeping kept)
{
    source *s = w->b->s;
    const double most = kept == KEPT_SAMPLE ? longest_sample : (double)LONGEST_DELAY;
    if (kept == KEPT_PREVIOUS || kept == KEPT_SHARE) {
        return kept == KEPT_SHARE ? share_ticks(w, f) : 1.0;
    }
    const size_t before = s->problem_count;
    const double ticks =
        value_constant(&w->b->values, f->parts[1], second, "the time", 0.0) / w->b->mechanism.method.step;
    if (s->problem_count > before) {
        return 0.0;
    }
    if (!is_whole_tick(ticks) || !(round(ticks) >= 1.0 && round(ticks) <= most)) {
        source_problem(s, f->parts[1]->at, "the time of a %s is a whole number of steps, from 1 to %.0f; this is %.6g",
                       f->name, most, ticks);
        return 0.0;
    }
    return round(ticks);
}

static bool is_number(effect_scope *w, const formula *f, const value *found)
{
    if (found->count > 1) {
        source_problem(w->b->s, f->parts[0]->at, "%s takes a number; this is a vector", f->name);
    }
    return found->count == 1;
}

/* A new memory; `start` is its start, or -1 for the value of the formula at the start. */
static int add_history_memory(effect_scope *w, const formula *f, node start, dimension expected, double ticks)
{
    builder *b = w->b;
    effect_set *all = &b->mechanism.effects;
    const node begin = start < 0 ? constant(b->g, 0.0) : start;
    const keeping kept = function_called(f->name)->kept;
    const row_rate own = kept == KEPT_PREVIOUS ? w->rate : each_row;
    const history_memory past = {f, w->within, all->memory_count, expected, own, start >= 0, false};
    effect_quantity m = {.begin = begin, .next = begin, .at = f->at, .kept = kept, .ticks = ticks};
    m.rate = kept == KEPT_SAMPLE ? (row_rate){ticks, 0.0} : own;
    m.about = unlimited(arena_format(b->s->memory, "kept_%s_%zu", f->name, b->history_memories.count + 1),
                        dimension_equal_but_angle(expected, no_unit) ? "1" : dimension_text(b->s->memory, expected),
                        source_quote(b->s, f->at));
    ADD_TO(b->s->memory, all->memories, all->memory_count, b->memory_room, m);
    LIST_ADD(b->s->memory, b->history_memories, past);
    return past.memory;
}

value history_memory_value(void *context, const formula *f)
{
    effect_scope *w = context;
    builder *b = w->b;
    if (refuse_in_function(w, f)) {
        return nothing;
    }
    const keeping kept = function_called(f->name)->kept;
    const bool is_share = kept == KEPT_SHARE;
    const size_t before = b->s->problem_count, at_start = is_share ? MOST_ARGUMENTS : kept == KEPT_PREVIOUS ? 1 : 2;
    FOR_EACH (const history_memory, p, b->history_memories) {
        if (p->call == f && p->within == w->within) {
            return (value){
                .count = 1, .parts = {leaf(b->g, OP_INPUT, b->mechanism.inputs.count + p->memory)}, .dim = p->in};
        }
    }
    const double ticks = ticks_of(w, f, kept);
    const bool has_start = f->count > at_start;
    const row_rate around = pace(w, kept == KEPT_PREVIOUS ? w->rate : each_row);
    const value first = is_share ? (value){.count = 1, .parts = {constant(b->g, 0.0)}, .dim = no_unit}
                                 : evaluate(w, w->within, f->parts[has_start ? at_start : 0], f->name);
    pace(w, around);
    if ((ticks == 0.0 && !is_share) || b->s->problem_count > before || !is_number(w, f, &first)) {
        return nothing;
    }
    if (has_start && !is_constant(b->g, first.parts[0])) {
        return REFUSED(b->s, f->parts[at_start]->at, "the start of a %s must be a constant", f->name);
    }
    if (b->mechanism.effects.memory_count + b->mechanism.inputs.count >= MOST_MEMORIES) {
        return REFUSED(b->s, f->at, "too many inputs and memories: a plant has at most %d", MOST_MEMORIES);
    }
    const int memory = add_history_memory(w, f, has_start ? first.parts[0] : -1, first.dim, ticks);
    return (value){.count = 1, .parts = {leaf(b->g, OP_INPUT, b->mechanism.inputs.count + memory)}, .dim = first.dim};
}

void finish_history_memories(builder *b)
{
    effect_scope *w = b->around == NULL ? NULL : b->around->context;
    b->values.around = b->around;
    for (size_t i = 0; w != NULL && i < b->history_memories.count; i++) {
        const history_memory p = b->history_memories.all[i];
        if (p.is_done) {
            continue;
        }
        b->history_memories.all[i].is_done = true;
        const bool is_share = function_called(p.call->name)->kept == KEPT_SHARE;
        const row_rate around = pace(w, p.rate);
        const value found =
            is_share ? share_value(w, p.within, p.call) : evaluate(w, p.within, p.call->parts[0], p.call->name);
        pace(w, around);
        if (found.count == 0 || !is_number(w, p.call, &found)) {
            continue;
        }
        if (!found.any && !dimension_equal_but_angle(found.dim, p.in)) {
            source_problem(b->s, p.call->parts[0]->at, "%s keeps a value in the unit of its start, %s; this %s",
                           p.call->name, dimension_text(b->s->memory, p.in), dimension_phrase(b->s->memory, found.dim));
        }
        effect_quantity *kept = &b->mechanism.effects.memories[p.memory];
        kept->next = found.parts[0];
        kept->begin = p.has_start ? kept->begin : found.parts[0];
    }
    b->values.around = NULL;
}

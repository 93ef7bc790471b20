/* Functions of time in the formulas of effects, signals and outputs: each is an input of its own, which the scene
 * drives with it; `time` itself is one for all. Inputs are numbered before any formula is evaluated, so these are
 * looked for first. */
#include <string.h>

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/formula/condition.h"
#include "tools/isoc/formula/ticks.h"
#include "tools/isoc/scene/names.h"

static bool is_time(const formula *f)
{
    return f->kind == FORMULA_NAME && strcmp(f->name, "time") == 0;
}

static bool is_time_function(const formula *f)
{
    const function_row *row = f->kind == FORMULA_CALL ? function_called(f->name) : NULL;
    return f->kind == FORMULA_FILE || is_time(f) || is_wave(f) ||
           (row != NULL && (row->kind == OF_TIME || row->kind == OF_JUMPS));
}

static time_input *time_input_called(const builder *b, const formula *f, const effect_use *within)
{
    FOR_ALL (time_input, t, b->time_inputs, b->time_input_count) {
        if (is_time(f) ? is_time(t->call) : t->call == f && t->within == within) {
            return t;
        }
    }
    return NULL;
}

static void add_time_inputs(builder *b, const formula *f, const effect_use *within)
{
    if (f == NULL) {
        return;
    }
    const size_t all = b->written->inputs.count + (size_t)(b->mechanism.effects.memory_count + b->time_input_count);
    const bool is_new = is_time_function(f) && time_input_called(b, f, within) == NULL;
    if (is_new && all == MOST_MEMORIES) {
        source_problem(b->s, f->at, "too many inputs and memories: a plant has at most %d", MOST_MEMORIES);
    }
    if (is_new && all < MOST_MEMORIES) {
        ADD_TO(b->s->memory, b->time_inputs, b->time_input_count, b->time_input_room,
               ((time_input){.call = f, .within = is_time(f) ? NULL : within}));
    }
    for (size_t i = 0; i < f->count; i++) {
        add_time_inputs(b, f->parts[i], within);
    }
}

static void add_time_inputs_of_sets(builder *b, const when_statement *when, const effect_use *within)
{
    FOR_EACH (const set_statement, set, when->sets) {
        add_time_inputs(b, set->along, within);
        add_time_inputs(b, set->value, within);
    }
}

void find_time_inputs(builder *b)
{
    const scene *written = b->written;
    FOR_EACH (const effect_use, use, written->effects) {
        const effect_kind *kind = use->left_out ? NULL : find_effect_kind(written, use->kind);
        for (size_t n = 0; kind != NULL && n < kind->line_count; n++) {
            const effect_line *line = &kind->lines[n];
            /* Of an operand that the use gives, the default does not count. */
            if (line->kind >= EFFECT_FAULT || operand_called(use, line->name.text) == NULL) {
                add_time_inputs(b, line->value, use);
                add_time_inputs(b, line->most, use);
            }
            if (line->when != NULL) {
                add_time_inputs_of_sets(b, line->when, use);
            }
        }
        for (size_t n = 0; kind != NULL && n < use->operand_count; n++) {
            add_time_inputs(b, use->operands[n].value, use->outer < 0 ? NULL : &written->effects.all[use->outer]);
        }
    }
    FOR_EACH (const quantity, signal, written->signals) {
        add_time_inputs(b, signal->left_out ? NULL : signal->value, NULL);
    }
    FOR_EACH (const quantity, mode, written->events.modes) {
        add_time_inputs(b, mode->value, NULL);
    }
    FOR_EACH (const when_statement, when, written->events.whens) {
        add_time_inputs(b, when->condition, NULL);
        add_time_inputs_of_sets(b, when, NULL);
    }
    FOR_EACH (const output, o, written->outputs) {
        add_time_inputs(b, o->formula, NULL);
    }
}

void build_time_inputs(builder *b)
{
    mechanism *m = &b->mechanism;
    const int first = (int)b->written->inputs.count;
    m->inputs.time_input_of = arena_take(b->s->memory, (size_t)m->inputs.count + 1, sizeof *m->inputs.time_input_of);
    m->inputs.time_inputs = arena_take(b->s->memory, (size_t)b->time_input_count + 1, sizeof *m->inputs.time_inputs);
    m->inputs.time_input_count = b->time_input_count;
    for (int i = 0; i < first; i++) {
        m->inputs.time_input_of[i] = -1;
    }
    for (int i = 0; i < b->time_input_count; i++) {
        const time_input *t = &b->time_inputs[i];
        const name origin = t->within != NULL ? t->within->name : (name){NULL, t->call->at};
        m->inputs.time_input_of[first + i] = i;
        m->inputs.time_inputs[i] = (time_input_origin){t->call->name, origin};
        m->inputs.all[first + i] = unlimited(arena_format(b->s->memory, "made_%s_%d", t->call->name, i + 1),
                                             is_time(t->call) ? "s" : "1", source_quote(b->s, t->call->at));
        m->inputs.driven[first + i] = true;
        m->inputs.drives[first + i] = constant(b->g, 0.0);
    }
}

/* The offset of the seeds of an effect: a hash of its name (FNV-1a: Fowler, Noll, Vo), to which the seeds of the
 * definition are added. */
static uint32_t seed_of(const effect_use *within)
{
    uint32_t hash = UINT32_C(2166136261);
    for (const char *c = within == NULL ? NULL : within->name.text; c != NULL && *c != '\0'; c++) {
        hash = (hash ^ (unsigned char)*c) * UINT32_C(16777619);
    }
    return within == NULL ? 0 : hash;
}

/* The function that drives its input; count 0 after noting a problem. */
static value drive_of(builder *b, const formula *f, const effect_use *within)
{
    const size_t before = b->s->problem_count;
    if (f->kind == FORMULA_CALL && strcmp(f->name, "noise") == 0) {
        uint32_t seed;
        const value argument = value_any(&b->values, f->parts[0]);
        const bool is_seed = noise_seed(&b->values, f, &argument, &seed) && b->s->problem_count == before;
        return is_seed ? (value){.count = 1, .parts = {noise_of_seed(b->g, seed_of(within) + seed)}} : nothing;
    }
    if (is_wave(f)) {
        return wave_over(&b->values, f);
    }
    b->values.time_allowed = true;
    const value found = value_any(&b->values, f);
    b->values.time_allowed = false;
    tables_forget(&b->values, f);
    if (found.count == 1) {
        find_edges(b, found.parts[0]);
    }
    return found;
}

value time_input_value(void *context, const formula *f)
{
    const effect_scope *w = context;
    builder *b = w->b;
    if (!is_time(f) && refuse_in_function(w, f)) {
        return nothing;
    }
    const effect_use *within = w->within == NULL ? NULL : w->within->use;
    time_input *s = time_input_called(b, f, within);
    if (s == NULL) { /* only its dimension is asked for */
        return (value){.count = 1, .parts = {constant(b->g, 0.0)}, .dim = is_time(f) ? second : no_unit};
    }
    if (s->drive.count == 0) {
        const int input = (int)b->written->inputs.count + (int)(s - b->time_inputs);
        s->drive = drive_of(b, f, within);
        if (s->drive.count == 1) {
            b->mechanism.inputs.drives[input] = s->drive.parts[0];
            s->drive.parts[0] = leaf(b->g, OP_INPUT, input);
        }
    }
    return s->drive;
}

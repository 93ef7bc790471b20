/* noise(SEED) in the formulas of effects, signals and outputs: each call is an input of its own, which the scene drives with
 * noise. Inputs are numbered before any formula is evaluated, so the calls are looked for first. */
#include <math.h>
#include <string.h>

#include "tools/isoc/mechanism/effects.h"
#include "tools/isoc/mechanism/timing.h"
#include "tools/isoc/scene/names.h"

static const value nothing = {0};

static void add_streams(builder *b, const formula *f, const effect_use *within)
{
    if (f == NULL) {
        return;
    }
    const size_t all = b->written->input_count + (size_t)(b->made.memory_count + b->stream_count);
    const bool is_noise = f->kind == FORMULA_CALL && strcmp(f->name, "noise") == 0;
    if (is_noise && all == MOST_MEMORIES) {
        source_problem(b->s, f->at, "too many inputs and memories: a plant has at most %d", MOST_MEMORIES);
    }
    if (is_noise && all < MOST_MEMORIES) {
        b->streams = arena_grow(b->s->memory, b->streams, (size_t)b->stream_count, &b->stream_room, sizeof *b->streams);
        b->streams[b->stream_count++] = (stream){f, within};
    }
    for (size_t i = 0; i < f->count; i++) {
        add_streams(b, f->parts[i], within);
    }
}

/* Whether the use gives what a line would have as its default. */
static bool is_given(const effect_use *use, const effect_line *line)
{
    bool is = false;
    for (size_t i = 0; i < use->operand_count && line->kind < EFFECT_FAULT; i++) {
        is = is || (line->name.text != NULL && strcmp(use->operands[i].name.text, line->name.text) == 0);
    }
    return is;
}

void find_streams(builder *b)
{
    const scene *written = b->written;
    for (size_t i = 0; i < written->effect_count; i++) {
        const effect_use *use = &written->effects[i];
        const effect_kind *kind = use->left_out ? NULL : find_effect_kind(written, use->kind);
        for (size_t n = 0; kind != NULL && n < kind->line_count; n++) {
            if (!is_given(use, &kind->lines[n])) {
                add_streams(b, kind->lines[n].value, use);
                add_streams(b, kind->lines[n].most, use);
            }
        }
        for (size_t n = 0; kind != NULL && n < use->operand_count; n++) {
            add_streams(b, use->operands[n].value, NULL);
        }
    }
    for (size_t i = 0; i < written->signal_count; i++) {
        add_streams(b, written->signals[i].left_out ? NULL : written->signals[i].value, NULL);
    }
    for (size_t i = 0; i < written->output_count; i++) {
        add_streams(b, written->outputs[i].formula, NULL);
    }
}

void build_streams(builder *b)
{
    mechanism *made = &b->made;
    const int first = (int)b->written->input_count;
    made->noises = arena_take(b->s->memory, (size_t)made->input_count + 1, sizeof *made->noises);
    made->noise_origins = arena_take(b->s->memory, (size_t)b->stream_count + 1, sizeof *made->noise_origins);
    made->noise_count = b->stream_count;
    for (int i = 0; i < first; i++) {
        made->noises[i] = -1;
    }
    for (int i = 0; i < b->stream_count; i++) {
        const stream *of = &b->streams[i];
        made->noises[first + i] = i;
        made->noise_origins[i] = of->within != NULL ? of->within->name : (name){NULL, of->of->at};
        made->inputs[first + i] = (variable){.name = arena_format(b->s->memory, "made_noise_%d", i + 1),
                                             .unit = "1",
                                             .quote = source_quote(b->s, of->of->at),
                                             .least = -HUGE_VAL,
                                             .most = HUGE_VAL};
        made->driven[first + i] = true;
        made->drives[first + i] = constant(b->g, 0.0);
    }
}

/* Of an effect its seeds are its own: those of its name (FNV-1a: Fowler, Noll, Vo) and beyond, as the definition has them. */
static uint32_t seed_of(const effect_use *within)
{
    uint32_t hash = UINT32_C(2166136261);
    for (const char *c = within == NULL ? NULL : within->name.text; c != NULL && *c != '\0'; c++) {
        hash = (hash ^ (unsigned char)*c) * UINT32_C(16777619);
    }
    return within == NULL ? 0 : hash;
}

value stream_value(void *of, const formula *f)
{
    const world *w = of;
    builder *b = w->b;
    const effect_use *within = w->within == NULL ? NULL : w->within->use;
    const size_t before = b->s->problem_count;
    uint32_t seed;
    if (!noise_seed(&b->values, f, &seed) || b->s->problem_count > before) {
        return nothing;
    }
    value found = {.count = 1, .parts = {constant(b->g, 0.0)}}; /* where only its dimension is asked for */
    for (int i = 0; i < b->stream_count; i++) {
        if (b->streams[i].of == f && b->streams[i].within == within) {
            const int input = (int)b->written->input_count + i;
            b->made.drives[input] = noise_of_seed(b->g, seed_of(within) + seed);
            found.parts[0] = leaf(b->g, OP_INPUT, input);
        }
    }
    return found;
}

/* The memory of a plant: one flat struct. A copy of it is read on every target (core/runtime/snapshot.h), so there is no
 * byte between its members: each stands where its size divides its place, which every compiler keeps. */
#include <string.h>

#include "tools/isoc/emit/parts.h"

typedef struct part {
    const char *declaration;
    const char *about;
    size_t bytes;
} part;

typedef struct memory_layout {
    const emission *e;
    part *parts;
    int count;
    size_t bytes;     /* of all of them */
    size_t real_size; /* in the plant */
} memory_layout;

static void add_member(memory_layout *list, const char *declaration, const char *about, size_t bytes)
{
    list->parts[list->count++] = (part){declaration, about, bytes};
    list->bytes += bytes;
}

/* An array of so many reals; its size as C. */
static void add_reals(memory_layout *list, const char *array, const char *size, size_t count, const char *about)
{
    if (count > 0) {
        add_member(list, arena_format(list->e->out->memory, "real %s[%s]", array, size), about,
                   count * list->real_size);
    }
}

/* The states with what the method keeps, and the inputs with their samples. */
static void add_moving(memory_layout *list)
{
    const mechanism *m = list->e->p->m;
    arena *memory = list->e->out->memory;
    const char *capitals = list->e->names->capitals;
    const size_t states = (size_t)state_count(m), vectors = ISO_METHOD_STATE(m->method.recipe, states) / states;
    const size_t inputs = (size_t)held_count(m),
                 samples = ISO_METHOD_SAMPLES(m->method.recipe, (size_t)m->inputs.sampled_count);
    if (vectors > 1) {
        add_reals(list, "x", arena_format(memory, "%s_STATES * %zu", capitals, vectors), states * vectors,
                  arena_format(memory, "the states, and behind them what %s keeps",
                               method_names[ISO_METHOD_OF(m->method.recipe)]));
    } else {
        add_reals(list, "x", arena_format(memory, "%s_STATES", capitals), states, NULL);
    }
    if (ISO_IS_SMOOTH(m->method.recipe)) {
        add_reals(list, "u",
                  arena_format(memory, "%s + %s * %d + 1", held_size(list->e), sampled_size(list->e),
                               ISO_DEGREE(m->method.recipe) + 1),
                  inputs + samples, "behind the inputs their samples");
    } else {
        add_reals(list, "u", held_size(list->e), inputs, NULL);
    }
}

/* How the last step went: iso_progress and iso_adams_state of core/methods/progress.h. */
static void add_progress(memory_layout *list)
{
    const unsigned recipe = list->e->p->m->method.recipe;
    if (ISO_IS_VARYING(recipe)) {
        add_member(list, "iso_adams_state adams", NULL, 5 * list->real_size + 24);
    } else if (ISO_HAS_PROGRESS(recipe)) {
        add_member(list, "iso_progress progress", NULL, 4 * list->real_size);
    }
}

/* The pivots by which steps are watched for singular positions: iso_watch_pivots. */
static void add_pivots(memory_layout *list)
{
    const int pivots = list->e->p->after.pivot_count;
    add_reals(list, "pivots", arena_format(list->e->out->memory, "%d", pivots), (size_t)pivots,
              "of the closures, at the end of the last step");
    if (pivots > 0 && list->e->p->m->drift.near_holds) {
        add_member(list, "iso_held_energy held_energy", NULL, 2 * list->real_size);
    }
}

/* The values by which a restart is found. */
static void add_last(memory_layout *list)
{
    const plant *p = list->e->p;
    const mechanism *m = p->m;
    arena *memory = list->e->out->memory;
    if (watches_inputs(m)) {
        add_reals(list, "last_u", arena_format(memory, "%s_INPUTS", list->e->names->capitals), (size_t)m->inputs.count,
                  NULL);
    }
    if (watches_parameters(p)) {
        add_member(list, "iso_bits changed", "not zero where a tunable has changed since the last step",
                   list->real_size);
    }
    if (p->held.tuned > 0) {
        add_reals(list, "h", arena_format(memory, "%d", p->held.count), (size_t)p->held.count,
                  p->held.count > p->held.tuned ? "what follows from tunables, and what a step holds"
                                                : "what follows from tunables");
    }
    for (int i = 0; i < p->reduced_plant_count; i++) {
        const plant *left = p->reduced_plants[i].p;
        if (left->held.tuned > 0) {
            add_reals(list, arena_format(memory, "h%s", p->reduced_plants[i].suffix),
                      arena_format(memory, "%d", left->held.count), (size_t)left->held.count,
                      "the same without the effects that a ladder drops");
        }
    }
    if (watches_edges(m)) {
        add_member(list, "iso_bits edge", "not zero in a tick in which an input jumps", list->real_size);
    }
}

static void add_rings(memory_layout *list)
{
    const mechanism *m = list->e->p->m;
    arena *memory = list->e->out->memory;
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (is_late(&m->effects.memories[i])) {
            const size_t places = last_of_ring(&m->effects.memories[i]) + 1;
            add_reals(list, arena_format(memory, "past_%d", i), arena_format(memory, "%zu", places), places,
                      arena_format(memory, "what %s shows in later rows", m->effects.memories[i].about.name));
        }
    }
}

static void add_good(memory_layout *list)
{
    const mechanism *m = list->e->p->m;
    arena *memory = list->e->out->memory;
    const char *capitals = list->e->names->capitals;
    const bool has_inputs = m->inputs.count > 0, has_tunables = m->parameters.count > 0;
    const char *size =
        arena_format(memory, "%s%s%s%s%s_OUTPUTS", has_inputs ? capitals : "", has_inputs ? "_INPUTS + " : "",
                     has_tunables ? capitals : "", has_tunables ? "_PARAMETERS + " : "", capitals);
    add_reals(list, "good", size, (size_t)(m->inputs.count + m->parameters.count + list->e->p->outputs.count),
              arena_format(memory, "the last good%s%s outputs", has_inputs ? " inputs," : "",
                           has_tunables ? " tunables," : ""));
}

/* Counts of whole turns, and the row: whole numbers of 4 and of 8 bytes, behind all that is as large as a real. */
static void add_counts(memory_layout *list)
{
    const plant *p = list->e->p;
    arena *memory = list->e->out->memory;
    const bool with_rows = keeps_rows(p);
    if (p->after.pivot_count > 0) {
        add_member(list, "iso_nearness nearness", NULL, 2 * sizeof(uint32_t));
    }
    if (p->turn_count > 0) {
        add_member(list, arena_format(memory, "int32_t turns[%d]", p->turn_count), "of the continuous joints",
                   (size_t)p->turn_count * sizeof(int32_t));
    }
    if (list->bytes % sizeof(uint64_t) != 0 && (p->is_double || with_rows)) {
        add_member(list, "uint32_t unused", "no byte of the memory is without a name", sizeof(uint32_t));
    }
    if (with_rows) {
        add_member(list, "uint64_t row", "that the tick ends with; after it that which has begun", sizeof(uint64_t));
    }
}

static memory_layout layout_of(const emission *e)
{
    enum { NAMED = 16 };
    const mechanism *m = e->p->m;
    memory_layout list = {.e = e, .real_size = e->p->is_double ? sizeof(double) : sizeof(float)};
    list.parts = arena_take(e->out->memory, NAMED + (size_t)(m->effects.memory_count + e->p->reduced_plant_count),
                            sizeof *list.parts);
    const char *capitals = e->names->capitals;
    add_moving(&list);
    add_reals(&list, "p", arena_format(e->out->memory, "%s_PARAMETERS", capitals), (size_t)m->parameters.count, NULL);
    add_reals(&list, "y", arena_format(e->out->memory, "%s_OUTPUTS", capitals), (size_t)e->p->outputs.count, NULL);
    add_reals(&list, "rests", arena_format(e->out->memory, "%d", e->p->turn_count), (size_t)e->p->turn_count,
              "what rounding has taken from the angles of continuous joints");
    add_progress(&list);
    add_pivots(&list);
    add_last(&list);
    add_rings(&list);
    add_good(&list);
    add_counts(&list);
    return list;
}

void emit_memory(const emission *e)
{
    const memory_layout list = layout_of(e);
    text_add(e->out, "/* All that a plant keeps, without pointers: a copy of it is a snapshot. */\n");
    text_add(e->out, "typedef struct %s_memory {\n", e->names->prefix);
    FOR_ALL (const part, p, list.parts, list.count) {
        if (p->about == NULL) {
            text_add(e->out, "    %s;\n", p->declaration);
        } else {
            text_add(e->out, "    %s; /* %s */\n", p->declaration, p->about);
        }
    }
    text_add(e->out, "} %s_memory;\n\n", e->names->prefix);
}

size_t memory_place(const emission *e, char array)
{
    const memory_layout list = layout_of(e);
    const char *begin = arena_format(e->out->memory, "real %c[", array);
    size_t offset = 0;
    for (int i = 0; i < list.count && strncmp(list.parts[i].declaration, begin, strlen(begin)) != 0; i++) {
        offset += list.parts[i].bytes;
    }
    return offset;
}

void emit_memory_check(const emission *e)
{
    text_add(e->out, "_Static_assert(sizeof(%s_memory) == %zu,\n    \"%s\");\n\n", e->names->prefix, layout_of(e).bytes,
             "a record of the memory has the same bytes on every target: no padding");
}

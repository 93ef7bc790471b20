/* The memory of a plant: one flat struct. A copy of it is read on every target (core/runtime/snapshot.h), so there is
 * no byte between its members: each stands where its size divides its place, which every compiler keeps. */
#include <string.h>

#include "tools/isoc/emit/parts.h"

typedef struct part {
    const char *declaration;
    const char *about;
    size_t bytes;
} part;

typedef struct memory_layout {
    const emission *e;
    LIST_OF(part) parts;
    size_t bytes;     /* of all of them */
    size_t real_size; /* in the plant */
} memory_layout;

static void add_member(memory_layout *to, const char *declaration, const char *about, size_t bytes)
{
    LIST_ADD(to->e->out->memory, to->parts, ((part){declaration, about, bytes}));
    to->bytes += bytes;
}

/* An array of so many reals; its size as C. */
static void add_reals(memory_layout *to, const char *array, const char *size, size_t count, const char *about)
{
    if (count > 0) {
        add_member(to, form(to->e, "real %s[%s]", array, size), about, count * to->real_size);
    }
}

/* Its size as a number. */
static void add_numbered(memory_layout *to, const char *array, int count, const char *about)
{
    add_reals(to, array, form(to->e, "%d", count), (size_t)count, about);
}

static size_t vectors_of(const emission *e)
{
    const size_t states = (size_t)state_count(e->p->m);
    return ISO_METHOD_STATE(e->p->m->method.recipe, states) / states;
}

const char *method_state_size(const emission *e)
{
    return vectors_of(e) > 1 ? form(e, "$C_STATES * %zu", vectors_of(e)) : form(e, "$C_STATES");
}

/* The comment of the state array: the values behind the states. */
static const char *about_state_array(const emission *e)
{
    const bool keeps = vectors_of(e) > 1, prepares = e->names->cut != NULL;
    const char *kept = keeps ? form(e, "what %s keeps", method_names[ISO_METHOD_OF(e->p->m->method.recipe)]) : "";
    return !keeps && !prepares ? NULL
                               : form(e, "the states, and behind them %s%s%s", kept, keeps && prepares ? ", and " : "",
                                      prepares ? "what follows from them alone" : "");
}

/* The states with the method's history, and the inputs with their samples. */
static void add_moving(memory_layout *to)
{
    const emission *e = to->e;
    const mechanism *m = e->p->m;
    const unsigned recipe = m->method.recipe;
    const size_t states = (size_t)state_count(m) * vectors_of(e);
    const size_t prepared = (size_t)prepared_count(e);
    const size_t samples = ISO_METHOD_SAMPLES(recipe, (size_t)m->inputs.sampled_count);
    const bool smooth = ISO_IS_SMOOTH(recipe);
    add_reals(to, "x", form(e, prepared > 0 ? "%s + %zu" : "%s", method_state_size(e), prepared), states + prepared,
              about_state_array(e));
    add_reals(to, "u",
              smooth ? form(e, "%s + %s * %d + 1", held_size(e), sampled_size(e), ISO_DEGREE(recipe) + 1)
                     : held_size(e),
              (size_t)held_count(m) + (smooth ? samples : 0), smooth ? "behind the inputs their samples" : NULL);
}

/* iso_progress and iso_adams_state of core/methods/progress.h. */
static void add_progress(memory_layout *to)
{
    const unsigned recipe = to->e->p->m->method.recipe;
    if (ISO_IS_VARYING(recipe)) {
        add_member(to, "iso_adams_state adams", NULL, 5 * to->real_size + 24);
    } else if (ISO_HAS_PROGRESS(recipe)) {
        add_member(to, "iso_progress progress", NULL, 4 * to->real_size);
    }
}

/* The pivots by which steps are watched for singular positions: iso_watch_pivots. */
static void add_pivots(memory_layout *to)
{
    const int pivots = to->e->p->after.pivot_count;
    add_numbered(to, "pivots", pivots, "products of those of a closure, at the end of the last step");
    if (pivots > 0 && to->e->p->m->drift.near_holds) {
        add_member(to, "iso_held_energy held_energy", NULL, 2 * to->real_size);
    }
}

/* What is known of events: core/methods/event.h. */
static void add_events(memory_layout *to)
{
    const int count = to->e->p->m->events.count;
    if (count > 0) {
        add_member(to, form(to->e, "iso_bits events[%d]", count), "what is known of each",
                   (size_t)count * to->real_size);
    }
}

/* The values by which a restart is found. */
static void add_last(memory_layout *to)
{
    const plant *p = to->e->p;
    if (watches_inputs(p->m)) {
        add_reals(to, "last_u", form(to->e, "$C_INPUTS"), (size_t)p->m->inputs.count, NULL);
    }
    if (watches_parameters(p)) {
        add_member(to, "iso_bits changed", "not zero where a tunable has changed since the last step", to->real_size);
    }
    if (p->held.tuned > 0) {
        add_numbered(to, "h", p->held.count,
                     p->held.count > p->held.tuned ? "what follows from tunables, and what a step holds"
                                                   : "what follows from tunables");
    }
    FOR_ALL (const reduced_plant, left, p->reduced_plants, p->reduced_plant_count) {
        if (left->p->held.tuned > 0) {
            add_numbered(to, form(to->e, "h%s", left->suffix), left->p->held.count,
                         "the same without the effects that a ladder drops");
        }
    }
    if (watches_edges(p->m)) {
        add_member(to, "iso_bits edge", "not zero in a tick in which an input jumps", to->real_size);
    }
}

static void add_rings(memory_layout *to)
{
    const mechanism *m = to->e->p->m;
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (is_late(&m->effects.memories[i])) {
            add_numbered(to, form(to->e, "past_%d", i), (int)last_of_ring(&m->effects.memories[i]) + 1,
                         form(to->e, "what %s shows in later rows", m->effects.memories[i].about.name));
        }
    }
}

/* The next values of slow memories that others read before they are set. */
static void add_coming(memory_layout *to)
{
    add_numbered(to, "coming", to->e->p->rows.coming_count, "next values, until all of a row are known");
}

static void add_good(memory_layout *to)
{
    const mechanism *m = to->e->p->m;
    const bool has_inputs = m->inputs.count > 0, has_tunables = m->parameters.count > 0;
    const char *size = form(to->e, "%s%s(int)$C_OUTPUTS", has_inputs ? form(to->e, "(int)$C_INPUTS + ") : "",
                            has_tunables ? form(to->e, "(int)$C_PARAMETERS + ") : "");
    add_reals(to, "good", size, (size_t)(m->inputs.count + m->parameters.count + to->e->p->outputs.count),
              form(to->e, "the last good%s%s outputs", has_inputs ? " inputs," : "", has_tunables ? " tunables," : ""));
}

/* Counts of whole turns, and the row: whole numbers of 4 and of 8 bytes, behind all that is as large as a real. */
static void add_counts(memory_layout *to)
{
    const plant *p = to->e->p;
    const bool with_rows = keeps_rows(p);
    if (p->after.pivot_count > 0) {
        add_member(to, "iso_nearness nearness", NULL, 2 * sizeof(uint32_t));
    }
    if (has_events(p->m)) {
        add_member(to, "iso_event_counts event_counts", NULL, 2 * sizeof(uint32_t));
    }
    if (p->rests.turn_count > 0) {
        add_member(to,
                   form(to->e, "%s turns[%d]", to->e->names->has_lanes ? "iso_turns" : "int32_t", p->rests.turn_count),
                   "of the continuous joints", (size_t)p->rests.turn_count * sizeof(int32_t));
    }
    if (to->bytes % sizeof(uint64_t) != 0 && (p->is_double || with_rows)) {
        add_member(to, "uint32_t unused", "no byte of the memory is without a name", sizeof(uint32_t));
    }
    if (with_rows) {
        add_member(to, "uint64_t row", "that the tick ends with; after it that which has begun", sizeof(uint64_t));
    }
    if (p->m->parameters.change_count > 0) {
        add_member(to, "uint64_t next_change", "in the table of what is set at times", sizeof(uint64_t));
    }
    const period_list periods = periods_of(to->e);
    FOR_EACH (const double, period, periods) {
        add_member(to, form(to->e, "uint32_t in_%.0f", *period), "that number modulo a period", sizeof(uint32_t));
    }
    if (periods.count % 2 != 0) {
        add_member(to, "uint32_t unused_too", "likewise", sizeof(uint32_t));
    }
}

static memory_layout layout_of(const emission *e)
{
    memory_layout all = {.e = e, .real_size = e->p->is_double ? sizeof(double) : sizeof(float)};
    add_moving(&all);
    add_reals(&all, "p", form(e, "$C_PARAMETERS"), (size_t)e->p->m->parameters.count, NULL);
    add_reals(&all, "y", form(e, "$C_OUTPUTS"), (size_t)e->p->outputs.count, NULL);
    add_numbered(&all, "rests", e->p->rests.count, "what rounding has taken from the angles of continuous joints");
    add_progress(&all);
    add_pivots(&all);
    add_events(&all);
    add_last(&all);
    add_rings(&all);
    add_coming(&all);
    add_good(&all);
    add_counts(&all);
    return all;
}

void emit_memory(const emission *e)
{
    const memory_layout all = layout_of(e);
    put(e, "/* All that a plant keeps, without pointers: a copy of it is a snapshot. */\n");
    put(e, "typedef struct $p_memory {\n");
    FOR_EACH (const part, p, all.parts) {
        put(e, p->about == NULL ? "    %s;\n" : "    %s; /* %s */\n", p->declaration, p->about);
    }
    put(e, "} $p_memory;\n\n");
}

size_t memory_place(const emission *e, char array)
{
    const memory_layout all = layout_of(e);
    const char *begin = form(e, "real %c[", array);
    size_t offset = 0;
    for (size_t i = 0; i < all.parts.count && strncmp(all.parts.all[i].declaration, begin, strlen(begin)) != 0; i++) {
        offset += all.parts.all[i].bytes;
    }
    return offset;
}

const char *lane_bytes(const emission *e)
{
    return keeps_rows(e->p) ? form(e, "offsetof($p_memory, row)") : form(e, "sizeof($p_memory)");
}

void emit_memory_check(const emission *e)
{
    put_if(e, e->names->has_lanes, "#ifndef ISO_LANES\n");
    put(e, "_Static_assert(sizeof($p_memory) == %zu,\n    \"%s\");\n%s\n", layout_of(e).bytes,
        "a record of the memory has the same bytes on every target: no padding", e->names->has_lanes ? "#endif\n" : "");
}

#include <string.h>

#include "tools/isoc/emit/parts.h"

/* A list of words, with commas between. A compiler need not take a string of more than 4095 characters: a longer list
 * is an array of characters, which stands before the struct that has it. */
typedef struct word_list {
    const char *field;
    const char *const *words;
    int count;
} word_list;

static bool is_long(const word_list *l)
{
    enum { LONGEST_STRING = 4095 };
    size_t length = 0;
    for (int i = 0; i < l->count; i++) {
        length += strlen(l->words[i]) + 1;
    }
    return length > LONGEST_STRING;
}

static void emit_long_list(emission *e, const word_list *l)
{
    put(e, "static const char %s[] = {\n", l->field);
    for (int i = 0; i < l->count; i++) {
        put(e, "   ");
        for (const char *c = l->words[i]; *c != '\0'; c++) {
            put(e, " '%c',", *c);
        }
        put(e, i + 1 < l->count ? " ',',\n" : " 0,\n};\n\n");
    }
}

static void emit_list(emission *e, const word_list *l)
{
    const bool is_array = is_long(l);
    put(e, "    .%s =%s", l->field, l->count == 0 ? " \"\"" : is_array ? " " : "");
    for (int i = 0; i < l->count && !is_array; i++) {
        put(e, "\n        \"%s%s\"", l->words[i], i + 1 < l->count ? "," : "");
    }
    put(e, "%s,\n", is_array ? l->field : "");
}

/* The names of the states in messages of the guard. */
static const char *const *state_names(emission *e)
{
    const char **names = arena_take(e->out->memory, (size_t)state_count(e->p->m), sizeof *names);
    for (int i = 0; i < state_count(e->p->m); i++) {
        names[i] = e->names->states[i].about.name;
    }
    return names;
}

/* The names of the closures in messages on singular positions. */
static const char *const *closure_names(emission *e)
{
    const mechanism *m = e->p->m;
    const char **names = arena_take(e->out->memory, (size_t)m->closure_count, sizeof *names);
    for (int i = 0; i < m->closure_count; i++) {
        names[i] = m->closures[i].name;
    }
    return names;
}

void emit_model(emission *e)
{
    const plant *p = e->p;
    const mechanism *m = p->m;
    const word_list lists[] = {
        {"state_names", state_names(e), state_count(m)},
        {"output_names", p->outputs.names, p->outputs.count},
        {"output_units", p->outputs.units, p->outputs.count},
        {"closure_names", closure_names(e), m->closure_count},
    };
    const int list_count = p->after.pivot_count > 0 ? 4 : 3;
    FOR_ALL (const word_list, l, lists, list_count) {
        if (is_long(l)) {
            emit_long_list(e, l);
        }
    }
    put(e, "const iso_model $p_model = {\n");
    put(e, "    .name = \"%s\",\n    .method = \"%s\",\n", m->name, method_names[ISO_METHOD_OF(m->method.recipe)]);
    put(e, "    .step_text = \"%s\",\n    .step_size = %s,\n", code_decimal(e->out->memory, m->method.step, true),
        table_literal(e, m->method.step));
    put(e, "    .period_ns = UINT32_C(%.0f),\n    .states = $C_STATES,\n", m->method.step * 1e9);
    put_if(e, m->inputs.count > 0, "    .inputs = $C_INPUTS,\n");
    put(e, "    .outputs = $C_OUTPUTS,\n");
    put_if(e, m->parameters.count > 0, "    .parameters = $C_PARAMETERS,\n");
    FOR_ALL (const word_list, l, lists, list_count) {
        emit_list(e, l);
    }
    put(e, "    .start = start,\n");
    put_if(e, m->effects.memory_count > 0, "    .memories = %d,\n", m->effects.memory_count);
    put_if(e, has_begin(e), "    .begin = begin,\n");
    put_if(e, m->parameters.count > 0, "    .defaults = defaults,\n");
    put_if(e, has_limits(&e->names->x), "    .range = range,\n");
    const char *by_rung = p->reduced_plant_count > 0 ? "_on_rung" : "";
    put(e, "    .memory_bytes = sizeof($p_memory),\n    .output = output%s,\n", by_rung);
    put_if(e, p->violation >= 0, "    .violation = violation,\n    .violation_limit = %s,\n",
           table_literal(e, m->drift.violation_limit));
    put_if(e, is_driven(p), "    .drive = drive,\n");
    put_if(e, m->inputs.count + m->parameters.count > 0, "    .amiss = amiss,\n    .admit = admit,\n");
    put_if(e, sets_rows(p), "    .advance = advance,\n");
    put_if(e, can_restart(p), "    .discontinuity = discontinuity,\n");
    put_if(e, is_primed(p) || e->names->cut != NULL, "    .prime = prime,\n");
    put(e, "    .step = step,\n");
    const bool has_ladder = m->policies.rung_count > 0;
    put_if(e, has_ladder, "    .attempt = attempt,\n");
    put_if(e, !has_ladder && (can_restart(p) || ISO_IS_WATCHED(m->method.recipe)),
           "    .attempt = iso_plant_attempt,\n");
    put_if(e, p->violation >= 0 || p->after.pivot_count > 0 || has_events(m) || ISO_HAS_PROGRESS(m->method.recipe),
           "    .tell = iso_plant_tell,\n");
    put(e, "    .finish = finish%s,\n", by_rung);
    put_if(e, m->policies.any, "    .policy = &policy,\n");
    put(e, "};\n\niso_derivative *const $p_derivative = derivative;\n");
}

void emit_plant(emission *e)
{
    const mechanism *m = e->p->m;
    put(e, "\n/* The plant of the program. */\nstatic $p_memory memory%s;\n\n",
        ISO_IS_WATCHED(m->method.recipe) ? ", before" : "");
    put(e, "const iso_plant iso_the_plant = {\n    .model = &$p_model,\n");
    put(e, "    .memory = &memory,\n    .x = memory.x,\n");
    put_if(e, held_count(m) > 0, "    .u = memory.u,\n");
    put_if(e, m->parameters.count > 0, "    .p = memory.p,\n");
    put(e, "    .y = memory.y,\n");
    if (ISO_IS_VARYING(m->method.recipe)) {
        put(e, "    .progress = &memory.adams.progress,\n    .adams = &memory.adams,\n");
    } else if (ISO_HAS_PROGRESS(m->method.recipe)) {
        put(e, "    .progress = &memory.progress,\n");
    }
    put_if(e, e->p->after.pivot_count > 0, "    .nearness = &memory.nearness,\n");
    put_if(e, has_events(m), "    .event_counts = &memory.event_counts,\n");
    put_if(e, ISO_IS_WATCHED(m->method.recipe), "    .before = &before,\n");
    put_if(e, e->names->has_lanes, "#ifdef ISO_LANES\n    .lane_bytes = %s,\n#endif\n", lane_bytes(e));
    put(e, "    .good = memory.good,\n};\n\niso_derivative *const iso_the_derivative = derivative;\n");
}

#include <string.h>

#include "tools/isoc/emit/parts.h"

/* A list of words, with commas between. A compiler need not take a string of more than 4095 characters: a longer list
 * is an array of characters, which stands before the struct that has it. */
static bool is_long(const char *const *words, int count)
{
    enum { LONGEST_STRING = 4095 };
    size_t length = 0;
    for (int i = 0; i < count; i++) {
        length += strlen(words[i]) + 1;
    }
    return length > LONGEST_STRING;
}

static void emit_long_list(emission *e, const char *field, const char *const *words, int count)
{
    if (!is_long(words, count)) {
        return;
    }
    text_add(e->out, "static const char %s[] = {\n", field);
    for (int i = 0; i < count; i++) {
        text_add(e->out, "   ");
        for (const char *c = words[i]; *c != '\0'; c++) {
            text_add(e->out, " '%c',", *c);
        }
        text_add(e->out, i + 1 < count ? " ',',\n" : " 0,\n};\n\n");
    }
}

static void emit_list(emission *e, const char *field, const char *const *words, int count)
{
    const bool is_array = is_long(words, count);
    text_add(e->out, "    .%s =%s", field, count == 0 ? " \"\"" : is_array ? " " : "");
    for (int i = 0; i < count && !is_array; i++) {
        text_add(e->out, "\n        \"%s%s\"", words[i], i + 1 < count ? "," : "");
    }
    text_add(e->out, "%s,\n", is_array ? field : "");
}

static void add_if(emission *e, bool wanted, const char *line)
{
    text_add(e->out, "%s", wanted ? line : "");
}

/* The names of the states: what the guard calls them. */
static const char *const *state_names(emission *e)
{
    const char **names = arena_take(e->out->memory, (size_t)state_count(e->p->m), sizeof *names);
    for (int i = 0; i < state_count(e->p->m); i++) {
        names[i] = e->names->states[i].about.name;
    }
    return names;
}

/* The names of the closures: what a singular position is near. */
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
    const char *seconds = code_literal(e->out->memory, m->method.step, true); /* R(0.001) */
    const char *capitals = e->names->capitals;
    const char *const *names_of_states = state_names(e);
    emit_long_list(e, "state_names", names_of_states, state_count(m));
    emit_long_list(e, "output_names", p->outputs.names, p->outputs.count);
    emit_long_list(e, "output_units", p->outputs.units, p->outputs.count);
    if (p->after.pivot_count > 0) {
        emit_long_list(e, "closure_names", closure_names(e), m->closure_count);
    }
    text_add(e->out, "const iso_model %s_model = {\n", e->names->prefix);
    text_add(e->out, "    .name = \"%s\",\n    .method = \"%s\",\n", m->name,
             method_names[ISO_METHOD_OF(m->method.recipe)]);
    text_add(e->out, "    .step_text = \"%.*s\",\n    .step_size = %s,\n", (int)strlen(seconds) - 3, seconds + 2,
             code_literal(e->out->memory, m->method.step, p->is_double));
    text_add(e->out, "    .period_ns = UINT32_C(%.0f),\n    .states = %s_STATES,\n", m->method.step * 1e9, capitals);
    add_if(e, m->inputs.count > 0, arena_format(e->out->memory, "    .inputs = %s_INPUTS,\n", capitals));
    text_add(e->out, "    .outputs = %s_OUTPUTS,\n", capitals);
    add_if(e, m->parameters.count > 0, arena_format(e->out->memory, "    .parameters = %s_PARAMETERS,\n", capitals));
    emit_list(e, "state_names", names_of_states, state_count(m));
    emit_list(e, "output_names", p->outputs.names, p->outputs.count);
    emit_list(e, "output_units", p->outputs.units, p->outputs.count);
    if (p->after.pivot_count > 0) {
        emit_list(e, "closure_names", closure_names(e), m->closure_count);
    }
    text_add(e->out, "    .start = start,\n");
    add_if(e, m->effects.memory_count > 0,
           arena_format(e->out->memory, "    .memories = %d,\n", m->effects.memory_count));
    add_if(e, has_begin(e), "    .begin = begin,\n");
    add_if(e, m->parameters.count > 0, "    .defaults = defaults,\n");
    add_if(e, has_range(e), "    .range = range,\n");
    const char *by_rung = p->reduced_plant_count > 0 ? "_on_rung" : "";
    text_add(e->out, "    .memory_bytes = sizeof(%s_memory),\n    .derivative = derivative,\n    .output = output%s,\n",
             e->names->prefix, by_rung);
    if (p->violation >= 0) {
        text_add(e->out, "    .violation = violation,\n    .violation_limit = %s,\n",
                 code_literal(e->out->memory, m->drift.violation_limit, p->is_double));
    }
    add_if(e, is_driven(p), "    .drive = drive,\n");
    add_if(e, m->inputs.count + m->parameters.count > 0, "    .amiss = amiss,\n    .admit = admit,\n");
    add_if(e, sets_rows(p), "    .advance = advance,\n");
    add_if(e, can_restart(p), "    .discontinuity = discontinuity,\n");
    add_if(e, is_primed(p), "    .prime = prime,\n");
    text_add(e->out, "    .step = step,\n");
    const bool has_ladder = m->policies.rung_count > 0;
    add_if(e, has_ladder, "    .attempt = attempt,\n");
    add_if(e, !has_ladder && (can_restart(p) || ISO_IS_WATCHED(m->method.recipe)),
           "    .attempt = iso_plant_attempt,\n");
    add_if(e, p->violation >= 0 || p->after.pivot_count > 0 || ISO_HAS_PROGRESS(m->method.recipe),
           "    .tell = iso_plant_tell,\n");
    text_add(e->out, "    .finish = finish%s,\n", by_rung);
    add_if(e, m->policies.any, "    .policy = &policy,\n");
    text_add(e->out, "};\n");
}

void emit_plant(emission *e)
{
    const mechanism *m = e->p->m;
    text_add(e->out, "\n/* The plant of the program. */\nstatic %s_memory memory%s;\n\n", e->names->prefix,
             ISO_IS_WATCHED(m->method.recipe) ? ", before" : "");
    text_add(e->out, "const iso_plant iso_the_plant = {\n    .model = &%s_model,\n", e->names->prefix);
    text_add(e->out, "    .memory = &memory,\n    .x = memory.x,\n");
    add_if(e, held_count(m) > 0, "    .u = memory.u,\n");
    add_if(e, m->parameters.count > 0, "    .p = memory.p,\n");
    text_add(e->out, "    .y = memory.y,\n");
    if (ISO_IS_VARYING(m->method.recipe)) {
        text_add(e->out, "    .progress = &memory.adams.progress,\n    .adams = &memory.adams,\n");
    } else if (ISO_HAS_PROGRESS(m->method.recipe)) {
        text_add(e->out, "    .progress = &memory.progress,\n");
    }
    add_if(e, e->p->after.pivot_count > 0, "    .nearness = &memory.nearness,\n");
    add_if(e, ISO_IS_WATCHED(m->method.recipe), "    .before = &before,\n");
    text_add(e->out, "    .good = memory.good,\n};\n");
}

#include "tools/isoc/emit/parts.h"

/* The energy as a function of the states; and the function that holds it in a step. */
static void emit_hold_energy(emission *e)
{
    static const char parameters[] = "const real *const x, const real *const u, const real *const p";
    const mechanism *m = e->p->m;
    const code result = code_of(e, numbered(e, "energy", 1), &e->p->energy, 1);
    const char *statements = emit_statements(e, "energy_of", form(e, "real *const energy, %s", parameters), &result);
    put(e, "static real energy_of(%s)\n{\n", parameters);
    emit_unread(e, parameters, statements);
    put(e, "    real energy[1];\n%s    return energy[0];\n}\n\n", statements);
    const char *more =
        form(e, "%s, %s", held_count(m) > 0 ? "memory->u" : "NULL", m->parameters.count > 0 ? "memory->p" : "NULL");
    put(e, "static void hold_energy($p_memory *const memory, const iso_bits near)\n{\n");
    put(e, "    real rest[$C_STATES];\n    memcpy(rest, memory->x, sizeof rest);\n");
    put(e, "    memset(rest + %d, 0, %d * sizeof *rest);\n", m->position_count, m->dof_count);
    put(e, "    iso_hold_energy(&memory->held_energy, near, energy_of(memory->x, %s), energy_of(rest, %s),\n", more,
        more);
    put(e, "                    memory->x + %d, %d);\n}\n\n", m->position_count, m->dof_count);
}

/* The function that puts states right after a step, in place, and sets the pivots of the closures. */
void emit_settle(emission *e)
{
    const settled *after = &e->p->after;
    assignments all = room_for(e->out->memory, after->count + after->pivot_count);
    for (int i = 0; i < after->count; i++) {
        const char *at = e->names->leaves.states[after->states[i]].place;
        assign(&all, after->adds ? form(e, "moved[%d]", i) : form(e, "x[%s]", at), NULL, after->values[i]);
    }
    for (int i = 0; i < after->pivot_count; i++) {
        assign(&all, form(e, "pivots[%d]", i), NULL, after->pivots[i]);
    }
    code result = code_of_assignments(e, &all);
    result.in_place = true;
    result.turns = after->kept_count > 0 ? given_sines(e, "sines[") : NULL;
    if (after->adds) {
        emit_states(e, "settled_states", after->states, after->count);
        put(e, "\n");
    }
    const char *parameters = form(
        e, "real *const x%s%s%s%s", settles_by(e->p, e->g, OP_INPUT) ? ", const real *const u" : "",
        settles_by(e->p, e->g, OP_PARAMETER) ? ", const real *const p" : "",
        after->pivot_count > 0 ? ", real *const pivots" : "", after->kept_count > 0 ? ", const real *const sines" : "");
    const char *statements =
        emit_statements(e, "settle", form(e, "%s, real *const moved, const real *const kept", parameters), &result);
    emit_head(e, "settle", parameters);
    put_if(e, after->adds, "    real moved[%d];\n", after->count);
    put_if(e, after->kept_count > 0, "    const real *const kept = sines + %d;\n", 2 * e->p->angles.count);
    put(e, "%s", statements);
    put_if(e, after->adds, "    iso_method_move(%s, $C_STATES, x, settled_states, moved, %d);\n",
           recipe_symbol(e->out->memory, e->p->m->method.recipe), after->count);
    put(e, "}\n\n");
    if (after->pivot_count > 0) {
        put(e, "static const uint16_t pivot_closures[%d] = {", after->pivot_count);
        for (int i = 0; i < after->pivot_count; i++) {
            put(e, "%s%d", i == 0 ? "" : ", ", after->pivot_closures[i]);
        }
        put(e, "};\n\n");
    }
    if (after->pivot_count > 0 && e->p->m->drift.near_holds) {
        emit_hold_energy(e);
    }
}

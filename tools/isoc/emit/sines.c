/* The derivative in a step of several stages: those after the first take sines and cosines of angles from those of the
 * start (core/methods/explicit.h), so that the derivative is given them. */
#include "tools/isoc/emit/parts.h"

const char *const *given_sines(const emission *e, const char *from)
{
    const plant *p = e->p;
    const char **result = arena_take(e->out->memory, (size_t)state_count(p->m), sizeof *result);
    for (int i = 0; i < p->angles.count; i++) {
        result[p->angles.all[i]] = form(e, "%s%d], %s%d]", from, 2 * i, from, 2 * i + 1);
    }
    return result;
}

const char *sines_parameter(const emission *e)
{
    return e->p->angles.count > 0 ? ",\n    const real *restrict const sines, real *restrict const kept" : "";
}

int prepared_count(const emission *e)
{
    return e->names->cut == NULL ? 0 : 2 * e->p->angles.count + e->names->cut->count;
}

const char *angles_table(const emission *e)
{
    int in_order = 0;
    while (in_order < e->p->angles.count && e->p->angles.all[in_order] == in_order) {
        in_order++;
    }
    return in_order == e->p->angles.count ? "NULL" : form(e, "angles$s");
}

void emit_angles(emission *e)
{
    if (strcmp(angles_table(e), "NULL") != 0) {
        put(e, "/* The angles among the states. */\n");
        emit_states(e, form(e, "angles$s"), e->p->angles.all, e->p->angles.count);
        put(e, "\n");
    }
    if (e->p->angles.spin_count > 0) {
        put(e, "/* Which of the angles may turn far in a step. */\nstatic const bool spins$s[%d] = {",
            e->p->angles.count);
        for (int i = 0; i < e->p->angles.count; i++) {
            put(e, "%s%s", i > 0 ? ", " : "", e->p->angles.spins[i] ? "true" : "false");
        }
        put(e, "};\n\n");
    }
}

void emit_found_sines(const emission *e, const char *x, const char *sines)
{
    put_if(e, e->p->angles.count > 0, "    iso_find_sines(%s, %d, %s, %s);\n", angles_table(e), e->p->angles.count, x,
           sines);
}

/* In a small step gcc inlines it only where this function is declared inline too. */
void emit_derivative_function(emission *e, const char *function, code result)
{
    if (e->p->angles.count == 0) {
        emit_function(e, function, equation_parameters(e, "dx", ""), &result);
        return;
    }
    result.turns = given_sines(e, "sines[");
    emit_angles(e);
    put_if(e, e->p->is_flat, "ISO_INLINE iso_derivative_by_sines %s_by_sines;\n", function);
    emit_function(e, form(e, "%s_by_sines", function), equation_parameters(e, "dx", sines_parameter(e)), &result);
    emit_head(e, function, equation_parameters(e, "dx", ""));
    put(e, "    real sines[%d];\n", 2 * e->p->angles.count);
    emit_found_sines(e, "x", "sines");
    put(e, "    %s_by_sines(dx, x, u, %s, sines, NULL);\n}\n\n", function, held_or_tunables(e));
}

/* The parts of a plant's functions: a head, the arrays that it reads, and statements. */
#include <string.h>

#include "tools/isoc/emit/parts.h"

emission emission_of(const emission *e, const reduced_plant *left)
{
    emission other = *e;
    if (left != NULL) {
        other.p = left->p;
        other.g = left->g;
        other.suffix = left->suffix;
    }
    return other;
}

/* Where values are held (tools/isoc/plant/plant.h), the functions of a step read these in the place of the tunables. */
static bool reads_held(const emission *e)
{
    return e->in_step && e->p->held.count > 0;
}

const char *held_or_tunables(const emission *e)
{
    return reads_held(e) ? "h" : "p";
}

bool code_uses(const emission *e, const code *result, operation op)
{
    return uses_operation(e->g, result->roots, result->count, op);
}

code code_of(const emission *e, const char *const *targets, const node *roots, int count)
{
    return (code){.g = e->g,
                  .names = e->names->leaves,
                  .is_double = e->p->is_double,
                  .targets = targets,
                  .roots = roots,
                  .count = (size_t)count};
}

assignments room_for(arena *memory, int count)
{
    const size_t room = (size_t)count + 1;
    return (assignments){arena_take(memory, room, sizeof(char *)), arena_take(memory, room, sizeof(char *)),
                         arena_take(memory, room, sizeof(node)), 0};
}

void assign(assignments *to, const char *target, const char *quote, node root)
{
    to->targets[to->count] = target;
    to->quotes[to->count] = quote;
    to->roots[to->count++] = root;
}

code code_of_assignments(const emission *e, const assignments *all)
{
    code result = code_of(e, all->targets, all->roots, all->count);
    result.quotes = all->quotes;
    return result;
}

/* array[CART_X_RAIL], ... */
const char *const *places_in(const emission *e, const char *array, const leaf_name *leaves, int count)
{
    const char **targets = arena_take(e->out->memory, (size_t)count + 1, sizeof *targets);
    for (int i = 0; i < count; i++) {
        targets[i] = form(e, "%s[%s]", array, leaves[i].place);
    }
    return targets;
}

const char *const *numbered(const emission *e, const char *array, int count)
{
    const char **targets = arena_take(e->out->memory, (size_t)count + 1, sizeof *targets);
    for (int i = 0; i < count; i++) {
        targets[i] = form(e, "%s[%d]", array, i);
    }
    return targets;
}

void begin_function(const emission *e, const char *head)
{
    put(e, "%s(void *const instance)\n{\n    $p_memory *const memory = instance;\n", head);
}

const char *equation_parameters(const emission *e, const char *array, const char *more)
{
    return form(e,
                "real *restrict const %s, const real *restrict const x,\n    const real *restrict const u, const real "
                "*restrict const %s%s",
                array, held_or_tunables(e), more);
}

void emit_head(const emission *e, const char *function, const char *parameters)
{
    put(e, "static void %s(%s)\n{\n", function, parameters);
}

code derivative_code(const emission *e)
{
    const mechanism *m = e->p->m;
    mark *marks = arena_take(e->out->memory, (size_t)m->closure_count + 1, sizeof *marks);
    for (int i = 0; i < m->closure_count; i++) {
        marks[i] = (mark){m->closures[i].name, source_quote(m->source, m->closures[i].at)};
    }
    const settled *after = &e->p->after;
    const int states = state_count(m), count = states + after->kept_count;
    const char **targets = arena_take(e->out->memory, (size_t)count, sizeof *targets);
    memcpy(targets, places_in(e, "dx", e->names->leaves.states, states), (size_t)states * sizeof *targets);
    for (int i = 0; i < after->kept_count; i++) {
        targets[states + i] = form(e, "kept[%d]", i);
    }
    code result = code_of(e, targets, e->p->held_derivatives, count);
    result.kept = (size_t)after->kept_count;
    result.can_order = true;
    result.zero = "R(-0.0)"; /* x + -0.0 is x for each x, so that compilers leave such a sum out */
    result.quotes_leaves = true;
    result.marks = marks;
    result.mark_count = (size_t)m->closure_count;
    return result;
}

const char array_scope[] = "const real *const x, const real *const u, const real *const p, const real *const dx, "
                           "const iso_progress *const progress";

void emit_arrays(const emission *e, const code *result, const char *derivative)
{
    const mechanism *m = e->p->m;
    const bool derives = code_uses(e, result, OP_DERIVATIVE), u = held_count(m) > 0, p = m->parameters.count > 0;
    put_if(e, derives || code_uses(e, result, OP_STATE), "    const real *const x = memory->x;\n");
    put_if(e, (derives && u) || code_uses(e, result, OP_INPUT), "    const real *const u = memory->u;\n");
    put_if(e, (derives && p) || code_uses(e, result, OP_PARAMETER), "    const real *const p = memory->p;\n");
    put_if(e, derives, "    real dx[$C_STATES];\n    %s$s(dx, x, %s, %s);\n", derivative, u ? "u" : "NULL",
           p ? "p" : "NULL");
    put_if(e, code_uses(e, result, OP_LOCAL_ERROR) || code_uses(e, result, OP_RESIDUAL),
           "    const iso_progress *const progress = %s;\n", progress_of(e->p->m));
}

void emit_states(const emission *e, const char *array, const int *states, int count)
{
    put(e, "static const uint16_t %s[%d] = {", array, count);
    for (int i = 0; i < count; i++) {
        put(e, "%s%s", i == 0 ? "" : ", ", e->names->leaves.states[states[i]].place);
    }
    put(e, "};\n");
}

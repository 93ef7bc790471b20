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

/* Adds the statements; many of them in an order in which few values go to memory and back. */
void emit_code(emission *e, const code *result)
{
    enum { SHORT = 60 };
    const operations n = count_operations(e->g, result->roots, result->count);
    if (result->can_order && n.add + n.mul > SHORT) {
        const code_pieces pieces = code_in_pieces(result, e->out_of_range_value);
        put(e, "%s", code_in_order(&pieces));
    } else {
        code_emit(result, e->out, e->out_of_range_value);
    }
}

void emit_body(emission *e, const code *result)
{
    emit_code(e, result);
    put(e, "}\n\n");
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

void emit_head(emission *e, const char *head, const char *function, const char *array, const char *before,
               const char *more)
{
    put(e, "%sstatic void %s(real *restrict const %s,%s const real *restrict const x,\n", head, function, array,
        before);
    put(e, "    const real *restrict const u, const real *restrict const %s%s)\n{\n", held_or_tunables(e), more);
}

void emit_unread(emission *e, const bool *reads, const char *more)
{
    put_if(e, !reads[OP_STATE], "    (void)x;\n");
    put_if(e, !reads[OP_INPUT], "    (void)u;\n");
    put_if(e, !reads[reads_held(e) ? OP_HELD : OP_PARAMETER], "    (void)%s;\n", held_or_tunables(e));
    put_if(e, strstr(more, "hb") != NULL && !reads[OP_STEP], "    (void)hb;\n");
    put_if(e, strstr(more, "dx") != NULL && !reads[OP_DERIVATIVE], "    (void)dx;\n");
}

/* Adds the statements in parts, one function each, which are called one after the other. */
static void emit_parts(emission *e, const char *function, const char *array, const char *more, code_parts parts)
{
    for (int i = 0; i < parts.count; i++) {
        const code_part *part = &parts.all[i];
        emit_head(e, "ISO_APART ", form(e, "%s_%d", function, i + 1), array, " real *restrict const v,", more);
        put_if(e, strstr(part->body, form(e, "    %s[", array)) == NULL, "    (void)%s;\n", array);
        put_if(e, !part->carries, "    (void)v;\n");
        put_if(e, strstr(more, "sines") != NULL && strstr(part->body, "sines[") == NULL, "    (void)sines;\n");
        put_if(e, strstr(more, "kept") != NULL && strstr(part->body, "kept[") == NULL, "    (void)kept;\n");
        emit_unread(e, part->reads, more);
        put(e, "%s}\n\n", part->body);
    }
    emit_head(e, "", function, array, "", more);
    put(e, "    real v[%d];\n", parts.carried + 1);
    for (int i = 0; i < parts.count; i++) {
        put(e, "    %s_%d(%s, v, x, u, %s%s%s%s);\n", function, i + 1, array, held_or_tunables(e),
            strstr(more, "dx") != NULL ? ", dx" : "", strstr(more, "hb") != NULL ? ", hb" : "",
            strstr(more, "sines") != NULL ? ", sines, kept" : "");
    }
    put(e, "}\n\n");
}

/* A function that fills `array` from x, u and p; `more` are further parameters. A long one is split: the time of gcc
 * -O2 grows with the square of a function's length, and is least for parts of some hundred statements. */
void emit_function(emission *e, const char *function, const char *array, const char *more, const code *result)
{
    enum { LONG = 3000, OF_PART = 250 };
    const operations n = count_operations(e->g, result->roots, result->count);
    if ((size_t)(n.add + n.mul) + result->count > LONG) {
        const code_pieces pieces = code_in_pieces(result, e->out_of_range_value);
        if (pieces.count > LONG) {
            emit_parts(e, function, array, more, code_split(&pieces, OF_PART));
            return;
        }
    }
    bool reads[OPERATIONS] = {false};
    for (reached r = reach(e->g, result->roots, result->count); reach_next(&r);) {
        reads[r.n->op] = true;
    }
    emit_head(e, "", function, array, "", more);
    emit_unread(e, reads, more);
    put_if(e, strstr(more, "kept") != NULL && result->kept == 0, "    (void)kept;\n");
    emit_body(e, result);
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

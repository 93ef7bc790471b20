#include <string.h>

#include "tools/isoc/emit/parts.h"

/* A function that computes a range of the values of h, from an array. */
static void emit_held_function(emission *e, const char *function, const char *array, int first, int end)
{
    code result = code_of(e, numbered(e, "h", end) + first, e->p->held.values + first, end - first);
    result.quotes_leaves = true;
    emit_function(e, form(e, "%s$s", function), form(e, "real *restrict const h, const real *restrict const %s", array),
                  &result);
}

static void emit_hold(emission *e)
{
    const held *h = &e->p->held;
    if (h->tuned > 0) {
        put(e, "/* What follows from tunables alone. */\n");
        emit_held_function(e, "tune", "p", 0, h->tuned);
    }
    if (h->count > h->tuned) {
        put(e, "/* What does not change within a step. */\n");
        emit_held_function(e, "hold", "u", h->tuned, h->count);
    }
}

/* Whether something calls the derivative beside the step: that of the whole plant is public; of a reduced plant,
 * outputs and memories that read accelerations do. */
static bool asks_for_derivative(const emission *e)
{
    const plant *p = e->p;
    bool any = e->suffix[0] == '\0' || uses_operation(e->g, p->outputs.roots, (size_t)p->outputs.count, OP_DERIVATIVE);
    for (int i = 0; i < p->m->effects.memory_count; i++) {
        any = any || uses_operation(e->g, &p->m->effects.memories[i].next, 1, OP_DERIVATIVE);
    }
    return any;
}

static void emit_derivative(emission *e)
{
    const code_cut *cut = e->names->cut;
    if (cut != NULL && cut->of_states != NULL) {
        emit_cut_derivative(e);
        return;
    }
    const held *h = &e->p->held;
    const char *function = form(e, "derivative$s");
    emit_hold(e);
    emit_derivative_function(e, form(e, "%s%s", h->count > 0 ? "held_" : "", function), derivative_code(e));
    if (cut != NULL) {
        emit_derivative_at_sines(e);
    }
    if (h->count == 0 || !asks_for_derivative(e)) {
        return;
    }
    emission outside = *e;
    outside.in_step = false;
    emit_head(e, function, equation_parameters(&outside, "dx", ""));
    put(e, "    real h[%d];\n", h->count);
    put(e, h->tuned > 0 ? "    tune$s(h, p);\n" : "    (void)p;\n");
    put_if(e, h->count > h->tuned, "    hold$s(h, u);\n");
    put(e, "    held_%s(dx, x, u, h);\n}\n\n", function);
}

/* dx of the positions alone. */
static void emit_rates(emission *e)
{
    const char *const *targets = places_in(e, "dx", e->names->leaves.states, e->p->rate_count);
    const code result = code_of(e, targets, e->p->held_derivatives, e->p->rate_count);
    emit_function(e, "rates", equation_parameters(e, "dx", ""), &result);
}

/* dx of the states with sub-steps of their own, one after the other. In a small step gcc inlines it into the steps of a
 * ladder only where this function is declared inline too. */
static void emit_fast(emission *e)
{
    const fast_part *fast = &e->p->fast;
    put_if(e, e->p->is_flat, "static inline iso_derivative fast_derivative$s;\n");
    const code result = code_of(e, numbered(e, "dx", fast->count), fast->derivatives, fast->count);
    emit_function(e, form(e, "fast_derivative$s"), equation_parameters(e, "dx", ""), &result);
}

/* A function of the memory that returns one number. */
static void emit_number(emission *e, const char *function, const node *root)
{
    const code result = code_of(e, numbered(e, "number", 1), root, 1);
    const char *statements = emit_statements(e, function, form(e, "real *const number, %s", array_scope), &result);
    put(e, "static real %s(const void *const instance)\n{\n", function);
    put(e, "    const $p_memory *const memory = instance;\n");
    emit_arrays(e, &result, "derivative");
    put(e, "    real number[1];\n%s    return number[0];\n}\n\n", statements);
}

static void emit_numbers(const emission *e, const char *type, const char *array, const int *numbers, int count)
{
    enum { IN_A_LINE = 20 };
    put(e, "static const %s %s[%d] = {", type, array, count);
    for (int i = 0; i < count; i++) {
        put(e, "%s%d,", i % IN_A_LINE == 0 ? "\n    " : " ", numbers[i]);
    }
    put(e, "\n};\n");
}

/* The places of the numbers of L U. */
static void emit_places_of_lu(const emission *e, const extended *x, int states)
{
    put(e, "/* Where the numbers of L U stand. */\n");
    emit_numbers(e, "uint32_t", "lu_row", x->e.row, x->e.count + 1);
    emit_numbers(e, "uint32_t", "lu_beyond", x->e.beyond, x->e.count);
    emit_numbers(e, "uint16_t", "lu_column", x->e.column, x->e.nonzeros);
    emit_numbers(e, "uint16_t", "lu_target", x->e.target, x->e.products);
    emit_numbers(e, "uint16_t", "lu_given", x->right_row, states);
    emit_numbers(e, "uint16_t", "lu_found", x->found, states);
    put(e, "static const iso_sparse places = {%d, $C_STATES, lu_row, lu_beyond, lu_column, lu_target,\n", x->e.count);
    put(e, "                                  lu_given, lu_found};\n\n");
}

/* The factors alone. */
static void emit_factor(emission *e)
{
    emit_head(e, "factor", equation_parameters(e, "lu", ", const real hb"));
    put(e, "    real dx[$C_STATES];\n    linearise(lu, x, u, %s, hb, dx);\n}\n\n", held_or_tunables(e));
}

/* The factors, and the derivative, which has most of what they follow from. */
static code linear_code(const emission *e)
{
    const jacobian *j = &e->p->j;
    const int states = state_count(e->p->m), count = j->factor_count + states;
    const char **targets = arena_take(e->out->memory, (size_t)count, sizeof *targets);
    node *roots = arena_take(e->out->memory, (size_t)count, sizeof *roots);
    memcpy(targets, numbered(e, "lu", j->factor_count), (size_t)j->factor_count * sizeof *targets);
    memcpy(targets + j->factor_count, places_in(e, "dx", e->names->leaves.states, states),
           (size_t)states * sizeof *targets);
    memcpy(roots, j->factors, (size_t)j->factor_count * sizeof *roots);
    memcpy(roots + j->factor_count, e->p->held_derivatives, (size_t)states * sizeof *roots);
    code result = code_of(e, targets, roots, count);
    result.can_order = true;
    return result;
}

/* The same by loops over tables. */
static void emit_looped_solver(emission *e)
{
    const jacobian *j = &e->p->j;
    assignments all = room_for(e->out->memory, j->factor_count);
    for (int i = 0; i < j->factor_count; i++) {
        if (!is_zero(e->g, j->factors[i])) {
            assign(&all, form(e, "lu[%d]", i), NULL, j->factors[i]);
        }
    }
    const code entries = code_of_assignments(e, &all);
    emit_places_of_lu(e, j->looped, state_count(e->p->m));
    emit_function(e, "entries", equation_parameters(e, "lu", ", const real *restrict const dx, const real hb"),
                  &entries);
    emit_head(e, "linearise", equation_parameters(e, "lu", ", const real hb, real *restrict const dx"));
    put(e, "    derivative(dx, x, u, p);\n");
    put(e, "    memset(lu, 0, %d * sizeof *lu);\n    entries(lu, x, u, p, dx, hb);\n", j->factor_count);
    put(e, "    iso_sparse_factor(&places, lu);\n}\n\n");
    emit_factor(e);
    put(e, "static void solve(real *restrict const d, const real *restrict const lu)\n{\n");
    put(e, "    real work[%d];\n    iso_sparse_solve(&places, d, lu, work);\n}\n\n", j->looped->e.count);
}

/* The factors that an implicit method solves with. */
static void emit_solver(emission *e)
{
    const jacobian *j = &e->p->j;
    if (j->looped != NULL) {
        emit_looped_solver(e);
        return;
    }
    const int states = state_count(e->p->m);
    const code factors = linear_code(e);
    code solution = code_of(e, places_in(e, "d", e->names->leaves.states, states), j->solution, states);
    solution.in_place = true;
    emit_function(e, "linearise", equation_parameters(e, "lu", ", const real hb, real *restrict const dx"), &factors);
    emit_factor(e);
    emit_function(e, "solve", "real *restrict const d, const real *restrict const lu", &solution);
}

/* Behind memory->good: where the tunables stand. */
static const char *good_inputs(const emission *e)
{
    const bool has_inputs = e->p->m->inputs.count > 0;
    return has_inputs ? form(e, " + $C_INPUTS") : "";
}

/* The function that asks whether an input or a tunable is to be put right, or to be kept. */
static void emit_amiss(emission *e)
{
    const mechanism *m = e->p->m;
    put(e, "/* What comes in from outside is finite, and within its limits. */\n");
    put(e, "static iso_bits amiss(const void *const instance)\n{\n");
    put(e, "    const $p_memory *const memory = instance;\n    return");
    put_if(e, m->inputs.count > 0, " iso_any_amiss(memory->u, %s, $C_INPUTS)%s",
           has_limits(&e->names->u) ? "input_limits" : "NULL", m->parameters.count > 0 ? " |\n          " : "");
    put_if(e, m->parameters.count > 0, " iso_any_changed(memory->p, memory->good%s, $C_PARAMETERS)", good_inputs(e));
    put(e, ";\n}\n\n");
}

/* The calls for inputs and for tunables, and their results as one number. */
static void emit_refused(emission *e, const char *good_parameters, const char *changed)
{
    const mechanism *m = e->p->m;
    const bool lanes = e->names->has_lanes, both = m->inputs.count > 0 && m->parameters.count > 0;
    put_if(e, lanes, " iso_pair_of(%s", m->inputs.count > 0 ? "" : "ISO_NOTHING,");
    put_if(e, m->inputs.count > 0, "%siso_admit(memory->u, memory->good, %s, $C_INPUTS, NULL)%s", lanes ? "" : " ",
           has_limits(&e->names->u) ? "input_limits" : "NULL",
           !both   ? ""
           : lanes ? ",\n          "
                   : " |\n          ");
    put_if(e, m->parameters.count > 0, " %siso_admit(memory->p, memory->good%s, %s, $C_PARAMETERS, %s)%s",
           lanes ? "" : "(iso_refused)", good_parameters, has_limits(&e->names->p) ? "parameter_limits" : "NULL",
           changed, lanes ? "" : " << 32");
    put_if(e, lanes, "%s)", m->parameters.count > 0 ? "" : ", ISO_NOTHING");
}

/* The function that puts inputs and tunables right, with the limits that the scene gives, and with its conditions. */
static void emit_admit(emission *e)
{
    const char *inputs = good_inputs(e);
    const bool has_conditions = e->p->broken >= 0, watches = watches_parameters(e->p);
    begin_function(e, "static iso_refused admit");
    put_if(e, has_conditions, "    real before[$C_PARAMETERS];\n    memcpy(before, memory->good%s, sizeof before);\n%s",
           inputs, watches ? form(e, "    iso_bits changed = %s;\n", no_bits(e)) : "");
    put(e, has_conditions ? "    const iso_refused refused =" : "    return");
    emit_refused(e, inputs, !watches ? "NULL" : has_conditions ? "&changed" : "&memory->changed");
    put(e, ";\n");
    if (has_conditions) {
        const bool lanes = e->names->has_lanes;
        put(e, "    const iso_bits mask = iso_less(R(0.0), broken(memory));\n%s",
            watches ? "    memory->changed |= changed & ~mask;\n" : "");
        put(e, "    return %s(memory->p, memory->good%s, before,\n",
            lanes ? "iso_pair_more(refused, iso_put_back" : "refused + ((iso_refused)iso_put_back", inputs);
        put(e, "                                                $C_PARAMETERS, mask)%s);\n", lanes ? "" : " << 32");
    }
    put(e, "}\n\n");
}

/* The rest of a tick, with the sizes of this plant: keeps the inputs of the step, which are good; then iso_finish. */
static void emit_finish(emission *e)
{
    const mechanism *m = e->p->m;
    const char *advance = form(e, "advance$s");
    begin_function(e, form(e, "/* Checks what the step made, and sets what follows from it. */\nstatic %s finish$s",
                           e->names->has_lanes ? "iso_count" : "uint32_t"));
    put_if(e, m->inputs.count > 0, "    iso_copy(memory->good, memory->u, $C_INPUTS);\n");
    put_if(e, m->drift.near_stops && e->p->after.pivot_count > 0, "    if (%s;\n    }\n",
           e->names->has_lanes ? "iso_any(memory->nearness.closure)) {\n        return ISO_COUNT(ISO_NEAR)"
                               : "memory->nearness.closure != 0) {\n        return ISO_NEAR");
    put(e, "    return iso_finish(memory, memory->x, %s, $C_STATES, %s, output%s%s$s,\n",
        has_limits(&e->names->x) ? "range" : "NULL", sets_rows(e->p) ? advance : "NULL",
        e->names->cut != NULL ? "_prepared" : "", has_slow_outputs(m) ? "_due" : "");
    put(e, "                      memory->y, memory->good");
    put_if(e, m->inputs.count > 0, " + $C_INPUTS");
    put_if(e, m->parameters.count > 0, " + $C_PARAMETERS");
    put(e, ", $C_OUTPUTS);\n}\n\n");
}

/* The equations without the effects that a ladder drops; functions that no effect changes are those of the whole plant.
 */
static void emit_reduced_functions(emission *e, const reduced_plant *left)
{
    emission other = emission_of(e, left);
    emit_derivative(&other);
    if (other.p->fast.count > 0) {
        emit_fast(&other);
    }
    emit_output(&other);
    if (sets_rows(other.p)) {
        emit_advance(&other);
    }
    if (count_shares(other.p->m) > 0) {
        emit_shares(&other);
    }
    emit_finish(&other);
}

void emit_functions(emission *e)
{
    const plant *p = e->p;
    emit_derivative(e);
    emit_output(e);
    if (has_events(p->m)) {
        emit_events(e);
    }
    if (is_driven(p)) {
        emit_drive(e);
    }
    if (p->broken >= 0) {
        emit_number(e, "broken", &p->broken);
    }
    if (p->m->inputs.count + p->m->parameters.count > 0) {
        emit_amiss(e);
        emit_admit(e);
    }
    if (sets_rows(p)) {
        emit_advance(e);
    }
    if (count_shares(p->m) > 0) {
        emit_shares(e);
    }
    if (has_begin(e)) {
        emit_begin(e);
    }
    emit_finish(e);
    if (ISO_IS_IMPLICIT(p->m->method.recipe)) {
        emit_solver(e);
    }
    if (p->rate_count > 0) {
        emit_rates(e);
    }
    if (p->fast.count > 0) {
        emit_fast(e);
    }
    if (p->after.count > 0) {
        emit_settle(e);
    }
    if (p->violation >= 0) {
        emit_number(e, "violation", &p->violation);
    }
    for (int i = 0; i < p->reduced_plant_count; i++) {
        emit_reduced_functions(e, &p->reduced_plants[i]);
    }
}

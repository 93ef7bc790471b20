#include <math.h>

#include "tools/isoc/emit/parts.h"

/* The limits of a method that varies its step. */
static void emit_adams(emission *e)
{
    const mechanism *m = e->p->m;
    const char *tolerance = literal(e, m->method.tolerance);
    put(e, "static const iso_adams_options options = {\n    .tolerance_absolute = %s,\n", tolerance);
    put(e, "    .tolerance_relative = %s,\n    .budget = %.0f,\n", tolerance, m->method.substeps);
    put(e, "    .driven = %s,\n", held_count(m) + m->parameters.count > 0 ? "true" : "false");
    put(e, "    .level_max = %s,\n};\n\n", m->method.substeps > 1024 ? "ISO_ADAMS_LEVELS" : "ISO_ADAMS_LEVEL_MAX");
}

/* The table of the inputs that a method extrapolates. */
static void emit_smooth(emission *e)
{
    const mechanism *m = e->p->m;
    put(e, "static const bool smooth[%s] = {\n", sampled_size(e));
    for (int i = 0; i < m->inputs.sampled_count; i++) {
        put_if(e, m->inputs.smooth[i], "    [%s] = true,\n", e->names->leaves.inputs[i].place);
    }
    put(e, "};\n\n");
}

/* The nodes that are one number throughout a step: they follow from states whose own derivative is zero, as where a
 * body moves that nothing accelerates. */
static bool *find_steady(const emission *e)
{
    const graph *g = e->g;
    bool *result = arena_take(g->memory, g->count, sizeof *result);
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        const bool is_state = n->op == OP_STATE, keeps = is_state && is_zero(g, e->p->derivatives[n->index]);
        const int operands = operators[n->op].operands;
        result[i] = operands == 0 ? keeps || is_constant(g, (node)i) : result[n->a] && (operands == 1 || result[n->b]);
    }
    return result;
}

/* Lists the states whose derivative is such a number, but no constant of the code; returns whether there are any. */
static bool emit_steady(emission *e)
{
    const bool has_stages = ISO_BY_SINES(e->p->m->method.recipe) && e->p->fast.count == 0;
    const node *derivatives = e->p->derivatives;
    const bool *is_steady = find_steady(e);
    int count = 0;
    for (int i = 0; i < state_count(e->p->m) && has_stages; i++) {
        if (is_steady[derivatives[i]] && !is_constant(e->g, derivatives[i])) {
            put_if(e, count++ == 0,
                   "/* States whose derivative is one number throughout a step. */\nstatic const bool "
                   "steady$s[$C_STATES] = {\n");
            put(e, "    [%s] = true,\n", e->names->leaves.states[i].place);
        }
    }
    put_if(e, count > 0, "};\n\n");
    return count > 0;
}

/* The states with sub-steps of their own. */
static void emit_fast_states(emission *e)
{
    const fast_part *fast = &e->p->fast;
    put(e, "/* States that move in %d sub-steps of a step, and the others that these read. */\n",
        e->p->m->effects.fast_substeps);
    emit_states(e, form(e, "fast_states$s"), fast->states, fast->count);
    if (fast->read_count > 0) {
        emit_states(e, form(e, "fast_reads$s"), fast->reads, fast->read_count);
    }
    put(e, "static const bool is_fast$s[$C_STATES] = {\n");
    for (int i = 0; i < fast->count; i++) {
        put(e, "    [%s] = true,\n", e->names->leaves.states[fast->states[i]].place);
    }
    put(e, "};\nstatic const iso_fast fast$s = {\n    .derivative = fast_derivative$s,\n");
    put(e, "    .states = fast_states$s,\n    .count = %d,\n    .is_fast = is_fast$s,\n", fast->count);
    put_if(e, fast->read_count > 0, "    .reads = fast_reads$s,\n    .read_count = %d,\n", fast->read_count);
    put(e, "    .substeps = %d,\n};\n\n", e->p->m->effects.fast_substeps);
}

/* The functions of the plant as a method takes them. */
static void emit_equations(emission *e)
{
    const plant *p = e->p;
    const bool any_steady = emit_steady(e);
    const char *derivative = form(e, "%sderivative$s", p->held.count > 0 ? "held_" : "");
    put(e, "static const iso_equations equations$s = {\n    .derivative = %s,\n", derivative);
    put_if(e, p->angles.count > 0, "    .by_sines = %s_by_sines,\n", derivative);
    put_if(e, p->angles.count > 0, "    .angles = %s,\n    .angle_count = %d,\n", angles_table(e), p->angles.count);
    put_if(e, p->angles.spin_count > 0, "    .spins = spins$s,\n");
    put_if(e, p->angles.count > 0 && p->angles.unread > 0 && !p->is_flat, "    .unread = %d,\n", p->angles.unread);
    put_if(e, any_steady, "    .steady = steady$s,\n");
    put_if(e, p->after.kept_count > 0, "    .kept = %d,\n", p->after.kept_count);
    put_if(e, ISO_IS_IMPLICIT(p->m->method.recipe),
           "    .linearise = linearise,\n    .factor = factor,\n    .solve = solve,\n    .factors = %d,\n",
           p->j.factor_count);
    put_if(e, p->rate_count > 0, "    .rates = rates,\n    .positions = %d,\n", p->rate_count);
    put_if(e, e->names->cut != NULL, "    .prepared = derivative_prepared,\n");
    if (ISO_IS_SMOOTH(p->m->method.recipe)) {
        put(e, "    .held = %s,\n    .inputs = %s,\n    .smooth = smooth,\n", held_size(e), sampled_size(e));
        put_if(e, p->is_curved, "    .curved = true,\n");
    }
    put(e, "%s};\n\n", ISO_IS_VARYING(p->m->method.recipe) ? "    .adams = &options,\n" : "");
    if (p->fast.count > 0) {
        emit_fast_states(e);
    }
}

/* Whether there is something that discontinuity() compares with. */
static bool remembers(const plant *p)
{
    return watches_inputs(p->m) || watches_parameters(p);
}

/* The inputs that discontinuity() compares with; and that no parameter has changed since. */
static void emit_remember(emission *e)
{
    put(e, "static void remember($p_memory *const memory)\n{\n");
    put_if(e, watches_inputs(e->p->m), "    memcpy(memory->last_u, memory->u, sizeof memory->last_u);\n");
    put_if(e, watches_parameters(e->p), "    memory->changed = %s;\n", no_bits(e));
    put(e, "}\n\n");
}

/* Causes of a restart of the method: an input that changed by more than its jump in a tick, or that has an edge there,
 * or a parameter that changed. */
static void emit_discontinuity(emission *e)
{
    const mechanism *m = e->p->m;
    const bool lanes = e->names->has_lanes;
    begin_function(e, lanes ? "static iso_flag discontinuity" : "static bool discontinuity");
    put(e, "    %s;\n", lanes ? "iso_flag found = iso_is_set(ISO_NOTHING)" : "bool found = false");
    for (int i = 0; i < m->inputs.count && watches_inputs(m); i++) {
        if (m->inputs.jumps[i] > 0.0) {
            const char *at = e->names->leaves.inputs[i].place;
            const char *moved = form(e, "iso_abs(memory->u[%s] - memory->last_u[%s])", at, at);
            put(e, lanes ? "    found |= iso_is_larger(%s, %s);\n" : "    found |= %s > %s;\n", moved,
                literal(e, m->inputs.jumps[i]));
        }
    }
    put_if(e, watches_parameters(e->p), "    found |= %s;\n",
           lanes ? "iso_is_set(memory->changed)" : "memory->changed != 0");
    put_if(e, watches_edges(m), "    found |= %s;\n", lanes ? "iso_is_set(memory->edge)" : "memory->edge != 0");
    put(e, "%s    return found;\n}\n\n", remembers(e->p) ? "    remember(memory);\n" : "");
}

static const char *array_or_null(int count, const char *array)
{
    return count > 0 ? array : "NULL";
}

/* The recipe of a step, whose states may be corrected after it, and then prepared for the next one. */
static unsigned step_recipe(const emission *e)
{
    return e->p->m->method.recipe | (e->p->after.count > 0 ? ISO_SETTLED : 0U) |
           (e->names->cut != NULL ? ISO_PREPARED : 0U);
}

/* Computes the values that do not change in a step; returns the array that has them, or the tunables. */
static const char *emit_held(emission *e)
{
    const held *h = &e->p->held;
    const char *kept = h->tuned > 0 ? form(e, "memory->h$s") : "h";
    put(e, "%s", h->count > 0 && h->tuned == 0 ? form(e, "    real h[%d];\n", h->count) : "");
    put_if(e, h->count > h->tuned, "    hold$s(%s, memory->u);\n", kept);
    return h->count > 0 ? kept : array_or_null(e->p->m->parameters.count, "memory->p");
}

/* The call of iso_method_step or iso_method_prime, with its arguments. */
static void emit_call(emission *e, const char *function, const char *size, bool is_step)
{
    const mechanism *m = e->p->m;
    const char *recipe = recipe_symbol(e->out->memory, step_recipe(e));
    const bool by_sines = ISO_BY_SINES(m->method.recipe) && e->p->angles.count > 0;
    put(e, "    real work[%s(%s, $C_STATES)%s%s];\n", size, recipe,
        ISO_IS_SMOOTH(m->method.recipe) ? form(e, " + %s", held_size(e)) : "",
        by_sines ? form(e, " + ISO_METHOD_SINES(%s, %d, %d)", recipe, e->p->angles.count, e->p->after.kept_count) : "");
    put_if(e, ISO_IS_IMPLICIT(m->method.recipe), "    real lu[%d];\n", e->p->j.factor_count);
    const char *parameters = emit_held(e);
    put(e, "    %s(%s, $C_STATES, &equations$s, %s, memory->x, %s, %s, %s, work,\n", function, recipe,
        literal(e, method_step(m)), array_or_null(held_count(m), "memory->u"), parameters,
        ISO_IS_IMPLICIT(m->method.recipe) ? "lu" : "NULL");
    put(e, "                    %s);\n", progress_of(m));
    if (has_events(m) && is_step) {
        emit_event_step(e, recipe, parameters);
    }
}

/* The call of iso_multirate_step. */
static void emit_multirate_call(emission *e)
{
    const mechanism *m = e->p->m;
    const char *recipe = recipe_symbol(e->out->memory, m->method.recipe);
    put(e, "    real work[ISO_MULTIRATE_WORK(%s, $C_STATES, %d, %d)];\n", recipe, e->p->fast.count,
        e->p->fast.read_count);
    const char *parameters = emit_held(e);
    put(e, "    iso_multirate_step(%s, $C_STATES, &equations$s, &fast$s, %s, memory->x, %s, %s, work);\n", recipe,
        literal(e, method_step(m)), array_or_null(held_count(m), "memory->u"), parameters);
}

/* Takes or forgets the samples of smooth inputs before a step or a restart. */
static void emit_samples(emission *e, const char *function)
{
    const unsigned recipe = e->p->m->method.recipe;
    put_if(e, ISO_IS_SMOOTH(recipe), "    %s(%s, &equations$s, memory->u);\n", function,
           recipe_symbol(e->out->memory, recipe));
}

static void emit_prime(emission *e)
{
    begin_function(e, "static void prime");
    put_if(e, e->p->held.tuned > 0, "    tune(memory->h, memory->p);\n");
    FOR_ALL (const reduced_plant, left, e->p->reduced_plants, e->p->reduced_plant_count) {
        put_if(e, left->p->held.tuned > 0, "    tune%s(memory->h%s, memory->p);\n", left->suffix, left->suffix);
    }
    emit_samples(e, "iso_method_forget");
    if (ISO_IS_PRIMED(e->p->m->method.recipe)) {
        emit_call(e, "iso_method_prime", "ISO_METHOD_PRIME_WORK", false);
    }
    emit_preparing(e);
    put(e, "%s}\n\n", remembers(e->p) ? "    remember(memory);\n" : "");
}

/* Calls `write` for each angle that is kept within a turn, with its number among these; or for each that has a rest,
 * with its number among these. */
static void for_turns(emission *e, bool with_rest, void (*write)(emission *e, const segment *l, int number))
{
    int number = 0;
    for (int i = 0; i < e->p->m->segment_count; i++) {
        if (with_rest ? e->p->rests.kept[i] : e->p->m->segments[i].continuous) {
            write(e, &e->p->m->segments[i], number++);
        }
    }
}

static const char *state_place(const emission *e, int index)
{
    return e->names->leaves.states[index].place;
}

static const char *speed_place(const emission *e, const segment *l)
{
    return state_place(e, e->p->m->position_count + l->dof);
}

static void emit_before_turn(emission *e, const segment *l, int number)
{
    put(e, "    const iso_turning before_%d = {memory->x[%s], memory->x[%s]};\n", number, state_place(e, l->position),
        speed_place(e, l));
}

/* The whole nanoseconds of the step less the step in the number type of the plant. */
static double step_rest(const plant *p)
{
    const double step = method_step(p->m), nanoseconds = floor(step * 1e9 + 0.5);
    return p->is_double ? -fma(step, 1e9, -nanoseconds) / 1e9 : step - (double)(float)step;
}

static void emit_turn(emission *e, const segment *l, int number)
{
    put(e, "    iso_turn(&memory->x[%s], &memory->rests[%d], before_%d, memory->x[%s],\n", state_place(e, l->position),
        number, number, speed_place(e, l));
    put(e, "             %s, %s);\n", literal(e, method_step(e->p->m)), literal(e, step_rest(e->p)));
}

static void emit_take_turns(emission *e, const segment *l, int number)
{
    const bool *has_rest = e->p->rests.kept;
    const long i = l - e->p->m->segments;
    int rest = 0;
    for (long before = 0; before < i; before++) {
        rest += has_rest[before];
    }
    put(e, "    memory->turns[%d] =\n        iso_counted_turns(memory->turns[%d], %s(&memory->x[%s]%s));\n", number,
        number, has_rest[i] ? "iso_take_turns" : "iso_take_whole_turns", state_place(e, l->position),
        has_rest[i] ? form(e, ", &memory->rests[%d]", rest) : "");
}

/* The plant's states are corrected; a local error is that of the corrected states. */
static void emit_settling(emission *e)
{
    const mechanism *m = e->p->m;
    const int pivots = e->p->after.pivot_count;
    const bool keeps = e->p->after.kept_count > 0;
    const char *more = form(e, "%s%s%s%s", settles_by(e->p, e->g, OP_INPUT) ? ", memory->u" : "",
                            settles_by(e->p, e->g, OP_PARAMETER) ? ", memory->p" : "", pivots > 0 ? ", pivots" : "",
                            keeps ? ", sines" : "");
    const char *recipe = recipe_symbol(e->out->memory, step_recipe(e));
    put_if(e, ISO_IS_SETTLED(step_recipe(e)), "    iso_method_settles(%s, $C_STATES, &equations, memory->x, work);\n",
           recipe);
    put_if(e, pivots > 0, "    real pivots[%d];\n", pivots);
    put_if(e, keeps, "    const real *const sines = iso_method_end_sines(&equations, work);\n");
    if (m->drift.projections > 1) {
        put(e, "    for (int i = 0; i < %d; i++) {\n        settle(memory->x%s);\n    }\n", m->drift.projections, more);
    } else {
        put(e, "    settle(memory->x%s);\n", more);
    }
    if (pivots > 0) {
        const char *watch =
            form(e, "iso_watch_pivots(memory->pivots, pivots, pivot_closures, %d, &memory->nearness)", pivots);
        put(e, m->drift.near_holds ? "    hold_energy(memory, %s);\n" : "    (void)%s;\n", watch);
    }
    put_if(e, ISO_IS_SETTLED(step_recipe(e)),
           "    iso_method_settled(%s, $C_STATES, &equations, memory->x, work,\n                       %s);\n", recipe,
           progress_of(m));
}

/* After the method, in a step: angles are put right, then the closures and the norms of quaternions, and whole
 * turns are taken from angles. */
static void emit_after(emission *e)
{
    for_turns(e, true, emit_turn);
    if (e->p->after.count > 0) {
        emit_settling(e);
    }
    for_turns(e, false, emit_take_turns);
    emit_preparing(e);
}

/* An assertion that the header, which does not include the methods, has room for the method's history. */
static void emit_check_of_room(emission *e)
{
    const code_cut *cut = e->names->cut;
    put(e, "_Static_assert(sizeof(($p_memory *)0)->x == %sISO_METHOD_STATE(%s, $C_STATES)%s * sizeof(real),\n",
        cut != NULL ? "(" : "", recipe_symbol(e->out->memory, e->p->m->method.recipe),
        cut != NULL ? form(e, " + %d)", prepared_count(e)) : "");
    put(e, "    \"made for another version of core/methods/method.h\");\n\n");
    if (ISO_IS_SMOOTH(e->p->m->method.recipe)) {
        put(e, "_Static_assert(sizeof(($p_memory *)0)->u == (%s + ISO_METHOD_SAMPLES(%s, %s)) * sizeof(real),\n",
            held_size(e), recipe_symbol(e->out->memory, e->p->m->method.recipe), sampled_size(e));
        put(e, "    \"made for another version of core/methods/inputs.h\");\n\n");
    }
}

/* The function of a step by the method of the plant; `suffix` behind its name. */
static void emit_step_function(emission *e, const char *suffix)
{
    const bool has_parts = e->p->m->method.parts > 1;
    put_if(e, has_parts, "/* A part of a step. */\n");
    begin_function(
        e, form(e, "%sstatic void %s%s", e->p->is_flat ? "ISO_FLAT " : "", has_parts ? "part" : "step", suffix));
    put_if(e, !has_parts && count_shares(e->p->m) > 0, "    find_shares$s(memory);\n");
    for_turns(e, true, emit_before_turn);
    emit_samples(e, "iso_method_sample");
    if (e->p->fast.count > 0) {
        emit_multirate_call(e);
    } else {
        put_if(e, has_events(e->p->m), "    real before[$C_STATES];\n    memcpy(before, memory->x, sizeof before);\n");
        emit_call(e, "iso_method_step", "ISO_METHOD_WORK", true);
    }
    emit_after(e);
    put(e, "}\n\n");
    if (has_parts) {
        put(e, "static void step%s(void *const instance)\n{\n", suffix);
        put_if(e, count_shares(e->p->m) > 0, "    find_shares$s(instance);\n");
        put(e, "    for (int i = 0; i < %d; i++) {\n", e->p->m->method.parts);
        put(e, "        part%s(instance);\n    }\n}\n\n", suffix);
    }
}

/* The step on a rung, by its method and of its reduced plant. Returns the suffix of its name. */
static const char *emit_step_of_rung(emission *e, int rung)
{
    const char *suffix = rung_suffix(e->p, rung, e->out->memory);
    emission other = emission_of(e, reduced_plant_on_rung(e->p, rung));
    mechanism by = *other.p->m;
    plant with = *other.p;
    by.method.recipe = rung_recipe(e->p, rung);
    with.m = &by;
    other.p = &with;
    emit_step_function(&other, suffix);
    return suffix;
}

/* Samples of smooth inputs are taken without a step too: those of the ticks before the next one. */
static void emit_rest(emission *e)
{
    put(e, "/* No step: the states stay. */\n");
    if (ISO_IS_SMOOTH(e->p->m->method.recipe)) {
        begin_function(e, "static void rest");
        emit_samples(e, "iso_method_sample");
        put(e, "}\n\n");
    } else {
        put(e, "static void rest(void *const instance)\n{\n    (void)instance;\n}\n\n");
    }
}

/* The steps of a ladder, from the top. */
static void emit_ladder(emission *e)
{
    const policies *how = &e->p->m->policies;
    const char *names = "step", *last = "";
    for (int i = 0; i < how->rung_count; i++) {
        const bool is_rest = how->rungs[i] == ISO_METHODS;
        if (is_rest) {
            emit_rest(e);
        } else {
            last = emit_step_of_rung(e, i);
        }
        names = form(e, "%s, %s%s", names, is_rest ? "rest" : "step", is_rest ? "" : last);
    }
    put(e, "static void (*const ladder[])(void *memory) = {%s};\n\n", names);
}

void emit_step(emission *e)
{
    emit_check_of_room(e);
    emit_memory_check(e);
    if (ISO_IS_SMOOTH(e->p->m->method.recipe)) {
        emit_smooth(e);
    }
    if (ISO_IS_VARYING(e->p->m->method.recipe)) {
        emit_adams(e);
    }
    emit_equations(e);
    for (int i = 0; i < e->p->reduced_plant_count; i++) {
        emission other = emission_of(e, &e->p->reduced_plants[i]);
        emit_equations(&other);
    }
    if (remembers(e->p)) {
        emit_remember(e);
    }
    if (can_restart(e->p)) {
        emit_discontinuity(e);
    }
    if (is_primed(e->p) || e->names->cut != NULL) {
        emit_prime(e);
    }
    emit_step_function(e, "");
    if (e->p->m->policies.rung_count > 0) {
        emit_ladder(e);
    }
}

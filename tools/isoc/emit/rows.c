/* The assignments of a row, in the order of tools/isoc/plant/plant.h. */
#include "tools/isoc/emit/parts.h"

static const char *state_target(const emission *e, int i)
{
    return form(e, "memory->x[%s]", e->names->x.leaves[i].place);
}

static const char *input_target(const emission *e, int i)
{
    return form(e, "memory->u[%s]", e->names->leaves.inputs[i].place);
}

static const char *memory_target(const emission *e, int i)
{
    return input_target(e, e->p->m->inputs.count + i);
}

/* The place in a ring of the value of so many rows ago, once the row has begun. */
static const char *ring_place(const emission *e, int i, double ago)
{
    const unsigned long last = last_of_ring(&e->p->m->effects.memories[i]);
    return last == 0    ? form(e, "memory->past_%d[0]", i)
           : ago == 0.0 ? form(e, "memory->past_%d[memory->row & UINT32_C(%lu)]", i, last)
                        : form(e, "memory->past_%d[(memory->row - UINT32_C(%.0f)) & UINT32_C(%lu)]", i, ago, last);
}

/* --- functions of time --- */

/* The values that the step gets at the begin of a tick; or with `is_row` those that the row shows, where the step gets
 * them too. */
static assignments functions_of_time(const emission *e, bool is_row)
{
    const mechanism *m = e->p->m;
    assignments result = room_for(e->out->memory, m->inputs.count + m->clocks.count);
    for (int i = 0; i < m->inputs.count; i++) {
        const bool is_seen = e->p->rows.sees[i] >= 0, is_again = is_seen && e->p->rows.sees_again[i];
        if (m->inputs.driven[i] && (is_row ? is_seen : !is_seen || is_again)) {
            assign(&result, input_target(e, i), m->inputs.all[i].quote,
                   is_row ? e->p->rows.sees[i] : m->inputs.drives[i]);
        }
    }
    for (int i = 0; i < m->clocks.count && !is_row; i++) {
        assign(&result, state_target(e, m->clocks.first + i), NULL, m->inputs.drives[m->inputs.count + i]);
    }
    return result;
}

/* Inputs that jump by themselves, at any tick. */
static void emit_edges(emission *e)
{
    const mechanism *m = e->p->m;
    const char *const *targets = numbered(e, "now", m->inputs.edge_count);
    const code result = code_of(e, targets, m->inputs.edges, m->inputs.edge_count);
    put(e, "/* What jumps at ticks that are known. */\n");
    emit_function(e, "find_edges", "real *const now, const uint64_t tick", &result);
}

/* What such functions have. */
static const char *tick_scope(const emission *e)
{
    return form(e, "$p_memory *const memory, const uint64_t tick, const real *const p");
}

static void emit_parameters(const emission *e, const code *result)
{
    put_if(e, code_uses(e, result, OP_PARAMETER), "    const real *const p = memory->p;\n");
}

/* The tunables that are set at times. */
static void emit_changes(emission *e)
{
    const parameter_set *all = &e->p->m->parameters;
    put(e, "/* What is set at times. */\nstatic const iso_change changes[] = {\n");
    FOR_ALL (const switching, c, all->changes, all->change_count) {
        put(e, "    {UINT32_C(%.0f), %s, %s},\n", c->tick, e->names->leaves.parameters[c->parameter].place,
            table_literal(e, c->value));
    }
    put(e, "};\n\n");
}

/* These, then the functions of time that outputs and memories read. */
static void emit_seen(emission *e)
{
    const bool any = e->p->m->parameters.change_count > 0;
    const assignments all = functions_of_time(e, true);
    const code result = code_of_assignments(e, &all);
    const char *statements = emit_statements(e, "see", tick_scope(e), &result);
    put(e, "/* What a row shows of the functions of time; the step from there gets it too. */\n");
    put(e, "static void see($p_memory *const memory, const uint64_t tick)\n{\n");
    put_if(e, any,
           "    memory->next_change = iso_set_due(memory->p, changes, %d, (uint32_t)memory->next_change, tick);\n",
           e->p->m->parameters.change_count);
    emit_parameters(e, &result);
    put(e, "%s}\n\n", statements);
}

/* The number of the row, where the plant keeps it; in a tick that does not follow the one before, what that row has. */
static void emit_row_of_tick(const emission *e, const assignments *all)
{
    const int changes = e->p->m->parameters.change_count;
    if (e->p->rows.any) {
        put(e, "    if (memory->row != tick) {\n        memory->row = tick;\n");
        put_if(e, changes > 0, "        memory->next_change = iso_place_of_changes(changes, %d, tick);\n", changes);
        put(e, "        see(memory, tick);\n    }\n");
    } else if (keeps_rows(e->p)) {
        put(e, "    memory->row = tick + 1;\n");
    } else if (!uses_time(e->g, all->roots, (size_t)all->count)) {
        put(e, "    (void)tick;\n");
    }
}

void emit_drive(emission *e)
{
    const mechanism *m = e->p->m;
    const assignments all = functions_of_time(e, false);
    node *drives = arena_take(e->out->memory, (size_t)(m->inputs.count + m->clocks.count) + 1, sizeof *drives);
    int count = 0;
    for (int i = 0; i < m->inputs.count + m->clocks.count; i++) {
        if (i >= m->inputs.count || m->inputs.driven[i]) {
            drives[count++] = m->inputs.drives[i];
        }
    }
    emit_tick_tables(e, drives, (size_t)count);
    if (watches_edges(m)) {
        emit_edges(e);
    }
    if (m->parameters.change_count > 0) {
        emit_changes(e);
    }
    if (e->p->rows.any) {
        emit_seen(e);
    }
    const code result = code_of_assignments(e, &all);
    const char *statements = emit_statements(e, "drive", tick_scope(e), &result);
    put(e, "/* What is a function of time; other inputs stay as they are set. */\n");
    put(e,
        "static void drive(void *const instance, const uint64_t tick)\n{\n    $p_memory *const memory = instance;\n");
    emit_row_of_tick(e, &all);
    emit_parameters(e, &result);
    put(e, "%s", statements);
    if (watches_edges(m)) {
        put(e, "    real now[%d], before[%d];\n    find_edges(now, tick);\n", m->inputs.edge_count,
            m->inputs.edge_count);
        put(e, "    find_edges(before, tick - (tick > 0));\n");
        put(e, "    memory->edge = iso_any_changed(now, before, %d);\n", m->inputs.edge_count);
    }
    put(e, "}\n\n");
}

/* --- memories --- */

/* A part of a row's assignments, as a function of its own below a comment. */
static void emit_part(emission *e, const char *about, const char *function, const assignments *all)
{
    code result = code_of_assignments(e, all);
    result.in_place = true;
    const char *statements =
        emit_statements(e, form(e, "%s$s", function), form(e, "$p_memory *const memory, %s", array_scope), &result);
    begin_function(e, form(e, "/* %s */\nstatic void %s$s", about, function));
    emit_arrays(e, &result, "derivative");
    put(e, "%s}\n\n", statements);
}

/* The samples of a level that are of every so many rows. */
typedef struct sample_group {
    double every;
    int level;
    const char *function;
    assignments all;
} sample_group;

typedef LIST_OF(sample_group) sample_groups;

static sample_group *group_of(const emission *e, sample_groups *all, const char *function, int level, double every)
{
    FOR_EACH (sample_group, group, *all) {
        if (group->level == level && !(group->every < every) && !(group->every > every)) {
            return group;
        }
    }
    const char *called = form(e, "%s_%d_every_%.0f", function, level + 1, every);
    const assignments none = room_for(e->out->memory, e->p->m->effects.memory_count);
    LIST_ADD(e->out->memory, *all, ((sample_group){every, level, called, none}));
    return &all->all[all->count - 1];
}

/* In the order of the levels: those of one read none of it. */
static sample_groups groups_of(const emission *e, const row_order *order, const char *function)
{
    sample_groups result = {0};
    for (int n = 0; n < order->count; n++) {
        const int i = order->all[n] - state_count(e->p->m);
        const effect_quantity *q = &e->p->m->effects.memories[i];
        assign(&group_of(e, &result, function, order->level[n], q->ticks)->all, memory_target(e, i), q->about.quote,
               q->next);
    }
    return result;
}

static void emit_sample_functions(emission *e, const sample_groups *all)
{
    FOR_EACH (const sample_group, group, *all) {
        emit_part(e, "Samples, in a row that these are of.", group->function, &group->all);
    }
}

/* What is not due stays as it is. The branch follows from the number of the row alone. */
static void call_samples(emission *e, const sample_groups *all)
{
    FOR_EACH (const sample_group, group, *all) {
        const bool is_slow = group->every > 1.0;
        put_if(e, is_slow, "    if (is_due_%.0f) {\n    ", group->every);
        put(e, "    %s$s(memory);\n", group->function);
        put_if(e, is_slow, "    }\n");
    }
}

/* Whether the row is one of a rate, of each rate once. */
static void emit_dues(emission *e, const sample_groups *early, const sample_groups *late)
{
    const sample_groups *const both[] = {early, late};
    sample_groups rates = {0};
    for (int k = 0; k < 2; k++) {
        FOR_EACH (const sample_group, group, *both[k]) {
            const size_t before = rates.count;
            (void)group_of(e, &rates, "", 0, group->every);
            put_if(e, rates.count > before && group->every > 1.0,
                   "    const bool is_due_%.0f = iso_tick_modulo(memory->row, UINT32_C(%.0f)) == 0;\n", group->every,
                   group->every);
        }
    }
}

/* The next values of effects' memories; the values in the row of formulas whose past is kept; constant starts that are
 * not zero. */
typedef enum memory_values { NEXT_VALUES, KEPT_VALUES, CONSTANT_STARTS } memory_values;

static void add_memories(const emission *e, memory_values which, assignments *to)
{
    const mechanism *m = e->p->m;
    for (int i = 0; i < m->effects.memory_count; i++) {
        const effect_quantity *q = &m->effects.memories[i];
        const bool is_start = which == CONSTANT_STARTS, is_kept = which == KEPT_VALUES;
        if (is_start ? is_constant(e->g, q->begin) && begins(e, q) : is_kept ? is_late(q) : q->kept == KEPT_NEXT) {
            assign(to, is_kept ? ring_place(e, i, 0.0) : memory_target(e, i), q->about.quote,
                   is_start ? q->begin : q->next);
        }
    }
}

static assignments memories_to(const emission *e, memory_values which)
{
    assignments result = room_for(e->out->memory, e->p->m->effects.memory_count);
    add_memories(e, which, &result);
    return result;
}

/* Memories get the values that were kept in an earlier row. */
static void emit_shifts(emission *e)
{
    const mechanism *m = e->p->m;
    for (int i = 0; i < m->effects.memory_count; i++) {
        put_if(e, is_late(&m->effects.memories[i]), "    %s = %s;\n", memory_target(e, i),
               ring_place(e, i, m->effects.memories[i].ticks));
    }
}

void emit_advance(emission *e)
{
    static const char about[] = "The memories of a row.";
    const row_plan *r = &e->p->rows;
    const assignments nexts = memories_to(e, NEXT_VALUES), kept = memories_to(e, KEPT_VALUES);
    const sample_groups early = groups_of(e, &r->early, "sample_early"), late = groups_of(e, &r->late, "sample");
    const bool is_all = kept.count + r->early.count + r->late.count == 0 && !keeps_rows(e->p);
    if (is_all) {
        emit_part(e, about, "advance", &nexts);
        return;
    }
    emit_sample_functions(e, &early);
    if (nexts.count > 0) {
        emit_part(e, "The memories of effects.", "follow", &nexts);
    }
    emit_sample_functions(e, &late);
    if (kept.count > 0) {
        emit_part(e, "What later rows show.", "keep", &kept);
    }
    begin_function(e, form(e, "/* %s */\nstatic void advance$s", about));
    put_if(e, r->any, "    memory->row++;\n    see(memory, memory->row);\n");
    emit_dues(e, &early, &late);
    emit_shifts(e);
    call_samples(e, &early);
    put_if(e, nexts.count > 0, "    follow$s(memory);\n");
    call_samples(e, &late);
    put_if(e, kept.count > 0, "    keep$s(memory);\n");
    put(e, "}\n\n");
}

void emit_shares(emission *e)
{
    const mechanism *m = e->p->m;
    assignments all = room_for(e->out->memory, m->effects.memory_count);
    for (int i = 0; i < m->effects.memory_count; i++) {
        const effect_quantity *q = &m->effects.memories[i];
        if (q->kept == KEPT_SHARE) {
            assign(&all, memory_target(e, i), q->about.quote, q->next);
        }
    }
    emit_part(e, "Shares of the step from here.", "find_shares", &all);
}

/* --- starts --- */

static assignments starts_of_level(const emission *e, int level)
{
    const mechanism *m = e->p->m;
    const row_order *order = &e->p->rows.starts;
    assignments result = room_for(e->out->memory, order->count);
    for (int n = 0; n < order->count; n++) {
        const int which = order->all[n], i = which - state_count(m);
        const effect_quantity *q = i < 0 ? &m->effects.states[which - m->effects.first_state] : &m->effects.memories[i];
        if (order->level[n] == level) {
            const char *at = i < 0 ? state_target(e, which) : memory_target(e, i);
            assign(&result, at, q->about.quote, q->begin);
        }
    }
    return result;
}

/* Before its first row a ring shows the start; one of a single place is kept at once. */
static void emit_rings(emission *e)
{
    const mechanism *m = e->p->m;
    for (int i = 0; i < m->effects.memory_count; i++) {
        const unsigned long places = last_of_ring(&m->effects.memories[i]) + 1;
        put_if(e, is_late(&m->effects.memories[i]) && begins(e, &m->effects.memories[i]) && places > 1,
               "    for (uint32_t i = 0; i < %lu; i++) {\n        memory->past_%d[i] = %s;\n    }\n", places, i,
               memory_target(e, i));
    }
}

/* The values that inputs have until they are set, also as the last good ones. */
static void add_values(const emission *e, assignments *to)
{
    const input_set *all = &e->p->m->inputs;
    for (int i = 0; i < all->count; i++) {
        if (has_value(e, i)) {
            assign(to, input_target(e, i), all->all[i].quote, all->drives[i]);
            assign(to, form(e, "memory->good[%s]", e->names->leaves.inputs[i].place), NULL, all->drives[i]);
        }
    }
}

void emit_begin(emission *e)
{
    assignments constants = room_for(e->out->memory, e->p->m->effects.memory_count + 2 * e->p->m->inputs.count);
    add_values(e, &constants);
    add_memories(e, CONSTANT_STARTS, &constants);
    const int levels = e->p->rows.starts.levels;
    for (int level = 0; level < levels; level++) {
        const assignments a = starts_of_level(e, level);
        emit_part(e, "Starts, each after what it follows from.", form(e, "begin_%d", level + 1), &a);
    }
    const code result = code_of_assignments(e, &constants);
    const char *statements = emit_statements(e, "begin", form(e, "$p_memory *const memory"), &result);
    begin_function(e, "/* What row 0 has besides constants of states, and zeros. */\nstatic void begin");
    if (e->p->rows.any) {
        put(e, "    see(memory, 0);\n");
    } else if (keeps_rows(e->p)) {
        put(e, "    memory->row = 0;\n");
    }
    put(e, "%s", statements);
    for (int level = 0; level < levels; level++) {
        put(e, "    begin_%d(memory);\n", level + 1);
    }
    emit_rings(e);
    put_if(e, memories_to(e, KEPT_VALUES).count > 0, "    keep(memory);\n");
    emit_event_begin(e);
    put_if(e, e->names->is_checked,
           "    /* A build with other bits has no start: each tick ends at the guard. */\n"
           "    memory->x[%s] = iso_if_bits_are_kept(memory->x[%s]);\n",
           e->names->leaves.states[0].place, e->names->leaves.states[0].place);
    put(e, "}\n\n");
}

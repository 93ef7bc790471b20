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

/* The values that the step gets at the begin of a tick; or with `is_row` those that each row shows, where the step gets
 * them too. */
static assignments functions_of_time(const emission *e, bool is_row)
{
    const mechanism *m = e->p->m;
    assignments result = room_for(e->out->memory, m->inputs.count + m->clocks.count);
    for (int i = 0; i < m->inputs.count; i++) {
        const bool is_seen = e->p->rows.sees[i] >= 0, is_again = is_seen && e->p->rows.sees_again[i];
        const bool is_slow_row = is_row && is_slow(e->p->rows.sees_at[i]);
        if (m->inputs.driven[i] && (is_row ? is_seen && !is_slow_row : !is_seen || is_again)) {
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

/* The functions of time that only rows of the rate of this one read, from this one on; those that are done count no
 * more.
 */
static assignments slow_functions_of_time(const emission *e, int first, bool *is_done)
{
    const mechanism *m = e->p->m;
    const row_rate rate = e->p->rows.sees_at[first];
    assignments all = room_for(e->out->memory, m->inputs.count);
    for (int i = first; i < m->inputs.count && is_slow(rate); i++) {
        if (!is_done[i] && e->p->rows.sees[i] >= 0 && is_same_rate(e->p->rows.sees_at[i], rate)) {
            is_done[i] = true;
            assign(&all, input_target(e, i), m->inputs.all[i].quote, e->p->rows.sees[i]);
        }
    }
    return all;
}

/* A function for each of these rates. Returns the calls. */
static const char *emit_slow_functions_of_time(emission *e)
{
    const int inputs = e->p->m->inputs.count;
    bool *is_done = arena_take(e->out->memory, (size_t)inputs + 1, sizeof *is_done);
    const char *calls = "";
    for (int first = 0; first < inputs; first++) {
        const row_rate rate = e->p->rows.sees_at[first];
        const assignments all = slow_functions_of_time(e, first, is_done);
        if (all.count == 0) {
            continue;
        }
        const code result = code_of_assignments(e, &all);
        const char *called = form(e, "see_%s", rate_words(e->out->memory, rate));
        const char *statements = emit_statements(e, called, tick_scope(e), &result);
        put(e, "/* The same in row 0, and in the rows of a rate. */\n");
        put(e, "static void %s($p_memory *const memory, const uint64_t tick)\n{\n", called);
        emit_parameters(e, &result);
        put(e, "%s}\n\n", statements);
        calls = form(e, "%s    if (tick == 0 || %s) {\n        %s(memory, tick);\n    }\n", calls,
                     due_condition(e, rate), called);
    }
    return calls;
}

/* These, then the functions of time that outputs and memories read. */
static void emit_seen(emission *e)
{
    const bool any = e->p->m->parameters.change_count > 0;
    const assignments all = functions_of_time(e, true);
    const code result = code_of_assignments(e, &all);
    const char *slow = emit_slow_functions_of_time(e);
    const char *statements = emit_statements(e, "see", tick_scope(e), &result);
    put(e, "/* What a row shows of the functions of time; the step from there gets it too. */\n");
    put(e, "static void see($p_memory *const memory, const uint64_t tick)\n{\n");
    put_if(e, any,
           "    memory->next_change = iso_set_due(memory->p, changes, %d, (uint32_t)memory->next_change, tick);\n",
           e->p->m->parameters.change_count);
    emit_parameters(e, &result);
    put(e, "%s%s}\n\n", statements, slow);
}

/* The number of the row, where the plant keeps it; in a tick that does not follow the one before, what that row has. */
static void emit_row_of_tick(const emission *e, const assignments *all)
{
    const int changes = e->p->m->parameters.change_count;
    if (counts_rows(e->p)) {
        put(e, "    if (memory->row != tick) {\n");
        emit_row(e, "        ", "tick");
        put_if(e, changes > 0, "        memory->next_change = iso_place_of_changes(changes, %d, tick);\n", changes);
        put_if(e, e->p->rows.any, "        see(memory, tick);\n");
        put(e, "    }\n");
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

/* What is set in the rows of a rate: by a function of its own, which is called in these. Samples are in the order of
 * their levels. */
typedef struct row_group {
    row_rate rate;
    int level;
    const char *function;
    assignments all;
} row_group;

typedef LIST_OF(row_group) row_groups;

static row_group *group_of(const emission *e, row_groups *all, const char *function, int level, row_rate rate)
{
    FOR_EACH (row_group, group, *all) {
        if (group->level == level && is_same_rate(group->rate, rate)) {
            return group;
        }
    }
    const char *called = form(e, "%s_%s", function, rate_words(e->out->memory, rate));
    const assignments none = room_for(e->out->memory, e->p->m->effects.memory_count + e->p->m->inputs.count);
    LIST_ADD(e->out->memory, *all, ((row_group){rate, level, called, none}));
    return &all->all[all->count - 1];
}

/* In the order of the levels: those of one read none of it. */
static row_groups samples_of(const emission *e, const row_order *order, const char *function)
{
    row_groups result = {0};
    for (int n = 0; n < order->count; n++) {
        const int i = order->all[n] - state_count(e->p->m), level = order->level[n];
        const effect_quantity *q = &e->p->m->effects.memories[i];
        row_group *to = group_of(e, &result, form(e, "%s_%d", function, level + 1), level, q->rate);
        assign(&to->all, memory_target(e, i), q->about.quote, q->next);
    }
    return result;
}

static void emit_group_functions(emission *e, const char *about, const row_groups *all)
{
    FOR_EACH (const row_group, group, *all) {
        emit_part(e, about, group->function, &group->all);
    }
}

/* Whether a memory of a rate reads other memories of that rate alone, and nobody needs its value before. */
static bool is_apart(const emission *e, int memory)
{
    const mechanism *m = e->p->m;
    const effect_quantity *q = &m->effects.memories[memory];
    bool is = e->p->rows.coming[memory] < 0;
    for (int n = 0; n < e->p->rows.early.count; n++) {
        is = is && e->p->rows.early.all[n] != state_count(m) + memory;
    }
    for (reached r = reach(e->g, &q->next, 1); reach_next(&r);) {
        const int other = r.n->op == OP_INPUT ? r.n->index - m->inputs.count : -1;
        is = is && r.n->op != OP_DERIVATIVE && (other < 0 || is_same_rate(m->effects.memories[other].rate, q->rate));
    }
    return is;
}

/* Whether all memories of a slow rate are such: then one look at the row is enough for all of them. */
static bool is_closed(const emission *e, row_rate rate)
{
    const mechanism *m = e->p->m;
    bool is = is_slow(rate);
    for (int i = 0; i < m->effects.memory_count && is; i++) {
        is = !is_same_rate(m->effects.memories[i].rate, rate) || is_apart(e, i);
    }
    return is;
}

/* The calls for rates that are not closed; what is not due stays as it is. */
static void call_groups(emission *e, const row_groups *all)
{
    FOR_EACH (const row_group, group, *all) {
        if (!is_closed(e, group->rate)) {
            put_when_due(e, group->rate, form(e, "%s$s(memory);", group->function));
        }
    }
}

/* The next values of effects' memories; the values in the row of formulas whose past is kept; constant starts that are
 * not zero. */
typedef enum memory_values { NEXT_VALUES, KEPT_VALUES, CONSTANT_STARTS } memory_values;

/* Whether a memory has such a value, in each row or in those of a rate. */
static bool has_one(const emission *e, const effect_quantity *q, memory_values which)
{
    return which == CONSTANT_STARTS ? is_constant(e->g, q->begin) && begins(e, q)
           : which == KEPT_VALUES   ? is_late(q)
                                    : q->kept == KEPT_NEXT;
}

static void add_memory(const emission *e, memory_values which, int i, assignments *to)
{
    const effect_quantity *q = &e->p->m->effects.memories[i];
    const int coming = e->p->rows.coming[i];
    const char *target = which == KEPT_VALUES                  ? ring_place(e, i, 0.0)
                         : which == NEXT_VALUES && coming >= 0 ? form(e, "memory->coming[%d]", coming)
                                                               : memory_target(e, i);
    assign(to, target, q->about.quote, which == CONSTANT_STARTS ? q->begin : q->next);
}

/* Those of each row; starts of all. */
static assignments memories_to(const emission *e, memory_values which)
{
    const effect_set *all = &e->p->m->effects;
    assignments result = room_for(e->out->memory, all->memory_count);
    for (int i = 0; i < all->memory_count; i++) {
        const bool is_of_row = which == CONSTANT_STARTS || !is_slow(all->memories[i].rate);
        if (is_of_row && has_one(e, &all->memories[i], which)) {
            add_memory(e, which, i, &result);
        }
    }
    return result;
}

/* Those of slower rates. */
static row_groups slow_memories_to(const emission *e, memory_values which, const char *function)
{
    const effect_set *all = &e->p->m->effects;
    row_groups result = {0};
    for (int i = 0; i < all->memory_count; i++) {
        if (is_slow(all->memories[i].rate) && has_one(e, &all->memories[i], which)) {
            add_memory(e, which, i, &group_of(e, &result, function, 0, all->memories[i].rate)->all);
        }
    }
    return result;
}

/* A memory gets the value that was kept in an earlier row. */
static const char *shift_of(const emission *e, int i)
{
    return form(e, "%s = %s;", memory_target(e, i), ring_place(e, i, e->p->m->effects.memories[i].ticks));
}

static void emit_shifts(emission *e)
{
    const mechanism *m = e->p->m;
    for (int i = 0; i < m->effects.memory_count; i++) {
        const effect_quantity *q = &m->effects.memories[i];
        if (is_late(q) && !is_closed(e, q->rate)) {
            put_when_due(e, q->rate, shift_of(e, i));
        }
    }
}

/* All that a row does for a closed rate, below one look at its number. */
static void emit_closed(emission *e, row_rate rate, const row_groups *const *calls, size_t count)
{
    const mechanism *m = e->p->m;
    put(e, "    if (%s) {\n", due_condition(e, rate));
    for (int i = 0; i < m->effects.memory_count; i++) {
        const effect_quantity *q = &m->effects.memories[i];
        put_if(e, is_late(q) && is_same_rate(q->rate, rate), "        %s\n", shift_of(e, i));
    }
    for (size_t k = 0; k < count; k++) {
        FOR_EACH (const row_group, group, *calls[k]) {
            put_if(e, is_same_rate(group->rate, rate), "        %s$s(memory);\n", group->function);
        }
    }
    put(e, "    }\n");
}

/* The closed rates, each once. */
static void emit_closed_rates(emission *e, const row_groups *const *calls, size_t count)
{
    row_groups done = {0};
    for (size_t k = 0; k < count; k++) {
        FOR_EACH (const row_group, group, *calls[k]) {
            const size_t before = done.count;
            (void)group_of(e, &done, "", 0, group->rate);
            if (done.count > before && is_closed(e, group->rate)) {
                emit_closed(e, group->rate, calls, count);
            }
        }
    }
}

/* Memories of slow rates get the next values that waited. */
static void emit_coming(emission *e)
{
    const mechanism *m = e->p->m;
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (e->p->rows.coming[i] >= 0) {
            put_when_due(e, m->effects.memories[i].rate,
                         form(e, "%s = memory->coming[%d];", memory_target(e, i), e->p->rows.coming[i]));
        }
    }
}

void emit_advance(emission *e)
{
    static const char about[] = "The memories of a row.", of_samples[] = "Samples, in a row that these are of.";
    const row_plan *r = &e->p->rows;
    const assignments nexts = memories_to(e, NEXT_VALUES), kept = memories_to(e, KEPT_VALUES);
    const row_groups early = samples_of(e, &r->early, "sample_early"), late = samples_of(e, &r->late, "sample");
    const row_groups slow = slow_memories_to(e, NEXT_VALUES, "follow"),
                     slow_kept = slow_memories_to(e, KEPT_VALUES, "keep");
    const bool is_all = kept.count + r->early.count + r->late.count == 0 && !keeps_rows(e->p);
    if (is_all) {
        emit_part(e, about, "advance", &nexts);
        return;
    }
    emit_group_functions(e, of_samples, &early);
    emit_group_functions(e, "Memories of effects, in a row of their rate.", &slow);
    if (nexts.count > 0) {
        emit_part(e, "The memories of effects.", "follow", &nexts);
    }
    emit_group_functions(e, of_samples, &late);
    if (kept.count > 0) {
        emit_part(e, "What later rows show.", "keep", &kept);
    }
    emit_group_functions(e, "What later rows of their rate show.", &slow_kept);
    begin_function(e, form(e, "/* %s */\nstatic void advance$s", about));
    if (counts_rows(e->p)) {
        emit_next_row(e);
    }
    put_if(e, r->any, "    see(memory, memory->row);\n");
    const row_groups *const calls[] = {&slow, &late, &slow_kept};
    emit_shifts(e);
    call_groups(e, &early);
    emit_closed_rates(e, calls, COUNT_OF(calls));
    call_groups(e, &slow);
    put_if(e, nexts.count > 0, "    follow$s(memory);\n");
    emit_coming(e);
    call_groups(e, &late);
    put_if(e, kept.count > 0, "    keep$s(memory);\n");
    call_groups(e, &slow_kept);
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
    FOR_ALL (const effect_quantity, q, e->p->m->effects.memories, e->p->m->effects.memory_count) {
        if (has_one(e, q, CONSTANT_STARTS)) {
            add_memory(e, CONSTANT_STARTS, (int)(q - e->p->m->effects.memories), &constants);
        }
    }
    const int levels = e->p->rows.starts.levels;
    for (int level = 0; level < levels; level++) {
        const assignments a = starts_of_level(e, level);
        emit_part(e, "Starts, each after what it follows from.", form(e, "begin_%d", level + 1), &a);
    }
    const code result = code_of_assignments(e, &constants);
    const char *statements = emit_statements(e, "begin", form(e, "$p_memory *const memory"), &result);
    begin_function(e, "/* What row 0 has besides constants of states, and zeros. */\nstatic void begin");
    if (keeps_rows(e->p) && periods_of(e).count + !e->p->rows.any > 0) {
        emit_row(e, "    ", "0");
    }
    put_if(e, e->p->rows.any, "    see(memory, 0);\n");
    put(e, "%s", statements);
    for (int level = 0; level < levels; level++) {
        put(e, "    begin_%d(memory);\n", level + 1);
    }
    emit_rings(e);
    put_if(e, memories_to(e, KEPT_VALUES).count > 0, "    keep(memory);\n");
    const row_groups slow_kept = slow_memories_to(e, KEPT_VALUES, "keep");
    FOR_EACH (const row_group, group, slow_kept) {
        put(e, "    %s(memory);\n", group->function);
    }
    emit_event_begin(e);
    put_if(e, e->names->is_checked,
           "    /* A build with other bits has no start: each tick ends at the guard. */\n"
           "    memory->x[%s] = iso_if_bits_are_kept(memory->x[%s]);\n",
           e->names->leaves.states[0].place, e->names->leaves.states[0].place);
    put(e, "}\n\n");
}

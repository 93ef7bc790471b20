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

/* The tunables that are set at times, then the functions of time that outputs and memories read. */
static void emit_seen(emission *e)
{
    const mechanism *m = e->p->m;
    const assignments all = functions_of_time(e, true);
    const code result = code_of_assignments(e, &all);
    const char *statements = emit_statements(e, "see", tick_scope(e), &result);
    put(e, "/* What a row shows of the functions of time; the step from there gets it too. */\n");
    put(e, "static void see($p_memory *const memory, const uint64_t tick)\n{\n");
    FOR_ALL (const switching, c, m->parameters.changes, m->parameters.change_count) {
        const char *at = e->names->leaves.parameters[c->parameter].place;
        put(e, "    memory->p[%s] =\n        iso_select(%s, %s, memory->p[%s]);\n", at,
            mask_where(e, form(e, "tick == UINT32_C(%.0f)", c->tick)), literal(e, c->value), at);
    }
    emit_parameters(e, &result);
    put(e, "%s}\n\n", statements);
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
    if (e->p->rows.any) {
        emit_seen(e);
    }
    const code result = code_of_assignments(e, &all);
    const char *statements = emit_statements(e, "drive", tick_scope(e), &result);
    put(e, "/* What is a function of time; other inputs stay as they are set. */\n");
    put(e,
        "static void drive(void *const instance, const uint64_t tick)\n{\n    $p_memory *const memory = instance;\n");
    if (e->p->rows.any) {
        put(e, "    if (memory->row != tick) {\n        memory->row = tick;\n        see(memory, tick);\n    }\n");
    } else if (keeps_rows(e->p)) {
        put(e, "    memory->row = tick + 1;\n");
    } else if (!uses_time(e->g, all.roots, (size_t)all.count)) {
        put(e, "    (void)tick;\n");
    }
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

/* Samples of a level: taken where the row is a multiple of their ticks. */
static void emit_samples_of(emission *e, const row_order *order, int level, const char *function)
{
    const mechanism *m = e->p->m;
    assignments all = room_for(e->out->memory, order->count);
    text selections = empty_text(e->out->memory);
    for (int n = 0; n < order->count; n++) {
        const int i = order->all[n] - state_count(m);
        const effect_quantity *q = &m->effects.memories[i];
        if (order->level[n] == level) {
            const char *at = memory_target(e, i);
            const char *due = form(e, "iso_tick_modulo(memory->row, UINT32_C(%.0f)) == 0", q->ticks);
            text_add(&selections, "    %s = iso_select(\n        %s, sampled[%d], %s);\n", at, mask_where(e, due),
                     all.count, at);
            assign(&all, form(e, "sampled[%d]", all.count), q->about.quote, q->next);
        }
    }
    const code result = code_of_assignments(e, &all);
    const char *scope = form(e, "real *const sampled, %s", array_scope);
    const char *statements = emit_statements(e, form(e, "%s$s", function), scope, &result);
    begin_function(e, form(e, "/* Samples, in the rows that these are of. */\nstatic void %s$s", function));
    emit_arrays(e, &result, "derivative");
    put(e, "    real sampled[%d];\n%s%s}\n\n", all.count, statements, selections.bytes);
}

static void emit_samples_of_levels(emission *e, const row_order *order, const char *function)
{
    for (int level = 0; level < order->levels; level++) {
        emit_samples_of(e, order, level, form(e, "%s_%d", function, level + 1));
    }
}

static void call_samples(emission *e, const row_order *order, const char *function)
{
    for (int level = 0; level < order->levels; level++) {
        put(e, "    %s_%d$s(memory);\n", function, level + 1);
    }
}

/* The next values of effects' memories; the values in the row of formulas whose past is kept; constant starts that are
 * not zero. */
typedef enum memory_values { NEXT_VALUES, KEPT_VALUES, CONSTANT_STARTS } memory_values;

static assignments memories_to(const emission *e, memory_values which)
{
    const mechanism *m = e->p->m;
    assignments result = room_for(e->out->memory, m->effects.memory_count);
    for (int i = 0; i < m->effects.memory_count; i++) {
        const effect_quantity *q = &m->effects.memories[i];
        const bool is_start = which == CONSTANT_STARTS, is_kept = which == KEPT_VALUES;
        if (is_start ? is_constant(e->g, q->begin) && begins(e, q) : is_kept ? is_late(q) : q->kept == KEPT_NEXT) {
            assign(&result, is_kept ? ring_place(e, i, 0.0) : memory_target(e, i), q->about.quote,
                   is_start ? q->begin : q->next);
        }
    }
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
    const bool is_all = kept.count + r->early.count + r->late.count == 0 && !keeps_rows(e->p);
    if (is_all) {
        emit_part(e, about, "advance", &nexts);
        return;
    }
    emit_samples_of_levels(e, &r->early, "sample_early");
    if (nexts.count > 0) {
        emit_part(e, "The memories of effects.", "follow", &nexts);
    }
    emit_samples_of_levels(e, &r->late, "sample");
    if (kept.count > 0) {
        emit_part(e, "What later rows show.", "keep", &kept);
    }
    begin_function(e, form(e, "/* %s */\nstatic void advance$s", about));
    put_if(e, r->any, "    memory->row++;\n    see(memory, memory->row);\n");
    emit_shifts(e);
    call_samples(e, &r->early, "sample_early");
    put_if(e, nexts.count > 0, "    follow$s(memory);\n");
    call_samples(e, &r->late, "sample");
    put_if(e, kept.count > 0, "    keep$s(memory);\n");
    put(e, "}\n\n");
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

void emit_begin(emission *e)
{
    const assignments constants = memories_to(e, CONSTANT_STARTS);
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
    put_if(e, e->names->is_checked,
           "    /* A build with other bits has no start: each tick ends at the guard. */\n"
           "    memory->x[%s] = iso_if_bits_are_kept(memory->x[%s]);\n",
           e->names->leaves.states[0].place, e->names->leaves.states[0].place);
    put(e, "}\n\n");
}

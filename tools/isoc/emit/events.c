/* The events of a plant: their functions, what they set, and the table of both for core/methods/event.h. */
#include "core/methods/hold.h"
#include "tools/isoc/emit/parts.h"

/* static const uint16_t ARRAY[COUNT] = {...}; */
static void emit_whole_numbers(emission *e, const char *array, const int *numbers, int count)
{
    put(e, "static const uint16_t %s[%d] = {", array, count);
    for (int i = 0; i < count; i++) {
        put(e, "%s%d", i == 0 ? "" : ", ", numbers[i]);
    }
    put(e, "};\n");
}

/* Of each event its function and its rate. */
static void emit_event_functions(emission *e)
{
    const mechanism *m = e->p->m;
    const char *names = "", *moves = "";
    for (int i = 0; i < m->events.count; i++) {
        const char *function = form(e, "event_%d", i + 1);
        const code result = code_of(e, numbered(e, "both", 2), &e->p->events.functions[2 * i], 2);
        put(e, "/* %s */\n", source_quote(m->source, m->events.all[i].at));
        emit_function(e, function,
                      "real *restrict const both, const real *restrict const x, const real *restrict const dx,\n"
                      "    const real *restrict const u, const real *restrict const p",
                      &result);
        names = form(e, "%s%s%s", names, i == 0 ? "" : ", ", function);
        moves = form(e, "%s%s%s", moves, i == 0 ? "" : ", ", e->p->events.moves[i] ? "true" : "false");
    }
    put(e, "static iso_event_function *const event_functions[%d] = {%s};\n", m->events.count, names);
    put(e, "static const bool event_moves[%d] = {%s};\n", m->events.count, moves);
    const int *ends = e->p->events.ends, all = ends[m->events.count - 1];
    if (all > 0) {
        emit_states(e, "event_reads", e->p->events.reads, all);
    }
    emit_whole_numbers(e, "event_ends", ends, m->events.count);
    put(e, "\n");
}

/* Of each hold its numbers, and the states that it has. */
static void emit_holds(emission *e)
{
    const mechanism *m = e->p->m;
    const int n = m->events.hold_count, count = (int)ISO_HOLD_NUMBERS(n);
    int *states = arena_take(e->out->memory, 3 * (size_t)n, sizeof *states);
    for (int i = 0; i < n; i++) {
        const held_speed *h = &m->events.holds[i];
        states[i] = h->state;
        states[n + i] = m->position_count + h->dof;
        states[2 * n + i] = m->position_count + (h->against < 0 ? h->dof : h->against);
    }
    const code numbers = code_of(e, numbered(e, "numbers", count), e->p->events.hold_numbers, count);
    put(e, "/* The holds: speeds, accelerations without any, limits, efforts while they slip, mobility. */\n");
    emit_function(
        e, "hold_numbers",
        "real *restrict const numbers, const real *restrict const x,\n    const real *restrict const u, const "
        "real *restrict const p",
        &numbers);
    emit_states(e, "hold_modes", states, n);
    emit_states(e, "hold_speeds", states + n, n);
    emit_states(e, "hold_against", states + 2 * n, n);
    put(e, "static const iso_holds holds = {\n    .count = %d,\n    .numbers = hold_numbers,\n", n);
    put(e, "    .modes = hold_modes,\n    .speeds = hold_speeds,\n    .against = hold_against,\n};\n\n");
}

/* Which events are impulses. */
static void emit_strikes(emission *e)
{
    const event_list *all = &e->p->m->events;
    const char *strikes = "";
    for (int i = 0; i < all->count; i++) {
        bool any = false;
        FOR_ALL (const event_set, set, all->all[i].sets, all->all[i].set_count) {
            any = any || is_impulse(set);
        }
        strikes = form(e, "%s%s%s", strikes, i == 0 ? "" : ", ", any ? "true" : "false");
    }
    put(e, "static const bool event_strikes[%d] = {%s};\n\n", all->count, strikes);
}

/* The table of a plant with holds alone. */
static void emit_events_of_holds(emission *e)
{
    const event_list *all = &e->p->m->events;
    put(e, "static const iso_events events = {\n    .slots = %d,\n", all->slots);
    put(e, "    .rest = &iso_tableau_%s,\n    .holds = &holds,\n};\n\n", method_names[ISO_METHOD_OF(all->rest)]);
}

void emit_events(emission *e)
{
    const event_list *all = &e->p->m->events;
    if (all->hold_count > 0) {
        emit_holds(e);
    }
    if (all->count == 0) {
        emit_events_of_holds(e);
        return;
    }
    if (all->hold_count > 0) {
        emit_strikes(e);
    }
    const event_plan *plan = &e->p->events;
    const code sets = code_of(e, numbered(e, "to", plan->set_count), plan->values, plan->set_count);
    emit_event_functions(e);
    put(e, "/* What the events set. */\n");
    emit_function(
        e, "event_sets",
        "real *restrict const to, const real *restrict const x,\n    const real *restrict const u, const real "
        "*restrict const p",
        &sets);
    emit_states(e, "set_states", plan->states, plan->set_count);
    emit_whole_numbers(e, "set_owners", plan->owners, plan->set_count);
    put(e, "static const iso_events events = {\n    .count = %d,\n    .functions = event_functions,\n", all->count);
    put(e, "    .moves = event_moves,\n    .reads = %s,\n    .ends = event_ends,\n",
        plan->ends[all->count - 1] > 0 ? "event_reads" : "NULL");
    put(e, "    .sets = %d,\n    .values = event_sets,\n", plan->set_count);
    put(e, "    .states = set_states,\n    .owners = set_owners,\n    .slots = %d,\n", all->slots);
    put(e, "    .rest = &iso_tableau_%s,\n", method_names[ISO_METHOD_OF(all->rest)]);
    put(e, "%s};\n\n", all->hold_count > 0 ? "    .holds = &holds,\n    .strikes = event_strikes,\n" : "");
}

static const char *array_of(int count, const char *array)
{
    return count > 0 ? array : "NULL";
}

void emit_event_begin(const emission *e)
{
    const mechanism *m = e->p->m;
    put_if(e, m->events.hold_count > 0,
           "    real room[ISO_HOLD_WORK(%d)];\n    iso_holds_begin(&holds, memory->x, %s, %s, room);\n",
           m->events.hold_count, array_of(held_count(m), "memory->u"), array_of(m->parameters.count, "memory->p"));
    put_if(e, m->events.count > 0, "    iso_events_begin(&events, memory->x, %s, %s, memory->events);\n",
           array_of(held_count(m), "memory->u"), array_of(m->parameters.count, "memory->p"));
}

void emit_event_step(const emission *e, const char *recipe, const char *read)
{
    const mechanism *m = e->p->m;
    const int holds = m->events.hold_count;
    put(e, "    real room[ISO_EVENT_WORK($C_STATES, %d, %d, %d)%s];\n", ISO_STAGES_OF(m->events.rest), m->events.count,
        e->p->events.set_count, holds > 0 ? form(e, " + ISO_EVENT_HOLD_WORK(%d)", holds) : "");
    put(e, "    iso_events_step(%s, $C_STATES, &equations$s, &events, %s, memory->x, before,\n", recipe,
        literal(e, method_step(m)));
    put(e, "                    %s, %s, %s, work, room, %s,\n", array_of(held_count(m), "memory->u"), read,
        array_of(m->parameters.count, "memory->p"), array_of(m->events.count, "memory->events"));
    put(e, "                    &memory->event_counts);\n");
}

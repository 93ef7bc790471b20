/* Tunables and faults that are set at times: at 2 s set stiffness = 3 N/m. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/mechanism/builder.h"

/* The index of a tunable, or of a fault by its EFFECT.FAULT; -1 after noting a problem. */
static int parameter_called(builder *b, name n)
{
    const mechanism *m = &b->mechanism;
    const char **names = arena_take(b->s->memory, (size_t)m->parameters.count + 1, sizeof *names);
    for (int i = 0; i < m->parameters.count; i++) {
        const variable *v = &m->parameters.all[i];
        names[i] = v->display_name != NULL ? v->display_name : v->name != NULL ? v->name : "";
        if (strcmp(names[i], n.text) == 0) {
            return i;
        }
    }
    source_problem(b->s, n.at, "no tunable and no fault is called '%s'%s", n.text,
                   source_suggestion(b->s, n.text, names, (size_t)m->parameters.count));
    return -1;
}

/* The first condition that these tunables break in the arithmetic of the plant; NULL where they keep all. */
static const condition *broken_condition(const builder *b, const double *p, double *numbers)
{
    graph_evaluate(b->g, 0, &(evaluation){.p = p, .rounds_to_float = !b->values.is_double}, numbers);
    FOR_EACH (const condition, c, b->values.conditions) {
        const double least = numbers[c->least], most = numbers[c->most];
        if (c->is_strict ? !(least < most) : !(least <= most)) {
            return c;
        }
    }
    return NULL;
}

/* A condition that the defaults keep in exact numbers, and break by a rounding of the plant: it would refuse every
 * change. */
static void check_defaults(builder *b)
{
    double *numbers = arena_take(b->s->memory, b->g->count + 1, sizeof *numbers);
    const condition *c = broken_condition(b, b->mechanism.parameters.defaults, numbers);
    for (size_t i = 0; c != NULL && i < b->written->parameters.count; i++) {
        const quantity *q = &b->written->parameters.all[i];
        const node sides[2] = {c->least, c->most};
        if (q->tunable && uses_leaf(b->g, sides, 2, leaf(b->g, OP_PARAMETER, b->values.tunable_index[i]))) {
            source_problem(b->s, q->name.at,
                           "a condition on '%s' holds at the defaults, but not as a %s rounds it: %.9g is not %s %.9g; "
                           "leave room between them",
                           q->name.text, b->values.is_double ? "double" : "float", numbers[c->most],
                           c->is_strict ? "above" : "at least", numbers[c->least]);
            return;
        }
    }
}

/* A change, with where its value is written. */
typedef struct written_change {
    switching change;
    place at;
    size_t order;
} written_change;

/* In the order of time; of one tick as they are written. */
static int compare(const void *one, const void *other)
{
    const written_change *a = one, *b = other;
    const bool is_before = a->change.tick < b->change.tick || (a->change.tick <= b->change.tick && a->order < b->order);
    return is_before ? -1 : 1;
}

/* The changes of a tick keep the conditions, together with all changes until then. */
static void check_changes(builder *b, const written_change *all)
{
    const mechanism *m = &b->mechanism;
    double *p = list_copy(b->s->memory, m->parameters.defaults, (size_t)m->parameters.count, sizeof *p);
    double *numbers = arena_take(b->s->memory, b->g->count + 1, sizeof *numbers);
    for (int i = 0; i < m->parameters.change_count && b->values.conditions.count > 0; i++) {
        const switching *c = &all[i].change;
        p[c->parameter] = c->value;
        const bool is_last = i + 1 == m->parameters.change_count || all[i + 1].change.tick > c->tick;
        const condition *broken = is_last ? broken_condition(b, p, numbers) : NULL;
        if (broken != NULL) {
            source_problem(b->s, all[i].at, "this breaks a condition of the formulas: %g is not %s %g",
                           numbers[broken->most], broken->is_strict ? "above" : "at least", numbers[broken->least]);
        }
    }
}

/* The change of a statement; false after noting a problem with its name. */
static bool read_change(builder *b, const setting *set, written_change *to)
{
    const mechanism *m = &b->mechanism;
    const int parameter = set->value == NULL ? -1 : parameter_called(b, set->what);
    if (parameter < 0) {
        return false;
    }
    const variable *v = &m->parameters.all[parameter];
    const double ticks = round(value_constant(&b->values, set->time, second, "the time", 0.0) / m->method.step);
    const double to_value = value_constant(&b->values, set->value, v->dimension, v->name, v->start);
    if (ticks < 0.0 || ticks > last_tick) {
        source_problem(b->s, set->time->at, "the time is from 0 to %g s with this step", last_tick * m->method.step);
    }
    if (to_value < v->least || to_value > v->most) {
        source_problem(b->s, set->value->at, "'%s' is from %g to %g, in SI units", set->what.text, v->least, v->most);
    }
    *to = (written_change){{ticks, parameter, to_value}, set->value->at, (size_t)m->parameters.change_count};
    return true;
}

void build_changes(builder *b)
{
    parameter_set *all = &b->mechanism.parameters;
    const size_t room = b->written->settings.count + 1;
    written_change *changes = arena_take(b->s->memory, room, sizeof *changes);
    double *at_start = list_copy(b->s->memory, all->defaults, (size_t)all->count, sizeof *at_start);
    FOR_EACH (const setting, set, b->written->settings) {
        all->change_count += read_change(b, set, &changes[all->change_count]);
    }
    qsort(changes, (size_t)all->change_count, sizeof *changes, compare);
    all->changes = arena_take(b->s->memory, room, sizeof *all->changes);
    for (int i = 0; i < all->change_count; i++) {
        const switching *c = &changes[i].change;
        all->changes[i] = *c;
        at_start[c->parameter] = c->tick > 0.0 ? at_start[c->parameter] : c->value;
    }
    all->at_start = at_start;
    if (b->s->problem_count == 0) {
        check_defaults(b);
    }
    check_changes(b, changes);
    all->conditions = b->values.conditions.all;
    all->condition_count = (int)b->values.conditions.count;
}

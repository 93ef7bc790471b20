/* The formulas of a mechanism as lists of nodes. */
#include "tools/isoc/mechanism/mechanism.h"

node account_with_parts(graph *g, const effect_set *all, int effect, quantity_kind kind)
{
    node sum = account_part(&all->accounts[effect], kind);
    for (int i = effect + 1; i < all->count; i++) {
        int outer = all->outer[i];
        while (outer > effect) {
            outer = all->outer[outer];
        }
        sum = outer == effect ? add(g, sum, account_part(&all->accounts[i], kind)) : sum;
    }
    return sum;
}

void for_roots(graph *g, const mechanism *m, bool with_memories, root_visitor *visit, void *context)
{
    visit(g, m->effects.efforts, (size_t)m->dof_count, context);
    FOR_ALL (effect_account, e, m->effects.accounts, m->effects.count) {
        visit(g, &e->power, 1, context);
        visit(g, &e->stored, 1, context);
        visit(g, &e->loss, 1, context);
        visit(g, &e->work, 1, context);
    }
    FOR_EACH (effect_quantity, e, m->effects.derived) {
        visit(g, &e->next, 1, context);
    }
    FOR_ALL (effect_quantity, e, m->effects.states, m->effects.state_count) {
        visit(g, &e->next, 1, context);
        visit(g, &e->begin, 1, context);
    }
    FOR_ALL (effect_quantity, e, m->effects.memories, with_memories ? m->effects.memory_count : 0) {
        visit(g, &e->next, 1, context);
        visit(g, &e->begin, 1, context);
    }
    FOR_ALL (event, e, m->events.all, m->events.count) {
        visit(g, &e->function, 1, context);
        FOR_ALL (event_set, set, e->sets, e->set_count) {
            visit(g, &set->to, 1, context);
            if (set->speed >= 0) {
                visit(g, &set->speed, 1, context);
            }
        }
    }
    FOR_ALL (held_speed, h, m->events.holds, m->events.hold_count) {
        visit(g, &h->limit, 1, context);
        visit(g, &h->sliding, 1, context);
    }
    FOR_ALL (shown, o, m->outputs, m->output_count) {
        visit(g, o->formula.parts, (size_t)o->formula.count, context);
    }
    FOR_ALL (effect_effort, e, m->effects.pushes, m->effects.push_count) {
        visit(g, &e->effort, 1, context);
    }
    FOR_ALL (applied_force, f, m->forces.applied, m->forces.applied_count) {
        if (f->drive < 0) {
            visit(g, f->force.at, 3, context);
            visit(g, f->moment.at, 3, context);
        }
    }
}

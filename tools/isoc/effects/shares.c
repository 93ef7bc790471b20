/* share(A < B) and pwm(duty, 1 ms) in formulas: a memory has the value of each, which is found at the begin of every
 * step. */
#include <string.h>

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/formula/condition.h"

/* Whether an input is `time`, which goes on within a step for shares. */
static bool is_time_itself(const mechanism *m, int input)
{
    const int which = input < m->inputs.count ? m->inputs.time_input_of[input] : -1;
    return which >= 0 && strcmp(m->inputs.time_inputs[which].word, "time") == 0;
}

static bool is_moving_leaf(const mechanism *m, const graph_node *n)
{
    const int effect = n->index - m->effects.first_state;
    const bool is_mode =
        n->op == OP_STATE && effect >= 0 && effect < m->effects.state_count && m->effects.states[effect].is_mode;
    return (n->op == OP_STATE && !is_mode) || n->op == OP_QUERY || (n->op == OP_INPUT && is_time_itself(m, n->index));
}

/* Notes a comparison that jumps within a step: between its ends it is no straight line. */
static bool refuse_jump(effect_scope *w, const formula *f, const node *functions, int count)
{
    const graph *g = w->b->g;
    bool *moves = arena_take(g->memory, g->count, sizeof *moves), jumps = false;
    for (reached r = reach(g, functions, (size_t)count); reach_next(&r);) {
        const int operands = operators[r.n->op].operands;
        const bool any = operands > 0 && (moves[r.n->a] || (operands == 2 && moves[r.n->b]));
        const operation op = r.n->op;
        moves[r.at] = any || is_moving_leaf(&w->b->mechanism, r.n);
        jumps = jumps || (any && (op == OP_ABOVE || op == OP_SIGN || op == OP_FLOOR || op == OP_ROUND));
    }
    arena_return(g->memory, moves, g->count, sizeof *moves);
    return jumps &&
           !source_problem(w->b->s, f->at,
                           "the sides of this comparison jump within a step (floor, round, sign, if, another "
                           "comparison): a wave is pwm(DUTY, PERIOD), and sample(x, every T) holds what jumps");
}

/* Notes what is not known at the begin of a step. */
static bool refuse_unknown(effect_scope *w, const formula *f, node root)
{
    const mechanism *m = &w->b->mechanism;
    const quantity_kind late = late_quantity(w, &root, 1);
    bool *reads = arena_take(w->b->s->memory, (size_t)held_count(m) + 1, sizeof *reads), shares = false, smooth = false;
    mark_leaves(w->b->g, &root, 1, OP_INPUT, reads);
    for (int i = 0; i < held_count(m); i++) {
        const int memory = i - m->inputs.count;
        shares = shares || (reads[i] && memory >= 0 && m->effects.memories[memory].kept == KEPT_SHARE);
        smooth = smooth || (reads[i] && memory < 0 && m->inputs.smooth[i]);
    }
    return (late < QUANTITY_ROWS &&
            !source_problem(w->b->s, f->at, "'%s' is known after the begin of the step, at which a share is found",
                            quantity_rows[late].word)) ||
           (shares && !source_problem(w->b->s, f->at,
                                      "a share of a step is found from states, inputs and memories, not from another "
                                      "share; previous(x) is that of the step before")) ||
           (smooth && !source_problem(w->b->s, f->at,
                                      "a smooth input changes within the step, and a share would not see it: let it be "
                                      "held, or take a state x with rate x = 1"));
}

double share_ticks(effect_scope *w, const formula *f)
{
    return is_wave(f) ? wave_period(&w->b->values, f) : 0.0;
}

value share_value(effect_scope *w, const instance *in, const formula *f)
{
    builder *b = w->b;
    node functions[MOST_COMPARED], root = -1;
    const instance *before = enter(w, in);
    if (is_wave(f)) {
        const value duty = value_of(&b->values, f->parts[0], no_unit, 1, "the duty of a pwm");
        const value over = time_input_value(w, f);
        root = duty.count == 0 || over.count == 0
                   ? -1
                   : share_of_wave(b->g, duty.parts[0], over.parts[0], wave_period(&b->values, f));
    } else {
        const int count = share_functions(&b->values, f->parts[0], functions);
        root = count < 0 || refuse_jump(w, f->parts[0], functions, count) ? -1 : share_of(b->g, functions, count);
    }
    enter(w, before);
    return root < 0 || refuse_unknown(w, f->parts[0], root) ? nothing
                                                            : (value){.count = 1, .parts = {root}, .dim = no_unit};
}

/* Notes methods that take the slopes of steps before for those of this one. */
static void refuse_history(builder *b, place at, unsigned recipe)
{
    if (ISO_PAST_KEPT(recipe) > 0) {
        source_problem(b->s, at,
                       "a share jumps from step to step, and %s has a history: take %s, or another method without one",
                       method_names[ISO_METHOD_OF(recipe)], ISO_IS_IMPLICIT(recipe) ? "rosenbrock" : "rk4");
    }
}

void check_shares(builder *b)
{
    const mechanism *m = &b->mechanism;
    FOR_ALL (const effect_quantity, e, m->effects.memories, m->effects.memory_count) {
        if (e->kept != KEPT_SHARE) {
            continue;
        }
        refuse_history(b, e->at, m->method.recipe);
        for (int i = 0; i < m->policies.rung_count; i++) {
            refuse_history(b, e->at, m->policies.rungs[i] == ISO_METHODS ? ISO_RK4 : m->policies.rungs[i]);
        }
        if (ISO_IS_CHECKED(m->method.recipe)) {
            source_problem(b->s, e->at,
                           "the local error is that of steps without jumps: leave out the shares, or the check");
        }
        return;
    }
}

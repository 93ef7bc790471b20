/* overrun, grace, publish, histogram: how the loop runs the plant; and the rungs of a ladder. */
#include <string.h>

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/parser.h"

static double ticks_of(builder *b, const formula *f, const char *what, double least)
{
    return whole_number(b, f, what, " of ticks", 0.0, least, 1e9);
}

/* The method of a rung: an explicit one of one step. These take over from one another with the same memory. */
static unsigned method_of_rung(builder *b, name rung)
{
    const policy_statement *written = &b->written->policies;
    const unsigned method = find_method(b, rung);
    if (!ISO_IS_EXPLICIT(method)) {
        source_problem(b->s, rung.at, "a rung is one of the methods %s, drop EFFECT, or hold",
                       explicit_methods(b->s->memory));
    }
    for (size_t j = 0; j < written->rung_count && written->rungs[j].at != rung.at; j++) {
        if (written->rung_kinds[j] == RUNG_METHOD && strcmp(rung.text, written->rungs[j].text) == 0) {
            source_problem(b->s, rung.at, "'%s' is a rung already", rung.text);
        }
    }
    for (size_t i = 0; i < b->written->inputs.count && method != ISO_METHOD_OF(b->mechanism.method.recipe); i++) {
        if (b->written->inputs.all[i].smooth) {
            source_problem(b->s, rung.at, "the smooth input '%s' is sampled for %s: let it be held, or leave out '%s'",
                           b->written->inputs.all[i].name.text, method_names[ISO_METHOD_OF(b->mechanism.method.recipe)],
                           rung.text);
        }
    }
    return method;
}

/* Checks the rung without a step. */
static void check_hold(builder *b, name rung)
{
    for (size_t j = 0; j < b->written->closures.count; j++) {
        if (closure_clocks(&b->written->closures.all[j]) > 0) {
            source_problem(b->s, rung.at, "a motion goes on while the states are held: leave out hold");
        }
    }
}

/* Whether an effect, or a part in it, has an effort, a force or a moment. */
static bool acts(const scene *written, int effect)
{
    bool any = false;
    for (int i = effect; i < (int)written->effects.count; i++) {
        const effect_kind *kind = find_effect_kind(written, written->effects.all[i].kind);
        for (size_t n = 0; kind != NULL && is_within_use(written, i, effect) && n < kind->line_count; n++) {
            const effect_line_kind is = kind->lines[n].kind;
            any = any || is == EFFECT_EFFORT || is == EFFECT_FORCE || is == EFFECT_MOMENT;
        }
    }
    return any;
}

static bool is_dropped(const policies *how, int effect)
{
    bool is = false;
    for (int i = 0; i < how->drop_count; i++) {
        is = is || how->drops[i] == effect;
    }
    return is;
}

/* An effect that another reads must be there: a machine that runs on zeros is another machine, not a coarser one. */
static bool refuse_readers(builder *b, name rung, int effect)
{
    const size_t before = b->s->problem_count;
    scene without = *b->written;
    without.effects.all = arena_take(b->s->memory, without.effects.count, sizeof *without.effects.all);
    for (size_t i = 0; i < without.effects.count; i++) {
        without.effects.all[i] = b->written->effects.all[i];
        without.effects.all[i].left_out = is_within_use(b->written, (int)i, effect);
    }
    for (size_t i = 0; i < without.effects.count; i++) {
        const effect_use *other = &b->written->effects.all[i];
        bool reads = false;
        for (size_t n = 0; n < other->operand_count && other->outer < 0; n++) {
            reads = reads || scene_reads_left_out(&without, other->operands[n].value);
        }
        if (reads && (int)i != effect && !other->left_out && !is_dropped(&b->mechanism.policies, (int)i)) {
            source_problem(b->s, rung.at, "'%s' cannot be dropped: the effect '%s' computes from it", rung.text,
                           other->name.text);
        }
    }
    return b->s->problem_count > before;
}

/* Drops an effect; one that --without has left out is absent in any case. */
static void drop(builder *b, name rung)
{
    policies *to = &b->mechanism.policies;
    const int effect = find_effect(b->s, b->written, rung);
    const effect_use *use = effect < 0 ? NULL : &b->written->effects.all[effect];
    const effect_kind *kind = use == NULL ? NULL : find_effect_kind(b->written, use->kind);
    if (kind == NULL) {
        return;
    }
    if (is_dropped(to, effect)) {
        source_problem(b->s, rung.at, "'%s' is dropped already", rung.text);
        return;
    }
    if (!use->left_out && !kind->broken && !refuse_readers(b, rung, effect) && !acts(b->written, effect)) {
        source_problem(b->s, rung.at, "'%s' acts on no joint and no body: to drop it would change only what is shown",
                       rung.text);
    }
    to->drops[to->drop_count++] = effect;
}

/* The rungs of a ladder, from the method of the scene downwards: a change of a rung holds on those below it. */
static void build_ladder(builder *b)
{
    const policy_statement *written = &b->written->policies;
    policies *to = &b->mechanism.policies;
    unsigned method = ISO_METHOD_OF(b->mechanism.method.recipe);
    if (!ISO_IS_EXPLICIT(method) || ISO_IS_CHECKED(b->mechanism.method.recipe)) {
        source_problem(b->s, written->overrun_at,
                       "a ladder is for the methods %s, without a check: others keep a history",
                       explicit_methods(b->s->memory));
    }
    if (written->rung_count == 0) {
        source_problem(b->s, written->overrun_at, "a ladder has rungs: method euler, drop EFFECT, or hold");
    }
    for (size_t i = 0; i < written->rung_count; i++) {
        const name rung = written->rungs[i];
        switch (written->rung_kinds[i]) {
        case RUNG_METHOD:
            method = method_of_rung(b, rung);
            break;
        case RUNG_DROP:
            if (method == ISO_METHODS) {
                source_problem(b->s, rung.at, "no step is made below hold: put 'drop %s' above it", rung.text);
            }
            drop(b, rung);
            break;
        case RUNG_HOLD:
            check_hold(b, rung);
            method = ISO_METHODS;
            break;
        }
        to->rungs[i] = method;
        to->dropped[i] = to->drop_count;
    }
    to->rung_count = (int)written->rung_count;
    to->after = ticks_of(b, written->after, "the number of good ticks", 1.0);
}

void build_policies(builder *b)
{
    const policy_statement *written = &b->written->policies;
    const double catch_up = ticks_of(b, written->catch_up, "what is caught up", 0.0);
    b->mechanism.policies = (policies){.overrun = written->overrun,
                                       .catch_up = catch_up,
                                       .grace = ticks_of(b, written->grace, "the grace", 1.0),
                                       .delayed = written->delayed,
                                       .histogram = written->histogram};
    b->mechanism.policies.any =
        written->overrun != OVERRUN_COUNT || written->grace != NULL || written->delayed || written->histogram;
    if (written->overrun == OVERRUN_DEGRADE) {
        build_ladder(b);
    }
}

/* Values that follow from step and method: step, stable_rate, stable_frequency, impact_frequency, impact_lead. */
#include "tools/isoc/effects/effects.h"

#include <string.h>

#include "tools/isoc/base/numbers.h"

static const char *const limit_names[] = {"step", "stable_rate", "stable_frequency", "impact_frequency", "impact_lead"};

enum { LIMIT_STEP, LIMIT_RATE, LIMIT_FREQUENCY, LIMIT_IMPACT, LIMIT_LEAD, LIMIT_NAMES };

bool is_limit(const char *called)
{
    const size_t i = index_of_word(called, limit_names, LIMIT_NAMES);
    return i > LIMIT_STEP && i < LIMIT_NAMES;
}

/* Tells of the first rung of a ladder where this effect still acts, by a method that makes more of an impact than that
 * of the scene, for which stiffness and lead are. */
static void check_rungs(const effect_scope *w)
{
    const policy_statement *written = &w->b->written->policies;
    const char *effect = w->within->use->name.text;
    for (size_t i = 0; i < written->rung_count; i++) {
        const name rung = written->rungs[i];
        const size_t method = index_of_word(rung.text, method_names, ISO_METHODS);
        if (written->rung_kinds[i] == RUNG_DROP && strcmp(rung.text, effect) == 0) {
            return;
        }
        if (written->rung_kinds[i] != RUNG_METHOD || method == ISO_METHODS) {
            continue;
        }
        const double lead = impact_limits_of((unsigned)method, limits_of((unsigned)method).rate).lead;
        const double more = elementary_exp(0.5 * 3.1416 * w->impact.frequency * (lead - w->impact.lead)) - 1.0;
        if (more > 0.0) {
            source_warn(w->b->s, rung.at,
                        "with %s an impact of '%s' leaves up to %.2g %% more speed than is asked: it is made for the "
                        "method of the scene; put 'drop %s' above this rung",
                        rung.text, effect, 100.0 * more, effect);
            return;
        }
    }
}

bool find_limit(effect_scope *w, const char *called, value *found)
{
    static const dimension hertz = DIMENSION(0, 0, -1, 0, 0, 0), speed = DIMENSION(0, 0, -1, 1, 0, 0);
    static const double margin = 0.5; /* of the limit: an effect that is linear here may be steeper elsewhere */
    const mechanism *m = &w->b->mechanism;
    const size_t which = index_of_word(called, limit_names, LIMIT_NAMES);
    const double h = method_step(m);
    if (which == LIMIT_NAMES) {
        return false;
    }
    if (which > LIMIT_STEP && w->limits.rate == 0.0) {
        w->limits = limits_of(m->method.recipe);
    }
    if (which >= LIMIT_IMPACT && w->impact.frequency == 0.0) {
        w->impact = impact_limits_of(m->method.recipe, w->limits.rate);
    }
    if (which == LIMIT_LEAD) {
        check_rungs(w);
    }
    const double values[] = {m->method.step, margin * w->limits.rate / h, margin * w->limits.frequency / h,
                             w->impact.frequency / h, w->impact.lead * h};
    const bool is_time = which == LIMIT_STEP || which == LIMIT_LEAD;
    *found = (value){.count = 1, .dim = is_time ? second : which == LIMIT_RATE ? hertz : speed};
    found->parts[0] = constant(w->b->g, values[which]);
    return true;
}

/* The line of a definition that reads a parameter, an input or a signal of the scene: value mass kg; NULL where the
 * scene has none of this name. */
static const char *line_for(effect_scope *w, const char *called)
{
    const builder *b = w->b;
    const int *parameter = dictionary_find(&b->values.names, called), input = INDEX_OF(b->written->inputs, called);
    const int signal = INDEX_OF(b->written->signals, called);
    if (parameter == NULL && input < 0 && signal < 0) {
        return NULL;
    }
    const bool is_known = signal < 0 || w->signal_progress[signal] == DONE;
    const value one = {.count = 1, .dim = input >= 0 ? b->input_dimensions[input] : no_unit};
    const value is = parameter != NULL ? b->values.parameters[*parameter] : signal >= 0 ? w->signals[signal] : one;
    const char *unit_of_it = dimension_text(b->s->memory, is.dim);
    const char *in = !is_known                          ? " UNIT"
                     : dimension_equal(is.dim, no_unit) ? ""
                                                        : arena_format(b->s->memory, " %s", unit_of_it);
    return arena_format(b->s->memory, "%s %s%s%s%s", parameter != NULL ? "value" : "signal", called, in,
                        is.count == 3 ? " = (0, 0, 0)" : "", is.count == 3 ? in : "");
}

static void refuse_name(effect_scope *w, const formula *f)
{
    const char *line = line_for(w, f->name);
    if (line != NULL) {
        source_problem(w->b->s, f->at,
                       "this effect has no '%s', and sees of the scene what its use gives: write '%s' in its "
                       "definition, and '%s %s' in its use",
                       f->name, line, f->name, f->name);
        return;
    }
    source_problem(w->b->s, f->at, "this effect has no '%s': no operand, let, state or memory is called so%s", f->name,
                   suggestion(w->b->s, w->within->kind, f->name, EFFECT_JOINT, EFFECT_MEMORY));
}

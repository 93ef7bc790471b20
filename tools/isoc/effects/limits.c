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
    const double numbers[] = {m->method.step * w->rate.every, margin * w->limits.rate / h,
                              margin * w->limits.frequency / h, w->impact.frequency / h, w->impact.lead * h};
    const bool is_time = which == LIMIT_STEP || which == LIMIT_LEAD;
    *found = (value){.count = 1, .dim = is_time ? second : which == LIMIT_RATE ? hertz : speed};
    found->parts[0] = constant(w->b->g, numbers[which]);
    return true;
}

#include "tools/isoc/scene/names.h"

#include <string.h>

typedef struct counter {
    const char *what;
    size_t count;
} counter;

static void count(source *s, counter *c, size_t more, place at)
{
    enum { MOST = 65535 };
    const size_t before = c->count;
    c->count += more;
    if (c->count > MOST && before <= MOST) {
        source_problem(s, at, "too many %s: a plant has at most %d", c->what, MOST);
    }
}

/* Positions and speeds: two of an elementary joint of one coordinate, seven of one that turns freely. */
static size_t states_of(const joint *j)
{
    const int balls = joint_parts_that(j->kind, JOINT_SPHERICAL);
    return (size_t)(2 * (joint_parts_count(j->kind) - balls) + 7 * balls);
}

bool counts_check(source *s, const scene *written)
{
    const size_t problems = s->problem_count;
    counter states = {.what = "states"}, inputs = {.what = "inputs and memories"};
    counter tunables = {.what = "tunable parameters"}, outputs = {.what = "outputs"};
    FOR_EACH (const joint, j, written->joints) {
        count(s, &states, states_of(j), j->name.at);
    }
    FOR_EACH (const closure_statement, c, written->closures) {
        count(s, &states, (size_t)closure_clocks(c), c->name.at);
    }
    FOR_EACH (const quantity, q, written->events.modes) {
        count(s, &states, 1, q->name.at);
    }
    FOR_EACH (const quantity, q, written->inputs) {
        count(s, &inputs, 1, q->name.at);
    }
    FOR_EACH (const quantity, q, written->parameters) {
        count(s, &tunables, q->tunable, q->name.at);
    }
    FOR_EACH (const effect_use, use, written->effects) {
        const effect_kind *kind = find_effect_kind(written, use->kind);
        for (size_t n = 0; kind != NULL && n < kind->line_count; n++) {
            const size_t parts = (size_t)kind->lines[n].parts;
            count(s, &states, kind->lines[n].kind == EFFECT_STATE ? parts : 0, use->name.at);
            count(s, &inputs, kind->lines[n].kind == EFFECT_MEMORY ? parts : 0, use->name.at);
            count(s, &tunables, kind->lines[n].kind == EFFECT_FAULT, use->name.at);
        }
    }
    FOR_EACH (const output, o, written->outputs) {
        const size_t letters = strlen(output_components(written, o));
        count(s, &outputs, letters == 0 ? 1 : letters, o->name.at);
    }
    return s->problem_count == problems;
}

/* Springs and dampers between points of bodies. */
#include "tools/isoc/mechanism/builder.h"

static const dimension per_metre = {1, 0, -2, 0, 0, 0, 0}, per_speed = {1, 0, -1, 0, 0, 0, 0};

static node positive(builder *b, const formula *f, dimension of, const char *what)
{
    const node n = scalar_value(b, f, of, what);
    if (value_now(&b->values, n) < 0.0) {
        source_problem(b->s, f->at, "%s must not be negative", what);
    }
    return n;
}

static void build_spring(builder *b, const spring_statement *written)
{
    point_spring made = {.name = written->name.text, .at = written->name.at, .base = GROUND};
    if (written->broken) {
        return;
    }
    made.stiffness = positive(b, written->stiffness, per_metre, "a stiffness");
    made.damping = positive(b, written->damping, per_speed, "a damping");
    made.length = positive(b, written->length, metre, "a length");
    if (written->stiffness == NULL && written->damping == NULL) {
        source_problem(b->s, made.at, "the spring '%s' has neither stiffness nor damping: stiffness 100 N/m",
                       made.name);
    } else if ((written->stiffness != NULL) != (written->length != NULL)) {
        source_problem(b->s, made.at,
                       written->length == NULL ? "the spring '%s' has no length, at which it is slack: length 0.1 m"
                                               : "the spring '%s' has a length and no stiffness: stiffness 100 N/m",
                       made.name);
    }
    const bool found = place_end(b, &written->first, matrix_identity(b->g), &made.first);
    if (!place_end(b, &written->second, matrix_identity(b->g), &made.second) || !found) {
        return;
    }
    if (made.first.segment == made.second.segment) {
        source_problem(b->s, made.at, "'%s' has no effect: '%s' and '%s' do not move relative to each other", made.name,
                       written->first.body.text, written->second.body.text);
        return;
    }
    made.base = common_segment(&b->made, made.first.segment, made.second.segment);
    b->made.point_springs[b->made.point_spring_count++] = made;
}

void build_springs(builder *b)
{
    b->made.point_springs = arena_take(b->s->memory, b->written->spring_count + 1, sizeof *b->made.point_springs);
    for (size_t i = 0; i < b->written->spring_count; i++) {
        build_spring(b, &b->written->springs[i]);
    }
}

/* What is found by its name in a mechanism, and the values of formulas. These call none of the files that build it. */
#include <string.h>

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/names.h"

vector vector_value(builder *b, const formula *f, dimension expected, const char *what)
{
    vector r = vector_zero(b->g);
    if (f != NULL) {
        const value v = value_of(&b->values, f, expected, 3, what);
        for (int i = 0; i < 3 && v.count == 3; i++) {
            r.at[i] = v.parts[i];
        }
    }
    return r;
}

node scalar_value(builder *b, const formula *f, dimension expected, const char *what)
{
    node r = constant(b->g, 0.0);
    if (f != NULL) {
        const value v = value_of(&b->values, f, expected, 1, what);
        r = v.count == 1 ? v.parts[0] : r;
    }
    return r;
}

int segment_called(const mechanism *m, name n)
{
    for (int i = 0; i < m->segment_count; i++) {
        if (m->segments[i].kind != JOINT_SPHERICAL && strcmp(m->segments[i].name, n.text) == 0) {
            return i;
        }
    }
    return -1;
}

int coordinate_of(builder *b, name n)
{
    if (n.text == NULL || b->written->broken) {
        return -1;
    }
    for (int i = 0; i < b->mechanism.segment_count; i++) {
        if (strcmp(b->mechanism.segments[i].name, n.text) == 0 && b->mechanism.segments[i].kind != JOINT_SPHERICAL) {
            return i;
        }
    }
    const int found = find_joint(b->s, b->written, n);
    if (found >= 0) {
        source_problem(b->s, n.at, "this needs one coordinate; the joint '%s' has none or several", n.text);
    }
    return -1;
}

bool find_connection(builder *b, name n, int *child, int *loop)
{
    bool is_joint;
    const int index = find_joint_or_closure(b->s, b->written, n, &is_joint);
    if (index >= 0 && !is_joint && acts_along_joints(b->written->closures.all[index].kind)) {
        source_problem(b->s, n.at, "'%s' has no force between bodies: show effort of %s", n.text, n.text);
    }
    *child = index >= 0 && is_joint ? b->children[index] : -1;
    *loop = index >= 0 && !is_joint ? index : -1;
    return index >= 0;
}

dimension coordinate_dimension(const segment *l)
{
    return l->kind == JOINT_PRISMATIC ? metre : radian;
}

dimension quantity_dimension(const char *word, const segment *l)
{
    const bool turns = l->kind == JOINT_REVOLUTE;
    dimension expected = turns ? radian : metre;
    if (strcmp(word, "speed") == 0) {
        dimension_times(&expected, second, -1);
    }
    return strcmp(word, "effort") == 0 ? (turns ? newton_metre : newton) : expected;
}

/* Search by name in a mechanism, the values of formulas, and jumps of functions of time. These call none of the files
 * that build it. */
#include <math.h>
#include <string.h>

#include "tools/isoc/mechanism/builder.h"

vector vector_value(builder *b, const formula *f, dimension expected, const char *what)
{
    const value v = f == NULL ? nothing : value_of(&b->values, f, expected, 3, what);
    return v.count == 3 ? (vector){{v.parts[0], v.parts[1], v.parts[2]}} : vector_zero(b->g);
}

node scalar_value(builder *b, const formula *f, dimension expected, const char *what)
{
    const value v = f == NULL ? nothing : value_of(&b->values, f, expected, 1, what);
    return v.count == 1 ? v.parts[0] : constant(b->g, 0.0);
}

double whole_number(builder *b, const formula *f, const char *what, const char *units, double fallback, double least,
                    double most)
{
    const double number = value_constant(&b->values, f, no_unit, what, fallback);
    if (f != NULL && (!(number >= least && number <= most) || number != floor(number))) {
        source_problem(b->s, f->at, "%s must be a whole number%s from %.0f to %.0f", what, units, least, most);
        return fallback;
    }
    return number;
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

/* The parts of a joint that have one coordinate, as a list; or advice on the right words. */
static const char *parts_of(builder *b, const joint *j)
{
    const char *list = "";
    FOR_ALL (const segment, l, b->mechanism.segments, b->mechanism.segment_count) {
        if (l->at == j->name.at && l->kind != JOINT_SPHERICAL) {
            list = arena_format(b->s->memory, "%s%s%s", list, list[0] == '\0' ? "" : ", ", l->name);
        }
    }
    return list[0] == '\0' ? "the orientation of its child" : list;
}

/* Notes a joint without a coordinate, or with several. */
static void refuse_joint(builder *b, name n, const joint *j)
{
    if (j->kind == JOINT_FIXED) {
        source_problem(b->s, n.at, "the joint '%s' is fixed: it has no coordinate", n.text);
    } else if (!joint_has_one_coordinate(j->kind)) {
        source_problem(b->s, n.at, "the joint '%s' has more than one coordinate: take %s", n.text, parts_of(b, j));
    }
}

int coordinate_of(builder *b, name n)
{
    if (n.text == NULL || b->written->broken) {
        return -1;
    }
    const int coordinate = segment_called(&b->mechanism, n);
    const int found = coordinate >= 0 ? -1 : find_joint(b->s, b->written, n);
    if (found >= 0) {
        refuse_joint(b, n, &b->written->joints.all[found]);
    }
    return coordinate;
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

dimension quantity_dimension(quantity_kind kind, const segment *l)
{
    const quantity_row *row = &quantity_rows[kind];
    return dimension_of_unit(l->kind == JOINT_PRISMATIC ? row->unit : row->turning_unit);
}

const char *query_unit(const mechanism *m, const query *q)
{
    const quantity_row *row = &quantity_rows[q->kind];
    const int index = q->closure >= 0 ? m->closures[q->closure].parent.segment : q->segment;
    const bool slides = q->spring >= 0 || (index >= 0 && m->segments[index].kind == JOINT_PRISMATIC);
    return slides ? row->unit : row->turning_unit;
}

bool find_transmission(builder *b, name n, int *loop, int *spring)
{
    bool is_closure;
    const int index = find_closure_or_spring(b->s, b->written, n, &is_closure);
    *loop = is_closure ? index : -1;
    *spring = is_closure ? -1 : index;
    const bool has = !is_closure || acts_along_joints(b->written->closures.all[index].kind);
    return index >= 0 && (has || source_problem(b->s, n.at, "'%s' has no effort: show force of %s, or moment of %s",
                                                n.text, n.text, n.text));
}

bool counts_turns(builder *b, const query *q, place at)
{
    return q->kind != QUANTITY_TURNS || b->mechanism.segments[q->segment].continuous ||
           source_problem(b->s, at, "only a continuous joint counts its turns");
}

bool is_of_plant(builder *b, quantity_kind kind, place at)
{
    const unsigned recipe = b->mechanism.method.recipe;
    const char *lack = quantity_rows[kind].owner == OF_CLOSURES && b->written->closures.count == 0
                           ? "a scene without closures has no violation"
                       : kind == QUANTITY_RESIDUAL && !ISO_IS_ITERATING(recipe) ? "only bdf4 has a residual"
                       : kind == QUANTITY_EVENT_LOSS && b->mechanism.events.loss_state < 0
                           ? "the loss of events is summed where an output asks for it: output loss = event_loss"
                       : kind == QUANTITY_LOCAL_ERROR && !ISO_IS_CHECKED(recipe)
                           ? "a formula has the local error where the scene says: checked yes"
                           : NULL;
    return lack == NULL || source_problem(b->s, at, "%s", lack);
}

/* Steps, square waves and sequences, each once. */
void find_edges(builder *b, node drive)
{
    mechanism *m = &b->mechanism;
    for (reached r = reach(b->g, &drive, 1); reach_next(&r);) {
        const operation op = r.n->op;
        bool is_new = op == OP_FROM || op == OP_SQUARE || op == OP_SQUARE_OF_PHASE || op == OP_PRBS;
        for (int k = 0; k < m->inputs.edge_count; k++) {
            is_new = is_new && m->inputs.edges[k] != r.at;
        }
        if (is_new) {
            ADD_TO(b->s->memory, m->inputs.edges, m->inputs.edge_count, b->edge_room, r.at);
        }
    }
}

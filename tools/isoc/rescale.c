#include "tools/isoc/rescale.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/scales.h"

typedef struct rescaling {
    scales s;
    graph to;
    node *moved;   /* where a node that is no multiple is in `to` */
    double *times; /* its scale, with the sign that it has there */
} rescaling;

/* An operand as a sum or a product in `to` takes it: so many times a node, or a constant. */
typedef struct part {
    double times;
    node of; /* or -1: the constant 1 */
} part;

static part part_of(const rescaling *r, node n)
{
    const multiple as = r->s.as[n];
    const bool fixed = is_constant(r->s.g, as.of);
    return (part){fixed ? as.times : as.times * r->times[as.of], fixed ? -1 : r->moved[as.of]};
}

static node put_part(rescaling *r, part p, int section)
{
    if (p.of < 0 || is_one(p.times)) {
        return p.of < 0 ? constant(&r->to, p.times) : p.of;
    }
    if (is_one(-p.times)) {
        return graph_put(&r->to, (graph_node){.op = OP_NEG, .a = p.of, .section = section});
    }
    const node c = constant(&r->to, p.times);
    return graph_put(&r->to, (graph_node){.op = OP_MUL, .a = c, .b = p.of, .section = section});
}

/* In the order in which graph.c has them: constants first, then by number. */
static void sort_operands(const rescaling *r, graph_node *n)
{
    if (is_constant(&r->to, n->b) || (n->b < n->a && !is_constant(&r->to, n->a))) {
        const node swap = n->a;
        n->a = n->b;
        n->b = swap;
    }
}

/* The sign that what takes a node as it is would have it with, or takes a product that it is in, if its other factor is
 * there; 0 if nothing does. */
static int sign_asked(const rescaling *r, node i)
{
    int sign = 0;
    for (int at = r->s.first[i]; at >= 0 && sign == 0; at = r->s.uses[at].next) {
        const use *u = &r->s.uses[at];
        const int own = u->times < 0.0 ? -1 : 1;
        if (u->by == WHOLE) {
            sign = own;
        } else if (is_product(&r->s.g->nodes[u->by])) {
            const multiple other = r->s.as[operand_at(&r->s.g->nodes[u->by], 1 - u->which)];
            const double of_other = is_constant(r->s.g, other.of) ? 1.0 : other.times * r->times[other.of];
            sign = of_other == 0.0 ? 0 : (of_other < 0.0 ? -own : own) * sign_asked(r, u->by);
        }
    }
    return sign;
}

/* Whether an operand is made for this one use: then what computes it may end in its place. */
static bool is_made_for_this(const rescaling *r, part p, node n)
{
    const node of = r->s.as[n].of;
    return p.of >= 0 &&
           (!is_one(fabs(p.times)) || (operands(&r->s.g->nodes[of]) > 0 && r->s.uses[r->s.first[of]].next < 0));
}

/* Of a sum that nothing takes as it is the sign is free: it is a + b rather than -a - b, and of a - b and b - a the one
 * that takes from what nobody else uses. Else -a - b is (-c) a' - b where a is c a'. */
static void move_sum(rescaling *r, node i, graph_node *n)
{
    const int sign = sign_asked(r, i);
    const node of[2] = {n->a, n->b};
    part parts[2] = {part_of(r, n->a), part_of(r, n->b)};
    r->times[i] = sign < 0 ? -r->s.scale[i] : r->s.scale[i];
    parts[0].times /= r->times[i];
    parts[1].times /= n->op == OP_SUB ? -r->times[i] : r->times[i];
    const int less = parts[0].times < 0.0 ? 0 : 1; /* the one to take away, where there is one */
    int absorbs = -1;
    bool turns = false;
    if (parts[0].times < 0.0 && parts[1].times < 0.0) {
        for (int k = 0; k < 2; k++) {
            absorbs = sign != 0 && (parts[k].of < 0 || !is_one(-parts[k].times)) ? k : absorbs;
        }
        turns = absorbs < 0;
    } else if (parts[less].times < 0.0 && sign == 0) {
        turns = is_made_for_this(r, parts[less], of[less]) && !is_made_for_this(r, parts[1 - less], of[1 - less]);
    }
    node made[2];
    bool negative[2];
    for (int k = 0; k < 2; k++) {
        parts[k].times = turns ? -parts[k].times : parts[k].times;
        negative[k] = parts[k].times < 0.0 && absorbs != k;
        parts[k].times = negative[k] ? -parts[k].times : parts[k].times;
        made[k] = put_part(r, parts[k], n->section);
    }
    r->times[i] = turns ? -r->times[i] : r->times[i];
    n->op = negative[0] || negative[1] ? OP_SUB : OP_ADD;
    n->a = made[negative[0]];
    n->b = made[!negative[0]];
    if (n->op == OP_ADD) {
        sort_operands(r, n);
    }
}

static void move_product(rescaling *r, node i, graph_node *n)
{
    node made[2];
    r->times[i] = r->s.scale[i];
    for (int k = 0; k < 2; k++) {
        part p = part_of(r, operand_at(n, k));
        r->times[i] = p.times < 0.0 ? -r->times[i] : r->times[i];
        const node of = r->s.as[operand_at(n, k)].of;
        p.times = p.of < 0 ? 1.0 : r->s.scale[of] / scale_taken(&r->s, i, k);
        made[k] = put_part(r, p, n->section);
    }
    n->a = made[0];
    n->b = made[1];
    if (n->op == OP_MUL) {
        sort_operands(r, n);
    }
}

static const char *name_of_multiple(arena *memory, const char *name, double times)
{
    static const char minus[] = "minus_";
    const size_t length = strlen(minus);
    if (name == NULL || is_one(times)) {
        return name;
    }
    const bool was_negative = strncmp(name, minus, length) == 0;
    const char *sign = (times < 0.0) != was_negative ? minus : "";
    return arena_format(memory, "%s%s%s", is_one(fabs(times)) ? "" : "scaled_", sign,
                        was_negative ? name + length : name);
}

static void move(rescaling *r, node i)
{
    graph_node n = r->s.g->nodes[i];
    if (is_sum(&n)) {
        move_sum(r, i, &n);
    } else if (is_product(&n)) {
        move_product(r, i, &n);
    } else {
        node made[2] = {n.a, n.b};
        for (int k = 0; k < operands(&n); k++) {
            made[k] = put_part(r, part_of(r, operand_at(&n, k)), n.section);
        }
        n.a = made[0];
        n.b = made[1];
        r->times[i] = 1.0;
    }
    n.name = name_of_multiple(r->to.memory, n.name, r->times[i]);
    r->moved[i] = graph_put(&r->to, n);
}

graph rescale(const graph *g, const node *roots, size_t count, node *made)
{
    rescaling r = {.s = scales_choose(g, roots, count)};
    graph_start(&r.to, g->memory);
    memcpy(r.to.sections, g->sections, sizeof r.to.sections);
    r.to.section_count = g->section_count;
    r.moved = arena_take(g->memory, g->count, sizeof *r.moved);
    r.times = arena_take(g->memory, g->count, sizeof *r.times);
    for (size_t i = 0; i < g->count; i++) {
        if (r.s.needed[i] && r.s.as[i].of == (node)i && g->nodes[i].op != OP_CONSTANT) {
            move(&r, (node)i);
        }
    }
    for (size_t i = 0; i < count; i++) {
        made[i] = put_part(&r, part_of(&r, roots[i]), g->nodes[roots[i]].section);
    }
    return r.to;
}

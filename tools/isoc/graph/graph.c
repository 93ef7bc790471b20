#include "tools/isoc/graph/graph.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

enum { LEAST_SLOTS = 64, FIRST_SLOTS = 4096 };

static void take_slots(graph *g, size_t count)
{
    g->slot_count = count;
    g->slots = arena_take(g->memory, count, sizeof *g->slots);
}

void graph_start(graph *g, arena *memory, const char *heading)
{
    *g = (graph){.memory = memory};
    g->counts = arena_take(memory, 1, sizeof *g->counts);
    g->tables = arena_take(memory, 1, sizeof *g->tables);
    take_slots(g, FIRST_SLOTS);
    graph_section(g, heading);
}

void graph_start_like(graph *g, const graph *other)
{
    size_t slots = LEAST_SLOTS;
    while (slots < 2 * other->count) {
        slots *= 2;
    }
    *g = (graph){.memory = other->memory, .room = other->count + 1, .tables = other->tables};
    g->nodes = arena_take(g->memory, g->room, sizeof *g->nodes);
    take_slots(g, slots);
    for (int i = 0; i < other->section_count; i++) {
        graph_section(g, other->sections[i]);
    }
}

graph graph_copy(const graph *g)
{
    graph result = *g;
    result.counts = arena_take(g->memory, 1, sizeof *result.counts);
    result.nodes = arena_take(g->memory, g->room, sizeof *g->nodes);
    memcpy(result.nodes, g->nodes, g->count * sizeof *g->nodes);
    result.slots = arena_take(g->memory, g->slot_count, sizeof *g->slots);
    memcpy(result.slots, g->slots, g->slot_count * sizeof *g->slots);
    result.section_room = (size_t)g->section_count;
    result.sections = list_copy(g->memory, g->sections, result.section_room, sizeof *g->sections);
    return result;
}

void graph_free(graph *g)
{
    arena_return(g->memory, g->nodes, g->room, sizeof *g->nodes);
    arena_return(g->memory, g->slots, g->slot_count, sizeof *g->slots);
    *g = (graph){0};
}

void graph_section(graph *g, const char *heading)
{
    ADD_TO(g->memory, g->sections, g->section_count, g->section_room, heading);
}

node graph_name(graph *g, node n, const char *format, ...)
{
    const bool negated = g->nodes[n].op == OP_NEG;
    graph_node *named = &g->nodes[negated ? g->nodes[n].a : n];
    if (operators[named->op].kind == KIND_OPERATION && named->name == NULL) {
        va_list arguments;
        va_start(arguments, format);
        const char *name = arena_format_list(g->memory, format, arguments);
        va_end(arguments);
        named->name = negated ? arena_format(g->memory, "minus_%s", name) : name;
    }
    return n;
}

static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
    return hash ^ (hash >> 29);
}

static uint64_t bits(double value)
{
    uint64_t b;
    memcpy(&b, &value, sizeof b);
    return b;
}

static uint32_t hash_of(const graph_node *n)
{
    uint64_t hash = mix(0, (uint64_t)n->op << 32 | (uint32_t)n->index);
    hash = mix(hash, (uint64_t)(uint32_t)n->a << 32 | (uint32_t)n->b);
    return (uint32_t)mix(mix(hash, bits(n->value)), bits(n->second));
}

static bool is_equal(const graph_node *n, const graph_node *other)
{
    return n->op == other->op && n->a == other->a && n->b == other->b && n->index == other->index &&
           bits(n->value) == bits(other->value) && bits(n->second) == bits(other->second);
}

/* The slot of the node that is equal to this one, or the free one where there is none. */
static graph_slot *slot_of(const graph *g, const graph_node *n, uint32_t hash)
{
    size_t slot = hash & (g->slot_count - 1);
    while (g->slots[slot].place > 0 &&
           (g->slots[slot].hash != hash || !is_equal(n, &g->nodes[g->slots[slot].place - 1]))) {
        slot = (slot + 1) & (g->slot_count - 1);
    }
    return &g->slots[slot];
}

static void grow_slots(graph *g)
{
    graph_slot *const before = g->slots;
    const size_t count = g->slot_count;
    take_slots(g, 2 * count);
    for (size_t i = 0; i < count; i++) {
        size_t slot = before[i].hash & (g->slot_count - 1);
        while (before[i].place > 0 && g->slots[slot].place > 0) {
            slot = (slot + 1) & (g->slot_count - 1);
        }
        if (before[i].place > 0) {
            g->slots[slot] = before[i];
        }
    }
    arena_return(g->memory, before, count, sizeof *before);
}

/* The node that exists already for this operation, or -1. */
static node find(const graph *g, operation op, node a, node b)
{
    const graph_node wanted = {.op = op, .a = a, .b = b};
    return slot_of(g, &wanted, hash_of(&wanted))->place - 1;
}

/* The node that is equal to `wanted`, made if there is none. */
static node intern(graph *g, graph_node wanted)
{
    const uint32_t hash = hash_of(&wanted);
    graph_slot *slot = slot_of(g, &wanted, hash);
    if (slot->place == 0) {
        if (2 * g->count > g->slot_count) {
            grow_slots(g);
            slot = slot_of(g, &wanted, hash);
        }
        wanted.section = g->section_count - 1;
        ADD_TO(g->memory, g->nodes, g->count, g->room, wanted);
        *slot = (graph_slot){.hash = hash, .place = (node)g->count};
    }
    return slot->place - 1;
}

node graph_put(graph *g, graph_node n)
{
    const size_t before = g->count;
    const node result = intern(g, n);
    if (g->count > before) {
        g->nodes[result].section = n.section;
    }
    return result;
}

node constant(graph *g, double value)
{
    return intern(g, (graph_node){.op = OP_CONSTANT, .value = value + 0.0}); /* no negative zero */
}

node leaf(graph *g, operation op, int index)
{
    return intern(g, (graph_node){.op = op, .index = index});
}

node timed(graph *g, operation op, double value, double second)
{
    return timed_by_index(g, op, value, second, 0);
}

node timed_by_index(graph *g, operation op, double value, double second, int index)
{
    return intern(g, (graph_node){.op = op, .value = value, .second = second, .index = index});
}

static node binary(graph *g, operation op, node a, node b)
{
    return intern(g, (graph_node){.op = op, .a = a, .b = b});
}

bool is_timed(const graph *g, node n)
{
    return operators[g->nodes[n].op].kind == KIND_TIMED;
}

bool is_constant(const graph *g, node n)
{
    return g->nodes[n].op == OP_CONSTANT;
}

double constant_value(const graph *g, node n)
{
    return g->nodes[n].value;
}

bool is_value(const graph *g, node n, double value)
{
    return is_constant(g, n) && constant_value(g, n) == value;
}

bool is_zero(const graph *g, node n)
{
    return is_value(g, n, 0.0);
}

static bool is(const graph *g, node n, operation op)
{
    return g->nodes[n].op == op;
}

/* The constant that is the result of an operation on constants. */
static node folded(graph *g, operation op, node a, node b)
{
    return constant(g, operators[op].value(g, NULL, NULL, constant_value(g, a), constant_value(g, b)));
}

node neg(graph *g, node a)
{
    return is(g, a, OP_NEG) ? g->nodes[a].a : function(g, OP_NEG, a, a);
}

/* n = coefficient * base, the coefficient a constant. */
static double coefficient(const graph *g, node n, node *base)
{
    const graph_node *m = &g->nodes[n];
    *base = n;
    if (m->op == OP_NEG) {
        return -coefficient(g, m->a, base);
    }
    if (m->op == OP_MUL && is_constant(g, m->a)) {
        *base = m->b;
        return constant_value(g, m->a);
    }
    return 1.0;
}

/* n = constant + rest, for a sum that carries a constant, through signs and constant factors; 0 for any other. */
static double addend(graph *g, node n, node *rest)
{
    const graph_node m = g->nodes[n];
    double c = 0.0;
    *rest = n;
    if ((m.op == OP_ADD || m.op == OP_SUB) && is_constant(g, m.a)) {
        c = constant_value(g, m.a);
        *rest = m.op == OP_SUB ? neg(g, m.b) : m.b;
    } else if (m.op == OP_NEG && (c = addend(g, m.a, rest)) != 0.0) {
        c = -c;
        *rest = neg(g, *rest);
    } else if (m.op == OP_MUL && is_constant(g, m.a) && (c = addend(g, m.b, rest)) != 0.0) {
        c *= constant_value(g, m.a);
        *rest = mul(g, m.a, *rest);
    }
    return c;
}

/* a + b, or zero where a and -b are equal but for rounding. */
static double sum_of_constants(double a, double b)
{
    const double sum = a + b;
    return fabs(sum) <= 4 * DBL_EPSILON * fabs(a) ? 0.0 : sum;
}

bool is_line_in(graph *g, node a, node b, double *slope, double *offset)
{
    node rest_a, rest_b, base_a, base_b;
    const double c = addend(g, a, &rest_a), d = addend(g, b, &rest_b);
    *slope = coefficient(g, rest_a, &base_a);
    *slope /= coefficient(g, rest_b, &base_b);
    *offset = sum_of_constants(c, -*slope * d);
    return base_a == base_b && !is_constant(g, a);
}

/* a + b where a repeated term or a cancelling part makes it simpler; -1 where none does. */
static node merge_terms(graph *g, node a, node b)
{
    node base_a, base_b;
    const double ca = coefficient(g, a, &base_a), cb = coefficient(g, b, &base_b);
    if (base_a == base_b) {
        return mul(g, constant(g, sum_of_constants(ca, cb)), base_a);
    }
    const graph_node *p = &g->nodes[a];
    const node minus_b = is(g, b, OP_NEG) ? g->nodes[b].a : -1;
    if (p->op == OP_SUB && p->b == b) {
        return p->a;
    }
    if (p->op == OP_SUB && p->a == minus_b) {
        return neg(g, p->b);
    }
    if (p->op == OP_ADD && minus_b >= 0 && (p->a == minus_b || p->b == minus_b)) {
        return p->a == minus_b ? p->b : p->a;
    }
    return -1;
}

/* The constants of a sum gathered in front: (c + x) + (d + y) is (c + d) + (x + y). -1 where there is but one part. */
static node gather_constants(graph *g, node a, node b)
{
    node rest_a, rest_b;
    const double ca = is_constant(g, a) ? constant_value(g, a) : addend(g, a, &rest_a);
    const double cb = ca == 0.0 ? 0.0 : addend(g, b, &rest_b);
    if (cb == 0.0) {
        return -1;
    }
    return add(g, constant(g, sum_of_constants(ca, cb)), is_constant(g, a) ? rest_b : add(g, rest_a, rest_b));
}

node add(graph *g, node a, node b)
{
    if (is_constant(g, a) && is_constant(g, b)) {
        return folded(g, OP_ADD, a, b);
    }
    if (is_constant(g, b)) {
        return add(g, b, a);
    }
    if (is_zero(g, a)) {
        return b;
    }
    node simpler = merge_terms(g, a, b);
    simpler = simpler >= 0 ? simpler : merge_terms(g, b, a);
    simpler = simpler >= 0 ? simpler : gather_constants(g, a, b);
    if (simpler >= 0) {
        return simpler;
    }
    if (is(g, a, OP_NEG) && is(g, b, OP_NEG)) {
        return neg(g, add(g, g->nodes[a].a, g->nodes[b].a));
    }
    if (is(g, a, OP_NEG) || is(g, b, OP_NEG)) {
        /* a - b and b - a are one node and its negation. */
        const node plus = is(g, a, OP_NEG) ? b : a;
        const node minus = g->nodes[is(g, a, OP_NEG) ? a : b].a;
        const node turned = find(g, OP_SUB, minus, plus);
        return turned >= 0 ? neg(g, turned) : binary(g, OP_SUB, plus, minus);
    }
    return a < b || is_constant(g, a) ? binary(g, OP_ADD, a, b) : binary(g, OP_ADD, b, a);
}

node sub(graph *g, node a, node b)
{
    return add(g, a, neg(g, b));
}

/* Whether a constant factor leaves half of the range of float to what it multiplies. */
static bool leaves_room(double factor)
{
    return fabs(factor) >= 0x1p-63 && fabs(factor) <= 0x1p63;
}

node mul(graph *g, node a, node b)
{
    if (is_constant(g, a) && is_constant(g, b)) {
        return folded(g, OP_MUL, a, b);
    }
    if (is_constant(g, b) || (b < a && !is_constant(g, a))) {
        return mul(g, b, a);
    }
    if (is_zero(g, a)) {
        return a;
    }
    if (is_value(g, a, 1.0)) {
        return b;
    }
    /* Signs go in front, where a sum takes them up. */
    if (is_constant(g, a) && constant_value(g, a) < 0.0) {
        return neg(g, mul(g, constant(g, -constant_value(g, a)), b));
    }
    if (is(g, a, OP_NEG)) {
        return neg(g, mul(g, g->nodes[a].a, b));
    }
    if (is(g, b, OP_NEG)) {
        return neg(g, mul(g, a, g->nodes[b].a));
    }
    /* Constant factors gather: (c x) (d y) is (c d) (x y), and c (d y) is (c d) y. They stay where they are if their
     * product leaves the range of float, as where each of many factors is scaled by its value at the start. */
    node base_a = a, base_b = b;
    const double ca = is_constant(g, a) ? constant_value(g, a) : coefficient(g, a, &base_a);
    const double cb = coefficient(g, b, &base_b);
    if (ca != 1.0 && cb != 1.0 && leaves_room(ca * cb)) {
        return mul(g, constant(g, ca * cb), is_constant(g, a) ? base_b : mul(g, base_a, base_b));
    }
    return binary(g, OP_MUL, a, b);
}

node divide(graph *g, node a, node b)
{
    if (is_constant(g, b)) {
        return mul(g, constant(g, 1.0 / constant_value(g, b)), a);
    }
    if (is_zero(g, a)) {
        return a;
    }
    if (a == b) {
        return constant(g, 1.0);
    }
    if (is(g, a, OP_NEG)) {
        return neg(g, divide(g, g->nodes[a].a, b));
    }
    if (is(g, b, OP_NEG)) {
        return neg(g, divide(g, a, g->nodes[b].a));
    }
    return binary(g, OP_DIV, a, b);
}

node larger(graph *g, node a, node b)
{
    if (is_constant(g, a) && is_constant(g, b)) {
        return folded(g, OP_MAX, a, b);
    }
    if (is_zero(g, a) || is_zero(g, b)) {
        return function(g, OP_POSITIVE, is_zero(g, a) ? b : a, a);
    }
    /* A constant comes last, whenever it was made. */
    const bool swaps = is_constant(g, a) || (!is_constant(g, b) && b < a);
    return a == b ? a : swaps ? binary(g, OP_MAX, b, a) : binary(g, OP_MAX, a, b);
}

node above(graph *g, node a, node b)
{
    return a == b ? constant(g, 0.0) : function(g, OP_ABOVE, a, b);
}

node wrap(graph *g, node a)
{
    return is_zero(g, a) ? a : intern(g, (graph_node){.op = OP_WRAP, .a = a});
}

node magnitude(graph *g, node a)
{
    const node bare = is(g, a, OP_NEG) ? g->nodes[a].a : a;
    return function(g, OP_ABS, bare, bare);
}

node sine(graph *g, node a)
{
    return is(g, a, OP_NEG) ? neg(g, sine(g, g->nodes[a].a)) : function(g, OP_SIN, a, a);
}

node cosine(graph *g, node a)
{
    return is(g, a, OP_NEG) ? cosine(g, g->nodes[a].a) : function(g, OP_COS, a, a);
}

node function(graph *g, operation op, node a, node b)
{
    if (operators[op].operands == 1) {
        return is_constant(g, a) ? folded(g, op, a, a) : intern(g, (graph_node){.op = op, .a = a});
    }
    const bool chooses = op == OP_WHERE || op == OP_UNLESS;
    if (is_constant(g, a) && is_constant(g, b)) {
        return folded(g, op, a, b);
    }
    if (op == OP_MIN && (is_zero(g, a) || is_zero(g, b))) {
        return function(g, OP_NEGATIVE, is_zero(g, a) ? b : a, a);
    }
    if (chooses && is_zero(g, b)) {
        return b;
    }
    if (chooses && is_constant(g, a)) {
        return (constant_value(g, a) > 0.5) == (op == OP_WHERE) ? b : constant(g, 0.0);
    }
    return op == OP_MIN && a == b ? a : binary(g, op, a, b);
}

node power(graph *g, node a, int n)
{
    node product = constant(g, 1.0);
    for (int i = 0; i < n; i++) {
        product = mul(g, product, a);
    }
    return product;
}

node sum_of_products(graph *g, node a, node b, node c, node d)
{
    const node ab = mul(g, a, b), cd = mul(g, c, d);
    return add(g, ab, cd);
}

node difference_of_products(graph *g, node a, node b, node c, node d)
{
    const node ab = mul(g, a, b), cd = mul(g, c, d);
    return sub(g, ab, cd);
}

void graph_evaluate(const graph *g, size_t first, const evaluation *at, double *values)
{
    for (size_t i = first; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        const double value = operators[n->op].value(g, n, at, values[n->a], values[n->b]);
        values[i] = at->rounds_to_float ? (double)(float)value : value;
    }
}

graph graph_part(const graph *g, const node *roots, size_t count, node *in_part)
{
    graph part = {.memory = g->memory, .sections = g->sections, .section_count = g->section_count, .tables = g->tables};
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    node *place = arena_take(g->memory, g->count, sizeof *place);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        part.room += needed[i];
    }
    part.nodes = arena_take(g->memory, part.room, sizeof *part.nodes);
    for (size_t i = 0; i < g->count; i++) {
        if (needed[i]) {
            graph_node *n = &part.nodes[part.count];
            *n = g->nodes[i];
            n->a = operators[n->op].operands > 0 ? place[n->a] : n->a;
            n->b = operators[n->op].operands == 2 ? place[n->b] : n->b;
            place[i] = (node)part.count++;
        }
    }
    for (size_t i = 0; i < count; i++) {
        in_part[i] = place[roots[i]];
    }
    arena_return(g->memory, needed, g->count, sizeof *needed);
    arena_return(g->memory, place, g->count, sizeof *place);
    return part;
}

node *zero_nodes(graph *g, size_t count)
{
    const node zero = constant(g, 0.0);
    node *result = arena_take(g->memory, count, sizeof *result);
    for (size_t i = 0; i < count; i++) {
        result[i] = zero;
    }
    return result;
}

node *all_nodes(const graph *g)
{
    node *result = arena_take(g->memory, g->count, sizeof *result);
    for (size_t i = 0; i < g->count; i++) {
        result[i] = (node)i;
    }
    return result;
}

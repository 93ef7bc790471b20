#include "tools/isoc/emit/code.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/graph/economy.h"

enum { LONGEST_INLINE = 72 }; /* characters of an expression that stands inside another */

/* How tightly an expression binds, for parentheses. */
typedef enum binding { BINDS_SUM, BINDS_PRODUCT, BINDS_WHOLE } binding;

/* What stands for a node where it is used. */
typedef struct rendering {
    const char *text;
    binding binds;
} rendering;

typedef struct emitter {
    const code *c;
    graph *g;
    text *out;
    const node *roots;
    bool *needed;
    int *uses;
    rendering *shown;
    const char **taken; /* names given so far */
    size_t taken_count, taken_room;
    int temporaries, section;
    double culprit;
} emitter;

static bool in_range(double value, bool is_double)
{
    const double largest = is_double ? 1.7976931348623157e308 : 3.4028234663852886e38;
    const double least = is_double ? 2.2250738585072014e-308 : 1.1754943508222875e-38;
    return value == 0.0 || (fabs(value) <= largest && fabs(value) >= least);
}

const char *code_literal(arena *memory, double value, bool is_double)
{
    char digits[40];
    for (int precision = 1; precision <= 17; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, value);
        if (is_double ? strtod(digits, NULL) == value : strtof(digits, NULL) == (float)value) {
            break;
        }
    }
    /* Without an exponent where that is as short: 20.0, not 2e+01. */
    if (fabs(value) >= 10.0 && fabs(value) < 1e6 && strchr(digits, '.') == NULL) {
        snprintf(digits, sizeof digits, "%.0f", value);
    }
    const char *point = strpbrk(digits, ".e") == NULL ? ".0" : "";
    return arena_format(memory, "R(%s%s)", digits, point);
}

static bool name_is_taken(const emitter *e, const char *name)
{
    for (size_t i = 0; i < e->taken_count; i++) {
        if (strcmp(e->taken[i], name) == 0) {
            return true;
        }
    }
    return false;
}

static const char *unique_name(emitter *e, const char *wanted)
{
    const char *name = wanted;
    for (int i = 2; name_is_taken(e, name); i++) {
        name = arena_format(e->g->memory, "%s_%d", wanted, i);
    }
    e->taken = arena_grow(e->g->memory, e->taken, e->taken_count, &e->taken_room, sizeof *e->taken);
    e->taken[e->taken_count++] = name;
    return name;
}

/* Where the last of these operators before `room` stands, or 0. */
static size_t last_operator(const char *line, size_t room, const char *signs)
{
    size_t cut = room;
    while (cut > 0 && !(line[cut] == ' ' && strchr(signs, line[cut + 1]) != NULL && line[cut + 2] == ' ')) {
        cut--;
    }
    return cut;
}

/* A statement, broken before an operator where it would pass the margin. */
static void statement(text *out, const char *line)
{
    enum { MARGIN = 116 };
    size_t left = strlen(line), room = MARGIN;
    text_add(out, "    ");
    while (left > room) {
        size_t cut = last_operator(line, room, "+-");
        cut = cut > 0 ? cut : last_operator(line, room, "*/");
        if (cut == 0) {
            break;
        }
        text_add(out, "%.*s\n       ", (int)cut, line);
        line += cut;
        left -= cut;
        room = MARGIN - 4;
    }
    text_add(out, "%s\n", line);
}

static void heading(emitter *e, int section)
{
    if (section != e->section) {
        e->section = section;
        text_add(e->out, "%s    /* %s */\n", e->out->bytes[e->out->length - 2] == '{' ? "" : "\n",
                 e->g->sections[section]);
    }
}

/* Parentheses where the operand binds less than its place asks for. */
static const char *operand(const emitter *e, node n, binding least)
{
    const rendering *r = &e->shown[n];
    return r->binds >= least ? r->text : arena_format(e->g->memory, "(%s)", r->text);
}

static rendering show_sum(const emitter *e, const graph_node *n)
{
    arena *memory = e->g->memory;
    const bool negative = n->op == OP_ADD && is_constant(e->g, n->a) && constant_value(e->g, n->a) < 0.0;
    if (negative) {
        const char *literal = code_literal(memory, -constant_value(e->g, n->a), e->c->is_double);
        return (rendering){arena_format(memory, "%s - %s", operand(e, n->b, BINDS_SUM), literal), BINDS_SUM};
    }
    const char *left = operand(e, n->a, BINDS_SUM), *right = operand(e, n->b, BINDS_PRODUCT);
    return (rendering){arena_format(memory, "%s %c %s", left, n->op == OP_ADD ? '+' : '-', right), BINDS_SUM};
}

static rendering show(emitter *e, node i)
{
    const graph_node *n = &e->g->nodes[i];
    arena *memory = e->g->memory;
    switch (n->op) {
    case OP_CONSTANT:
        e->culprit = in_range(n->value, e->c->is_double) ? e->culprit : n->value;
        return (rendering){code_literal(memory, n->value, e->c->is_double), BINDS_WHOLE};
    case OP_STATE:
        return (rendering){e->c->names.states[n->index], BINDS_WHOLE};
    case OP_INPUT:
        return (rendering){e->c->names.inputs[n->index], BINDS_WHOLE};
    case OP_PARAMETER:
        return (rendering){e->c->names.parameters[n->index], BINDS_WHOLE};
    case OP_TURNS:
        return (rendering){arena_format(memory, "(real)memory->turns[%d]", n->index), BINDS_WHOLE};
    case OP_STEP:
        return (rendering){"hb", BINDS_WHOLE};
    case OP_FACTOR:
        return (rendering){arena_format(memory, "lu_%d", n->index), BINDS_WHOLE};
    case OP_RIGHT:
        return (rendering){arena_format(memory, "r_%s", e->c->names.states[n->index]), BINDS_WHOLE};
    case OP_LOCAL_ERROR:
        return (rendering){"memory->progress.local_error", BINDS_WHOLE};
    case OP_RESIDUAL:
        return (rendering){"memory->progress.residual", BINDS_WHOLE};
    case OP_DERIVATIVE:
        return (rendering){arena_format(memory, "dx[%d]", n->index), BINDS_WHOLE};
    case OP_ADD:
    case OP_SUB:
        return show_sum(e, n);
    case OP_MUL:
    case OP_DIV:
        return (rendering){arena_format(memory, "%s %c %s", operand(e, n->a, BINDS_PRODUCT),
                                        n->op == OP_MUL ? '*' : '/', operand(e, n->b, BINDS_WHOLE)),
                           BINDS_PRODUCT};
    case OP_NEG:
        return (rendering){arena_format(memory, "-%s", operand(e, n->a, BINDS_WHOLE)), BINDS_PRODUCT};
    case OP_ABS:
        return (rendering){arena_format(memory, "iso_abs(%s)", e->shown[n->a].text), BINDS_WHOLE};
    case OP_MAX:
    case OP_ABOVE:
        return (rendering){arena_format(memory, "iso_%s(%s, %s)", n->op == OP_MAX ? "max" : "above",
                                        e->shown[n->a].text, e->shown[n->b].text),
                           BINDS_WHOLE};
    case OP_WRAP:
        return (rendering){arena_format(memory, "iso_within_turn(%s)", e->shown[n->a].text), BINDS_WHOLE};
    default:
        return (rendering){"", BINDS_WHOLE};
    }
}

/* 2^64 per turn; the fraction of a turn as a phase. */
static uint64_t phase_of(double turns)
{
    const double fraction = turns - floor(turns);
    return (uint64_t)(fraction * 18446744073709549568.0);
}

static rendering show_timed(emitter *e, const graph_node *n)
{
    arena *memory = e->g->memory;
    if (n->op == OP_PHASE) {
        return (rendering){arena_format(memory, "iso_phase(tick, UINT64_C(0x%016llX), UINT64_C(0x%016llX))",
                                        (unsigned long long)phase_of(n->value),
                                        (unsigned long long)phase_of(n->second)),
                           BINDS_WHOLE};
    }
    const char *second = code_literal(memory, n->second, e->c->is_double);
    if (n->op == OP_TIME) {
        return (rendering){arena_format(memory, "%s * (real)tick", second), BINDS_PRODUCT};
    }
    const double whole = floor(n->value);
    const char *first = arena_format(memory, "tick, UINT32_C(%.0f), %s", whole,
                                     code_literal(memory, n->value - whole, e->c->is_double));
    return n->op == OP_SINCE ? (rendering){arena_format(memory, "%s * iso_since(%s)", second, first), BINDS_PRODUCT}
                             : (rendering){arena_format(memory, "iso_ramp(%s, %s)", first, second), BINDS_WHOLE};
}

/* Sine and cosine of one angle come from one call. */
static void declare_turn(emitter *e, node i)
{
    const graph_node *n = &e->g->nodes[i];
    for (node j = 0; j < i; j++) {
        const graph_node *other = &e->g->nodes[j];
        if (e->needed[j] && (other->op == OP_SIN || other->op == OP_COS) && other->a == n->a) {
            const char *pair = arena_copy(e->g->memory, e->shown[j].text, strlen(e->shown[j].text) - 4);
            e->shown[i] =
                (rendering){arena_format(e->g->memory, "%s.%s", pair, n->op == OP_SIN ? "sin" : "cos"), BINDS_WHOLE};
            return;
        }
    }
    const char *joint = n->name != NULL ? n->name + strlen("sin_") : "wave";
    const char *pair = unique_name(e, arena_format(e->g->memory, "turn_%s", joint));
    heading(e, n->section);
    text_add(e->out, "    const iso_sine_cosine %s = iso_sincos(%s);\n", pair, e->shown[n->a].text);
    e->shown[i] = (rendering){arena_format(e->g->memory, "%s.%s", pair, n->op == OP_SIN ? "sin" : "cos"), BINDS_WHOLE};
}

/* A node with a name or several uses is declared; the others stand where they are used, unless they grow long. */
static void emit_node(emitter *e, node i)
{
    const graph_node *n = &e->g->nodes[i];
    if (n->op == OP_SIN || n->op == OP_COS) {
        declare_turn(e, i);
        return;
    }
    e->shown[i] = is_timed(e->g, i) ? show_timed(e, n) : show(e, i);
    const bool leaf_like = n->op < OP_ADD || n->op == OP_NEG;
    if (leaf_like || (n->name == NULL && e->uses[i] < 2 && strlen(e->shown[i].text) < LONGEST_INLINE)) {
        return;
    }
    const char *wanted = n->name != NULL ? n->name : arena_format(e->g->memory, "t%d", ++e->temporaries);
    const char *name = unique_name(e, wanted);
    heading(e, n->section);
    statement(e->out, arena_format(e->g->memory, "const real %s = %s;", name, e->shown[i].text));
    e->shown[i] = (rendering){name, BINDS_WHOLE};
}

static void count_uses(emitter *e)
{
    for (size_t i = 0; i < e->g->count; i++) {
        const graph_node *n = &e->g->nodes[i];
        if (e->needed[i] && n->op >= OP_ADD) {
            e->uses[n->a]++;
            e->uses[n->b] += n->op <= OP_DIV;
        }
    }
    for (size_t i = 0; i < e->c->count; i++) {
        e->uses[e->roots[i]]++;
    }
}

/* const real q_shoulder = x[PLANT_X_SHOULDER]; for the states, inputs and parameters that are used. */
static void declare_leaves(emitter *e)
{
    static const struct {
        operation op;
        const char *array;
    } kinds[] = {{OP_STATE, "x"}, {OP_INPUT, "u"}, {OP_PARAMETER, "p"}, {OP_RIGHT, "d"}, {OP_FACTOR, "lu"}};
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        for (size_t i = 0; i < e->g->count; i++) {
            const graph_node *n = &e->g->nodes[i];
            if (e->needed[i] && n->op == kinds[k].op) {
                const char *name = unique_name(e, show(e, (node)i).text);
                text_add(e->out, "    const real %s = %s[%d];\n", name, kinds[k].array, n->index);
            }
        }
    }
}

bool code_emit(const code *c, text *out, double *culprit)
{
    node *roots = arena_take(out->memory, c->count + 1, sizeof *roots);
    graph economical = economise(c->g, c->roots, c->count, roots), *g = &economical;
    emitter e = {.c = c, .g = g, .out = out, .roots = roots, .section = -1};
    e.needed = arena_take(g->memory, g->count, sizeof *e.needed);
    e.uses = arena_take(g->memory, g->count, sizeof *e.uses);
    e.shown = arena_take(g->memory, g->count, sizeof *e.shown);
    graph_reach(g, roots, c->count, e.needed);
    count_uses(&e);
    declare_leaves(&e);
    for (size_t i = 0; i < g->count; i++) {
        if (e.needed[i]) {
            emit_node(&e, (node)i);
        }
    }
    text_add(out, "\n");
    for (size_t i = 0; i < c->count; i++) {
        statement(out, arena_format(g->memory, "%s = %s;", c->targets[i], e.shown[roots[i]].text));
    }
    *culprit = e.culprit;
    return e.culprit == 0.0;
}

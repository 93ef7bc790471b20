#include "tools/isoc/emit/code.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/base/dictionary.h"
#include "tools/isoc/base/numbers.h"
#include "tools/isoc/graph/timed.h"

enum { LONGEST_INLINE = 72 }; /* characters of an expression that stands inside another */

/* The text of a node where it is used. */
typedef struct rendering {
    const char *text;
    binding binds;
} rendering;

typedef struct emitter {
    const code *c;
    graph *g;
    text *out;
    node *roots;
    int *first, *next; /* the targets of each root, as lists: first[nodes], next[targets], -1 at their ends */
    bool *needed;
    int *uses;
    rendering *shown;
    const char **names;  /* of the nodes that are declared */
    const char **turned; /* of an angle: the variable with its sine and cosine */
    dictionary taken;    /* the names given so far, each with the number to try next behind it */
    int temporaries, section;
    size_t body;        /* where in the text the last heading ends */
    const char *quoted; /* the last line of the scene that was quoted */
    bool *is_marked;
    double *out_of_range_value;
    code_pieces *pieces; /* NULL: none are noted */
    size_t *piece_of;    /* [nodes] one more than the piece that declares it, or its sine and cosine; 0: none */
    size_t *turn_piece_of;
} emitter;

const char *shortest_decimal(arena *memory, double value, bool is_double)
{
    char digits[40];
    for (int precision = 1; precision <= 17; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, value);
        if (is_double ? strtod(digits, NULL) == value : strtof(digits, NULL) == (float)value) {
            break;
        }
    }
    return arena_copy(memory, digits, strlen(digits));
}

const char *code_decimal(arena *memory, double value, bool is_double)
{
    if (fabs(value) < (is_double ? DBL_MIN : (double)FLT_MIN)) {
        value = is_double ? copysign(0.0, value) : (double)(float)value;
    }
    const char *digits = shortest_decimal(memory, value, is_double);
    /* Without an exponent where that is as short: 20.0, not 2e+01. */
    if (fabs(value) >= 10.0 && fabs(value) < 1e6 && strchr(digits, '.') == NULL) {
        digits = arena_format(memory, "%.0f", value);
    }
    return arena_format(memory, "%s%s", digits, strpbrk(digits, ".e") == NULL ? ".0" : "");
}

const char *code_literal(arena *memory, double value, bool is_double)
{
    return arena_format(memory, "R(%s)", code_decimal(memory, value, is_double));
}

/* The wanted name; if it is taken, with the least number from 2 on behind it that makes a new name. */
static const char *unique_name(emitter *e, const char *wanted)
{
    const char *name = wanted;
    for (int *next = dictionary_find(&e->taken, wanted); dictionary_find(&e->taken, name) != NULL; ++*next) {
        name = arena_format(e->g->memory, "%s_%d", wanted, *next);
    }
    dictionary_put(&e->taken, name, 2);
    return name;
}

/* Where the last of these operators before `room` stands, or 0. */
static size_t last_operator(const char *line, size_t room, const char *signs)
{
    size_t closure = room;
    while (closure > 0 &&
           !(line[closure] == ' ' && strchr(signs, line[closure + 1]) != NULL && line[closure + 2] == ' ')) {
        closure--;
    }
    return closure;
}

/* A statement, broken before an operator where it would pass the margin. */
static void statement(text *out, int depth, const char *line)
{
    enum { COLUMNS = 120, INDENT = 4 };
    size_t room = (size_t)(COLUMNS - INDENT * depth);
    text_add(out, "%*s", INDENT * depth, "");
    while (strlen(line) > room) {
        size_t closure = last_operator(line, room, "+-");
        closure = closure > 0 ? closure : last_operator(line, room, "*/");
        if (closure == 0) {
            break;
        }
        text_add(out, "%.*s\n%*s", (int)closure, line, INDENT * (depth + 1) - 1, "");
        line += closure;
        room = (size_t)(COLUMNS - INDENT * (depth + 1));
    }
    text_add(out, "%s\n", line);
}

static void heading(emitter *e, int section)
{
    if (section != e->section) {
        e->section = section;
        text_add(e->out, "%s    /* %s */\n", e->out->length < 2 || e->out->bytes[e->out->length - 2] == '{' ? "" : "\n",
                 e->g->sections[section]);
    }
    e->body = e->out->length;
}

/* Parentheses where the operand binds less than its place asks for. */
static const char *operand_text(const emitter *e, node n, binding least)
{
    const rendering *r = &e->shown[n];
    return r->binds >= least ? r->text : arena_format(e->g->memory, "(%s)", r->text);
}

/* Notes the declared quantities and leaves that a piece reads: the ends of the expressions within it. */
static void note_reads(emitter *e, code_piece *result, const node *open, size_t count)
{
    graph *g = e->g;
    size_t read_room = 0, leaf_room = 0;
    LIST_OF(node) list = {0};
    FOR_ALL (const node, i, open, count) {
        LIST_ADD(g->memory, list, *i);
    }
    while (list.count > 0) {
        const node i = list.all[--list.count];
        const graph_node *n = &g->nodes[i];
        const bool turns = n->op == OP_SIN || n->op == OP_COS;
        const size_t piece = turns ? e->turn_piece_of[n->a] : e->piece_of[i];
        if (piece > 0) {
            ADD_TO(g->memory, result->reads, result->read_count, read_room, piece - 1);
            continue;
        }
        if (operators[n->op].operands == 0) {
            ADD_TO(g->memory, result->leaves, result->leaf_count, leaf_room, i);
        }
        for (int k = 0; k < operators[n->op].operands; k++) {
            LIST_ADD(g->memory, list, k == 0 ? n->a : n->b);
        }
    }
}

/* Whether a name has a word in it, between underscores or ends. */
static bool has_word(const char *name, const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = strstr(name, word); at != NULL; at = strstr(at + 1, word)) {
        if ((at == name || at[-1] == '_') && (at[length] == '\0' || at[length] == '_')) {
            return true;
        }
    }
    return false;
}

/* The mark of the longest name in this one, or -1. */
static int mark_of(const code *c, const char *name)
{
    int longest = -1;
    for (size_t i = 0; i < c->mark_count; i++) {
        const char *word = c->marks[i].name;
        if (has_word(name, word) && (longest < 0 || strlen(word) > strlen(c->marks[longest].name))) {
            longest = (int)i;
        }
    }
    return longest;
}

/* The text since the last piece is a piece, of these nodes. */
static void note_piece(emitter *e, const char *declares, bool is_turn, const node *n, size_t count)
{
    code_pieces *p = e->pieces;
    if (p != NULL) {
        const size_t begin = p->count == 0 ? 0 : p->all[p->count - 1].end;
        code_piece result = {.declares = declares, .is_turn = is_turn, .section = e->section};
        result.body = e->body > begin ? e->body : begin;
        result.angle = n[0];
        result.mark = declares == NULL || is_turn ? -1 : mark_of(e->c, declares);
        note_reads(e, &result, n, count);
        result.end = e->out->length;
        ADD_TO(e->g->memory, p->all, p->count, p->room, result);
    }
}

const char *code_phase(arena *memory, double turns)
{
    return arena_format(memory, "UINT64_C(0x%016llX)", (unsigned long long)phase_of(turns));
}

static const char *number(emitter *e, double value)
{
    if (!real_holds(value, e->c->is_double) && !real_is_tiny(value, e->c->is_double)) {
        *e->out_of_range_value = value;
    }
    return code_literal(e->g->memory, value, e->c->is_double);
}

/* Where the sine and cosine of a state stand already, or NULL. */
static const char *kept_turn(const emitter *e, node angle)
{
    const graph_node *n = &e->g->nodes[angle];
    return n->op == OP_STATE && e->c->turns != NULL ? e->c->turns[n->index] : NULL;
}

/* A state is not read where only its sine and cosine are asked for, and these stand in an array. */
static void leave_out_kept_angles(emitter *e)
{
    int *others = arena_take(e->g->memory, e->g->count, sizeof *others);
    memcpy(others, e->uses, e->g->count * sizeof *others);
    for (size_t i = 0; i < e->g->count; i++) {
        const graph_node *n = &e->g->nodes[i];
        if (e->needed[i] && (n->op == OP_SIN || n->op == OP_COS) && kept_turn(e, n->a) != NULL) {
            e->needed[n->a] = --others[n->a] > 0;
        }
    }
    arena_return(e->g->memory, others, e->g->count, sizeof *others);
}

/* Sine and cosine of one angle come from one call. */
static const char *turned(emitter *e, const graph_node *n)
{
    if (e->turned[n->a] == NULL) {
        const char *joint = n->name != NULL ? n->name + strlen("sin_") : "wave";
        e->turned[n->a] = unique_name(e, arena_format(e->g->memory, "turn_%s", joint));
        heading(e, n->section);
        const char *kept = kept_turn(e, n->a);
        const char *value = arena_format(e->g->memory, kept != NULL ? "{%s}" : "iso_sincos(%s)",
                                         kept != NULL ? kept : e->shown[n->a].text);
        text_add(e->out, "    const iso_sine_cosine %s = %s;\n", e->turned[n->a], value);
        note_piece(e, e->turned[n->a], true, &n->a, kept == NULL ? 1 : 0);
        e->turn_piece_of[n->a] = e->pieces == NULL ? 0 : e->pieces->count;
    }
    return e->turned[n->a];
}

static const leaf_name *leaf_of(const emitter *e, char array, int index)
{
    const leaf_names *all = &e->c->names;
    return &(array == 'x' ? all->states : array == 'u' ? all->inputs : all->parameters)[index];
}

/* A line of the scene, unless it stands above already. */
static void quote(emitter *e, const char *line)
{
    if (line != NULL && (e->quoted == NULL || strcmp(line, e->quoted) != 0)) {
        text_add(e->out, "    /* %s */\n", line);
        e->quoted = line;
    }
}

/* The line of the mark in a name, once, as part of the heading. */
static void quote_mark(emitter *e, const char *name)
{
    const int at = mark_of(e->c, name);
    if (at >= 0 && !e->is_marked[at]) {
        e->is_marked[at] = true;
        quote(e, e->c->marks[at].quote);
        e->body = e->out->length;
    }
}

/* The text for @letter in the text of an operator (tools/isoc/graph/operators.h). */
static const char *letter_text(emitter *e, const graph_node *n, char letter)
{
    const operator_row *row = &operators[n->op];
    arena *memory = e->g->memory;
    switch (letter) {
    case 'a':
        return operand_text(e, n->a, row->least_a);
    case 'b':
        return operand_text(e, n->b, row->least_b);
    case 't':
        return turned(e, n);
    case 'x':
    case 'u':
    case 'p':
        return leaf_of(e, letter, n->index)->symbol;
    case 'X':
        return leaf_of(e, 'x', n->index)->place;
    case 'i':
        return arena_format(memory, "%d", n->index);
    case '1':
        return number(e, n->value);
    case '2':
        return number(e, n->second);
    case 'w':
        return arena_format(memory, "UINT32_C(%.0f)", floor(n->value));
    case 'W':
        return arena_format(memory, "UINT32_C(%.0f)", floor(n->second));
    case 'f':
        return number(e, n->value - floor(n->value));
    case 'v':
        return code_phase(memory, n->value);
    default:
        return code_phase(memory, n->second);
    }
}

/* The operand of a product, or the dividend, that no normal float holds; -1 where there is none. */
static node tiny_factor(const emitter *e, const graph_node *n)
{
    const node operands[2] = {n->a, n->b};
    const int count = n->op == OP_MUL ? 2 : n->op == OP_DIV ? 1 : 0;
    for (int i = 0; i < count; i++) {
        if (is_constant(e->g, operands[i]) && real_is_tiny(constant_value(e->g, operands[i]), e->c->is_double)) {
            return operands[i];
        }
    }
    return -1;
}

/* The tiny factor is scaled up and the result is scaled down by 2^126. Both are exact, so that the result is rounded as
 * one of normal floats is, and underflows only where its own size does. */
static rendering show_tiny_product(emitter *e, const graph_node *n, node tiny)
{
    const char *down = code_literal(e->g->memory, 0x1p-126, false);
    text result = {.memory = e->g->memory};
    double factor = constant_value(e->g, tiny);
    int scales = 0;
    for (; real_is_tiny(factor, false); scales++) {
        factor *= 0x1p126;
    }
    text_add(&result, "%s %c %s", number(e, factor), n->op == OP_DIV ? '/' : '*',
             operand_text(e, tiny == n->a ? n->b : n->a, BINDS_WHOLE));
    while (scales-- > 0) {
        text_add(&result, " * %s", down);
    }
    return (rendering){result.bytes, BINDS_PRODUCT};
}

static rendering show(emitter *e, const graph_node *n)
{
    const operator_row *row = &operators[n->op];
    text result = {.memory = e->g->memory};
    if (n->op == OP_ADD && is_constant(e->g, n->a) && constant_value(e->g, n->a) < 0.0) {
        text_add(&result, "%s - %s", operand_text(e, n->b, BINDS_SUM), number(e, -constant_value(e->g, n->a)));
        return (rendering){result.bytes, BINDS_SUM};
    }
    const node tiny = tiny_factor(e, n);
    if (tiny >= 0) {
        return show_tiny_product(e, n, tiny);
    }
    text_add(&result, "%s", "");
    for (const char *c = row->text; *c != '\0'; c++) {
        if (*c == '@') {
            text_add(&result, "%s", letter_text(e, n, *++c));
        } else {
            text_add(&result, "%c", *c);
        }
    }
    return (rendering){result.bytes, row->binds};
}

/* A node with a name or several uses is declared; the others are written where they are used, unless they grow long. */
static void emit_node(emitter *e, node i)
{
    const graph_node *n = &e->g->nodes[i];
    e->shown[i] = show(e, n);
    if (operators[n->op].form == INLINE ||
        (n->name == NULL && e->uses[i] < 2 && strlen(e->shown[i].text) < LONGEST_INLINE)) {
        return;
    }
    const char *wanted = n->name != NULL ? n->name : arena_format(e->g->memory, "t%d", ++e->temporaries);
    const char *name = unique_name(e, wanted);
    heading(e, n->section);
    quote_mark(e, name);
    statement(e->out, 1, arena_format(e->g->memory, "const real %s = %s;", name, e->shown[i].text));
    e->shown[i] = (rendering){name, BINDS_WHOLE};
    e->names[i] = name;
    const node root[2] = {n->a, n->b};
    note_piece(e, name, false, root, (size_t)operators[n->op].operands);
    e->piece_of[i] = e->pieces == NULL ? 0 : e->pieces->count;
}

/* The names of a leaf that stands in an array; NULL for a factor, which has a number alone. */
static const leaf_name *named_leaf(const emitter *e, const graph_node *n)
{
    const char array = operators[n->op].array[0];
    return n->op == OP_FACTOR ? NULL : leaf_of(e, array == 'd' ? 'x' : array, n->index);
}

/* const real q_shoulder = x[PLANT_X_SHOULDER]; or NULL for a node that stands in no array. */
static const char *declaration(emitter *e, node i)
{
    const graph_node *n = &e->g->nodes[i];
    const char *array = operators[n->op].array;
    if (array == NULL) {
        return NULL;
    }
    const char *name = unique_name(e, show(e, n).text);
    const leaf_name *leaf = named_leaf(e, n);
    const char *place = leaf == NULL ? arena_format(e->g->memory, "%d", n->index) : leaf->place;
    return arena_format(e->g->memory, "    const real %s = %s[%s];\n", name, array, place);
}

/* The scene's line of a leaf that stands in an array, where the function quotes them. */
static const char *quote_of_leaf(const emitter *e, node i)
{
    const leaf_name *leaf = named_leaf(e, &e->g->nodes[i]);
    return leaf != NULL && e->c->quotes_leaves ? leaf->quote : NULL;
}

/* For the states, inputs and parameters that are used. */
static void declare_leaves(emitter *e)
{
    for (operation op = 0; op < OPERATIONS; op++) {
        for (size_t i = 0; i < e->g->count && operators[op].array != NULL; i++) {
            const graph_node *n = &e->g->nodes[i];
            if (e->needed[i] && n->op == op) {
                const char *result = declaration(e, (node)i);
                quote(e, quote_of_leaf(e, (node)i));
                text_add(e->out, "%s", result);
            }
        }
    }
}

/* The number of targets that are set in every call. */
static size_t count_unkept(const code *c)
{
    return c->count - c->kept;
}

/* Without the negations and other operations that the function as a whole can do without. */
static emitter begin(const code *c, text *out, double *out_of_range_value)
{
    arena *memory = c->g->memory;
    graph *g = arena_take(memory, 1, sizeof *g);
    node *roots = arena_take(memory, c->count + 1, sizeof *roots);
    *g = economise(c->g, c->roots, c->count, roots);
    emitter e = {.c = c, .g = g, .out = out, .roots = roots, .taken = {.memory = memory}, .section = -1};
    e.out_of_range_value = out_of_range_value;
    e.first = arena_take(memory, g->count, sizeof *e.first);
    e.next = arena_take(memory, c->count + 1, sizeof *e.next);
    e.needed = arena_take(memory, g->count, sizeof *e.needed);
    e.uses = arena_take(memory, g->count, sizeof *e.uses);
    e.shown = arena_take(memory, g->count, sizeof *e.shown);
    e.names = arena_take(memory, g->count, sizeof *e.names);
    e.is_marked = arena_take(memory, c->mark_count + 1, sizeof *e.is_marked);
    e.turned = arena_take(memory, g->count, sizeof *e.turned);
    e.piece_of = arena_take(memory, g->count, sizeof *e.piece_of);
    e.turn_piece_of = arena_take(memory, g->count, sizeof *e.turn_piece_of);
    graph_reach(g, roots, c->count, e.needed);
    graph_uses(g, roots, c->count, e.needed, e.uses);
    leave_out_kept_angles(&e);
    memset(e.first, -1, g->count * sizeof *e.first);
    for (size_t i = count_unkept(c); i-- > 0;) {
        e.next[i] = e.first[roots[i]];
        e.first[roots[i]] = (int)i;
    }
    return e;
}

/* Sets a target. */
static void set(emitter *e, size_t target, int depth)
{
    const node root = e->roots[target];
    const char *value = e->c->zero != NULL && is_zero(e->g, root) ? e->c->zero : e->shown[root].text;
    quote(e, e->c->quotes == NULL ? NULL : e->c->quotes[target]);
    statement(e->out, depth, arena_format(e->g->memory, "%s = %s;", e->c->targets[target], value));
}

/* The targets that a step keeps only of its last stage; very many in several pieces. */
static void keep(emitter *e)
{
    enum { MOST = 250 };
    for (size_t end, i = count_unkept(e->c); i < e->c->count; i = end) {
        end = e->c->count - i > MOST ? i + MOST : e->c->count;
        text_add(e->out, "    if (kept != NULL) {\n");
        for (size_t k = i; k < end; k++) {
            set(e, k, 2);
        }
        text_add(e->out, "    }\n");
        note_piece(e, NULL, false, e->roots + i, end - i);
    }
}

/* The last node that a step keeps, or -1. */
static node last_kept(const emitter *e)
{
    node last = -1;
    for (size_t i = count_unkept(e->c); i < e->c->count; i++) {
        last = e->roots[i] > last ? e->roots[i] : last;
    }
    return last;
}

/* The needed nodes; the kept targets as soon as all are known; and in pieces each target as soon as it is known. */
static void emit_nodes(emitter *e)
{
    const node last = last_kept(e);
    for (size_t i = 0; i < e->g->count; i++) {
        const node root = (node)i;
        if (e->needed[i]) {
            emit_node(e, root);
        }
        for (int target = e->pieces == NULL ? -1 : e->first[i]; target >= 0; target = e->next[target]) {
            set(e, (size_t)target, 1);
            note_piece(e, NULL, false, &root, 1);
        }
        if (root == last) {
            keep(e);
        }
    }
}

void code_emit(const code *c, text *out, double *out_of_range_value)
{
    emitter e = begin(c, out, out_of_range_value);
    declare_leaves(&e);
    emit_nodes(&e);
    text_add(out, "\n");
    for (size_t i = 0; i < count_unkept(c); i++) {
        set(&e, i, 1);
    }
}

code_nodes code_in_nodes(const code *c)
{
    double out_of_range_value;
    text unread = {.memory = c->g->memory};
    emitter e = begin(c, &unread, &out_of_range_value);
    text_add(&unread, "{\n");
    declare_leaves(&e);
    emit_nodes(&e);
    return (code_nodes){e.g, e.roots, e.needed, e.names};
}

code_pieces code_in_pieces(const code *c, double *out_of_range_value)
{
    arena *memory = c->g->memory;
    code_pieces result = {.text = {.memory = memory}, .marks = c->marks};
    emitter e = begin(c, &result.text, out_of_range_value);
    e.pieces = &result;
    result.g = e.g;
    result.leaves = arena_take(memory, e.g->count, sizeof *result.leaves);
    result.quotes = arena_take(memory, e.g->count, sizeof *result.quotes);
    result.is_marked = arena_take(memory, c->mark_count + 1, sizeof *result.is_marked);
    text_add(&result.text, "{\n");
    e.body = result.text.length;
    for (size_t i = 0; i < e.g->count; i++) {
        result.leaves[i] = e.needed[i] ? declaration(&e, (node)i) : NULL;
        result.quotes[i] = result.leaves[i] == NULL ? NULL : quote_of_leaf(&e, (node)i);
    }
    emit_nodes(&e);
    return result;
}

size_t code_length(const code_pieces *from)
{
    size_t result = from->count;
    for (size_t i = 0; i < from->g->count; i++) {
        result += from->leaves[i] != NULL;
    }
    return result;
}

void code_add_piece(const code_pieces *from, size_t i, text *out)
{
    const code_piece *c = &from->all[i];
    if (c->mark >= 0 && !from->is_marked[c->mark]) {
        from->is_marked[c->mark] = true;
        text_add(out, "    /* %s */\n", from->marks[c->mark].quote);
    }
    text_add(out, "%.*s", (int)(c->end - c->body), from->text.bytes + c->body);
}

/* Nodes as expressions of text and of LaTeX. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/export/equations.h"

/* How tightly an expression binds; one with a sign before it is a product. */
typedef enum tightness { OF_SUM, OF_SIGNED, OF_PRODUCT, OF_WHOLE } tightness;

typedef struct expression {
    const char *text;
    tightness binds;
    node base; /* it is a power of this node, */
    int exponent;
} expression;

/* Operators besides sums, products, quotients and signs, with the letters of tools/isoc/graph/operators.h, @d for the
 * state of a derivative, @k and @l for @1 and @2 with all digits, @t and @T for them as ticks. A function of core
 * without a row is called by its own word. */
typedef struct spelling {
    const char *text[EQUATIONS_STYLES];
    const char *meaning; /* where it is not a usual one */
} spelling;

static const spelling spellings[OPERATIONS] = {
    [OP_TURNS] = {{"turns_@i", "\\mathrm{turns}_{@i}"},
                  "turns_0, turns_1, ...: the angle of whole turns of continuous joints"},
    [OP_LOCAL_ERROR] = {{"local_error", "\\mathrm{local\\_error}"}, "local_error: the estimate of a checked step"},
    [OP_RESIDUAL] = {{"residual", "\\mathrm{residual}"}, "residual: what Newton's iteration leaves"},
    [OP_DERIVATIVE] = {{"der(@d)", "\\tfrac{\\mathrm{d}}{\\mathrm{d}t}@d"}, NULL},
    [OP_PHASE] = {{"phase(k, @k, @l)", "\\operatorname{phase}(k, @k, @l)"},
                  "phase(k, a, b): the angle of a k + b turns, in [-pi, pi)"},
    [OP_RAMP] = {{"min(max(k - @t, 0), @T)", "\\min(\\max(k - @t, 0), @T)"}, NULL},
    [OP_NOISE] = {{"noise(k, @k)", "\\operatorname{noise}(k, @k)"},
                  "noise(k, a): Gaussian numbers of the seed a, core/numbers/noise.h"},
    [OP_TIME] = {{"(@2 * k)", "(@2 \\, k)"}, NULL},
    [OP_FROM] = {{"[k >= @k]", "[k \\ge @k]"}, NULL},
    [OP_SQUARE] = {{"square(k, @k, @l, @i)", "\\operatorname{square}(k, @k, @l, @i)"},
                   "square(k, a, b, c): 1 where (k + b) mod a < c, else -1"},
    [OP_SQUARE_OF_PHASE] = {{"half(k, @k, @l)", "\\operatorname{half}(k, @k, @l)"},
                            "half(k, a, b): 1 in the first half of each turn of a k + b turns, else -1"},
    [OP_CYCLE] = {{"cycle(k, @k, @l)", "\\operatorname{cycle}(k, @k, @l)"},
                  "cycle(k, a, b): a k + b less its whole part"},
    [OP_PRBS] = {{"prbs_@i(k)", "\\operatorname{prbs}_{@i}(k)"}, "prbs_0(k), ...: bits of tables in plant.c"},
    [OP_CHIRP] = {{"chirp_@i(k)", "\\operatorname{chirp}_{@i}(k)"}, "chirp_0(k), ...: sweeps of tables in plant.c"},
    [OP_LINES] = {{"lines_@i(k)", "\\operatorname{lines}_{@i}(k)"}, "lines_0(k), ...: lines of tables in plant.c"},
    [OP_SINCE] = {{"(@2 * since(k, @t))", "(@2 \\, \\operatorname{since}(k, @t))"},
                  "since(k, a): k - a; before the last tick below a that less than 0 which it is there"},
    [OP_ABS] = {{"abs(@a)", "\\left|@a\\right|"}, NULL},
    [OP_MAX] = {{"max(@a, @b)", "\\max(@a, @b)"}, NULL},
    [OP_MIN] = {{"min(@a, @b)", "\\min(@a, @b)"}, NULL},
    [OP_POSITIVE] = {{"max(@a, 0)", "\\max(@a, 0)"}, NULL},
    [OP_NEGATIVE] = {{"min(@a, 0)", "\\min(@a, 0)"}, NULL},
    [OP_ABOVE] = {{"[@a > @b]", "[@a > @b]"}, "[a > b]: 1 where it is true, else 0"},
    [OP_WRAP] = {{"wrap(@a)", "\\operatorname{wrap}(@a)"}, "wrap(a): the angle a without whole turns, in [-pi, pi]"},
    [OP_SIN] = {{"sin(@a)", "\\sin(@a)"}, NULL},
    [OP_COS] = {{"cos(@a)", "\\cos(@a)"}, NULL},
    [OP_SQRT] = {{"sqrt(@a)", "\\sqrt{@a}"}, NULL},
    [OP_INVERSE_ROOT] = {{"(1 / sqrt(@a))", "\\left(1/\\sqrt{@a}\\right)"}, NULL},
    [OP_EXP] = {{"exp(@a)", "\\exp(@a)"}, NULL},
    [OP_LOG] = {{"log(@a)", "\\ln(@a)"}, NULL},
    [OP_POWER] = {{"power(@a, @b)", "\\operatorname{power}(@a, @b)"}, "power(a, b): a to the power b"},
    [OP_TANH] = {{"tanh(@a)", "\\tanh(@a)"}, NULL},
    [OP_FLOOR] = {{"floor(@a)", "\\lfloor @a\\rfloor"}, NULL},
    [OP_ROUND] = {{"round(@a)", "\\operatorname{round}(@a)"},
                  "round(a): the nearest whole number, of two the even one"},
    [OP_WHERE] = {{"where(@a, @b)", "\\operatorname{where}(@a, @b)"}, "where(a, b): b where a > 1/2, else 0"},
    [OP_ONLY] = {{"only(@a, @b)", "\\operatorname{only}(@a, @b)"}, "only(a, b): b where a > 1/2, else no number"},
    [OP_UNLESS] = {{"unless(@a, @b)", "\\operatorname{unless}(@a, @b)"}, "unless(a, b): 0 where a > 1/2, else b"},
};

const char *spell_meaning(operation op)
{
    return spellings[op].meaning;
}

/* --- names --- */

static const char *const greek[] = {"alpha", "beta",    "gamma",  "delta", "epsilon", "zeta",  "eta", "theta",
                                    "iota",  "kappa",   "lambda", "mu",    "nu",      "xi",    "rho", "sigma",
                                    "tau",   "upsilon", "phi",    "chi",   "psi",     "omega", "pi"};

static bool is_greek(const char *word)
{
    return index_of_word(word, greek, COUNT_OF(greek)) < COUNT_OF(greek);
}

/* The prefixes of names; of two that fit, the first counts. */
static const struct {
    const char *head, *text, *of_angle;
} heads[] = {
    {"qdd_", "\\ddot{q}", "\\ddot{\\theta}"},
    {"qd_", "\\dot{q}", "\\dot{\\theta}"},
    {"q_", "q", "\\theta"},
    {"Phi_dd_", "\\ddot{\\Phi}", NULL},
    {"Phi_", "\\Phi", NULL},
    {"inverse_D_", "{D^{-1}}", NULL},
};

static bool is_angle(const equations_document *to, const char *called)
{
    bool any = false;
    FOR_ALL (const variable, about, to->names->x.all, to->names->x.count) {
        any = any || (strcmp(about->name, called) == 0 && strcmp(about->unit, "rad") == 0);
    }
    return any;
}

/* The words of a name, between underscores, as a subscript. */
static const char *subscript(arena *memory, const char *words)
{
    text result = {.memory = memory};
    while (*words != '\0') {
        const size_t length = strcspn(words, "_");
        const char *word = arena_copy(memory, words, length);
        text_add(&result, is_greek(word) ? "\\%s" : "\\mathrm{%s}", word);
        words += length;
        text_add(&result, "%s", *words == '_' ? "," : "");
        words += *words == '_';
    }
    return result.bytes;
}

/* t_{12} of t12, \tau of tau, \mathrm{effort} of effort. */
static const char *symbol(arena *memory, const char *word)
{
    const size_t length = strcspn(word, "0123456789");
    const char *letters = arena_copy(memory, word, length);
    const char *spelled = is_greek(letters) ? arena_format(memory, "\\%s", letters)
                          : length == 1     ? letters
                                            : arena_format(memory, "\\mathrm{%s}", letters);
    return word[length] == '\0' ? spelled : arena_format(memory, "%s_{%s}", spelled, word + length);
}

const char *spell_name(const equations_document *to, const char *word)
{
    static const char minus[] = "minus_";
    arena *memory = to->out->memory;
    if (to->style == EQUATIONS_TEXT) {
        return word;
    }
    const bool is_negative = strncmp(word, minus, sizeof minus - 1) == 0;
    const char *rest = is_negative ? word + sizeof minus - 1 : word, *head = NULL;
    for (size_t i = 0; i < COUNT_OF(heads) && head == NULL; i++) {
        const size_t length = strlen(heads[i].head);
        if (strncmp(rest, heads[i].head, length) == 0) {
            rest += length;
            head = heads[i].of_angle != NULL && is_angle(to, rest) ? heads[i].of_angle : heads[i].text;
        }
    }
    if (head == NULL) {
        const size_t length = strcspn(rest, "_");
        head = symbol(memory, arena_copy(memory, rest, length));
        rest += length + (rest[length] == '_');
    }
    const char *whole = *rest == '\0' ? head : arena_format(memory, "%s_{%s}", head, subscript(memory, rest));
    return is_negative ? arena_format(memory, "\\overline{%s}", whole) : whole;
}

const char *spell_words(const equations_document *to, const char *words)
{
    text result = empty_text(to->out->memory);
    for (const char *c = words; *c != '\0' && to->style == EQUATIONS_LATEX; c++) {
        if (strchr("\\^~", *c) != NULL) {
            text_add(&result, "\\char%d{}", *c);
        } else {
            text_add(&result, "%s%c", strchr("_{}#$%&", *c) != NULL ? "\\" : "", *c);
        }
    }
    return to->style == EQUATIONS_LATEX ? result.bytes : words;
}

const char *spell_unit(const equations_document *to, const char *symbols)
{
    text result = {.memory = to->out->memory};
    for (const char *c = symbols; *c != '\0'; c++) {
        text_add(&result, *c == '*' ? "\\," : *c == ' ' ? "\\ " : "%c", *c);
    }
    return to->style == EQUATIONS_LATEX ? arena_format(to->out->memory, "\\mathrm{%s}", result.bytes) : symbols;
}

/* --- expressions --- */

/* The shortest decimal that reads back as the same number of the plant. */
const char *spell_number(arena *memory, equations_style style, double number, bool is_double)
{
    const char *digits = code_decimal(memory, number, is_double), *power = strchr(digits, 'e');
    const size_t length = strlen(digits);
    if (length > 2 && strcmp(digits + length - 2, ".0") == 0) {
        return arena_copy(memory, digits, length - 2);
    }
    return style == EQUATIONS_TEXT || power == NULL
               ? digits
               : arena_format(memory, "%.*s \\cdot 10^{%d}", (int)(power - digits), digits, atoi(power + 1));
}

static const char *operand_of(const equations_document *to, const expression *all, node i, tightness least)
{
    arena *memory = to->out->memory;
    const expression *e = &all[i];
    const bool is_tall = strstr(e->text, "\\frac") != NULL || strstr(e->text, "\\left") != NULL;
    return e->binds >= least                         ? e->text
           : to->style == EQUATIONS_LATEX && is_tall ? arena_format(memory, "\\left(%s\\right)", e->text)
                                                     : arena_format(memory, "(%s)", e->text);
}

/* A sum or a difference; a sign before the second, or the first of a sum, turns the one between them. */
static expression spelled_sum(const equations_document *to, const expression *all, const graph_node *n)
{
    const bool is_turned = n->op == OP_ADD && all[n->a].binds == OF_SIGNED && all[n->b].binds != OF_SIGNED;
    const node first = is_turned ? n->b : n->a, second = is_turned ? n->a : n->b;
    const bool is_signed = all[second].binds == OF_SIGNED;
    const bool is_minus = (n->op == OP_SUB) != is_signed;
    const tightness least = n->op == OP_SUB || all[second].text[0] == '-' ? OF_SIGNED : OF_SUM;
    return (expression){.text = arena_format(to->out->memory, "%s %c %s", operand_of(to, all, first, OF_SUM),
                                             is_minus ? '-' : '+', operand_of(to, all, second, least) + is_signed),
                        .binds = OF_SUM};
}

static expression spelled_product(const equations_document *to, const expression *all, const graph_node *n)
{
    arena *memory = to->out->memory;
    const bool is_latex = to->style == EQUATIONS_LATEX;
    const tightness binds = all[n->a].binds == OF_SIGNED ? OF_SIGNED : OF_PRODUCT;
    const expression *a = &all[n->a], *b = &all[n->b];
    if (n->op == OP_MUL && a->base == b->base) {
        const int exponent = a->exponent + b->exponent;
        return (expression){.text = arena_format(memory, is_latex ? "%s^{%d}" : "%s^%d",
                                                 operand_of(to, all, a->base, OF_WHOLE), exponent),
                            .binds = OF_PRODUCT,
                            .base = a->base,
                            .exponent = exponent};
    }
    if (n->op == OP_DIV && is_latex) {
        return (expression){.text = arena_format(memory, "\\frac{%s}{%s}", a->text, b->text), .binds = OF_PRODUCT};
    }
    const char *right = operand_of(to, all, n->b, n->op == OP_DIV ? OF_WHOLE : OF_PRODUCT);
    const char *sign = n->op == OP_DIV ? "/" : !is_latex ? "*" : isdigit((unsigned char)right[0]) ? "\\cdot" : "\\,";
    return (expression){.text = arena_format(memory, "%s %s %s", operand_of(to, all, n->a, OF_SIGNED), sign, right),
                        .binds = binds};
}

static const leaf_name *leaf_called(const equations_document *to, const graph_node *n)
{
    const leaf_names *all = &to->names->leaves;
    return &(n->op == OP_INPUT ? all->inputs : n->op == OP_PARAMETER ? all->parameters : all->states)[n->index];
}

static const char *letter(const equations_document *to, const expression *all, const graph_node *n, char which)
{
    const bool is_first = strchr("1kt", which) != NULL, is_exact = strchr("kl", which) != NULL;
    const double number = is_first ? n->value : n->second;
    switch (which) {
    case 'a':
        return operand_of(to, all, n->a, OF_SUM);
    case 'b':
        return operand_of(to, all, n->b, OF_SUM);
    case 'i':
        return arena_format(to->out->memory, "%d", n->index);
    case 'd':
        return spell_name(to, to->names->leaves.states[n->index].symbol);
    case 't':
    case 'T':
        return arena_format(to->out->memory, to->p->is_double ? "%.17g" : "%.12g", number);
    default:
        return spell_number(to->out->memory, to->style, number, to->p->is_double || is_exact);
    }
}

/* The operator's row, or core's word for it. */
static expression spelled_call(const equations_document *to, const expression *all, const graph_node *n)
{
    arena *memory = to->out->memory;
    text result = {.memory = memory};
    const char *row = spellings[n->op].text[to->style];
    if (row == NULL) {
        const char *call = operators[n->op].call + strlen("iso_");
        row = arena_format(memory, to->style == EQUATIONS_LATEX ? "\\operatorname{%.*s}(@a%s)" : "%.*s(@a%s)",
                           (int)strcspn(call, "("), call, operators[n->op].operands > 1 ? ", @b" : "");
    }
    for (const char *c = row; *c != '\0'; c++) {
        text_add(&result, *c == '@' ? "%s" : "%.1s", *c == '@' ? letter(to, all, n, c[1]) : c);
        c += *c == '@';
    }
    return (expression){.text = result.bytes, .binds = OF_WHOLE};
}

static expression spelled(const equations_document *to, const expression *all, const graph_node *n)
{
    arena *memory = to->out->memory;
    switch (n->op) {
    case OP_CONSTANT: {
        const char *number = spell_number(memory, to->style, n->value, to->p->is_double);
        return (expression){.text = number,
                            .binds = number[0] == '-'              ? OF_SIGNED
                                     : strchr(number, ' ') != NULL ? OF_PRODUCT
                                                                   : OF_WHOLE};
    }
    case OP_STATE:
    case OP_INPUT:
    case OP_PARAMETER:
        return (expression){.text = spell_name(to, leaf_called(to, n)->symbol), .binds = OF_WHOLE};
    case OP_ADD:
    case OP_SUB:
        return spelled_sum(to, all, n);
    case OP_MUL:
    case OP_DIV:
        return spelled_product(to, all, n);
    case OP_NEG:
        return (expression){.text = arena_format(memory, "-%s", operand_of(to, all, n->a, OF_PRODUCT)),
                            .binds = OF_SIGNED};
    default:
        return spelled_call(to, all, n);
    }
}

const char *const *spell_nodes(const equations_document *to, const code_nodes *nodes)
{
    const graph *g = nodes->g;
    expression *all = arena_take(g->memory, g->count, sizeof *all);
    const char **result = arena_take(g->memory, g->count, sizeof *result);
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        if (!nodes->needed[i]) {
            continue;
        }
        to->is_asked[n->op] = true;
        all[i] = spelled(to, all, n);
        result[i] = all[i].text;
        if (nodes->names[i] != NULL) {
            all[i] = (expression){.text = spell_name(to, nodes->names[i]), .binds = OF_WHOLE};
        }
        if (all[i].exponent == 0) {
            all[i].base = (node)i;
            all[i].exponent = 1;
        }
    }
    return result;
}

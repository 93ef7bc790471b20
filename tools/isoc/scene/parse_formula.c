#include "tools/isoc/scene/take.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 100 };

formula *formula_new(parser *p, formula_kind kind, place at)
{
    formula *f = arena_take(p->s->memory, 1, sizeof *f);
    *f = (formula){.kind = kind, .at = at, .unit = unit_one};
    return f;
}

void formula_put(parser *p, formula *f, formula *part)
{
    ADD_TO(p->s->memory, f->parts, f->count, f->room, part);
}

/* Words that may follow a number on its line; they are not misspelt units. */
static bool next_is_connective(const parser *p)
{
    static const char *const words[] = {"at",   "about", "rotate", "quaternion", "rest",     "along", "of",
                                        "jump", "in",    "to",     "and",        "or",       "set",   "like",
                                        "safe", "after", "ticks",  "every",      "as_given", "then"};
    return (p->next->kind == TOKEN_NAME && index_of_word(p->next->text, words, COUNT_OF(words)) < COUNT_OF(words)) ||
           block_has_word(p->within, p->next);
}

static bool is_unit(const token *t)
{
    unit u;
    return t->kind == TOKEN_NAME && unit_find(t->text, &u);
}

/* sqrt(Hz), sqrt(N*m^2) and the like: nothing but a unit in the parentheses. */
static bool is_root(const token *t)
{
    if (t->kind != TOKEN_NAME || strcmp(t->text, "sqrt") != 0 || t[1].sign != '(') {
        return false;
    }
    for (t += 2; is_unit(t); t++) {
        t++;
        if (t->sign == '^') {
            t += t[1].sign == '-' ? 3 : 2;
        }
        if (t->sign != '*' && t->sign != '/') {
            return t->sign == ')';
        }
    }
    return false;
}

/* 1/s, which stands behind a number like any unit. */
static bool next_is_inverse(const parser *p)
{
    const token *t = p->next;
    return t->kind == TOKEN_NUMBER && strcmp(t->text, "1") == 0 && t[1].sign == '/' &&
           (is_unit(t + 2) || is_root(t + 2));
}

static bool next_is_unit(const parser *p)
{
    return !p->next->first_on_line && (is_unit(p->next) || is_root(p->next) || next_is_inverse(p));
}

/* After `*` or `/` a unit continues only if the name of a unit follows: in 2 N * sin(3 Hz) it ends at N. */
static bool unit_goes_on(const parser *p)
{
    const token *after = p->next + 1;
    return (next_is_sign(p, '*') || next_is_sign(p, '/')) &&
           ((is_unit(after) && after[1].sign != '(') || is_root(after));
}

/* 20 degC is a place on a scale and no multiple of a unit: it is not multiplied, so the scale stands alone. */
static bool refuse_scale(parser *p, place at, const char *called)
{
    return PARSE_FAULT(p, at, "'%s' stands alone behind a number, as in 20 degC; a difference of temperatures is in K",
                       called);
}

/* A power: digits. */
static int take_power(parser *p, int most, const char *expected)
{
    const token *t = p->next;
    if (t->kind != TOKEN_NUMBER || t->text[strspn(t->text, "0123456789")] != '\0' || t->number > most) {
        parse_problem(p, expected);
        return 0;
    }
    return (int)(p->next++)->number;
}

static bool refuse_power(parser *p, place at)
{
    return PARSE_FAULT(p, at, "a power of kg, m, s, rad, A or K is beyond %d", MOST_POWER);
}

static void note_factor(parser *p)
{
    LIST_ADD(p->s->memory, p->factors, ((name){p->next->text, p->next->at}));
}

static unit parse_unit(parser *p);

/* ( unit ), behind sqrt. */
static bool multiply_root(parser *p, unit *product, int power, place at)
{
    dimension root;
    p->next++;
    note_factor(p);
    const unit u = parse_unit(p);
    p->next++;
    const double size = sqrt(u.numerator / u.denominator);
    dimension_root(u.dim, &root);
    product->numerator *= power > 0 ? size : 1.0;
    product->denominator *= power > 0 ? 1.0 : size;
    return dimension_times(&product->dim, root, power) || refuse_power(p, at);
}

/* unit name [^ [-] power], or sqrt(unit) */
static bool parse_unit_factor(parser *p, unit *product, bool divide, bool is_first)
{
    unit u;
    unit_find(p->next->text, &u);
    const token *word = p->next++;
    int power = divide ? -1 : 1;
    if (is_root(word)) {
        return multiply_root(p, product, power, word->at);
    }
    if (take_sign(p, '^')) {
        power = take_sign(p, '-') ? -power : power;
        power *= take_power(p, MOST_POWER, "the power of a unit is a whole number up to 60: m/s^2");
        if (p->failed) {
            return false;
        }
    }
    for (int i = 0; i < abs(power); i++) {
        product->numerator *= power > 0 ? u.numerator : u.denominator;
        product->denominator *= power > 0 ? u.denominator : u.numerator;
    }
    if (!dimension_times(&product->dim, u.dim, power)) {
        return refuse_power(p, word->at);
    }
    product->zero = u.zero;
    return u.zero == 0.0 || (is_first && !divide && p->next == word + 1 && !unit_goes_on(p)) ||
           refuse_scale(p, word->at, word->text);
}

/* unit { (* | /) unit }, or 1 / unit { (* | /) unit } */
static unit parse_unit(parser *p)
{
    unit product = unit_one;
    const bool inverse = next_is_inverse(p);
    p->next += inverse ? 2 : 0;
    bool going = parse_unit_factor(p, &product, inverse, true);
    while (going && unit_goes_on(p)) {
        const bool divide = next_is_sign(p, '/');
        p->next++;
        note_factor(p);
        going = parse_unit_factor(p, &product, divide, false);
    }
    return product;
}

/* 1, of a plain number. */
static bool next_is_one(const parser *p)
{
    return p->next->kind == TOKEN_NUMBER && strcmp(p->next->text, "1") == 0 && !p->next->first_on_line;
}

bool take_unit(parser *p, unit *taken)
{
    if (!p->failed && !next_is_unit(p) && next_is_one(p)) {
        *taken = unit_one;
        p->next++;
        return true;
    }
    const bool is = !p->failed && next_is_unit(p);
    const token *first = p->next;
    const size_t factors = p->factors.count;
    if (is) {
        *taken = parse_unit(p);
        p->factors.count = factors; /* no formula stands here, and no name of a quantity */
    }
    if (is && !p->failed && taken->zero != 0.0) {
        refuse_scale(p, first->at, first->text);
    }
    return is;
}

void refuse_factor(parser *p, size_t from, name called)
{
    for (size_t i = from; i < p->factors.count; i++) {
        if (name_is(p->factors.all[i], called.text)) {
            source_problem(p->s, called.at, "'%s' is a unit, as in %s: choose another name", called.text,
                           source_line(p->s, p->factors.all[i].at));
            return;
        }
    }
}

/* Reports a word that stands where only a unit can. */
static void refuse_false_unit(parser *p)
{
    if (p->next->kind == TOKEN_NAME && !p->next->first_on_line && !next_is_connective(p)) {
        size_t count;
        const char *const *names = unit_names(&count);
        if (is_unit(p->next)) {
            PARSE_FAULT(p, p->next->at, "a unit behind a unit: a product has a sign between them, as in kg*m^2");
        } else {
            PARSE_FAULT(p, p->next->at, "unknown unit '%s'%s", p->next->text,
                        source_suggestion(p->s, p->next->text, names, count));
        }
        p->next++;
    }
}

static formula *parse_number(parser *p)
{
    formula *f = formula_new(p, FORMULA_NUMBER, p->next->at);
    f->number = p->next->number;
    p->next++;
    if (next_is_unit(p)) {
        f->unit = parse_unit(p);
    }
    refuse_false_unit(p);
    return f;
}

/* formula [ (< | > | <= | >= | ==) formula ] */
static formula *parse_comparison(parser *p)
{
    formula *left = parse_formula(p);
    const bool is_equal = next_is_sign(p, '=') && p->next[1].sign == '=';
    if (left == NULL || (!next_is_sign(p, '<') && !next_is_sign(p, '>') && !is_equal)) {
        return left;
    }
    formula *f = formula_new(p, FORMULA_ORDER, p->next->at);
    f->sign = p->next->sign;
    p->next++;
    f->number = take_sign(p, '=') ? 1.0 : 0.0;
    formula *right = parse_formula(p);
    if (right == NULL) {
        return NULL;
    }
    formula_put(p, f, left);
    formula_put(p, f, right);
    return f;
}

/* [not] comparison */
static formula *parse_denial(parser *p)
{
    if (!next_is_word(p, "not")) {
        return parse_comparison(p);
    }
    formula *f = formula_new(p, FORMULA_LOGIC, p->next->at);
    f->sign = '~';
    p->next++;
    formula *denied = parse_comparison(p);
    if (denied == NULL) {
        return NULL;
    }
    formula_put(p, f, denied);
    return f;
}

/* part { word part } */
static formula *parse_joined(parser *p, const char *word, char sign, formula *(*parse_part)(parser *))
{
    formula *f = parse_part(p);
    while (f != NULL && next_is_word(p, word)) {
        formula *both = formula_new(p, FORMULA_LOGIC, p->next->at);
        both->sign = sign;
        p->next++;
        formula *right = parse_part(p);
        formula_put(p, both, f);
        formula_put(p, both, right);
        f = right == NULL ? NULL : both;
    }
    return p->failed ? NULL : f;
}

static formula *parse_conjunction(parser *p)
{
    return parse_joined(p, "and", '&', parse_denial);
}

/* It stands in parentheses, and behind `when`: elsewhere its signs and words are a statement's own. */
formula *parse_condition(parser *p)
{
    return parse_joined(p, "or", '|', parse_conjunction);
}

/* formula { , formula } ), after the opening parenthesis. A semicolon separates like a comma, and so does a colon
 * between time and value. Points may stand behind a quantity that they are of, lines of values behind two, and a file
 * behind either. */
static void parse_parts(parser *p, formula *f, bool of_points)
{
    do {
        if (of_points && f->number > 0.0 && (take_map(p, f) || take_table_option(p, f))) {
            continue;
        }
        if (f->name != NULL && strcmp(f->name, "sample") == 0 && f->count == 1 && !take_word(p, "every")) {
            parse_problem(p, "expected 'every' and a time: sample(x, every 5 ms)");
            return;
        }
        formula *part = parse_condition(p);
        if (part == NULL) {
            return;
        }
        formula_put(p, f, part);
        if (of_points && f->count == 1 && next_is_sign(p, ',')) {
            f->number = 1.0;
        } else if (f->number > 0.0 && f->count == 2 && next_is_sign(p, ';')) {
            parse_grid(p, f);
            return;
        }
    } while (!p->failed && (take_sign(p, ',') || take_sign(p, ';') || (of_points && take_sign(p, ':'))));
    expect_sign(p, ')', "expected , or )");
}

static formula *parse_parenthesis(parser *p)
{
    formula *f = formula_new(p, FORMULA_VECTOR, p->next->at);
    p->next++;
    parse_parts(p, f, false);
    if (f->count == 1) {
        f = f->parts[0];
    }
    if (!p->failed && next_is_unit(p)) {
        formula *scaled = formula_new(p, FORMULA_SCALE, f->at);
        formula_put(p, scaled, f);
        scaled->unit = parse_unit(p);
        f = scaled;
    }
    if (!p->failed) {
        refuse_false_unit(p);
    }
    return f;
}

static formula *parse_product(parser *p);

/* speed of JOINT, force of CLOSURE, velocity of BODY [at PRODUCT] [in body | in ground] [along LETTER] */
static formula *parse_quantity(parser *p)
{
    static const char *const letters[] = {"w", "x", "y", "z"};
    formula *f = formula_new(p, FORMULA_OF, p->next->at);
    f->name = p->next->text;
    p->next += 2;
    formula *owner = formula_new(p, FORMULA_NAME, p->next->at);
    owner->name = p->next->text;
    p->next++;
    owner->name = take_indices(p, owner->name);
    formula_put(p, f, owner);
    if (take_option(p, "at")) {
        formula *beside = parse_product(p);
        if (beside == NULL) {
            return NULL;
        }
        formula_put(p, f, beside);
    }
    if (next_is_word(p, "in") && !p->next->first_on_line && p->next[1].kind == TOKEN_NAME) {
        f->axes = (name){p->next[1].text, p->next[1].at};
        p->next += 2;
    }
    f->along.at = p->next->at;
    if (take_option(p, "along")) {
        const bool is_quaternion = quantity_called(f->name, OF_BODY) == QUANTITY_ORIENTATION;
        const char *const *parts = letters + !is_quaternion;
        const size_t count = COUNT_OF(letters) - !is_quaternion, which = take_one_of(p, parts, count);
        f->along.text = which < count ? parts[which] : NULL;
    }
    return p->failed ? NULL : f;
}

bool next_is_owned(const parser *p)
{
    const token *after = p->next + 1;
    return after->kind == TOKEN_NAME && !after->first_on_line && strcmp(after->text, "of") == 0;
}

bool next_is_quantity(const parser *p)
{
    bool is = false;
    for (quantity_kind kind = 0; kind < QUANTITY_ROWS; kind++) {
        is = is || (quantity_rows[kind].owner >= OF_COORDINATE && next_is_word(p, quantity_rows[kind].word));
    }
    return is && next_is_owned(p) && p->next[2].kind == TOKEN_NAME;
}

static formula *parse_name_or_call(parser *p)
{
    if (next_is_quantity(p)) {
        return parse_quantity(p);
    }
    const bool call = p->next[1].sign == '(';
    formula *f = formula_new(p, call ? FORMULA_CALL : FORMULA_NAME, p->next->at);
    f->name = p->next->text;
    p->next++;
    const int *index = call ? NULL : find_index(p, f->name);
    if (index != NULL) {
        f->kind = FORMULA_NUMBER;
        f->number = *index;
    } else if (!call) {
        f->name = take_indices(p, f->name);
    }
    if (call) {
        p->next++;
        parse_parts(p, f, strcmp(f->name, "table") == 0 || strcmp(f->name, "ramp") == 0);
    }
    return f;
}

/* file "road.csv" [column 3] */
static formula *parse_file(parser *p)
{
    enum { MOST_COLUMNS = 1000 };
    formula *f = formula_new(p, FORMULA_FILE, p->next->at);
    const token *named = p->next + 1;
    const char *fault;
    f->name = "file";
    f->number = 2.0;
    f->file = open_beside(p, p->next->at, named->text, &fault);
    p->next += 2;
    if (f->file == NULL) {
        PARSE_FAULT(p, named->at, "cannot read '%s': %s", named->text, fault);
        return NULL;
    }
    f->text_at = source_passage(p->s, f->file, 0, f->file->length, NULL);
    if (take_option(p, "column")) {
        f->number = p->next->number;
        if (p->next->kind != TOKEN_NUMBER || !(f->number >= 2.0 && f->number <= (double)MOST_COLUMNS) ||
            f->number != (int)f->number) {
            parse_problem(p, "expected the number of a column, from 2 on: the first is the time");
            return NULL;
        }
        p->next++;
    }
    return f;
}

static formula *parse_primary(parser *p)
{
    if (p->next->kind == TOKEN_NUMBER) {
        return parse_number(p);
    }
    if (next_is_sign(p, '(')) {
        return parse_parenthesis(p);
    }
    if (next_is_word(p, "file") && p->next[1].kind == TOKEN_TEXT) {
        return parse_file(p);
    }
    /* A name at the start of a line is the next statement's, unless an operator asks for more. */
    if (p->next->kind == TOKEN_NAME && (!p->next->first_on_line || p->next[-1].kind == TOKEN_SIGN)) {
        return parse_name_or_call(p);
    }
    parse_problem(p, "expected a value, such as 0.5 kg, (0, 0, 1) m or a parameter's name");
    return NULL;
}

/* [-] primary */
static formula *parse_exponent(parser *p)
{
    const place at = p->next->at;
    const bool is_negative = take_sign(p, '-');
    formula *f = parse_primary(p);
    if (f == NULL || !is_negative) {
        return f;
    }
    formula *negative = formula_new(p, FORMULA_NEGATE, at);
    formula_put(p, negative, f);
    return negative;
}

/* [-] primary [^ exponent] */
static formula *parse_signed(parser *p)
{
    const place at = p->next->at;
    formula *f = NULL;
    if (++p->depth > DEEPEST) {
        parse_problem(p, arena_format(p->s->memory, "parentheses and signs nested more than %d deep", DEEPEST));
    } else if (take_sign(p, '-')) {
        const bool is_number = p->next->kind == TOKEN_NUMBER;
        formula *inner = parse_signed(p);
        if (inner != NULL && is_number && inner->kind == FORMULA_NUMBER && inner->unit.zero != 0.0) {
            f = inner; /* -20 degC */
            f->number = -f->number;
        } else if (inner != NULL) {
            f = formula_new(p, FORMULA_NEGATE, at);
            formula_put(p, f, inner);
        }
    } else {
        f = parse_primary(p);
        if (f != NULL && take_sign(p, '^')) {
            formula *power = formula_new(p, FORMULA_POWER, at);
            formula_put(p, power, f);
            formula *exponent = parse_exponent(p);
            if (exponent != NULL) {
                formula_put(p, power, exponent);
            }
            f = power;
        }
    }
    p->depth--;
    return p->failed ? NULL : f;
}

/* operand { sign operand }; it stands where its last sign does. */
static formula *parse_chain(parser *p, const char *signs, formula *(*parse_operand)(parser *))
{
    formula *first = parse_operand(p), *chain = NULL;
    while (first != NULL && !p->failed && p->next->sign != '\0' && strchr(signs, p->next->sign) != NULL) {
        formula *step = formula_new(p, FORMULA_STEP, p->next->at);
        if (chain == NULL) {
            chain = formula_new(p, FORMULA_CHAIN, step->at);
            formula_put(p, chain, first);
        }
        chain->at = step->at;
        step->sign = p->next->sign;
        p->next++;
        formula *right = parse_operand(p);
        if (right != NULL) {
            formula_put(p, step, right);
            formula_put(p, chain, step);
        }
    }
    return p->failed ? NULL : chain != NULL ? chain : first;
}

static formula *parse_product(parser *p)
{
    return parse_chain(p, "*/", parse_signed);
}

formula *parse_formula(parser *p)
{
    return p->failed ? NULL : parse_chain(p, "+-", parse_product);
}

formula *formula_of_number(parser *p, double number, place at)
{
    formula *f = formula_new(p, FORMULA_NUMBER, at);
    f->number = number;
    return f;
}

formula *parse_axis(parser *p)
{
    const token *t = p->next + next_is_sign(p, '-');
    if (t->kind != TOKEN_NAME || t->text[0] < 'x' || t->text[0] > 'z' || t->text[1] != '\0') {
        return parse_formula(p);
    }
    formula *f = formula_new(p, FORMULA_VECTOR, p->next->at);
    for (char letter = 'x'; letter <= 'z'; letter++) {
        formula *part = formula_new(p, FORMULA_NUMBER, p->next->at);
        part->number = letter != t->text[0] ? 0 : next_is_sign(p, '-') ? -1 : 1;
        formula_put(p, f, part);
    }
    p->next = t + 1;
    return f;
}

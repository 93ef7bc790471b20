#include "tools/measure/cycles/cycles.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"

const char *const kind_names[KINDS] = {"float", "integer", "load", "store", "move", "branch", "spill", "wait"};

enum { HEAD_CELLS = 2, RULE_CELLS = 6, NAME_MOST = 16 };

static _Noreturn void refuse(const table *const t, const size_t row, const char *const what)
{
    quit("%s:%zu: %s", t->path, row + 1, what);
}

/* A cell without the spaces around it. */
static char *trimmed(const table *const t, const size_t row, const size_t column)
{
    char *text = t->cell[t->first[row] + column];
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == ' ') {
        text[--length] = '\0';
    }
    return text;
}

/* Cycles: 2, 0.5, or a range 2-12. Returns where the text ends. */
static const char *read_bound(const char *const text, bound *const b)
{
    char *end = NULL;
    b->least = (int32_t)(strtod(text, &end) * (double)HALVES);
    b->most = b->least;
    if (end != text && *end == '-') {
        b->most = (int32_t)(strtod(end + 1, &end) * (double)HALVES);
    }
    return end;
}

/* Cycles with those of each register: 1+n, 1+2n. */
static bool read_cycles(const char *text, rule *const r)
{
    const char *const begin = text;
    text = read_bound(text, &r->cycles);
    if (text != begin && *text == '+') {
        r->each = (bound){HALVES, HALVES};
        text++;
        if (*text != 'n') {
            text = read_bound(text, &r->each);
        }
        return strcmp(text, "n") == 0;
    }
    return text != begin && *text == '\0';
}

/* The number of a word in a list; `count` if it is none of them. */
static size_t index_of(const char *const word, const char *const *const words, const size_t count)
{
    size_t i = 0;
    while (i < count && strcmp(words[i], word) != 0) {
        i++;
    }
    return i;
}

/* Further words of a rule: `late 1`, `address 1`, `indexed 1`, `literal 0-1`, or how operands are used. */
static bool read_further(char *const text, rule *const r)
{
    static const char *const uses[] = {"reads", "both",  "two",   "stack",   "calls",
                                       "rests", "skips", "leads", "follows", "wide"};
    static const char *const names[] = {"late", "address", "indexed", "literal"};
    bound *const bounds[] = {&r->late, &r->late_addressed, &r->indexed, &r->literal};
    enum { USES = sizeof uses / sizeof *uses, BOUNDS = sizeof bounds / sizeof *bounds };
    for (const char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " ")) {
        const size_t use = index_of(word, uses, USES), which = index_of(word, names, BOUNDS);
        if (use < USES) {
            r->use |= 1U << use;
            continue;
        }
        const char *const cycles = which < BOUNDS ? strtok(NULL, " ") : NULL;
        if (cycles == NULL || *read_bound(cycles, bounds[which]) != '\0') {
            return false;
        }
    }
    return true;
}

static void read_head(core *const c, const table *const t, const size_t row)
{
    const char *const key = trimmed(t, row, 0), *const value = trimmed(t, row, 1);
    static const char *const keys[] = {"name", "source", "note", "stack"};
    const char **const values[] = {&c->name, &c->source, &c->note, &c->stack};
    enum { KEYS = sizeof keys / sizeof *keys };
    const size_t which = index_of(key, keys, KEYS);
    if (which < KEYS) {
        *values[which] = value;
    } else if (strcmp(key, "code") == 0 && strcmp(value, "thumb") == 0) {
        c->is_thumb = true;
    } else if (strcmp(key, "code") != 0 || strcmp(value, "avr") != 0) {
        refuse(t, row, "it is no line of a table of a core");
    }
}

static void read_rule(core *const c, const table *const t, const size_t row)
{
    rule r = {.names = trimmed(t, row, 0),
              .where = trimmed(t, row, 5),
              .kind = (kind)index_of(trimmed(t, row, 1), kind_names, KINDS_OF_RULES)};
    const char *const taken = trimmed(t, row, 3);
    if (r.kind == KINDS_OF_RULES) {
        refuse(t, row, "the kind is none of: float integer load store move branch");
    }
    if (!read_cycles(trimmed(t, row, 2), &r) || (*taken != '\0' && *read_bound(taken, &r.taken) != '\0')) {
        refuse(t, row, "these are no cycles; they could be 1, 2-12 or 1+n");
    }
    if (!read_further(trimmed(t, row, 4), &r)) {
        refuse(t, row,
               "a word is unknown; they are late N, address N, indexed N, literal N, reads both two stack calls rests "
               "skips leads follows wide");
    }
    if (*r.where == '\0') {
        refuse(t, row, "it does not say where it is published");
    }
    c->rules[c->count++] = r;
}

core core_read(const char *const path)
{
    /* Its cells live as long as the core, which is as long as the program. */
    const table t = table_read(path, '|');
    core c = {.rules = memory_for(t.rows + 1, sizeof(rule))};
    for (size_t row = 0; row < t.rows; row++) {
        const char *const begin = table_text(&t, row, 0);
        const size_t cells = table_cells(&t, row);
        if (begin[0] == '#' || (cells <= 1 && begin[0] == '\0')) {
            continue;
        }
        if (cells == HEAD_CELLS) {
            read_head(&c, &t, row);
        } else if (cells == RULE_CELLS) {
            read_rule(&c, &t, row);
        } else {
            refuse(&t, row, "a line has a key and its value, or six columns");
        }
    }
    if (c.name == NULL || c.source == NULL || c.stack == NULL || c.note == NULL) {
        quit("%s: a core has a name, a source, a note and a stack", path);
    }
    return c;
}

bool is_listed(const char *names, const char *const separators, const char *const name)
{
    while (*names != '\0') {
        const size_t length = strcspn(names, separators);
        const bool open = length > 0 && names[length - 1] == '*';
        if (open ? strncmp(name, names, length - 1) == 0
                 : strlen(name) == length && strncmp(name, names, length) == 0) {
            return true;
        }
        names += length;
        names += strspn(names, separators);
    }
    return false;
}

static const rule *named(const core *const c, const char *const name)
{
    for (size_t i = 0; i < c->count; i++) {
        if (is_listed(c->rules[i].names, " ", name)) {
            return &c->rules[i];
        }
    }
    return NULL;
}

/* The name without a condition behind it, false if there is none. */
static bool without_condition(char *const name)
{
    static const char conditions[] = "eq ne cs hs cc lo mi pl vs vc hi ls ge lt gt le al ";
    const size_t length = strlen(name);
    if (length < 3) {
        return false;
    }
    const char end[] = {name[length - 2], name[length - 1], ' ', '\0'};
    const char *const found = strstr(conditions, end);
    if (found == NULL || (found - conditions) % 3 != 0) {
        return false;
    }
    name[length - 2] = '\0';
    return true;
}

/* Of Thumb: the rule of the name with its type, vdiv.f64, or of the name alone. */
static const rule *typed(const core *const c, const char *const name, const char *const type)
{
    char text[2 * NAME_MOST];
    snprintf(text, sizeof text, "%s%s", name, type);
    const rule *const found = named(c, text);
    return found != NULL ? found : named(c, name);
}

const rule *core_rule(const core *const c, const char *const name)
{
    /* Of Thumb, where sizes and types stand behind a point: adds, addne, addsne. */
    enum { CONDITION = 1, FLAGS = 2, FORMS = 4 };
    const size_t stem = c->is_thumb ? strcspn(name, ".") : strlen(name);
    for (unsigned form = 0; form < (c->is_thumb ? FORMS : 1); form++) {
        char text[NAME_MOST] = "";
        snprintf(text, sizeof text, "%.*s", (int)stem, name);
        if ((form & CONDITION) != 0 && !without_condition(text)) {
            continue;
        }
        const size_t length = strlen(text);
        if ((form & FLAGS) != 0 && (length < 2 || text[length - 1] != 's')) {
            continue;
        }
        text[(form & FLAGS) != 0 ? length - 1 : length] = '\0';
        const rule *const found = typed(c, text, name + stem);
        if (found != NULL) {
            return found;
        }
    }
    return NULL;
}

/* The statements of a plant's functions. Too many for one function stand in several, which it calls one after the
 * other: the time of gcc -O2 grows with the square of a function's length, and is least for parts of some hundred
 * statements. In order, where a value is read only before the first statement that needs it, more are not too many. */
#include <ctype.h>
#include <string.h>

#include "tools/isoc/emit/parts.h"

/* --- the variables that a function has --- */

static bool is_of_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* The next of the declarations with commas between; NULL behind the last. */
static const char *next_declaration(arena *memory, const char **scope)
{
    const char *begin = *scope + strspn(*scope, ", \n");
    const size_t length = strcspn(begin, ",");
    *scope = begin + length;
    return length == 0 ? NULL : arena_copy(memory, begin, length);
}

/* const real *const x: x */
static const char *declared_name(const char *declaration)
{
    const char *variable_name = declaration + strlen(declaration);
    while (variable_name > declaration && is_of_name(variable_name[-1])) {
        variable_name--;
    }
    return variable_name;
}

/* Whether statements name a variable: not in a comment, and not as a member. */
static bool names_variable(const char *statements, const char *variable_name)
{
    const size_t length = strlen(variable_name);
    for (const char *at = statements; *at != '\0';) {
        if (strncmp(at, "/*", 2) == 0) {
            at = strstr(at, "*/") + 2;
            continue;
        }
        size_t word = 0;
        while (is_of_name(at[word])) {
            word++;
        }
        const bool is_member = at > statements && (at[-1] == '.' || at[-1] == '>');
        if (word == length && strncmp(at, variable_name, length) == 0 && !is_member) {
            return true;
        }
        at += word > 0 ? word : 1;
    }
    return false;
}

void emit_unread(const emission *e, const char *scope, const char *statements)
{
    const char *d;
    while ((d = next_declaration(e->out->memory, &scope)) != NULL) {
        put_if(e, !names_variable(statements, declared_name(d)), "    (void)%s;\n", declared_name(d));
    }
}

/* --- parts --- */

/* A part as a function, of the variables that it names; adds the call of it. */
static void put_part(const emission *e, const char *function, const char *scope, const char *statements, text *calls)
{
    const char *d, *before = "";
    text parameters = {.memory = e->out->memory}, arguments = parameters;
    while ((d = next_declaration(e->out->memory, &scope)) != NULL) {
        if (names_variable(statements, declared_name(d))) {
            text_add(&parameters, "%s%s", before[0] == '\0' ? "" : ",\n    ", d);
            text_add(&arguments, "%s%s", before, declared_name(d));
            before = ", ";
        }
    }
    put(e, "ISO_APART static void %s(%s)\n{\n%s}\n\n", function, parameters.bytes, statements);
    text_add(calls, "    %s(%s);\n", function, arguments.bytes);
}

/* Adds the parts, and returns their calls. */
static const char *emit_parts(const emission *e, const char *function, const char *scope, const code_pieces *pieces)
{
    enum { MOST = 300 };
    const code_parts parts = code_split(pieces, MOST);
    text calls = {.memory = e->out->memory};
    if (parts.carried > 0) {
        text_add(&calls, "    real v[%d];\n", parts.carried);
    }
    for (int i = 0; i < parts.count; i++) {
        put_part(e, form(e, "%s_%d", function, i + 1), form(e, "%s, real *restrict const v", scope), parts.bodies[i],
                 &calls);
    }
    return calls.bytes;
}

/* The same where a part would read what one before has set: all targets are set at the end. */
static const char *emit_parts_in_place(const emission *e, const char *function, const char *scope, const code *c)
{
    code found = *c;
    text result = {.memory = e->out->memory};
    found.targets = numbered(e, "next", (int)c->count);
    const code_pieces pieces = code_in_pieces(&found, e->out_of_range_value);
    const char *calls = emit_parts(e, function, form(e, "%s, real *restrict const next", scope), &pieces);
    text_add(&result, "    real next[%d];\n%s", (int)c->count, calls);
    for (size_t i = 0; i < c->count; i++) {
        text_add(&result, "    %s = next[%d];\n", c->targets[i], (int)i);
    }
    return result.bytes;
}

/* Many that can stand in any order have one in which few values go to memory and back. */
const char *emit_statements(const emission *e, const char *function, const char *scope, const code *c)
{
    enum { LONG = 1200, LONG_IN_ORDER = 3000, SHORT = 60 };
    text result = {.memory = e->out->memory};
    const operations n = count_operations(c->g, c->roots, c->count);
    const bool is_ordered = c->can_order && n.add + n.mul > SHORT;
    if (is_ordered || 4 * (n.add + n.mul + n.div + (int)c->count) > LONG) {
        const code_pieces pieces = code_in_pieces(c, e->out_of_range_value);
        if (code_length(&pieces) > (is_ordered ? LONG_IN_ORDER : LONG)) {
            return c->in_place ? emit_parts_in_place(e, function, scope, c) : emit_parts(e, function, scope, &pieces);
        }
        if (is_ordered) {
            return code_in_order(&pieces);
        }
    }
    text_add(&result, "%s", "");
    code_emit(c, &result, e->out_of_range_value);
    return result.bytes;
}

void emit_function(const emission *e, const char *function, const char *parameters, const code *c)
{
    const char *statements = emit_statements(e, function, parameters, c);
    emit_head(e, function, parameters);
    emit_unread(e, parameters, statements);
    put(e, "%s}\n\n", statements);
}

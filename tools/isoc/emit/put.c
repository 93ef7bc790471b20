/* The functions by which the parts add their text. */
#include <math.h>
#include <string.h>

#include "tools/isoc/emit/parts.h"

static const char *with_names(const emission *e, const char *format)
{
    text result = {.memory = e->out->memory};
    for (const char *at = format; *at != '\0'; at += *at == '$' ? 2 : 0) {
        const int length = (int)strcspn(at, "$");
        text_add(&result, "%.*s", length, at);
        at += length;
        text_add(&result, "%s",
                 *at == '\0'    ? ""
                 : at[1] == 'p' ? e->names->prefix
                 : at[1] == 'C' ? e->names->capitals
                                : e->suffix);
    }
    return result.bytes;
}

const char *form(const emission *e, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const char *result = arena_format_list(e->out->memory, with_names(e, format), arguments);
    va_end(arguments);
    return result;
}

void put(const emission *e, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    text_add(e->out, "%s", arena_format_list(e->out->memory, with_names(e, format), arguments));
    va_end(arguments);
}

void put_if(const emission *e, bool wanted, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (wanted) {
        text_add(e->out, "%s", arena_format_list(e->out->memory, with_names(e, format), arguments));
    }
    va_end(arguments);
}

const char *literal(const emission *e, double number)
{
    return code_literal(e->out->memory, number, e->p->is_double);
}

const char *table_type(const emission *e)
{
    return e->names->has_lanes ? "iso_scalar" : "real";
}

const char *table_literal(const emission *e, double number)
{
    const char *of_all = literal(e, number); /* R(0.5) */
    return e->names->has_lanes ? form(e, "ISO_SCALAR%s", of_all + 1) : of_all;
}

const char *no_bits(const emission *e)
{
    return e->names->has_lanes ? "ISO_NOTHING" : "0";
}

const char *limit(const emission *e, double number)
{
    return !isinf(number) ? table_literal(e, number) : number < 0.0 ? "-ISO_REAL_MAX" : "ISO_REAL_MAX";
}

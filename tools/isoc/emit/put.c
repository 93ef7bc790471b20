/* How the parts add their text. */
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

const char *limit(const emission *e, double number)
{
    return !isinf(number) ? literal(e, number) : number < 0.0 ? "-ISO_REAL_MAX" : "ISO_REAL_MAX";
}

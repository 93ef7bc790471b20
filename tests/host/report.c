#include "tests/host/report.h"

#include <stdarg.h>
#include <stdio.h>

static unsigned tests;
static unsigned failures;

bool report_ok(const bool passed, const char *const format, ...)
{
    tests++;
    failures += passed ? 0 : 1;
    printf("%s %u - ", passed ? "ok" : "not ok", tests);
    va_list values;
    va_start(values, format);
    vprintf(format, values);
    va_end(values);
    printf("\n");
    return passed;
}

void report_note(const char *const format, ...)
{
    printf("# ");
    va_list values;
    va_start(values, format);
    vprintf(format, values);
    va_end(values);
    printf("\n");
}

int report_done(void)
{
    printf("1..%u\n", tests);
    return tests > 0 && failures == 0 ? 0 : 1;
}

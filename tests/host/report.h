/* The Test Anything Protocol for host-only tests, whose results are numbers to be read. */
#ifndef ISO_TESTS_HOST_REPORT_H
#define ISO_TESTS_HOST_REPORT_H

#include <stdbool.h>

#define REPORT_LIKE_PRINTF(text, values) __attribute__((format(printf, text, values)))

/* One test, named as printf does. Returns passed. */
bool report_ok(bool passed, const char *format, ...) REPORT_LIKE_PRINTF(2, 3);

/* A comment line. */
void report_note(const char *format, ...) REPORT_LIKE_PRINTF(1, 2);

/* Prints the plan. Returns the program's exit status: 0 if there were tests and all passed. */
int report_done(void);

#endif

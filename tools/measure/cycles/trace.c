#include "tools/measure/cycles/cycles.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool trace_next(executed *const e)
{
    static char line[1024];
    while (fgets(line, sizeof line, stdin) != NULL) {
        char *end = NULL;
        if (strncmp(line, "Trace", 5) == 0) {
            const char *const bracket = strchr(line, '[');
            const char *const slash = bracket == NULL ? NULL : strchr(bracket, '/');
            if (slash != NULL) {
                *e = (executed){.address = (uint32_t)strtoul(slash + 1, NULL, 16)};
                return true;
            }
        } else if (line[0] == '=') {
            e->address = (uint32_t)strtoul(line + 1, &end, 16);
            e->stack = (uint32_t)strtoul(end, &end, 16);
            e->cycle = strtoull(end, NULL, 16);
            e->has_stack = true;
            return true;
        }
    }
    return false;
}

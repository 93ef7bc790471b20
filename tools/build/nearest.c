/* nearest WORD NAME...: prints the name that WORD was meant to be, or nothing. */
#include <stdio.h>

#include "tools/isoc/base/nearest.h"

int main(int argc, char **argv)
{
    const char *const name = argc > 2 ? nearest(argv[1], (const char *const *)argv + 2, (size_t)argc - 2) : NULL;
    if (name != NULL) {
        puts(name);
    }
    return 0;
}

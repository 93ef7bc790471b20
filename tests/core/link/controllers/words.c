/* The words of an end frame, in their order, as core has them. */
#include <stdio.h>

#include "core/link/link.h"

int main(void)
{
#define PRINT(name, ...) puts(#name);
#define PRINT_OF_LINK(name) puts("link_" #name);
    ISO_STREAM_COUNTS(PRINT)
    ISO_STREAM_WORDS(PRINT)
    ISO_LINK_COUNTS(PRINT_OF_LINK)
    return 0;
}

/* Prints those words of standard input, one on a line, that isoc takes as names of a plant. */
#include <stdio.h>

#include "tools/isoc/base/arena.h"
#include "tools/isoc/emit/emit.h"

int main(void)
{
    arena *const memory = arena_new();
    char word[256];
    while (scanf("%255s", word) == 1) {
        if (prefix_fault(word, memory) == NULL) {
            puts(word);
        }
    }
    arena_free(memory);
    return 0;
}

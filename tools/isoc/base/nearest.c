#include "tools/isoc/base/nearest.h"

#include <ctype.h>
#include <string.h>

enum { LONGEST_NAME_COMPARED = 40 };

/* Levenshtein (1966): the least number of characters to insert, delete or change; upper and lower case are alike. */
static size_t distance(const char *a, const char *b)
{
    size_t row[LONGEST_NAME_COMPARED + 1];
    const size_t a_length = strlen(a), b_length = strlen(b);
    if (a_length > LONGEST_NAME_COMPARED || b_length > LONGEST_NAME_COMPARED) {
        return LONGEST_NAME_COMPARED;
    }
    for (size_t j = 0; j <= b_length; j++) {
        row[j] = j;
    }
    for (size_t i = 1; i <= a_length; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b_length; j++) {
            const size_t change = diagonal + (tolower((unsigned char)a[i - 1]) != tolower((unsigned char)b[j - 1]));
            diagonal = row[j];
            const size_t indel = 1 + (row[j] < row[j - 1] ? row[j] : row[j - 1]);
            row[j] = change < indel ? change : indel;
        }
    }
    return row[b_length];
}

const char *nearest(const char *typed, const char *const *names, size_t count)
{
    const size_t length = strlen(typed), near = length < 2 ? 0 : length < 4 ? 1 : 2;
    size_t best = near + 1;
    const char *name = NULL;
    for (size_t i = 0; i < count; i++) {
        const size_t d = distance(typed, names[i]);
        if (d < best) {
            best = d;
            name = names[i];
        }
    }
    return name;
}

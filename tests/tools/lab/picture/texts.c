#include "tests/tools/lab/picture/texts.h"

#include <stdio.h>
#include <string.h>

/* The width of a letter, in parts of its size: rather wide where a text must stay inside, rather narrow where two must
 * not lie on each other. */
#define WIDE 0.6
#define NARROW 0.5

typedef struct box {
    double left, right, top, bottom;
} box;

/* What a text covers, if its letters are so wide. */
static box box_of(const words *const w, const double letter)
{
    const double length = letter * w->size * (double)strlen(w->text);
    const double before = w->anchor == 's' ? 0 : w->anchor == 'm' ? length / 2 : length;
    if (w->upright) {
        return (box){w->at.x - 0.75 * w->size, w->at.x + 0.25 * w->size, w->at.y - (length - before), w->at.y + before};
    }
    return (box){w->at.x - before, w->at.x + length - before, w->at.y - 0.75 * w->size, w->at.y + 0.25 * w->size};
}

bool check_texts(const drawing *const d)
{
    bool right = true;
    for (size_t i = 0; i < d->text_count; i++) {
        const box wide = box_of(&d->texts[i], WIDE);
        if (wide.left < 0 || wide.right > d->width || wide.top < 0 || wide.bottom > d->height) {
            printf("cut off: %s\n", d->texts[i].text);
            right = false;
        }
        for (size_t j = 0; j < i; j++) {
            const box a = box_of(&d->texts[i], NARROW);
            const box b = box_of(&d->texts[j], NARROW);
            if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) {
                printf("on each other: %s, %s\n", d->texts[i].text, d->texts[j].text);
                right = false;
            }
        }
    }
    return right;
}

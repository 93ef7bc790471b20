/* Reads a picture back as its reader does: every point through the labels of its axes, every curve by the legend.
 *
 *     picture FILE.svg                  prints each point: panel, curve, abscissa, ordinate, separated by tabs
 *     picture FILE.svg POINTS all       every point of POINTS (lines like those) is drawn, and every drawn one is there
 *     picture FILE.svg POINTS drawn     every drawn point is in POINTS, which may have more
 *     picture FILE.svg POINTS covered   every point of POINTS is drawn, and there may be more
 *
 * A panel is named TITLE|LABEL OF THE ABSCISSA; a curve that no legend names has an empty name. Whatever it is asked,
 * no text may leave the picture or lie on another one. Status 1, with a line for each thing that is wrong.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/tools/lab/picture/compare.h"
#include "tests/tools/lab/picture/file.h"
#include "tests/tools/lab/picture/texts.h"

static void print_points(const points *const drawn)
{
    for (size_t i = 0; i < drawn->count; i++) {
        const point *const d = &drawn->all[i];
        printf("%s|%s\t%s\t%.6g\t%.6g\n", d->panel->title, d->panel->abscissa, d->curve,
               value_of(&d->panel->x, d->at.x), value_of(&d->panel->y, d->at.y));
    }
}

/* Whether the points of the file are drawn, the drawn ones are there, or both. */
static bool check_points(const points *const drawn, const panels *const of, const char *const path,
                         const char *const which)
{
    char *const text = read_all(path);
    points expected;
    bool right = read_expected(&expected, of, text);
    if (right && expected.count == 0) {
        fail("no point is expected");
    }
    if (right && strcmp(which, "covered") != 0) {
        right = all_expected(drawn, &expected);
    }
    if (right && strcmp(which, "drawn") != 0) {
        right = all_drawn(&expected, drawn);
    }
    free(expected.all);
    free(text);
    return right;
}

int main(const int argc, char **const argv)
{
    static drawing d;
    static panels of;
    bool asked = argc >= 2 && argc % 2 == 0;
    for (int i = 3; i < argc; i += 2) {
        asked =
            asked && (strcmp(argv[i], "all") == 0 || strcmp(argv[i], "drawn") == 0 || strcmp(argv[i], "covered") == 0);
    }
    if (!asked) {
        fail("usage: picture FILE.svg [POINTS all|drawn|covered]...");
    }
    char *const svg = read_all(argv[1]);
    read_drawing(&d, svg);
    free(svg);
    bool right = read_panels(&of, &d);
    right = check_texts(&d) && right;
    points drawn = read_points(&d, &of);
    if (drawn.count == 0) {
        fail("there is no point");
    }
    for (int i = 2; i < argc; i += 2) {
        right = right && check_points(&drawn, &of, argv[i], argv[i + 1]);
    }
    if (right && argc == 2) {
        print_points(&drawn);
    }
    free(drawn.all);
    return right ? EXIT_SUCCESS : EXIT_FAILURE;
}

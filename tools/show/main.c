/* Shows how a mechanism moves: a page, or a picture, of a run.
 *
 *     show scene SCENE SHAPE                              the scene with the poses of its bodies among its outputs
 *     show page FOLDER { LABEL SHAPE COMMAND }            the page, by the template in the folder
 *     show still SECONDS SHAPE COMMAND                    a picture of that time, as SVG
 *
 * SHAPE is the output of `isoc SCENE --shape`. COMMAND runs the plant of the former scene, and writes its stream. With
 * `-` as SHAPE it is the folder of a run that was kept, which has outputs alone. All goes to the standard output.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/show/show.h"

enum { MOST_RUNS = 8, CELLS_OF_A_RUN = 3 };

/* The scene is included by its path, which must be a whole one. */
static void write_scene(const char *path, const char *shape_path)
{
    const shape s = shape_read(shape_path);
    char name[RECORD_NAME_BYTES];
    printf("include \"%s\"\n", path);
    for (size_t i = 0; i < s.bodies; i++) {
        printf("output %s = position of %s\n", record_name(name, "at", i), s.body[i]);
        printf("output %s = orientation of %s\n", record_name(name, "turn", i), s.body[i]);
    }
    for (size_t i = 0; i < s.forces; i++) {
        printf("output %s = %s\n", record_name(name, "force", i), s.force[i].input);
    }
}

static run run_of(const char *label, const char *shape_path, const char *command)
{
    if (strcmp(shape_path, "-") == 0) {
        return (run){.label = label, .record = record_kept(command)};
    }
    run r = {.label = label, .shape = shape_read(shape_path)};
    r.record = record_run(command, r.shape.bodies);
    r.figure = figure_of(&r.shape, &r.record);
    if (r.record.stopped[0] != '\0') {
        fprintf(stderr, "show: %s: the run ends at %g s: %s\n", r.shape.name, r.record.end, r.record.stopped);
    }
    return r;
}

static void write_page(const char *folder, char **cells, int count)
{
    static run runs[MOST_RUNS];
    size_t n = 0;
    for (int i = 0; i + CELLS_OF_A_RUN <= count && n < MOST_RUNS; i += CELLS_OF_A_RUN) {
        runs[n++] = run_of(cells[i], cells[i + 1], cells[i + 2]);
    }
    page_write(stdout, folder, runs, n);
}

static void write_still(const char *seconds, const char *shape_path, const char *command)
{
    const run r = run_of("", shape_path, command);
    const view v = view_of(&r.shape, &r.record, &r.figure);
    still_write(stdout, &r.shape, &r.record, &r.figure, &v, strtod(seconds, NULL));
}

int main(int count, char **arguments)
{
    const char *what = count > 1 ? arguments[1] : "";
    if (strcmp(what, "scene") == 0 && count == 4) {
        write_scene(arguments[2], arguments[3]);
    } else if (strcmp(what, "page") == 0 && count >= 3 + CELLS_OF_A_RUN && count % CELLS_OF_A_RUN == 0) {
        write_page(arguments[2], arguments + 3, count - 3);
    } else if (strcmp(what, "still") == 0 && count == 5) {
        write_still(arguments[2], arguments[3], arguments[4]);
    } else {
        quit("usage: show scene SCENE SHAPE | show page FOLDER {LABEL SHAPE COMMAND} | show still SECONDS SHAPE "
             "COMMAND");
    }
    return EXIT_SUCCESS;
}

/* A scene with one effect more, from the list of effects and the scene.
 *
 *     effect NAME tools/measure/effects.txt models/pendulum.scene
 *
 * Status 1 if the list has no such effect or the scene no joint that it could stand in.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"

/* The text of a cell without the spaces at its ends, which are cut off. */
static const char *trimmed(const table *const lines, const size_t row, const size_t column)
{
    char *const text = lines->cell[lines->first[row] + column];
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == ' ') {
        text[--length] = '\0';
    }
    return text + strspn(text, " ");
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fputs("usage: effect NAME LIST SCENE\n", stderr);
        return EXIT_FAILURE;
    }
    table list = table_read(argv[2], '|');
    table scene = table_read(argv[3], '\n');
    const char *in_joint = NULL, *statement = NULL;
    for (size_t row = 0; row < list.rows; row++) {
        if (table_cells(&list, row) == 3 && strcmp(trimmed(&list, row, 0), argv[1]) == 0) {
            in_joint = trimmed(&list, row, 1);
            statement = trimmed(&list, row, 2);
        }
    }
    bool in_a_joint = false, placed = false;
    for (size_t row = 0; row < scene.rows && in_joint != NULL; row++) {
        const char *const line = table_text(&scene, row, 0);
        puts(line);
        in_a_joint = in_a_joint || strncmp(line, "joint ", 6) == 0;
        if (in_a_joint && strncmp(line + strspn(line, " "), "axis", 4) == 0) {
            if (in_joint[0] != '\0') {
                printf("    %s\n", in_joint);
            }
            placed = true;
            in_a_joint = false;
        }
    }
    if (!placed) {
        fprintf(stderr, "effect: there is no place for '%s'\n", argv[1]);
        return EXIT_FAILURE;
    }
    if (statement[0] != '\0') {
        puts(statement);
    }
    table_free(&list);
    table_free(&scene);
    return EXIT_SUCCESS;
}

#include "tools/plot/pictures.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"

/* A drawing without its groups' indentation, as elements: a group's beginning, a group's end, or what stands between.
 * A group that is empty, or that begins like the one that has just ended, is not written anew. */
enum { DEPTH_MOST = 64 };
static char **kept;         /* the elements to write */
static const char **closed; /* of an end, how its group begins */
static size_t count;
static const char *open_groups[DEPTH_MOST];
static size_t depth;

/* Writes `with`, which is shorter, in the place of every `from`, as long as there is one. */
static void replace(char *const text, const char *const from, const char *const with)
{
    for (char *at = strstr(text, from); at != NULL; at = strstr(at, from)) {
        const char *const rest = at + strlen(from);
        memcpy(at, with, strlen(with));
        memmove(at + strlen(with), rest, strlen(rest) + 1);
    }
}

/* Takes away the names that gnuplot gives to its curves. */
static void erase_names(char *const text)
{
    for (char *at = strstr(text, "<title>gnuplot_plot_"); at != NULL; at = strstr(at, "<title>gnuplot_plot_")) {
        const char *const end = strstr(at, "</title>");
        if (end == NULL) {
            return;
        }
        memmove(at, end + strlen("</title>"), strlen(end + strlen("</title>")) + 1);
    }
}

/* Writes colours as #rrggbb. */
static void shorten_colours(char *const text)
{
    for (char *at = strstr(text, "rgb("); at != NULL; at = strstr(at + 1, "rgb(")) {
        unsigned red = 0;
        unsigned green = 0;
        unsigned blue = 0;
        int length = 0;
        char colour[sizeof "#rrggbb"];
        if (sscanf(at, "rgb(%3u ,%3u ,%3u)%n", &red, &green, &blue, &length) == 3 && length > 0) {
            snprintf(colour, sizeof colour, "#%02x%02x%02x", red & 0xff, green & 0xff, blue & 0xff);
            memcpy(at, colour, sizeof colour - 1);
            memmove(at + sizeof colour - 1, at + length, strlen(at + length) + 1);
        }
    }
}

/* Writes one blank for many, and none before the end of a value; texts keep theirs. */
static void close_up(char *const text)
{
    if (strstr(text, "<text>") == NULL) {
        replace(text, "  ", " ");
        replace(text, " '/>", "'/>");
    }
}

static bool begins_group(const char *const text)
{
    return strncmp(text, "<g ", 3) == 0 || strncmp(text, "<g>", 3) == 0;
}

static void add(char *const text)
{
    if (begins_group(text)) {
        if (depth == DEPTH_MOST) {
            fputs("plot: the groups of the drawing are too deep\n", stderr);
            exit(EXIT_FAILURE);
        }
        open_groups[depth++] = text;
        if (count > 0 && closed[count - 1] != NULL && strcmp(closed[count - 1], text) == 0) {
            count--;
            return;
        }
    }
    closed[count] = NULL;
    kept[count++] = text;
}

static void end_group(char *const text)
{
    if (depth == 0) {
        fputs("plot: a group of the drawing ends that did not begin\n", stderr);
        exit(EXIT_FAILURE);
    }
    depth--;
    if (count > 0 && kept[count - 1] == open_groups[depth]) {
        count--;
    } else {
        closed[count] = open_groups[depth];
        kept[count++] = text;
    }
}

/* The text between two places, without the blanks around it. */
static void take(char *start, char *end)
{
    static char group_end[] = "</g>";
    while (start < end && strchr(" \t", *start) != NULL) {
        start++;
    }
    while (end > start && strchr(" \t", end[-1]) != NULL) {
        end--;
    }
    if (end == start) {
        return;
    }
    const size_t length = (size_t)(end - start);
    char *const text = table_memory(length + 1, 1);
    memcpy(text, start, length);
    if (strcmp(text, group_end) == 0) {
        end_group(group_end);
    } else {
        add(text);
    }
}

/* Where the next beginning or end of a group is behind a place of a line, or the end of the line. */
static char *next_group(char *const line)
{
    char *at = line;
    while (*at != '\0' && !begins_group(at) && strncmp(at, "</g>", 4) != 0) {
        at++;
    }
    return at;
}

void compact_svg(void)
{
    table lines = table_read("-", '\n');
    size_t bytes = 1;
    for (size_t row = 0; row < lines.rows; row++) {
        bytes += strlen(table_text(&lines, row, 0)) + 1;
    }
    kept = table_memory(bytes, sizeof *kept);
    closed = table_memory(bytes, sizeof *closed);
    for (size_t row = 0; row < lines.rows; row++) {
        char *const line = lines.cell[lines.first[row]];
        erase_names(line);
        replace(line, "<text></text>", "");
        replace(line, " stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", "");
        replace(line, " class=\"gridline\" ", "");
        replace(line, "<tspan font-family=\"sans-serif\" >", "<tspan>");
        shorten_colours(line);
        close_up(line);
        for (char *at = line; *at != '\0';) {
            char *const end = next_group(at + 1);
            take(at, end);
            at = end;
        }
    }
    for (size_t i = 0; i < count; i++) {
        puts(kept[i]);
    }
    table_free(&lines);
    if (depth != 0) {
        fputs("plot: a group of the drawing does not end\n", stderr);
        exit(EXIT_FAILURE);
    }
}

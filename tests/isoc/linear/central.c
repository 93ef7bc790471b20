/* A linear model against central differences of its plant, in double: central FOLDER GEOMETRY. FOLDER has what isoc
 * --linear wrote; GEOMETRY is what write_scene.py says of the closed loop. Nothing here is of isoc: a small turn turns
 * a quaternion, and a four-bar linkage is closed by Newton's method on its lengths.
 *
 * Prints the largest difference, as a part of 1 + |entry|, where it is, and how many entries were compared. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/tick.h"

enum { MOST = 128, JOINTS = 3 };

static const double distance = 4e-4;

static const iso_plant *const plant = &iso_the_plant;

/* A row of the model: a state, or a turn of a quaternion about an axis of the parent. */
typedef struct row {
    char name[64];
    int state; /* of a quaternion its first */
    int axis;  /* -1: of a state */
} row;

static row rows[MOST];
static int row_count;
static double start[MOST];

/* A linkage: its lengths, and where its angles and speeds stand; `kept` is the joint that the model has. */
static bool is_bar;
static double lengths[4];
static int angles[JOINTS], speeds[JOINTS], kept;

static int index_in(const char *list, const char *const name)
{
    const size_t length = strlen(name);
    for (int i = 0; list != NULL; i++) {
        const char *const comma = strchr(list, ',');
        const size_t here = comma == NULL ? strlen(list) : (size_t)(comma - list);
        if (here == length && strncmp(list, name, here) == 0) {
            return i;
        }
        list = comma == NULL ? NULL : comma + 1;
    }
    return -1;
}

static int state_called(const char *const name)
{
    return index_in(plant->model->state_names, name);
}

static FILE *open_in(const char *const folder, const char *const name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *const file = fopen(path, "r");
    char head[256];
    if (file == NULL || fgets(head, sizeof head, file) == NULL) {
        fprintf(stderr, "central: no %s\n", path);
        exit(EXIT_FAILURE);
    }
    return file;
}

static void read_rows(const char *const folder)
{
    FILE *const file = open_in(folder, "states.tsv");
    char line[512];
    while (fgets(line, sizeof line, file) != NULL && row_count < MOST) {
        row *const r = &rows[row_count++];
        snprintf(r->name, sizeof r->name, "%.*s", (int)strcspn(line, "\t"), line);
        r->state = state_called(r->name);
        r->axis = -1;
        if (r->state < 0) { /* NAME_about_x of NAME_w */
            char first[64];
            const size_t stem = strlen(r->name) - strlen("about_x");
            snprintf(first, sizeof first, "%.*sw", (int)stem, r->name);
            r->state = state_called(first);
            r->axis = r->name[strlen(r->name) - 1] - 'x';
        }
    }
    fclose(file);
}

static void read_geometry(const char *const path)
{
    FILE *const file = fopen(path, "r");
    char word[8] = "";
    is_bar = file != NULL &&
             fscanf(file, "%7s %lf %lf %lf %lf", word, &lengths[0], &lengths[1], &lengths[2], &lengths[3]) == 5;
    if (file != NULL) {
        fclose(file);
    }
    for (int i = 0; i < JOINTS && is_bar; i++) {
        char name[16];
        snprintf(name, sizeof name, "j%d", i);
        angles[i] = state_called(name);
        for (int k = 0; k < row_count; k++) {
            kept = strcmp(rows[k].name, name) == 0 ? i : kept;
        }
        snprintf(name, sizeof name, "j%d_speed", i);
        speeds[i] = state_called(name);
    }
}

/* How far the linkage is open along x or y, and by how much each joint changes that. */
static double gap(const double *const x, const int along, double *const by)
{
    const double first = x[angles[0]], second = first + x[angles[1]], third = x[angles[2]];
    const double s[] = {lengths[0] * sin(first), lengths[1] * sin(second), lengths[2] * sin(third)};
    const double c[] = {lengths[0] * cos(first), lengths[1] * cos(second), lengths[2] * cos(third)};
    by[0] = along == 0 ? -s[0] - s[1] : c[0] + c[1];
    by[1] = along == 0 ? -s[1] : c[1];
    by[2] = along == 0 ? s[2] : -c[2];
    return along == 0 ? c[0] + c[1] - c[2] - lengths[3] : s[0] + s[1] - s[2];
}

/* Moves the two other angles, or speeds, so that the linkage stays closed. */
static void close_bar(double *const x)
{
    const int a = (kept + 1) % JOINTS, b = (kept + 2) % JOINTS;
    for (int i = 0; i < 8; i++) {
        double by[2][JOINTS], open[2];
        const bool of_speeds = i == 7;
        for (int along = 0; along < 2; along++) {
            open[along] = gap(x, along, by[along]);
            for (int k = 0; k < JOINTS && of_speeds; k++) {
                open[along] = (k == 0 ? 0.0 : open[along]) + by[along][k] * x[speeds[k]];
            }
        }
        const double det = by[0][a] * by[1][b] - by[0][b] * by[1][a];
        const int *const of = of_speeds ? speeds : angles;
        x[of[a]] -= (open[0] * by[1][b] - by[0][b] * open[1]) / det;
        x[of[b]] -= (by[0][a] * open[1] - open[0] * by[1][a]) / det;
    }
}

/* a b of quaternions. */
static void product(const double *const a, const double *const b, double *const to)
{
    to[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
    to[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
    to[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
    to[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

/* The start with one row moved. */
static void moved(const row *const r, const double by, double *const x)
{
    memcpy(x, start, sizeof start);
    if (r->axis < 0) {
        x[r->state] += by;
    } else {
        double turn[4] = {cos(0.5 * by), 0.0, 0.0, 0.0};
        turn[1 + r->axis] = sin(0.5 * by);
        product(turn, start + r->state, x + r->state);
    }
    if (is_bar) {
        close_bar(x);
    }
}

/* The angular velocity in the axes of the parent: 2 q' times q conjugated. */
static void angular_velocity(const double *const x, const double *const dx, const int at, double *const omega)
{
    const double back[4] = {x[at], -x[at + 1], -x[at + 2], -x[at + 3]};
    double both[4];
    product(dx + at, back, both);
    for (int i = 0; i < 3; i++) {
        omega[i] = 2.0 * both[1 + i];
    }
}

/* The rate of row r at x, of which only `by` was moved, by so much: of a small turn e, e' = omega - omega of the start
 * - e x that. */
static double rate_of(const row *const r, const double *const x, const double *const dx, const double *const dx0,
                      const row *const by, const double size)
{
    if (r->axis < 0) {
        return dx[r->state];
    }
    double now[3], before[3], e[3] = {0.0, 0.0, 0.0};
    angular_velocity(x, dx, r->state, now);
    angular_velocity(start, dx0, r->state, before);
    if (by != NULL && by->axis >= 0 && by->state == r->state) {
        e[by->axis] = size;
    }
    const int i = r->axis, j = (i + 1) % 3, k = (i + 2) % 3;
    return now[i] - before[i] - (e[j] * before[k] - e[k] * before[j]);
}

/* The rate of a row, or an output, with a row or an input moved. */
static double value_at(const int of_row, const int of_output, const int by_row, const int by_input, const double size)
{
    static double x[MOST], u[MOST], dx[MOST], dx0[MOST];
    const iso_model *const m = plant->model;
    const row *const by = by_row < 0 ? NULL : &rows[by_row];
    memset(u, 0, sizeof u);
    memcpy(x, start, sizeof x);
    if (by != NULL) {
        moved(by, size, x);
    } else {
        u[by_input] += size;
    }
    if (of_output >= 0) {
        memcpy(plant->x, x, m->states * sizeof *plant->x);
        memcpy(plant->u, u, m->inputs * sizeof *plant->u);
        m->output(plant->memory);
        return plant->y[of_output];
    }
    iso_the_derivative(dx, x, u, plant->p);
    memset(u, 0, sizeof u);
    iso_the_derivative(dx0, start, u, plant->p);
    return rate_of(&rows[of_row], x, dx, dx0, by, size);
}

/* Central differences over two distances, extrapolated to none (Richardson). */
static double slope(const int of_row, const int of_output, const int by_row, const int by_input)
{
    double of[2];
    for (int i = 0; i < 2; i++) {
        const double h = i == 0 ? distance : 0.5 * distance;
        of[i] = (value_at(of_row, of_output, by_row, by_input, h) - value_at(of_row, of_output, by_row, by_input, -h)) /
                (2.0 * h);
    }
    return (4.0 * of[1] - of[0]) / 3.0;
}

static int row_called(const char *const name)
{
    int found = 0;
    while (found < row_count && strcmp(rows[found].name, name) != 0) {
        found++;
    }
    return found;
}

int main(const int argc, char **const argv)
{
    if (argc != 3) {
        return EXIT_FAILURE;
    }
    iso_plant_start(plant);
    memcpy(start, plant->x, plant->model->states * sizeof *start);
    read_rows(argv[1]);
    read_geometry(argv[2]);
    FILE *const file = open_in(argv[1], "matrices.tsv");
    char kind[4], of[64], by[64], worst[256] = "", inputs[MOST][64];
    double entry, largest = 0.0;
    int count = 0, input_count = 0;
    while (fscanf(file, " %3s %63s %63s %lf %*[^\n]", kind, of, by, &entry) == 4) {
        const bool of_state = kind[0] == 'A' || kind[0] == 'B', by_state = kind[0] == 'A' || kind[0] == 'C';
        int input = 0;
        while (!by_state && input < input_count && strcmp(inputs[input], by) != 0) {
            input++;
        }
        if (!by_state && input == input_count) {
            memcpy(inputs[input_count++], by, sizeof by);
        }
        const double found =
            slope(of_state ? row_called(of) : -1, of_state ? -1 : index_in(plant->model->output_names, of),
                  by_state ? row_called(by) : -1, by_state ? -1 : input);
        const double off = fabs(found - entry) / (1.0 + fabs(entry));
        if (!(off <= largest)) {
            largest = off;
            snprintf(worst, sizeof worst, "%s %s by %s is %.9g, by differences %.9g", kind, of, by, entry, found);
        }
        count++;
    }
    fclose(file);
    const int whole = (row_count + plant->model->outputs) * (row_count + plant->model->inputs);
    printf("%.3g %d %s\n", largest, count, worst);
    return count == whole && largest < 1e-6 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Runs a plant as the loop does, and compares outputs with those that another plant wrote. Compiled with the plant, in
 * its real.
 *
 *     run [OPTION VALUE]... BOUND=COLUMN[,COLUMN...]...
 *
 *     -n TICKS     how many
 *     -e EVERY     the ticks from one row to the next; default: 1
 *     -w FILE      where rows are written, doubles of all columns in turn
 *     -r FILE      rows of a reference, of the same columns
 *     -s STRIDE    the rows of the reference from one row to the next; default: 1
 *     -p SEED      each state at the start is another, at most by half a unit in the last place of a float
 *     -u FILE      recorded inputs: a line for each tick of the reference
 *
 * A BOUND is in the unit of its columns; the error is the length of the vector that they make, at the largest row.
 * Prints for each bound `error BOUND ERROR ROW KEPT`: the largest error, its row, and the rows from the first on that
 * keep the bound, in rows of the reference; `rows ROWS`, as many as there are in both; and `guard STATE` where the run
 * ended early.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/runtime/tick.h"
#include "tools/measure/signals.h"

enum { BOUNDS_MOST = 16, COLUMNS_MOST = 256 };

typedef struct bound {
    double value;
    double error; /* the largest */
    long row;     /* where it is */
    long kept;
} bound;

typedef struct job {
    bound bounds[BOUNDS_MOST];
    size_t count;
    size_t column[COLUMNS_MOST]; /* of all bounds in turn */
    size_t bound_of[COLUMNS_MOST];
    size_t columns;
    long ticks, every, stride, seed;
    FILE *written, *reference;
    signals inputs;
} job;

static const iso_plant *const plant = &iso_the_plant;

static void add_bound(job *const j, const char *const text)
{
    char *end = NULL;
    if (j->count == BOUNDS_MOST) {
        quit("run: too many bounds");
    }
    j->bounds[j->count].value = strtod(text, &end);
    do {
        if ((*end != '=' && *end != ',') || j->columns == COLUMNS_MOST) {
            quit("run: no bound: %s", text);
        }
        j->column[j->columns] = (size_t)strtoul(end + 1, &end, 10);
        j->bound_of[j->columns] = j->count;
        if (j->column[j->columns++] >= plant->model->outputs) {
            quit("run: no such column: %s", text);
        }
    } while (*end != '\0');
    j->count++;
}

static FILE *opened(const char *const path, const char *const mode)
{
    FILE *const file = fopen(path, mode);
    if (file == NULL) {
        quit("run: cannot open %s", path);
    }
    return file;
}

static job job_of(const int argc, char **const argv)
{
    job j = {.every = 1, .stride = 1};
    static const char letters[] = "nesp";
    long *const numbers[] = {&j.ticks, &j.every, &j.stride, &j.seed};
    j.inputs.inputs = plant->model->inputs;
    for (int option = 0; (option = getopt(argc, argv, "n:e:s:p:w:r:u:")) != -1;) {
        const char *const of_number = strchr(letters, option);
        if (of_number != NULL) {
            *numbers[of_number - letters] = strtol(optarg, NULL, 10);
        } else if (option == 'w') {
            j.written = opened(optarg, "wb");
        } else if (option == 'r') {
            j.reference = opened(optarg, "rb");
        } else if (option == 'u') {
            signals_recorded(&j.inputs, optarg);
        } else {
            exit(EXIT_FAILURE);
        }
    }
    for (int i = optind; i < argc; i++) {
        add_bound(&j, argv[i]);
    }
    if (j.ticks < 1 || j.every < 1 || j.stride < 1 || j.count == 0) {
        quit("run: usage: run [OPTION VALUE]... BOUND=COLUMN[,COLUMN...]...");
    }
    return j;
}

/* A neighbour of the start: as far off as rounding to float may put it, and a start of 0 a little. */
static void move_start(const long seed)
{
    uint64_t state = (uint64_t)seed;
    for (size_t i = 0; i < plant->model->states; i++) {
        const double size = fabs((double)plant->x[i]);
        plant->x[i] += (real)((signals_random(&state) < 0.5 ? -0x1p-24 : 0x1p-24) * (size > 0x1p-10 ? size : 0x1p-10));
    }
}

/* The unit of an output is that number in the list of all. */
static int is_angle(const size_t column)
{
    const char *unit = plant->model->output_units;
    for (size_t i = 0; i < column && unit != NULL; i++) {
        unit = strchr(unit, ',');
        unit = unit == NULL ? NULL : unit + 1;
    }
    return unit != NULL && strncmp(unit, "rad", 3) == 0 && (unit[3] == ',' || unit[3] == '\0');
}

/* Angles that were counted down to a turn may be turns apart. */
static double apart(const double a, const double b, const size_t column)
{
    const double difference = a - b;
    return fabs(difference) > 6 && is_angle(column) ? remainder(difference, 8 * atan(1)) : difference;
}

/* Reads a row of the reference into the errors. Returns whether there is one. */
static int compare(job *const j, const long row)
{
    double there[COLUMNS_MOST], squares[BOUNDS_MOST] = {0};
    if (fseek(j->reference, row * (long)(j->columns * sizeof *there), SEEK_SET) != 0 ||
        fread(there, sizeof *there, j->columns, j->reference) != j->columns) {
        return 0;
    }
    for (size_t k = 0; k < j->columns; k++) {
        const double d = apart((double)plant->y[j->column[k]], there[k], j->column[k]);
        squares[j->bound_of[k]] += d * d;
    }
    for (size_t i = 0; i < j->count; i++) {
        bound *const b = &j->bounds[i];
        const double error = sqrt(squares[i]);
        if (error > b->error) {
            b->error = error;
            b->row = row;
        }
        b->kept = b->error <= b->value ? row + 1 : b->kept;
    }
    return 1;
}

static void write_row(const job *const j)
{
    for (size_t k = 0; k < j->columns; k++) {
        const double y = (double)plant->y[j->column[k]];
        fwrite(&y, sizeof y, 1, j->written);
    }
}

static void set_inputs(const job *const j, const long tick)
{
    const size_t row = (size_t)(tick * j->stride / j->every) % (j->inputs.rows == 0 ? 1 : j->inputs.rows);
    for (size_t i = 0; i < j->inputs.inputs && j->inputs.samples != NULL; i++) {
        plant->u[i] = (real)j->inputs.samples[row * j->inputs.inputs + i];
    }
}

/* Makes the rows; returns how many the reference has too. */
static long run(job *const j)
{
    long rows = 0;
    for (long tick = 0;; tick++) {
        if (tick % j->every == 0) {
            if (j->written != NULL) {
                write_row(j);
            }
            if (j->reference != NULL && !compare(j, tick / j->every * j->stride)) {
                return rows;
            }
            rows++;
        }
        if (tick == j->ticks) {
            return rows;
        }
        iso_plant_drive(plant, (uint64_t)tick);
        set_inputs(j, tick);
        (void)iso_plant_admit(plant);
        (void)iso_plant_step(plant);
        const uint32_t finished = plant->model->finish(plant->memory);
        if (finished != ISO_WELL && finished != ISO_HELD) {
            printf("guard %u\n", (unsigned)iso_plant_guard(plant, finished));
            return rows;
        }
    }
}

int main(const int argc, char **const argv)
{
    job j = job_of(argc, argv);
    iso_plant_start(plant);
    if (j.seed != 0) {
        move_start(j.seed);
    }
    (void)iso_plant_output(plant);
    const long rows = run(&j);
    for (size_t i = 0; i < j.count && j.reference != NULL; i++) {
        const bound *const b = &j.bounds[i];
        printf("error %.9g %.9g %ld %ld\n", b->value, b->error, b->row, b->kept);
    }
    printf("rows %ld\n", rows);
    if (j.written != NULL && fclose(j.written) != 0) {
        quit("run: cannot write");
    }
    return EXIT_SUCCESS;
}

#include "tools/sweep/run.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/numbers/self_check.h"
#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#include "tools/trace/decimal.h"

/* An output over the rows of a run, from that of the start on. */
typedef struct seen {
    real last, least, most;
    double sum, squares;
} seen;

/* The results of a run. */
typedef struct account {
    seen *outputs;
    uint64_t rows, ticks, restarts, hash;
    char failure[240]; /* empty: none */
} account;

static uint64_t names_in(const char *const list)
{
    uint64_t count = list[0] != '\0';
    for (const char *c = list; *c != '\0'; c++) {
        count += *c == ',';
    }
    return count;
}

void run_check(const plan *const p)
{
    if (!iso_self_check()) {
        plan_fail("the processor or a flag of the compiler changes the bits of results", "this program");
    }
    for (uint64_t i = 0; i < p->plants; i++) {
        if (sweep_plants[i].plant == NULL) {
            continue;
        }
        const iso_model *const m = sweep_plants[i].plant->model;
        if (m->outputs != p->output_count || strcmp(m->output_names, p->outputs) != 0 ||
            names_in(p->outputs) != p->output_count) {
            plan_fail("what SET varies changes the outputs; a table is of the same ones", m->name);
        }
        for (uint64_t k = 0; k < p->variable_count; k++) {
            if (p->variables[k].place >= (int)m->parameters) {
                plan_fail("what SET varies changes the tunables", m->name);
            }
        }
    }
}

static void see(account *const a, const iso_plant *const plant)
{
    for (uint16_t i = 0; i < plant->model->outputs; i++) {
        seen *const s = &a->outputs[i];
        const real y = plant->y[i];
        s->last = y;
        s->least = a->rows == 0 || y < s->least ? y : s->least;
        s->most = a->rows == 0 || y > s->most ? y : s->most;
        s->sum += (double)y;
        s->squares += (double)y * (double)y;
    }
    a->rows++;
}

/* The name of a state, or its number. */
static void name_state(const iso_model *const m, unsigned state, char *const name, const size_t room)
{
    const char *from = m->state_names == NULL ? "" : m->state_names;
    for (unsigned i = 0; i < state && from[0] != '\0'; i++) {
        from += strcspn(from, ",");
        from += from[0] == ',';
    }
    if (from[0] == '\0') {
        snprintf(name, room, "%u", state);
    } else {
        snprintf(name, room, "%.*s", (int)strcspn(from, ","), from);
    }
}

static void note_guard(account *const a, const iso_plant *const plant, const uint16_t guard)
{
    char name[96];
    if (guard > plant->model->states) {
        snprintf(a->failure, sizeof a->failure, "near a singular position at tick %" PRIu64, a->ticks + 1);
        return;
    }
    name_state(plant->model, guard, name, sizeof name);
    snprintf(a->failure, sizeof a->failure, "guard: %s at tick %" PRIu64 " is %s", name, a->ticks + 1,
             iso_not_finite(plant->x[guard]) != 0 ? "not finite" : "out of range");
}

/* The same ticks as of the loop of a program (core/runtime/loop.h) in virtual time, where no tick is late. */
static void go(const iso_plant *const plant, account *const a)
{
    const iso_model *const m = plant->model;
    iso_tick_counts counts = {.restarts = 0};
    (void)iso_plant_output(plant);
    see(a, plant);
    for (uint64_t time = 0; time < sweep_duration_ns && a->failure[0] == '\0'; time += m->period_ns) {
        const uint16_t guard = iso_plant_tick_counted(plant, a->ticks, &counts);
        if (guard != m->states) {
            note_guard(a, plant, guard);
        } else {
            a->ticks++;
            a->hash = iso_hash_reals(a->hash, plant->x, m->states);
            see(a, plant);
        }
    }
    a->restarts = counts.restarts;
}

/* A column of the row. A run that failed has the ticks until then, and their hash. */
static void put_column(FILE *const to, const plan_column *const c, const account *const a)
{
    const char *const f = c->sort;
    const double rows = (double)a->rows;
    char text[DECIMAL_BYTES];
    fputc('\t', to);
    if (strcmp(f, "hash") == 0) {
        fprintf(to, "%016" PRIx64, a->hash);
    } else if (strcmp(f, "ticks") == 0) {
        fprintf(to, "%" PRIu64, a->ticks);
    } else if (strcmp(f, "restarts") == 0) {
        fprintf(to, "%" PRIu64, a->restarts);
    } else if (a->failure[0] == '\0' && c->place >= 0) {
        const seen *const s = &a->outputs[c->place];
        const real size = -s->least > s->most ? -s->least : s->most;
        if (strcmp(f, "mean") == 0) {
            fputs(decimal_of(s->sum / rows, sizeof(double), text), to);
        } else if (strcmp(f, "rms") == 0) {
            fputs(decimal_of(sqrt(s->squares / rows), sizeof(double), text), to);
        } else {
            const real y = strcmp(f, "final") == 0 ? s->last
                           : strcmp(f, "max") == 0 ? s->most
                           : strcmp(f, "min") == 0 ? s->least
                                                   : size;
            fputs(decimal_of((double)y, sizeof y, text), to);
        }
    }
}

static void put_row(FILE *const to, const plan *const p, const uint64_t run, const plan_cell *const cells,
                    const account *const a)
{
    fprintf(to, "%" PRIu64, run);
    for (uint64_t i = 0; i < p->variable_count; i++) {
        fprintf(to, "\t%s", cells[i].text);
    }
    for (uint64_t i = 0; i < p->column_count; i++) {
        put_column(to, &p->columns[i], a);
    }
    fprintf(to, "\t%s\n", a->failure[0] == '\0' ? "ok" : a->failure);
}

/* Of the tunables: the defaults of the plant, and in their places the values of the run. */
static void take_values(const plan *const p, const plan_cell *const cells, const iso_model *const m, real *const values)
{
    if (m->parameters > 0) {
        memcpy(values, m->defaults, m->parameters * sizeof *values);
    }
    for (uint64_t i = 0; i < p->variable_count; i++) {
        if (p->variables[i].place >= 0) {
            char *end = NULL;
            const char *const literal = cells[i].literal;
            values[p->variables[i].place] =
                sizeof(real) == sizeof(float) ? (real)strtof(literal, &end) : (real)strtod(literal, &end);
            if (*end != '\0') {
                plan_fail("a value is no number", cells[i].literal);
            }
        }
    }
}

/* A single run: its plant, with its own defaults of tunables and its own start. */
static void one_run(const plan *const p, const sweep_plant *const its, const plan_cell *const cells, account *const a)
{
    const iso_plant *const original = its->plant;
    iso_model model;
    iso_plant plant;
    real *const values = memory_for(original->model->parameters, sizeof *values);
    take_values(p, cells, original->model, values);
    memcpy(&model, original->model, sizeof model);
    memcpy(&plant, original, sizeof plant);
    model.defaults = values;
    model.start = its->start == NULL ? original->model->start : its->start;
    plant.model = &model;
    /* The start of a plant puts a tunable right that is beyond its limits, or breaks a condition. */
    if (iso_plant_start(&plant) && memcmp(plant.p, values, model.parameters * sizeof *values) == 0) {
        go(&plant, a);
    } else {
        snprintf(a->failure, sizeof a->failure, "refused: a value is beyond its limits, or breaks a condition");
    }
    free(values);
}

/* Runs are independent. Plants in lanes, several of the same kind at once, would be stepped here: the runs of a part
 * with the same plant, with a row for each as in a single run. */
void run_rows(const plan *const p, const uint64_t first, const uint64_t end, FILE *const to)
{
    plan_cell *const cells = memory_for(p->variable_count, sizeof *cells);
    seen *const outputs = memory_for(p->output_count, sizeof *outputs);
    for (uint64_t run = first; run < end; run++) {
        const sweep_plant *const variant = &sweep_plants[plan_cells(p, run, cells)];
        account a = {.outputs = outputs, .hash = ISO_HASH_START};
        memset(outputs, 0, (size_t)p->output_count * sizeof *outputs);
        if (variant->plant == NULL) {
            snprintf(a.failure, sizeof a.failure, "refused: %s", variant->refusal);
        } else {
            one_run(p, variant, cells, &a);
        }
        put_row(to, p, run, cells, &a);
    }
    free(outputs);
    free(cells);
}

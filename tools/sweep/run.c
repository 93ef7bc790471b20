#include "tools/sweep/run.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/runtime/hash.h"
#include "tools/sweep/steps.h"
#include "tools/trace/decimal.h"

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
    if (!steps_keep_bits()) {
        plan_fail("the processor or a flag of the compiler changes the bits of results", "this program");
    }
    for (uint64_t i = 0; i < p->plants; i++) {
        if (sweep_plants[i].plant == NULL) {
            continue;
        }
        const plant_facts m = steps_facts(sweep_plants[i].plant);
        if (m.outputs != p->output_count || strcmp(m.output_names, p->outputs) != 0 ||
            names_in(p->outputs) != p->output_count) {
            plan_fail("what --set varies changes the outputs; a table is of the same ones", m.name);
        }
        for (uint64_t k = 0; k < p->variable_count; k++) {
            if (p->variables[k].place >= (int)m.parameters) {
                plan_fail("what --set varies changes the tunables", m.name);
            }
        }
    }
}

/* The name of a state, or its number. */
static void name_state(const char *from, unsigned state, char *const name, const size_t room)
{
    from = from == NULL ? "" : from;
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

static void put_status(FILE *const to, const account *const a)
{
    char name[96];
    if (a->variant->plant == NULL) {
        fprintf(to, "refused: %s", a->variant->refusal);
    } else if (a->ending == ENDS_WELL) {
        fputs("ok", to);
    } else if (a->ending == ENDS_REFUSED) {
        fputs("refused: a value is beyond its limits, or breaks a condition", to);
    } else if (a->ending == ENDS_NEAR) {
        fprintf(to, "near a singular position at tick %" PRIu64, a->ticks + 1);
    } else {
        name_state(steps_facts(a->variant->plant).state_names, a->state, name, sizeof name);
        fprintf(to, "guard: %s at tick %" PRIu64 " is %s", name, a->ticks + 1,
                a->ending == ENDS_NOT_FINITE ? "not finite" : "out of range");
    }
}

/* A column of the row. A run that failed has the ticks until then, and their hash. */
static void put_column(FILE *const to, const plan_column *const c, const account *const a)
{
    const char *const f = c->sort;
    const double rows = (double)(a->ticks + 1); /* one is that of the start */
    char text[DECIMAL_BYTES];
    fputc('\t', to);
    if (strcmp(f, "hash") == 0) {
        fprintf(to, "%016" PRIx64, a->hash);
    } else if (strcmp(f, "ticks") == 0) {
        fprintf(to, "%" PRIu64, a->ticks);
    } else if (strcmp(f, "restarts") == 0) {
        fprintf(to, "%" PRIu64, a->restarts);
    } else if (a->is_made && a->ending == ENDS_WELL && c->place >= 0) {
        const seen *const s = &a->outputs[c->place];
        const iso_scalar size = -s->least > s->most ? -s->least : s->most;
        if (strcmp(f, "mean") == 0) {
            fputs(decimal_of(s->sum / rows, sizeof(double), text), to);
        } else if (strcmp(f, "rms") == 0) {
            fputs(decimal_of(sqrt(s->squares / rows), sizeof(double), text), to);
        } else {
            const iso_scalar y = strcmp(f, "final") == 0 ? s->last
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
    fputc('\t', to);
    put_status(to, a);
    fputc('\n', to);
}

/* Of the tunables: the defaults of the plant, and in their places the values of the run. */
static iso_scalar *values_of(const plan *const p, const plan_cell *const cells, const plant_facts m)
{
    iso_scalar *const values = memory_for(m.parameters, sizeof *values);
    if (m.parameters > 0) {
        memcpy(values, m.defaults, m.parameters * sizeof *values);
    }
    for (uint64_t i = 0; i < p->variable_count; i++) {
        if (p->variables[i].place >= 0) {
            char *end = NULL;
            const char *const literal = cells[i].literal;
            values[p->variables[i].place] =
                sizeof *values == sizeof(float) ? (iso_scalar)strtof(literal, &end) : (iso_scalar)strtod(literal, &end);
            if (*end != '\0') {
                plan_fail("a value is no number", cells[i].literal);
            }
        }
    }
    return values;
}

/* What the columns show; of_output[p->output_count] is of zeros. */
static shown shown_by(const plan *const p, uint8_t *const of_output)
{
    shown what = {.hash = false, .of_output = of_output};
    for (uint64_t i = 0; i < p->column_count; i++) {
        const plan_column *const c = &p->columns[i];
        what.hash |= strcmp(c->sort, "hash") == 0;
        if (c->place >= 0) {
            const bool is_sum = strcmp(c->sort, "mean") == 0 || strcmp(c->sort, "rms") == 0;
            of_output[c->place] |= is_sum ? SHOWS_SUMS : strcmp(c->sort, "final") == 0 ? SHOWS_LAST : SHOWS_EXTREMES;
        }
    }
    return what;
}

/* The run of a number, before it is made. Its values are in memory of its own, and its results will be. */
static account account_of(const plan *const p, const uint64_t run, plan_cell *const cells)
{
    const sweep_plant *const variant = &sweep_plants[plan_cells(p, run, cells)];
    account a = {.variant = variant, .hash = ISO_HASH_START};
    if (variant->plant != NULL) {
        a.values = values_of(p, cells, steps_facts(variant->plant));
        a.outputs = memory_for(p->output_count, sizeof *a.outputs);
    }
    return a;
}

/* Runs are independent: those of a plant are made together. */
static void make_all(account *const runs, const uint64_t count, const shown *const what)
{
    account **const together = memory_for(count, sizeof *together);
    for (uint64_t i = 0; i < count; i++) {
        const struct iso_plant *const plant = runs[i].variant->plant;
        uint64_t found = 0;
        for (uint64_t k = i; k < count && plant != NULL && !runs[i].is_made; k++) {
            if (runs[k].variant->plant == plant) {
                together[found++] = &runs[k];
            }
        }
        for (uint64_t k = 0; k < found; k++) {
            together[k]->is_made = true;
        }
        if (found > 0) {
            steps_make(plant, together, found, what);
        }
    }
    free(together);
}

void run_rows(const plan *const p, const uint64_t first, const uint64_t end, FILE *const to)
{
    const uint64_t count = end - first;
    account *const runs = memory_for(count, sizeof *runs);
    plan_cell *const cells = memory_for(p->variable_count, sizeof *cells);
    uint8_t *const of_output = memory_for(p->output_count, sizeof *of_output);
    const shown what = shown_by(p, of_output);
    for (uint64_t i = 0; i < count; i++) {
        runs[i] = account_of(p, first + i, cells);
    }
    make_all(runs, count, &what);
    for (uint64_t i = 0; i < count; i++) {
        (void)plan_cells(p, first + i, cells);
        put_row(to, p, first + i, cells, &runs[i]);
        free(runs[i].values);
        free(runs[i].outputs);
    }
    free(of_output);
    free(cells);
    free(runs);
}

#include "tools/isoc/formula/ticks.h"

#include <float.h>
#include <math.h>

#include "tools/isoc/formula/scalar.h"

bool is_time_input(const values *v)
{
    return v->around != NULL && !v->time_allowed;
}

bool allows_time(values *v, const formula *f)
{
    return v->time_allowed ||
           source_problem(v->s, f->at, "'%s' depends on time: only an input or a motion can", f->name);
}

bool is_in_input(values *v, const formula *f)
{
    return allows_time(v, f) &&
           (!v->is_smooth || source_problem(v->s, f->at, "'%s' is for inputs only, not for motions", f->name));
}

/* Numbers with units and the step have a rounding each. */
bool is_whole_tick(double ticks)
{
    return fabs(ticks - round(ticks)) <= 16 * DBL_EPSILON * fmax(1.0, fabs(ticks));
}

double first_tick_of(double ticks)
{
    return is_whole_tick(ticks) ? round(ticks) : ceil(ticks);
}

const table_call *table_made(const values *v, const formula *f)
{
    FOR_EACH (const table_call, table, v->table_calls) {
        if (table->call == f) {
            return table;
        }
    }
    return NULL;
}

void tables_forget(values *v, const formula *f)
{
    FOR_EACH (table_call, table, v->table_calls) {
        table->call = table->call == f ? NULL : table->call;
    }
}

tick_table *table_new(values *v, operation op, double number, double other, node *root)
{
    tick_table_list *all = v->g->tables;
    *root = timed_by_index(v->g, op, number, other, (int)all->count);
    LIST_ADD(v->s->memory, *all, (tick_table){0});
    return &all->all[all->count - 1];
}

value value_with_table(values *v, const formula *f, node root)
{
    LIST_ADD(v->s->memory, v->table_calls, ((table_call){f, root}));
    return scalar(root, plain);
}

/* A comparison has no name. */
const char *name_of(const formula *f)
{
    return f->kind == FORMULA_ORDER ? "a comparison" : f->name;
}

/* A function with a corner is no function of time in a motion. */
bool refuses_corner(values *v, const formula *f, const value *arguments, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (v->is_smooth && uses_time(v->g, &arguments[i].parts[0], 1)) {
            source_problem(v->s, f->at, "a motion must be smooth, and %s has a corner", name_of(f));
            return true;
        }
    }
    return false;
}

#include "tools/isoc/emit/emit.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

const char *capitals_of(arena *memory, const char *word)
{
    char *copy = arena_copy(memory, word, strlen(word));
    for (char *c = copy; *c != '\0'; c++) {
        *c = (char)toupper((unsigned char)*c);
    }
    return copy;
}

/* CART_X_RAIL; in the equations q_rail of a state, else u_push and p_mass. */
static const leaf_name *leaves_of(const naming *n, arena *memory, char array, const variable *all, int count)
{
    leaf_name *result = arena_take(memory, (size_t)count + 1, sizeof *result);
    for (int i = 0; i < count; i++) {
        const char *symbol = array == 'X' ? n->states[i].symbol
                                          : arena_format(memory, "%c_%s", tolower((unsigned char)array), all[i].name);
        const char *index = arena_format(memory, "%s_%c_%s", n->capitals, array, capitals_of(memory, all[i].name));
        result[i] = (leaf_name){symbol, index, all[i].quote};
    }
    return result;
}

static const variable *about_states(const naming *n, arena *memory, int count)
{
    variable *all = arena_take(memory, (size_t)count + 1, sizeof *all);
    for (int i = 0; i < count; i++) {
        all[i] = n->states[i].about;
    }
    return all;
}

/* Quantities that are constant within a step: inputs, then memories. */
static const variable *about_held(arena *memory, const mechanism *m)
{
    variable *all = arena_take(memory, (size_t)held_count(m) + 1, sizeof *all);
    for (int i = 0; i < held_count(m); i++) {
        all[i] = i < m->inputs.count ? m->inputs.all[i] : m->effects.memories[i - m->inputs.count].about;
    }
    return all;
}

static const variable *about_outputs(arena *memory, const plant *p)
{
    variable *all = arena_take(memory, (size_t)p->outputs.count + 1, sizeof *all);
    for (int i = 0; i < p->outputs.count; i++) {
        const char *quote = source_quote(p->m->source, p->outputs.shows[i]->name.at);
        all[i] = unlimited(p->outputs.names[i], p->outputs.units[i], quote);
    }
    return all;
}

naming naming_of(const plant *p, arena *memory, const char *prefix)
{
    const mechanism *m = p->m;
    naming result = {.prefix = prefix == NULL ? "plant" : prefix, .is_program = prefix == NULL};
    result.capitals = capitals_of(memory, result.prefix);
    result.states = mechanism_states(m, memory);
    result.about_states = about_states(&result, memory, state_count(m));
    result.about_held = about_held(memory, m);
    result.about_outputs = about_outputs(memory, p);
    result.leaves.states = leaves_of(&result, memory, 'X', result.about_states, state_count(m));
    result.leaves.inputs = leaves_of(&result, memory, 'U', result.about_held, held_count(m));
    result.leaves.parameters = leaves_of(&result, memory, 'P', m->parameters.all, m->parameters.count);
    result.outputs = leaves_of(&result, memory, 'Y', result.about_outputs, p->outputs.count);
    return result;
}

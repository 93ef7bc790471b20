/* Speeds after an impulse on joints, or at points along a direction, whose speeds are given then: an impulse on the
 * others, and what the closures add to it, is zero. All speeds change by
 *
 *     M v+ = M v + Phi_q' L + S' P,    Phi' = 0,    S v+ = given
 *
 * with the impulses P on the joints that S selects and L of the closures: the change with the least kinetic energy.
 * Pfeiffer and Glocker (1996), Multibody Dynamics with Unilateral Contacts, ch. 8. */
#include "tools/isoc/dynamics/dynamics.h"

/* The constraints of the closures, then those of the given speeds. */
static constraints with_given(const dynamics *d, const given_speed *wanted, int count)
{
    graph *g = d->g;
    const constraints *loops = &d->loops.phi;
    constraints result = {.all = arena_take(g->memory, (size_t)(loops->count + count), sizeof *result.all)};
    for (int r = 0; r < loops->count; r++) {
        result.all[result.count++] = loops->all[r];
    }
    for (int i = 0; i < count; i++) {
        constraint *c = &result.all[result.count++];
        const bool is_own = wanted[i].dof >= 0;
        const node speed = is_own ? leaf(g, OP_STATE, d->m->position_count + wanted[i].dof) : wanted[i].speed;
        *c = (constraint){.closure = -1, .position = constant(g, 0.0), .row = zero_nodes(g, (size_t)d->m->dof_count)};
        c->rate = sub(g, speed, wanted[i].to);
        if (is_own) {
            c->row[wanted[i].dof] = constant(g, 1.0);
        }
        for (int f = 0; f < d->m->dof_count && !is_own; f++) {
            differentiate(g, &speed, 1, leaf(g, OP_STATE, d->m->position_count + f), &c->row[f]);
        }
    }
    return result;
}

node *impulse_build(const dynamics *d, const given_speed *wanted, int count)
{
    graph *g = d->g;
    const constraints all = with_given(d, wanted, count);
    mass_matrix *mass = arena_take(g->memory, 1, sizeof *mass);
    graph_section(g, "Impulses of events");
    *mass = mass_matrix_build(&d->k);
    mass_matrix_factorise(mass);
    const augmented over = augmented_factors(mass, all);
    node *gaps = arena_take(g->memory, (size_t)all.count, sizeof *gaps);
    for (int r = 0; r < all.count; r++) {
        gaps[r] = all.all[r].rate;
    }
    graph_section(g, "Speeds behind an impulse");
    node *speeds = augmented_project(&over, gaps);
    for (int f = 0; f < d->m->dof_count; f++) {
        if (!is_zero(g, speeds[f])) {
            speeds[f] = add(g, leaf(g, OP_STATE, d->m->position_count + f), speeds[f]);
        } else {
            speeds[f] = -1;
        }
    }
    for (int i = 0; i < count; i++) {
        if (wanted[i].dof >= 0) {
            speeds[wanted[i].dof] = wanted[i].to;
        }
    }
    return speeds;
}

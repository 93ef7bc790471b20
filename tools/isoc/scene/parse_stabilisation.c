/* stabilisation KIND [{ ... }] */
#include <stddef.h>

#include "tools/isoc/scene/take.h"

static const char *const kind_names[] = {"baumgarte", "projection", "lagrangian", "none"};

enum { BAUMGARTE = 1, PROJECTION = 2, LAGRANGIAN = 4 };

static const char *const near_names[] = {"count", "stop", "hold"};

/* near count, near stop, near hold: the reaction to a tick near a singular position. */
static void read_near(parser *p, void *slot)
{
    name *to = slot;
    const size_t chosen = take_one_of(p, near_names, COUNT_OF(near_names));
    *to = (name){chosen < COUNT_OF(near_names) ? near_names[chosen] : NULL, p->word->at};
}

#define IN(member) offsetof(stabilisation, member)
static const property stabilisation_properties[] = {
    {"alpha", read_formula, IN(alpha), BAUMGARTE, NULL},
    {"beta", read_formula, IN(beta), BAUMGARTE, NULL},
    {"penalty", read_formula, IN(penalty), LAGRANGIAN, NULL},
    {"omega", read_formula, IN(omega), LAGRANGIAN, NULL},
    {"mu", read_formula, IN(mu), LAGRANGIAN, NULL},
    {"iterations", read_formula, IN(iterations), PROJECTION | LAGRANGIAN, NULL},
    {"limit", read_formula, IN(limit), EVERY_KIND, NULL},
    {"near", read_near, IN(near), PROJECTION | LAGRANGIAN, NULL},
};
#undef IN

static const block stabilisation_block = {"stabilisation", KINDS(kind_names), PROPERTIES(stabilisation_properties)};

void read_stabilisation(parser *p, void *slot)
{
    stabilisation *to = slot;
    to->kind.at = p->next->at;
    const size_t kind = parse_kind(p, &stabilisation_block);
    to->kind.text = kind < stabilisation_block.kind_count ? kind_names[kind] : NULL;
    if (!p->failed && next_is_sign(p, '{')) {
        parse_block(p, &stabilisation_block, kind, to->kind, to);
    }
}

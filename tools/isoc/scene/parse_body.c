/* body NAME { ... } and frame NAME { ... } */
#include <stddef.h>
#include <string.h>

#include "tools/isoc/scene/take.h"

/* Goldstein, Poole and Safko (2002), Classical Mechanics, sec. 5.3; a homogeneous body, its own axis along z. */
#define TWELFTH (1.0 / 12.0)
static const solid_row solid_rows[] = {
    {"box",
     "box (1, 2, 3) cm of 2 kg",
     3,
     false,
     {{0, TWELFTH, TWELFTH}, {TWELFTH, 0, TWELFTH}, {TWELFTH, TWELFTH, 0}}},
    {"cylinder", "cylinder (2, 10) cm of 2 kg", 2, false, {{0.25, TWELFTH}, {0.25, TWELFTH}, {0.5, 0}}},
    {"sphere", "sphere 5 cm of 2 kg", 1, false, {{0.4}, {0.4}, {0.4}}},
    {"rod", "rod 1 m of 2 kg", 1, false, {{TWELFTH}, {TWELFTH}, {0}}},
    {"tube", "tube (3, 2, 10) cm of 2 kg", 3, true, {{0.25, 0.25, TWELFTH}, {0.25, 0.25, TWELFTH}, {0.5, 0.5, 0}}},
    {"lump", "lump (1, 2, 3) g*m^2 of 2 kg", 0, false, {{0}}},
};
#undef TWELFTH

/* The row of a word, which is there for each word that read_solid reads. */
static const solid_row *find_solid(const char *word)
{
    const solid_row *row = solid_rows;
    while (strcmp(word, row->word) != 0) {
        row++;
    }
    return row;
}

/* SIZE [as_given] of MASS [at FORMULA] { rotate FORMULA about AXIS }; the slot is the body. */
static void read_solid(parser *p, void *slot)
{
    body *to = slot;
    solid result = {.kind = find_solid(p->word->text), .size = parse_formula(p)};
    result.is_as_given = result.kind->numbers == 0 && take_option(p, "as_given");
    expect_word(p, "of", arena_format(p->s->memory, "expected 'of' and a mass: %s", result.kind->example));
    result.mass = parse_formula(p);
    if (p->failed) {
        return;
    }
    result.at = parse_place_and_turns(p, "a solid");
    LIST_ADD(p->s->memory, to->solids, result);
}

/* The slot is the body. */
static void read_inertia(parser *p, void *slot)
{
    body *to = slot;
    read_formula(p, &to->inertia);
    to->is_as_given = take_option(p, "as_given");
    if (!p->failed) {
        to->inertia_axes = parse_place_and_turns(p, "an inertia");
    }
    if (to->inertia_axes.position != NULL) {
        source_problem(p->s, to->inertia_axes.position->at,
                       "an inertia is about the centre of mass: leave out 'at', or write a lump");
    }
}

#define IN(member) offsetof(body, member)
static const property body_properties[] = {
    {"mass", read_formula, IN(mass), EVERY_KIND, NULL},   {"com", read_formula, IN(com), EVERY_KIND, NULL},
    {"inertia", read_inertia, 0, EVERY_KIND, NULL},       {"box", read_solid, 0, EVERY_KIND | MANY, NULL},
    {"cylinder", read_solid, 0, EVERY_KIND | MANY, NULL}, {"sphere", read_solid, 0, EVERY_KIND | MANY, NULL},
    {"rod", read_solid, 0, EVERY_KIND | MANY, NULL},      {"tube", read_solid, 0, EVERY_KIND | MANY, NULL},
    {"lump", read_solid, 0, EVERY_KIND | MANY, NULL},
};
#undef IN

static const block body_block = {"body", PROPERTIES(body_properties)};

/* A body has a mass of its own, or solids that give it. */
static void check_mass(parser *p, const body *b)
{
    const formula *const own[] = {b->mass, b->com, b->inertia};
    static const char *const words[] = {"mass", "com", "inertia"};
    if (b->solids.count == 0 && b->mass == NULL) {
        source_problem(p->s, b->name.at, "the body '%s' has no mass: mass 1 kg", b->name.text);
    }
    for (int i = 0; i < 3 && b->solids.count > 0; i++) {
        if (own[i] != NULL) {
            source_problem(p->s, own[i]->at, "the %s of '%s' follows from its solids: leave it out, or write a lump",
                           words[i], b->name.text);
        }
    }
}

void read_body(parser *p, void *slot)
{
    scene *written = slot;
    body b = {.name = take_new_name(p, "expected a name for the body")};
    if (parse_block(p, &body_block, 0, b.name, &b)) {
        check_mass(p, &b);
    }
    LIST_ADD(p->s->memory, written->bodies, b);
}

static const property frame_properties[] = {
    {"on", read_placement, offsetof(named_frame, on), EVERY_KIND, "on BODY at (0, 0, 1) m"},
};

static const block frame_block = {"frame", PROPERTIES(frame_properties)};

void read_frame(parser *p, void *slot)
{
    scene *written = slot;
    named_frame f = {.name = take_new_name(p, "expected a name for the frame")};
    (void)parse_block(p, &frame_block, 0, f.name, &f);
    LIST_ADD(p->s->memory, written->frames, f);
}

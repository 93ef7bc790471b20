/* isoc: from a scene to a plant in straight-line C. Here its options are read; tools/isoc/pipeline.c compiles. */
#include <stddef.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/request.h"

static const char version[] = "isoc 0.1\n";

static const char *const real_names[] = {"float", "double"};
static const char *const fmi_names[] = {"2", "3"};
static const char *const reading_names[] = {"held", "smooth"};

#define SLOT(member) offsetof(request, member)
/* The options: where the text of each stands, whether a value follows; and the possible values, where these are words.
 * The argument without an option is the scene. */
static const struct {
    const char *word;
    size_t slot;
    bool has_value;
    const char *const *choices;
    size_t choice_count;
} rows[] = {
    {"-o", SLOT(directory), .has_value = true},
    {"--name", SLOT(name), .has_value = true},
    {"--method", SLOT(in_place.method), .has_value = true},
    {"--step", SLOT(in_place.step), .has_value = true},
    {"--tolerance", SLOT(in_place.tolerance), .has_value = true},
    {"--set", SLOT(in_place.set), .has_value = true},
    {"--without", SLOT(in_place.without), .has_value = true},
    {"--xcp", SLOT(lock), .has_value = true},
    {"--real", SLOT(real), true, real_names, 2},
    {"--inputs", SLOT(in_place.inputs), true, reading_names, 2},
    {"--formulation", SLOT(formulation), true, formulation_names, FORMULATIONS},
    {"--factors", SLOT(factors), true, factoring_names, FACTORINGS},
    {"--dot", SLOT(instead.dot), .has_value = false},
    {"--files", SLOT(instead.files), .has_value = false},
    {"--effects", SLOT(instead.effects), .has_value = false},
    {"--shape", SLOT(instead.shape), .has_value = false},
    {"--mjcf", SLOT(instead.mjcf), .has_value = false},
    {"--standalone", SLOT(standalone), .has_value = false},
    {"--link", SLOT(link), .has_value = false},
    {"--python", SLOT(python), .has_value = false},
    {"--lanes", SLOT(lanes), .has_value = false},
    {"--linear", SLOT(instead.linear), .has_value = false},
    {"--fmu", SLOT(fmu), .has_value = false},
    {"--fmi", SLOT(fmi), true, fmi_names, 2},
    {"--exchange", SLOT(exchange), .has_value = false},
    {"--trim", SLOT(linear.trim), .has_value = true},
    {"--state", SLOT(linear.state), .has_value = true},
    {"--sweep", SLOT(sweep.set), .has_value = true},
    {"--of", SLOT(sweep.columns), .has_value = true},
    {"--runs", SLOT(sweep.runs), .has_value = true},
    {"--seed", SLOT(sweep.seed), .has_value = true},
    {"--vary", SLOT(vary), .has_value = true},
    {"--equations", SLOT(instead.equations), true, equations_styles, EQUATIONS_STYLES},
    {"--ended", SLOT(instead.ended), .has_value = true},
    {"--check", SLOT(instead.check), .has_value = false},
};
enum { OPTIONS = COUNT_OF(rows) };

/* The text of an option. */
static const char **words_at(request *r, size_t slot)
{
    void *words = (char *)r + slot;
    return words;
}

static bool is_identifier(const char *word)
{
    static const char known[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    return word[0] != '\0' && strspn(word, known) == strlen(word) && strchr("0123456789", word[0]) == NULL;
}

static size_t option_called(const char *word)
{
    size_t found = 0;
    while (found < OPTIONS && strcmp(rows[found].word, word) != 0) {
        found++;
    }
    return found;
}

/* The text of each option: its value, or itself where none follows. */
static bool read_options(char **arguments, request *r)
{
    for (char **a = arguments; *a != NULL; a++) {
        const size_t o = option_called(*a);
        const char **words = words_at(r, o == OPTIONS ? SLOT(scene) : rows[o].slot);
        if (o == OPTIONS && (*a)[0] == '-' && (*a)[1] != '\0') {
            return complain("unknown option", *a);
        }
        if (o == OPTIONS && r->scene != NULL) {
            return complain("more than one scene:", *a);
        }
        if (o == OPTIONS || !rows[o].has_value) {
            *words = *a;
            continue;
        }
        if (a[1] == NULL) {
            return complain("a value is missing after", *a);
        }
        if (*words != NULL) {
            return complain("given twice:", *a);
        }
        *words = *++a;
    }
    return true;
}

/* Which options can stand together: a message that begins with the word of one of them, or with none. */
static bool check_together(arena *memory, const request *r)
{
    const products *i = &r->instead;
    const product wanted = product_of(r);
    const char *listing = wanted.is_list ? wanted.option : NULL;
    const char *unlinked = r->name != NULL ? "--name" : r->standalone != NULL ? r->standalone : listing;
    const char *program = r->link != NULL ? r->link : r->python;
    const char *of_one = program != NULL ? program : r->fmu;
    const bool has_target = r->directory != NULL || i->equations != NULL || listing != NULL;
    const struct {
        bool is_wrong;
        const char *subject, *message, *argument;
    } rules[] = {
        {r->scene == NULL, "", "no scene is given", NULL},
        {!has_target, "", "no folder for the plant: -o DIR", NULL},
        {r->directory != NULL && listing != NULL, listing, " makes no plant: leave out -o", r->directory},
        {program != NULL && unlinked != NULL, program, " makes a whole program: leave out", unlinked},
        {r->link != NULL && r->python != NULL, "",
         "--link and --python make a package each: call isoc for each, with a folder of its own", NULL},
        {of_one != NULL && r->lanes != NULL, of_one, " is for one plant, not for many side by side: leave out",
         r->lanes},
        {wanted.option != NULL && r->lanes != NULL, wanted.option, " makes no plant that could have lanes: leave out",
         r->lanes},
        {(r->linear.trim != NULL || r->linear.state != NULL) && i->linear == NULL, "",
         "--trim and --state are for a linear model: add --linear", NULL},
        {(r->sweep.set == NULL) != (r->sweep.columns == NULL), "", "--sweep and --of stand together", NULL},
        {(r->sweep.runs != NULL || r->sweep.seed != NULL) && r->sweep.set == NULL, "",
         "--runs and --seed are for a sweep: add --sweep and --of", NULL},
        {r->fmu != NULL && (r->link != NULL || i->linear != NULL || listing != NULL), r->fmu,
         " makes a folder for an FMU: leave out --link, --linear and lists", NULL},
        {r->fmi != NULL && r->fmu == NULL, "", "--fmi is the version of the standard of an FMU: add --fmu to --fmi",
         r->fmi},
        {r->exchange != NULL && r->fmu == NULL, r->exchange, " is for an FMU: add --fmu", NULL},
        {r->lock != NULL && r->link == NULL, "", "--xcp is for a plant with a link: add --link to --xcp", r->lock},
    };
    for (size_t n = 0; n < COUNT_OF(rules); n++) {
        if (rules[n].is_wrong) {
            return complain(arena_format(memory, "%s%s", rules[n].subject, rules[n].message), rules[n].argument);
        }
    }
    return true;
}

/* Checks the possible values of options. */
static bool check_options(arena *memory, request *r)
{
    if (!check_together(memory, r)) {
        return false;
    }
    if (r->lock != NULL && !is_identifier(r->lock)) {
        return complain("--xcp is open, or the name of an iso_xcp_lock in C; not", r->lock);
    }
    for (size_t o = 0; o < OPTIONS; o++) {
        const char *words = *words_at(r, rows[o].slot);
        const size_t count = rows[o].choice_count;
        if (words != NULL && count > 0 && index_of_word(words, rows[o].choices, count) == count) {
            const char *choices = alternatives(memory, rows[o].choices, count);
            return complain(arena_format(memory, "%s must be %s, not", rows[o].word, choices), words);
        }
    }
    const char *fault = r->name == NULL ? NULL : prefix_fault(r->name, memory);
    return fault == NULL || complain(arena_format(memory, "--name of a plant: %s; not", fault), r->name);
}

/* Converts the words of options to their values. */
static void resolve_words(request *r)
{
    r->is_double = index_of_word(r->real, real_names, 2) == 1;
    r->is_standalone = r->standalone != NULL || r->fmu != NULL;
    r->fmi_version = r->fmu == NULL ? 0 : index_of_word(r->fmi, fmi_names, 2) == 0 ? 2 : 3;
    r->wanted.formulation = (formulation)index_of_word(r->formulation, formulation_names, FORMULATIONS);
    r->wanted.factors = (factoring)index_of_word(r->factors, factoring_names, FACTORINGS);
    r->linear.folder = r->sweep.folder = r->directory;
}

/* The options that need no scene. */
static const char *const questions[] = {"--version", "--help", "--methods"};

static bool answer(arena *memory, const char *question)
{
    text table = {.memory = memory};
    write_methods(&table);
    const char *help = embedded_text(help_files, "tools/isoc/help.txt");
    return strcmp(question, "--version") == 0 ? write_out(version, strlen(version))
           : strcmp(question, "--help") == 0  ? write_out(help, strlen(help))
                                              : write_out(table.bytes, table.length);
}

static bool run(arena *memory, char **arguments)
{
    for (char **a = arguments; *a != NULL; a++) {
        if (index_of_word(*a, questions, 3) < 3) {
            return answer(memory, *a);
        }
    }
    request r = {0};
    if (!read_options(arguments, &r) || !check_options(memory, &r)) {
        return false;
    }
    resolve_words(&r);
    return compile(memory, &r);
}

int main(int count, char **arguments)
{
    arena *memory = arena_new();
    const bool good = count > 0 && run(memory, arguments + 1);
    arena_free(memory);
    return good ? 0 : 1;
}

/* isoc: from a scene to a plant in straight-line C. Here its options are read; tools/isoc/pipeline.c compiles. */
#include <stdio.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/emit/equations.h"
#include "tools/isoc/request.h"

static const char version[] = "isoc 0.1\n";

/* The options; the argument without an option is the scene. */
typedef enum option {
    OPTION_SCENE,
    OPTION_DIRECTORY,
    OPTION_NAME,
    OPTION_METHOD,
    OPTION_STEP,
    OPTION_TOLERANCE,
    OPTION_SET,
    OPTION_WITHOUT,
    OPTION_LOCK,
    OPTION_REAL,
    OPTION_INPUTS,
    OPTION_FORMULATION,
    OPTION_FACTORS,
    OPTION_DOT,
    OPTION_FILES,
    OPTION_EFFECTS,
    OPTION_SHAPE,
    OPTION_MJCF,
    OPTION_STANDALONE,
    OPTION_LINK,
    OPTION_PYTHON,
    OPTION_LANES,
    OPTION_LINEAR,
    OPTION_FMU,
    OPTION_FMI,
    OPTION_EXCHANGE,
    OPTION_TRIM,
    OPTION_STATE,
    OPTION_SWEEP,
    OPTION_OF,
    OPTION_RUNS,
    OPTION_SEED,
    OPTION_VARY,
    OPTION_EQUATIONS,
    OPTIONS
} option;

static const char *const real_names[] = {"float", "double"};
static const char *const fmi_names[] = {"3", "2"};
static const char *const reading_names[] = {"held", "smooth"};

/* Whether a value follows; the possible values, where these are words; and the message for any other. */
static const struct {
    const char *word;
    bool has_value;
    const char *const *choices;
    size_t choice_count;
    const char *refusal;
} rows[OPTIONS] = {
    [OPTION_DIRECTORY] = {"-o", .has_value = true},
    [OPTION_NAME] = {"--name", .has_value = true},
    [OPTION_METHOD] = {"--method", .has_value = true},
    [OPTION_STEP] = {"--step", .has_value = true},
    [OPTION_TOLERANCE] = {"--tolerance", .has_value = true},
    [OPTION_SET] = {"--set", .has_value = true},
    [OPTION_WITHOUT] = {"--without", .has_value = true},
    [OPTION_LOCK] = {"--xcp", .has_value = true},
    [OPTION_REAL] = {"--real", true, real_names, 2, "--real must be float or double, not"},
    [OPTION_INPUTS] = {"--inputs", true, reading_names, 2, "--inputs must be held or smooth, not"},
    [OPTION_FORMULATION] = {"--formulation", true, formulation_names, FORMULATIONS,
                            "--formulation must be composite, articulated, parent_axes or child_axes, not"},
    [OPTION_FACTORS] = {"--factors", true, factoring_names, FACTORINGS,
                        "--factors must be full, sparse or looped, not"},
    [OPTION_DOT] = {.word = "--dot"},
    [OPTION_FILES] = {.word = "--files"},
    [OPTION_EFFECTS] = {.word = "--effects"},
    [OPTION_SHAPE] = {.word = "--shape"},
    [OPTION_MJCF] = {.word = "--mjcf"},
    [OPTION_STANDALONE] = {.word = "--standalone"},
    [OPTION_LINK] = {.word = "--link"},
    [OPTION_PYTHON] = {.word = "--python"},
    [OPTION_LANES] = {.word = "--lanes"},
    [OPTION_LINEAR] = {.word = "--linear"},
    [OPTION_FMU] = {.word = "--fmu"},
    [OPTION_FMI] = {"--fmi", true, fmi_names, 2, "--fmi must be 2 or 3, not"},
    [OPTION_EXCHANGE] = {.word = "--exchange"},
    [OPTION_TRIM] = {"--trim", .has_value = true},
    [OPTION_STATE] = {"--state", .has_value = true},
    [OPTION_SWEEP] = {"--sweep", .has_value = true},
    [OPTION_OF] = {"--of", .has_value = true},
    [OPTION_RUNS] = {"--runs", .has_value = true},
    [OPTION_SEED] = {"--seed", .has_value = true},
    [OPTION_VARY] = {"--vary", .has_value = true},
    [OPTION_EQUATIONS] = {"--equations", true, equations_styles, EQUATIONS_STYLES,
                          "--equations must be text or latex, not"},
};

static bool is_identifier(const char *word)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", digits[] = "0123456789";
    const size_t length = strlen(word);
    size_t known = 0;
    while (known < length && (strchr(letters, word[known]) != NULL || strchr(digits, word[known]) != NULL)) {
        known++;
    }
    return known > 0 && known == length && strchr(letters, word[0]) != NULL;
}

static option option_called(const char *word)
{
    option found = OPTION_DIRECTORY;
    while (found < OPTIONS && strcmp(rows[found].word, word) != 0) {
        found++;
    }
    return found;
}

/* The text of each option: its value, or itself where none follows. */
static bool read_options(char **arguments, const char **texts)
{
    for (char **a = arguments; *a != NULL; a++) {
        const option o = option_called(*a);
        if (o == OPTIONS && (*a)[0] == '-' && (*a)[1] != '\0') {
            return complain("unknown option", *a);
        }
        if (o == OPTIONS && texts[OPTION_SCENE] != NULL) {
            return complain("more than one scene:", *a);
        }
        if (o == OPTIONS || !rows[o].has_value) {
            texts[o == OPTIONS ? OPTION_SCENE : o] = *a;
            continue;
        }
        if (a[1] == NULL) {
            return complain("a value is missing after", *a);
        }
        if (texts[o] != NULL) {
            return complain("given twice:", *a);
        }
        texts[o] = *++a;
    }
    return true;
}

/* Which options can stand together. */
static bool check_together(arena *memory, const char *const *texts)
{
    const char *listing = texts[OPTION_DOT] != NULL       ? texts[OPTION_DOT]
                          : texts[OPTION_FILES] != NULL   ? texts[OPTION_FILES]
                          : texts[OPTION_EFFECTS] != NULL ? texts[OPTION_EFFECTS]
                          : texts[OPTION_MJCF] != NULL    ? texts[OPTION_MJCF]
                                                          : texts[OPTION_SHAPE]; /* and no plant */
    const char *unlinked = texts[OPTION_NAME] != NULL         ? rows[OPTION_NAME].word
                           : texts[OPTION_STANDALONE] != NULL ? texts[OPTION_STANDALONE]
                                                              : listing;
    const bool has_target = texts[OPTION_DIRECTORY] != NULL || texts[OPTION_EQUATIONS] != NULL;
    if (texts[OPTION_SCENE] == NULL || (!has_target && listing == NULL)) {
        return complain(texts[OPTION_SCENE] == NULL ? "no scene is given" : "no folder for the plant: -o DIR", NULL);
    }
    if (texts[OPTION_DIRECTORY] != NULL && listing != NULL) {
        return complain(arena_format(memory, "%s makes no plant: leave out -o", listing), texts[OPTION_DIRECTORY]);
    }
    const char *program = texts[OPTION_LINK] != NULL ? texts[OPTION_LINK] : texts[OPTION_PYTHON];
    if (program != NULL && unlinked != NULL) {
        return complain(arena_format(memory, "%s is of a whole program: leave out", program), unlinked);
    }
    if (texts[OPTION_LINK] != NULL && texts[OPTION_PYTHON] != NULL) {
        return complain("--link and --python make a package each: call isoc for each, with a folder of its own", NULL);
    }
    if (texts[OPTION_LANES] != NULL && program != NULL) {
        return complain(arena_format(memory, "%s is of one plant, not of many side by side: leave out", program),
                        texts[OPTION_LANES]);
    }
    if ((texts[OPTION_TRIM] != NULL || texts[OPTION_STATE] != NULL) && texts[OPTION_LINEAR] == NULL) {
        return complain("--trim and --state are of a linear model: add --linear", NULL);
    }
    if ((texts[OPTION_SWEEP] == NULL) != (texts[OPTION_OF] == NULL)) {
        return complain("--sweep and --of stand together", NULL);
    }
    if ((texts[OPTION_RUNS] != NULL || texts[OPTION_SEED] != NULL) && texts[OPTION_SWEEP] == NULL) {
        return complain("--runs and --seed are of a sweep: add --sweep and --of", NULL);
    }
    if (texts[OPTION_FMU] != NULL && (texts[OPTION_LINK] != NULL || texts[OPTION_LINEAR] != NULL || listing != NULL)) {
        return complain("--fmu makes a folder for an FMU: leave out --link, --linear and lists", NULL);
    }
    if (texts[OPTION_FMI] != NULL && texts[OPTION_FMU] == NULL) {
        return complain("--fmi is the version of the standard of an FMU: add --fmu to --fmi", texts[OPTION_FMI]);
    }
    if (texts[OPTION_EXCHANGE] != NULL && texts[OPTION_FMU] == NULL) {
        return complain("--exchange is of an FMU: add --fmu", NULL);
    }
    if (texts[OPTION_LOCK] != NULL && texts[OPTION_LINK] == NULL) {
        return complain("--xcp is of a plant with a link: add --link to --xcp", texts[OPTION_LOCK]);
    }
    return true;
}

/* Their possible values. */
static bool check_options(arena *memory, const char *const *texts)
{
    if (!check_together(memory, texts)) {
        return false;
    }
    if (texts[OPTION_LOCK] != NULL && !is_identifier(texts[OPTION_LOCK])) {
        return complain("--xcp is open, or the name of an iso_xcp_lock in C; not", texts[OPTION_LOCK]);
    }
    for (option o = OPTION_DIRECTORY; o < OPTIONS; o++) {
        const size_t count = rows[o].choice_count;
        if (texts[o] != NULL && count > 0 && index_of_word(texts[o], rows[o].choices, count) == count) {
            return complain(rows[o].refusal, texts[o]);
        }
    }
    const char *fault = texts[OPTION_NAME] == NULL ? NULL : prefix_fault(texts[OPTION_NAME], memory);
    return fault == NULL || complain(arena_format(memory, "--name of a plant: %s; not", fault), texts[OPTION_NAME]);
}

/* The first product that an option names; else a plant. */
static product product_of(const char *const *texts)
{
    static const option options[] = {
        [PRODUCT_FILES] = OPTION_FILES, [PRODUCT_EFFECTS] = OPTION_EFFECTS,     [PRODUCT_SHAPE] = OPTION_SHAPE,
        [PRODUCT_DRAWING] = OPTION_DOT, [PRODUCT_MJCF] = OPTION_MJCF,           [PRODUCT_LINEAR] = OPTION_LINEAR,
        [PRODUCT_SWEEP] = OPTION_SWEEP, [PRODUCT_EQUATIONS] = OPTION_EQUATIONS,
    };
    product result = PRODUCT_FILES;
    while (result < PRODUCT_PLANT && texts[options[result]] == NULL) {
        result++;
    }
    return result;
}

static request request_of(const char *const *texts)
{
    return (request){
        .scene = texts[OPTION_SCENE],
        .directory = texts[OPTION_DIRECTORY],
        .name = texts[OPTION_NAME],
        .method = texts[OPTION_METHOD],
        .step = texts[OPTION_STEP],
        .tolerance = texts[OPTION_TOLERANCE],
        .set = texts[OPTION_SET],
        .without = texts[OPTION_WITHOUT],
        .inputs = texts[OPTION_INPUTS],
        .lock = texts[OPTION_LOCK],
        .linear = {texts[OPTION_STATE], texts[OPTION_TRIM], texts[OPTION_DIRECTORY]},
        .sweep = {texts[OPTION_SWEEP], texts[OPTION_OF], texts[OPTION_RUNS], texts[OPTION_SEED],
                  texts[OPTION_DIRECTORY]},
        .vary = texts[OPTION_VARY],
        .product = product_of(texts),
        .is_double = index_of_word(texts[OPTION_REAL], real_names, 2) == 1,
        .is_standalone = texts[OPTION_STANDALONE] != NULL || texts[OPTION_FMU] != NULL,
        .fmi_version = texts[OPTION_FMU] == NULL                             ? 0
                       : index_of_word(texts[OPTION_FMI], fmi_names, 2) == 1 ? 2
                                                                             : 3,
        .is_exchanged = texts[OPTION_EXCHANGE] != NULL,
        .is_linked = texts[OPTION_LINK] != NULL,
        .is_python = texts[OPTION_PYTHON] != NULL,
        .has_lanes = texts[OPTION_LANES] != NULL,
        .style = (equations_style)index_of_word(texts[OPTION_EQUATIONS], equations_styles, EQUATIONS_STYLES),
        .wanted = {(formulation)index_of_word(texts[OPTION_FORMULATION], formulation_names, FORMULATIONS),
                   (factoring)index_of_word(texts[OPTION_FACTORS], factoring_names, FACTORINGS)},
    };
}

/* --version, --help and --methods, which need no scene. */
static bool is_question(const char *argument)
{
    return strcmp(argument, "--version") == 0 || strcmp(argument, "--help") == 0 || strcmp(argument, "--methods") == 0;
}

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
        if (is_question(*a)) {
            return answer(memory, *a);
        }
    }
    const char *texts[OPTIONS] = {NULL};
    const request r = read_options(arguments, texts) && check_options(memory, texts) ? request_of(texts) : (request){0};
    return r.scene != NULL && compile(memory, &r);
}

int main(int count, char **arguments)
{
    arena *memory = arena_new();
    const bool good = count > 0 && run(memory, arguments + 1);
    arena_free(memory);
    return good ? 0 : 1;
}

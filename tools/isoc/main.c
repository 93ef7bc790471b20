/* isoc: from a scene to a plant in straight-line C. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "tools/isoc/dynamics/assembly.h"
#include "tools/isoc/emit/emit.h"
#include "tools/isoc/plant/cost.h"
#include "tools/isoc/scene/dot.h"
#include "tools/isoc/scene/parser.h"

static const char version[] = "isoc 0.1\n";

static const char help[] =
    "isoc: compiles a scene to a plant in straight-line C\n"
    "\n"
    "  isoc SCENE -o DIR [--method M] [--step H] [--tolerance T] [--real float|double] [--formulation F]\n"
    "  isoc SCENE --dot\n"
    "\n"
    "  SCENE          the scene, a text file\n"
    "  -o DIR         where plant.h and plant.c go; made if it is not there\n"
    "  --method M     a method, instead of the scene's; --methods lists them\n"
    "  --step H       the step with its unit, e.g. 1ms, instead of the scene's\n"
    "  --tolerance T  of adams, which then takes as many sub-steps as it needs\n"
    "  --real R       the number type of the plant: float (default) or double\n"
    "  --formulation F  instead of the cheapest; of a tree composite or articulated bodies, of closed loops composite "
    "bodies\n"
    "                 with the closures in the axes of their base, composite, or of a side, parent_axes or child_axes\n"
    "  --dot          nothing but a graph of bodies, joints and closures, for graphviz: isoc SCENE --dot | dot -Tsvg\n"
    "  --methods      what each method costs, as a table\n"
    "  --help         this text\n"
    "  --version      the version\n"
    "\n"
    "Prints what the plant costs: states, inputs, outputs, operations of a derivative and of a step, bytes of state.\n"
    "A mistake in the scene is told as file:line:column; the exit status is then 1 and no file is touched.\n";

typedef struct options {
    const char *scene, *directory, *method, *step, *tolerance;
    bool is_double, draws;
    formulation wanted; /* FORMULATIONS: the cheapest one */
} options;

static bool complain(const char *message, const char *argument)
{
    fprintf(stderr, "isoc: error: %s%s%s\nisoc --help tells more\n", message, argument == NULL ? "" : " ",
            argument == NULL ? "" : argument);
    return false;
}

/* Takes the value of an option, which must follow it, and come once. */
static bool take_option(char **argument, const char **slot)
{
    if (argument[1] == NULL) {
        return complain("a value is missing after", argument[0]);
    }
    if (*slot != NULL) {
        return complain("given twice:", argument[0]);
    }
    *slot = argument[1];
    return true;
}

static bool read_options(char **arguments, options *o)
{
    const char *real_name = NULL, *formulation_name = NULL;
    for (char **a = arguments; *a != NULL; a++) {
        const char **slot = strcmp(*a, "-o") == 0              ? &o->directory
                            : strcmp(*a, "--method") == 0      ? &o->method
                            : strcmp(*a, "--step") == 0        ? &o->step
                            : strcmp(*a, "--tolerance") == 0   ? &o->tolerance
                            : strcmp(*a, "--real") == 0        ? &real_name
                            : strcmp(*a, "--formulation") == 0 ? &formulation_name
                                                               : NULL;
        if (slot != NULL) {
            if (!take_option(a, slot)) {
                return false;
            }
            a++;
        } else if (strcmp(*a, "--dot") == 0) {
            o->draws = true;
        } else if ((*a)[0] == '-' && (*a)[1] != '\0') {
            return complain("unknown option", *a);
        } else if (o->scene != NULL) {
            return complain("more than one scene:", *a);
        } else {
            o->scene = *a;
        }
    }
    o->is_double = real_name != NULL && strcmp(real_name, "double") == 0;
    for (o->wanted = 0; o->wanted < FORMULATIONS; o->wanted++) {
        if (formulation_name != NULL && strcmp(formulation_name, formulation_names[o->wanted]) == 0) {
            break;
        }
    }
    if (o->scene == NULL || (o->directory == NULL && !o->draws)) {
        return complain(o->scene == NULL ? "no scene named" : "no folder for the plant: -o DIR", NULL);
    }
    if (o->directory != NULL && o->draws) {
        return complain("--dot makes no plant: leave out -o", o->directory);
    }
    if (real_name != NULL && !o->is_double && strcmp(real_name, "float") != 0) {
        return complain("--real is float or double, not", real_name);
    }
    if (formulation_name != NULL && o->wanted == FORMULATIONS) {
        return complain("--formulation is composite, articulated, parent_axes or child_axes, not", formulation_name);
    }
    return true;
}

/* The scene's name: its file's, without folder and ending, as an identifier. */
static const char *scene_name(arena *memory, const char *path)
{
    const char *base = strrchr(path, '/') == NULL ? path : strrchr(path, '/') + 1;
    const size_t length = strcspn(base, ".");
    char *made = length == 0 ? arena_copy(memory, "scene", 5) : arena_copy(memory, base, length);
    for (char *c = made; *c != '\0'; c++) {
        const bool letter = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') || (*c >= '0' && *c <= '9');
        *c = letter ? *c : '_';
    }
    return made;
}

/* --step and --method, read as if they stood in the scene. Their problems are told at once. */
static bool override(arena *memory, const options *o, scene *s)
{
    if (o->step == NULL && o->method == NULL && o->tolerance == NULL) {
        return true;
    }
    const char *step = o->step == NULL ? "" : arena_format(memory, "step %s\n", o->step);
    const char *method = o->method == NULL ? step : arena_format(memory, "%smethod %s\n", step, o->method);
    const char *words = o->tolerance == NULL
                            ? method
                            : arena_format(memory, "%stolerance %s\nsubsteps 1000000\n", method, o->tolerance);
    source given = {.memory = memory, .path = "command line", .text = words, .length = strlen(words)};
    const scene read = parse_scene(&given, lex(&given));
    graph g;
    graph_start(&g, memory);
    graph_section(&g, "");
    mechanism_method_and_step(&given, &g, &read);
    source_report(&given);
    s->step = read.step == NULL ? s->step : read.step;
    s->method = read.method.text == NULL ? s->method : read.method;
    s->tolerance = read.tolerance == NULL ? s->tolerance : read.tolerance;
    s->substeps = read.substeps == NULL ? s->substeps : read.substeps;
    return given.problem_count == 0;
}

/* A joint that moves no inertia has no acceleration: told at the start, where it can be told from a bad moment later.
 */
static void check_pivots(source *s, const graph *g, const plant *p)
{
    static const char *const about[] = {" about its x axis", " about its y axis", " about its z axis"};
    const mechanism *m = p->m;
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    graph_evaluate(g, mechanism_start(m, g->memory), NULL, m->defaults, numbers);
    /* From the tips inward, as they are eliminated: what comes after a bad pivot is bad too. */
    for (int f = m->dof_count - 1; f >= 0; f--) {
        const double pivot = numbers[p->d->mass.pivots[f]], inertia = numbers[p->d->mass.diagonal[f]];
        const link *l = &m->links[m->dofs[f].link];
        if (!(inertia > 0.0) || !(pivot > 1e-10 * inertia)) {
            const bool is_ball = l->kind == JOINT_SPHERICAL;
            source_problem(s, l->at,
                           "the joint '%s' moves no inertia%s at the start (singular mass matrix): give a body beyond "
                           "it an inertia%s",
                           l->name, is_ball ? about[f - l->dof] : "",
                           is_ball ? "" : " or a centre of mass off its axis");
            return;
        }
    }
}

static bool make_folder(arena *memory, const char *path)
{
    char *partial = arena_copy(memory, path, strlen(path));
    for (char *slash = partial + 1; *slash != '\0'; slash++) {
        if (*slash == '/') {
            *slash = '\0';
            mkdir(partial, 0777);
            *slash = '/';
        }
    }
    if (mkdir(path, 0777) != 0 && errno != EEXIST) {
        fprintf(stderr, "%s: error: %s\n", path, strerror(errno));
        return false;
    }
    return true;
}

/* Writes beside the file and renames, so that a half-written one is never seen. */
static bool write_file(arena *memory, const char *folder, const char *base, const text *t)
{
    const char *path = arena_format(memory, "%s/%s", folder, base);
    const char *beside = arena_format(memory, "%s.new", path);
    FILE *file = fopen(beside, "wb");
    bool good = file != NULL && fwrite(t->bytes, 1, t->length, file) == t->length;
    good = file != NULL && fclose(file) == 0 && good;
    good = good && rename(beside, path) == 0;
    if (!good) {
        fprintf(stderr, "%s: error: %s\n", path, strerror(errno));
        remove(beside);
    }
    return good;
}

static bool write_plant(arena *memory, const options *o, const plant *p, graph *g)
{
    text header = {.memory = memory}, source_text = {.memory = memory}, summary = {.memory = memory};
    double culprit = 0.0;
    emit_header(p, &header);
    if (!emit_source(p, g, &source_text, &culprit)) {
        fprintf(stderr, "%s: error: the equations contain the number %g, which a %s cannot hold%s\n", o->scene, culprit,
                o->is_double ? "double" : "float", o->is_double ? "" : ": try --real double");
        return false;
    }
    cost_summary(p, g, &summary);
    if (!make_folder(memory, o->directory) || !write_file(memory, o->directory, "plant.h", &header) ||
        !write_file(memory, o->directory, "plant.c", &source_text)) {
        return false;
    }
    fwrite(summary.bytes, 1, summary.length, stdout);
    return fflush(stdout) == 0;
}

static bool write_graph(arena *memory, const scene *written)
{
    text drawing = {.memory = memory};
    dot_write(written, &drawing);
    fwrite(drawing.bytes, 1, drawing.length, stdout);
    return fflush(stdout) == 0;
}

static bool compile(arena *memory, const options *o)
{
    source s;
    graph g;
    if (!source_read(&s, memory, o->scene)) {
        return false;
    }
    scene written = parse_scene(&s, lex(&s));
    written.name = scene_name(memory, o->scene);
    if (!override(memory, o, &written)) {
        return false;
    }
    graph_start(&g, memory);
    graph_section(&g, "Constants of the scene");
    mechanism m = mechanism_build(&s, &g, &written);
    m.is_double = o->is_double;
    if (s.problem_count == 0 && o->draws) {
        return write_graph(memory, &written);
    }
    if (s.problem_count == 0) {
        if (o->wanted != FORMULATIONS && !formulation_fits(&m, o->wanted)) {
            return complain(m.cut_count > 0 ? "closed loops have no such formulation:"
                                            : "a tree has no such formulation:",
                            o->scene);
        }
        const plant p = plant_build(&g, &m, o->is_double, o->wanted);
        graph resting = graph_copy(&g); /* whatever formulation is kept, gaps are told in resting axes */
        assemble(&s, dynamics_build(&resting, &m, FORMULATION_COMPOSITE));
        check_pivots(&s, &g, &p);
        if (s.problem_count == 0) {
            return write_plant(memory, o, &p, &g);
        }
    }
    source_report(&s);
    return false;
}

/* --version, --help and --methods, which need no scene. */
static bool answer(const char *argument)
{
    if (strcmp(argument, "--version") == 0) {
        fputs(version, stdout);
    } else if (strcmp(argument, "--help") == 0) {
        fputs(help, stdout);
    } else if (strcmp(argument, "--methods") == 0) {
        text table = {.memory = arena_new()};
        cost_methods(&table);
        fwrite(table.bytes, 1, table.length, stdout);
        arena_free(table.memory);
    } else {
        return false;
    }
    return true;
}

int main(int count, char **arguments)
{
    for (int i = 1; i < count; i++) {
        if (answer(arguments[i])) {
            return 0;
        }
    }
    options o = {0};
    if (count == 0 || !read_options(arguments + 1, &o)) {
        return 1;
    }
    arena *memory = arena_new();
    const bool good = compile(memory, &o);
    arena_free(memory);
    return good ? 0 : 1;
}

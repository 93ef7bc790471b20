#include "tools/isoc/export/terminals.h"

#include <math.h>

#include "core/wire/protocol.h"
#include "tools/isoc/base/embedded.h"

/* The words that no attribute may be called by in Python 3; whoever wants an output of such a name calls getattr. */
static const char *const words_of_python[] = {
    "False",  "None",     "True", "and",    "as",   "assert",  "async",  "await",  "break", "class",  "continue", "def",
    "del",    "elif",     "else", "except", "for",  "finally", "from",   "global", "if",    "import", "in",       "is",
    "lambda", "nonlocal", "not",  "or",     "pass", "raise",   "return", "try",    "while", "with",   "yield",
};

static const char *python_dictionary(arena *memory, const quantities *content)
{
    text rows = {.memory = memory};
    text_add(&rows, "{\n");
    FOR_ALL (const variable, v, content->all, content->count) {
        text_add(&rows, "    \"%s\": (\"%s\", %s, %s),\n", v->name, v->unit, bound(memory, v->least, "float(\"inf\")"),
                 bound(memory, v->most, "float(\"inf\")"));
    }
    text_add(&rows, "}");
    return rows.bytes;
}

/* The outputs as attributes of a class, each with its type. */
static const char *typed_outputs(const terminals *t, arena *memory)
{
    text rows = empty_text(memory);
    FOR_ALL (const variable, y, t->outputs.all, t->outputs.count) {
        if (index_of_word(y->name, words_of_python, COUNT_OF(words_of_python)) == COUNT_OF(words_of_python)) {
            text_add(&rows, "    %s: float  # %s\n", y->name, y->unit);
        }
    }
    return rows.bytes;
}

/* A table of names, units and limits for the module's docstring. */
static void list_quantities(text *out, const char *title, const quantities *content)
{
    if (content->count > 0) {
        text_add(out, "%s:\n", title);
    }
    FOR_ALL (const variable, v, content->all, content->count) {
        text_add(out, "    %-24s %s", v->name, v->unit);
        if (!isinf(v->least) || !isinf(v->most)) {
            text_add(out, ", from %s to %s", bound(out->memory, v->least, "infinity"),
                     bound(out->memory, v->most, "infinity"));
        }
        text_add(out, "\n");
    }
}

/* The part that both modules have: the words of a plant. */
static const char *shared_part(const terminals *t, arena *memory)
{
    static const char assignment[] = "    @name@=@number@,\n", entry[] = "    @number@: @words@,\n",
                      layout[] = "    @name@=\"@layout@\",\n", quoted[] = "    \"@name@\",\n";
    text filled = {.memory = memory};
    text_fill(&filled, embedded_text(client_files, "tools/client/words.py.in"),
              (const filling[]){{"type", t->is_double ? "d" : "f"},
                                {"identity", arena_format(memory, "0x%s", t->identity)},
                                {"period_ns", arena_format(memory, "%ld", t->period_ns)},
                                {"inputs", python_dictionary(memory, &t->inputs)},
                                {"outputs", python_dictionary(memory, &t->outputs)},
                                {"tunables", python_dictionary(memory, &t->tunables)},
                                {"typed outputs", typed_outputs(t, memory)},
                                {"commands", protocol_rows(memory, PROTOCOL_COMMANDS, assignment)},
                                {"states", protocol_rows(memory, PROTOCOL_STATES, entry)},
                                {"answers", protocol_rows(memory, PROTOCOL_ANSWERS, entry)},
                                {"piece", arena_format(memory, "%d", ISO_COMMAND_PIECE)},
                                {"start fields", protocol_rows(memory, PROTOCOL_START_FIELDS, quoted)},
                                {"state fields", protocol_rows(memory, PROTOCOL_STATE_FIELDS, quoted)},
                                {"state layout", protocol_rows(memory, PROTOCOL_STATE_FIELDS, "@layout@")},
                                {"layouts", protocol_rows(memory, PROTOCOL_FRAMES, layout)},
                                {"command layouts", protocol_rows(memory, PROTOCOL_COMMANDS, layout)},
                                {"words", protocol_rows(memory, PROTOCOL_WORDS, quoted)},
                                {NULL, NULL}});
    return filled.bytes;
}

/* A module by its template. */
static void add_module(const terminals *t, const char *path, const char *template, file_list *files)
{
    arena *memory = files->memory;
    text listing = empty_text(memory), starts = empty_text(memory);
    FOR_ALL (const variable, v, t->inputs.all, t->inputs.count) {
        text_add(&starts, "%s\"%s\": %.17g", starts.length > 0 ? ", " : "", v->name, v->start);
    }
    list_quantities(&listing, "Inputs", &t->inputs);
    list_quantities(&listing, "Outputs", &t->outputs);
    list_quantities(&listing, "Tunables and faults", &t->tunables);
    file_list_fill(files, path, template,
                   (const filling[]){{"scene", t->scene},
                                     {"listing", listing.bytes},
                                     {"shared", shared_part(t, memory)},
                                     {"starts", starts.bytes},
                                     {"frames", protocol_rows(memory, PROTOCOL_FRAMES, "    @name@=b@number@,\n")},
                                     {"modes", protocol_rows(memory, PROTOCOL_MODES, "    @words@: @number@,\n")},
                                     {"reasons", protocol_rows(memory, PROTOCOL_REASONS, "    @number@: @words@,\n")},
                                     {"version", arena_format(memory, "%d", ISO_LINK_VERSION)},
                                     {NULL, NULL}});
}

/* The files by which pip installs a module. */
static void add_package(const terminals *t, const char *module, const char *what, file_list *files)
{
    const filling fillings[] = {
        {"what", what}, {"scene", t->scene}, {"module", module}, {"identity", t->identity}, {NULL, NULL}};
    file_list_fill(files, "pyproject.toml", "tools/client/pyproject.toml.in", fillings);
    file_list_fill(files, arena_format(files->memory, "%s_wheel.py", module), "tools/client/wheel.py.in", fillings);
}

void add_python_of_link(const terminals *t, file_list *files)
{
    const char *called = arena_format(files->memory, "%s_link", t->prefix);
    add_module(t, arena_format(files->memory, "%s.py", called), "tools/client/client.py.in", files);
    add_package(t, called, "The controller's end of the link to the plant", files);
}

/* What the library of the plant knows beside it: its identity, and the places of the inputs that come in. */
static void add_library(const plant *p, const terminals *t, file_list *files)
{
    text out = {.memory = files->memory};
    text_add(&out, "/* The plant of %s.scene in a process. Made by isoc. */\n#include \"tools/python/instance.h\"\n\n",
             t->scene);
    text_add(&out, "const uint64_t iso_instance_identity = UINT64_C(0x%s);\n", t->identity);
    text_add(&out, "const size_t iso_instance_wires = %d;\nconst uint16_t iso_instance_inputs[] = {", t->inputs.count);
    for (int i = 0; i < t->inputs.count; i++) {
        text_add(&out, "%d, ", p->m->inputs.wires[i].input);
    }
    text_add(&out, "0};\n");
    file_list_add(files, "library.c", &out);
}

void emit_python(const plant *p, const naming *names, file_list *files)
{
    arena *memory = files->memory;
    const terminals t = terminals_of(p, names, files);
    const char *called = arena_format(memory, "%s_plant", t.prefix);
    const text typed = empty_text(memory);
    add_library(p, &t, files);
    add_module(&t, arena_format(memory, "%s/__init__.py", called), "tools/client/plant.py.in", files);
    file_list_add(files, arena_format(memory, "%s/py.typed", called), &typed);
    add_package(&t, called, "The plant", files);
}

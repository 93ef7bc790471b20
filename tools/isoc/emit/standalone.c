#include "tools/isoc/emit/emit.h"

#include <string.h>

#include "tools/isoc/base/embedded.h"

static const char include[] = "#include \"";

/* How the files of core are copied: for which reals, and whether for plants side by side. */
typedef struct copying {
    bool is_double, has_lanes;
} copying;

/* The length of the path that is included at `at`, which is moved to it; 0 if there is none further on. */
static size_t next_include(const char **at)
{
    const char *found = strstr(*at, include);
    *at = found == NULL ? "" : found + strlen(include);
    return strcspn(*at, "\"");
}

/* What the copy of a file has before its text: a root where the core has no instruction for it. */
static const char *preface_of(const embedded_file *f)
{
    return strcmp(f->path, "core/numbers/sqrt.h") == 0 ? "#include \"port/soft/own_root.h\"\n" : "";
}

/* Adds a text with relative paths: "core/methods/equations.h" is "../../core/methods/equations.h" for its neighbours,
 * which stand as deep in the folder. */
static void add_relative(text *copy, const char *file)
{
    const char *from = file, *at = from;
    for (size_t length = next_include(&at); length > 0; length = next_include(&at)) {
        text_add(copy, "%.*s../../%.*s", (int)(at - from), from, (int)length, at);
        from = at + length;
    }
    text_add(copy, "%s", from);
}

/* Adds a file, and those that it includes, each once. */
static void add_file(file_list *files, const embedded_file *f, copying how);

/* Headers that only plants side by side include. */
static bool is_of_lanes(const embedded_file *f)
{
    return strcmp(f->path, "core/numbers/lanes.h") == 0 || strcmp(f->path, "core/runtime/lanes.h") == 0;
}

/* Adds the files that this text includes. */
static void add_includes(file_list *files, const char *file, copying how)
{
    const char *at = file;
    for (size_t length = next_include(&at); length > 0; length = next_include(&at)) {
        const embedded_file *f = embedded_find(core_files, at, length);
        if (f != NULL && (how.has_lanes || !is_of_lanes(f))) {
            add_file(files, f, how);
        }
    }
}

static void add_file(file_list *files, const embedded_file *f, copying how)
{
    if (file_list_has(files, f->path)) {
        return;
    }
    text copy = {.memory = files->memory};
    if (how.is_double) {
        text_add(&copy, "#ifndef ISO_REAL_DOUBLE\n#define ISO_REAL_DOUBLE\n#endif\n");
    }
    add_relative(&copy, preface_of(f));
    add_relative(&copy, f->text);
    file_list_add(files, f->path, &copy);
    add_includes(files, preface_of(f), how);
    add_includes(files, f->text, how);
}

/* The folder as a package of build systems. */
static void add_packages(file_list *files, const naming *names)
{
    static const char *const packages[][2] = {
        {"CMakeLists.txt", "tools/package/CMakeLists.txt.in"},
        {"zephyr/module.yml", "tools/package/module.yml.in"},
        {"zephyr/Kconfig", "tools/package/Kconfig.in"},
        {"library.properties", "tools/package/library.properties.in"},
        {"library.json", "tools/package/library.json.in"},
        {"README.md", "tools/package/README.md.in"},
    };
    for (size_t i = 0; i < COUNT_OF(packages); i++) {
        file_list_fill(files, packages[i][0], packages[i][1],
                       (const filling[]){{"name", names->prefix},
                                         {"NAME", names->capitals},
                                         {"flags", compiler_flags(files->memory, FLAGS_OF_ROOTS)},
                                         {NULL, NULL}});
    }
}

void standalone_files(file_list *files, const naming *names, bool is_double, bool has_packages)
{
    const copying how = {.is_double = is_double, .has_lanes = names->has_lanes};
    const size_t count = files->count;
    for (size_t i = 0; i < count; i++) {
        add_includes(files, files->files[i].text.bytes, how);
    }
    if (has_packages) {
        add_packages(files, names);
    }
    add_includes(files, "#include \"core/runtime/tick.h\"", how); /* what a program calls */
}

#include "tools/isoc/export/fmu.h"

#include <ctype.h>
#include <string.h>

const char *fmu_name(const plant *p, arena *memory)
{
    char *word = arena_copy(memory, p->m->name, strlen(p->m->name));
    for (char *c = word; *c != '\0'; c++) {
        *c = isalnum((unsigned char)*c) ? (char)tolower((unsigned char)*c) : '_';
    }
    return prefix_fault(word, memory) == NULL ? word : arena_format(memory, "plant_%s", word);
}

void emit_fmu(const plant *p, const graph *g, const naming *names, int version, bool exchanges, file_list *files)
{
    const char *const copies[][2] = {
        {"fmu_instance.h", "tools/fmu/instance.h.in"},
        {"fmu_record.h", "tools/fmu/record.h.in"},
        {"fmu_exchange.h", "tools/fmu/exchange.h.in"},
        {version == 3 ? "fmi3.h" : "fmi2.h", version == 3 ? "tools/fmu/fmi3.h.in" : "tools/fmu/fmi2.h.in"},
        {version == 3 ? "fmi3.c" : "fmi2.c", version == 3 ? "tools/fmu/fmi3.c.in" : "tools/fmu/fmi2.c.in"},
    };
    const text none = empty_text(files->memory);
    const char *identity = identity_of(files, files->count, &none);
    const fmu f = {p, g, names, files->memory, identity, version, exchanges};
    fmu_add_model(&f, files);
    for (size_t i = 0; i < COUNT_OF(copies); i++) {
        file_list_fill(files, copies[i][0], copies[i][1], (const filling[]){{NULL, NULL}});
    }
    fmu_describe(&f, files);
    file_list_fill(
        files, "buildDescription.xml", "tools/fmu/buildDescription.xml.in",
        (const filling[]){{"name", names->prefix},
                          {"sources", fmu_sources(&f, "      <SourceFile name=\"%s\"/>\n")},
                          {"flags", arena_format(files->memory, "%s %s", compiler_flags(files->memory, FLAGS_OF_FUSING),
                                                 compiler_flags(files->memory, FLAGS_OF_ROOTS))},
                          {"version", version == 3 ? "3" : "2"},
                          {NULL, NULL}});
}

#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/emit/fmu.h"

/* FNV-1a in 64 bits over the texts of the plant. */
static uint64_t identity_of_files(const file_list *files)
{
    uint64_t hash = UINT64_C(0xCBF29CE484222325);
    for (size_t k = 0; k < files->count; k++) {
        const text *t = &files->files[k].text;
        for (size_t i = 0; i < t->length; i++) {
            hash = (hash ^ (uint8_t)t->bytes[i]) * UINT64_C(0x00000100000001B3);
        }
    }
    return hash;
}

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
    static const char *const fixed[][2] = {{"fmu_instance.h", "tools/fmu/instance.h.in"},
                                           {"fmu_record.h", "tools/fmu/record.h.in"},
                                           {"fmu_exchange.h", "tools/fmu/exchange.h.in"}};
    static const char *const calls[][2] = {{"fmi2.h", "tools/fmu/fmi2.h.in"},
                                           {"fmi2.c", "tools/fmu/fmi2.c.in"},
                                           {"fmi3.h", "tools/fmu/fmi3.h.in"},
                                           {"fmi3.c", "tools/fmu/fmi3.c.in"}};
    arena *memory = files->memory;
    const fmu f = {p,       g,        names, memory, arena_format(memory, "%016" PRIx64, identity_of_files(files)),
                   version, exchanges};
    text model = {.memory = memory}, description = model, build = model;
    fmu_add_model(&f, &model);
    file_list_add(files, "fmu_model.h", &model);
    for (size_t i = 0; i < 5; i++) {
        const char *const *pair = i < 3 ? fixed[i] : calls[2 * (size_t)(version - 2) + i - 3];
        text copy = {.memory = memory};
        text_add(&copy, "%s", embedded_text(client_files, pair[1]));
        file_list_add(files, pair[0], &copy);
    }
    fmu_describe(&f, &description);
    file_list_add(files, "modelDescription.xml", &description);
    text_fill(&build, embedded_text(client_files, "tools/fmu/buildDescription.xml.in"),
              (const filling[]){{"name", names->prefix},
                                {"sources", fmu_sources(&f, "      <SourceFile name=\"%s\"/>\n")},
                                {"version", version == 3 ? "3" : "2"},
                                {NULL, NULL}});
    file_list_add(files, "buildDescription.xml", &build);
}

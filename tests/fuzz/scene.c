/* A text as a scene: whatever it says, the parser ends, with problems or without, and all memory is given back. */
#include <stddef.h>
#include <stdint.h>

#include "tools/isoc/scene/parser.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

int LLVMFuzzerTestOneInput(const uint8_t *const bytes, const size_t count)
{
    arena *const memory = arena_new();
    source s = {.memory = memory, .path = "fuzz.scene"};
    const script *const whole = source_add(&s, s.path, arena_copy(memory, (const char *)bytes, count));
    source_passage(&s, whole, 0, whole->length, NULL);
    (void)parse_scene(&s, NULL);
    source_report(&s);
    arena_free(memory);
    return 0;
}

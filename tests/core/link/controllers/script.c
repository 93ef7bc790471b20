/* script SCHEDULE TICKS: balances the cart of the scene, sets tunables by a schedule of lines `tick name value`, and
 * prints the hash of the trajectory. */
#include "script_link.h"

static script_link plant;

typedef struct entry {
    unsigned long long tick;
    char name[64];
    float value;
} entry;

static uint16_t place_of(const char *const name)
{
    uint16_t i = 0;
    while (i < SCRIPT_TUNABLES && strcmp(script_tunables[i].name, name) != 0) {
        i++;
    }
    return i;
}

static bool next_entry(FILE *const file, entry *const e)
{
    return fscanf(file, "%llu %63s %f", &e->tick, e->name, &e->value) == 3;
}

/* Sets what is due; leaves in *e what is not. */
static bool set_due(FILE *const file, entry *const e, bool *const more)
{
    bool good = true;
    while (good && *more && e->tick == plant.client.tick) {
        script_real read = 0;
        good = script_set(&plant, place_of(e->name), e->value) && script_get(&plant, place_of(e->name), &read) &&
               memcmp(&read, &e->value, sizeof read) == 0;
        *more = next_entry(file, e);
    }
    return good;
}

int main(int count, char **arguments)
{
    entry e = {0};
    FILE *const file = count == 3 ? fopen(arguments[1], "r") : NULL;
    if (file == NULL) {
        return EXIT_FAILURE;
    }
    const uint64_t last = strtoull(arguments[2], NULL, 10);
    bool more = next_entry(file, &e);
    bool good = script_open(&plant, NULL) && !script_set(&plant, 0, 0) &&
                strstr(plant.client.problem, "no run") != NULL && script_start(&plant, ISO_CLIENT_LOCKSTEP, 0);
    while (good && plant.client.tick < last) {
        const float volts = 30 * plant.y[SCRIPT_Y_MEASURED_POLE] + 2 * plant.y[SCRIPT_Y_MEASURED_CART];
        plant.u[SCRIPT_U_COMMAND] = volts < -12 ? -12 : volts > 12 ? 12 : volts;
        good = set_due(file, &e, &more) && script_exchange(&plant);
    }
    (void)fclose(file);
    script_real value = 0;
    good = good && script_state(&plant) && script_counts(&plant) && plant.client.end.ticks == last &&
           plant.client.end.hash == plant.client.state.hash && !plant.client.over &&
           !script_set(&plant, SCRIPT_TUNABLES, 0) && strstr(plant.client.problem, "no such tunable") != NULL &&
           !script_get(&plant, SCRIPT_TUNABLES, &value) && strstr(plant.client.problem, "no such tunable") != NULL;
    if (!good) {
        fprintf(stderr, "tick %llu: %s\n", (unsigned long long)plant.client.tick, plant.client.problem);
        return EXIT_FAILURE;
    }
    printf("%016llx\n", (unsigned long long)plant.client.end.hash);
    return EXIT_SUCCESS;
}

/* A controller with a state of its own: a filter of the angle, whose speed it uses.
 *
 *     kept FILE TICKS WORD    at TICKS a snapshot goes to the file; prints the hash 500 ticks later, and once more from
 *                             the snapshot there; WORD is `kept`, and the controller's state goes along, or `left`
 *     kept FILE TICKS from    puts plant and controller to that snapshot, and prints the hash 500 ticks later
 */
#include "cart_pole_link.h"

#include "tests/core/link/controllers/record.h"

enum { MORE = 500 };

static cart_pole_link plant;
static struct {
    double angle, turns;
} filter;

static bool balance(const uint64_t tick)
{
    bool good = true;
    while (good && plant.client.tick < tick) {
        const double angle = (double)plant.y[CART_POLE_Y_POLE], speed = 100 * (angle - filter.angle);
        filter.angle += 0.1 * (angle - filter.angle);
        filter.turns += 1e-3 * angle;
        plant.u[CART_POLE_U_FORCE] =
            (cart_pole_real)(30 * angle + 0.6 * speed + filter.turns + 4 * (double)plant.y[CART_POLE_Y_CART_SPEED]);
        good = cart_pole_exchange(&plant);
    }
    return good;
}

static bool tell(const bool good)
{
    if (good && cart_pole_state(&plant)) {
        printf("%016llx\n", (unsigned long long)plant.client.state.hash);
        return true;
    }
    fprintf(stderr, "%s\n", plant.client.problem);
    return false;
}

static size_t taken(const char *const path, const uint64_t tick)
{
    const size_t bytes = balance(tick) ? cart_pole_snapshot(&plant, record, sizeof record) : 0;
    return write_record(path, bytes) ? bytes : 0;
}

int main(const int count, char **const arguments)
{
    if (count < 4 || !cart_pole_open(&plant, NULL) || !cart_pole_start(&plant, ISO_CLIENT_LOCKSTEP, 0)) {
        (void)tell(false);
        cart_pole_close(&plant);
        return fcntl(STDIN_FILENO, F_GETFD) < 0 ? 2 : 1; /* 2: what was not opened took another file along */
    }
    const uint64_t tick = strtoull(arguments[2], NULL, 10);
    const bool is_from = strcmp(arguments[3], "from") == 0;
    if (strcmp(arguments[3], "left") != 0) {
        cart_pole_keep(&plant, &filter, sizeof filter);
    }
    const size_t bytes = is_from ? read_record(arguments[1]) : taken(arguments[1], tick);
    const bool good = is_from || (bytes > 0 && balance(tick + MORE) && tell(true));
    const bool ends =
        tell(good && cart_pole_restore(&plant, record, bytes) && cart_pole_run(&plant, 0) && balance(tick + MORE));
    cart_pole_close(&plant);
    return !ends;
}

/* Balances the pole of cart_pole.scene, a thousand times in a second, from what a real cart has: the counts of its
 * encoder, and a reading of its place. A filter of 10 ms gives the speeds. The gains are those of a linear-quadratic
 * regulator. */
#include "cart_pole_link.h"

/* A signal, and its speed. */
typedef struct tracked {
    double place, speed;
} tracked;

static void follow(tracked *const s, const double place)
{
    const double step = 1e-9 * CART_POLE_PERIOD_NS, lag = 0.01;
    s->speed = (place - s->place) / lag;
    s->place += step * s->speed;
}

int main(void)
{
    const double radians = 2 * 3.14159265358979 / 4096; /* of a count */
    const double friction = 0.6;                        /* what the belt needs to move, in volts */
    static cart_pole_link plant;
    bool good = cart_pole_open(&plant, NULL) && cart_pole_start(&plant, ISO_CLIENT_LOCKSTEP, 0);
    tracked cart = {0}, pole = {0};
    while (good) {
        const double place = (double)plant.y[CART_POLE_Y_PLACE];
        const double angle = radians * (double)plant.y[CART_POLE_Y_COUNTS];
        if (plant.client.tick < 2) { /* the first readings are those before the converter's */
            cart.place = place;
            pole.place = angle;
        }
        follow(&cart, place);
        follow(&pole, angle);
        const double volts = 43.6 * place + 39.7 * cart.speed + 144.7 * angle + 25.2 * pole.speed +
                             friction * cart.speed / (fabs(cart.speed) + 0.02);
        plant.u[CART_POLE_U_VOLTS] = (cart_pole_real)(plant.client.tick < 2 ? 0 : fmin(fmax(volts, -12), 12));
        good = cart_pole_exchange(&plant);
    }
    return plant.client.over ? EXIT_SUCCESS : (fprintf(stderr, "%s\n", plant.client.problem), EXIT_FAILURE);
}

/* A controller on a Pico of its own, which knows its plant by pins alone: two encoders in, the duty of a drive out. */
#include <stdbool.h>

#include "port/port.h"

enum { PERIOD_NS = 1000000, POLE = 0, CART = 1, SENSORS = 2 };

int main(int argc, char **argv)
{
    (void)iso_port_duration(argc, argv);
    (void)iso_port_start(PERIOD_NS);
    real now[SENSORS] = {0}, before[SENSORS] = {0}, speed[SENSORS] = {0};
    for (bool is_first = true;; is_first = false) {
        (void)iso_port_wait();
        iso_port_read(now, SENSORS);
        for (unsigned i = 0; i < SENSORS; i++) {
            /* A difference of counts, smoothed over some 8 ms. */
            const real difference = is_first ? R(0.0) : (now[i] - before[i]) * R(1000.0);
            speed[i] += (difference - speed[i]) * R(0.125);
            before[i] = now[i];
        }
        const real force = R(60.0) * now[POLE] + R(5.0) * speed[POLE] + R(4.0) * now[CART] + R(6.0) * speed[CART];
        iso_port_publish(&force, 1);
    }
}

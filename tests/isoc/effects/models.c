/* The machines with effects, models/, over ten seconds in double: each against what must hold whatever else happens in
 * it, a balance or a closed form. Constants are those of the scenes. */
#include <math.h>
#include <stdlib.h>

#include "arm_drive.h"
#include "balancer.h"
#include "cart_pole_drive.h"
#include "core/runtime/tick.h"
#include "crane.h"
#include "dc_motor_bench.h"
#include "hopper.h"
#include "quadrotor_sih.h"
#include "quarter_car.h"
#include "tests/host/report.h"

#define PI 3.14159265358979323846

static const double g = 9.81;

/* The outputs of a run, a row for each tick. */
typedef struct run {
    double *rows;
    int ticks, outputs;
} run;

static double at(const run *const r, const int tick, const int output)
{
    return r->rows[(size_t)tick * (size_t)r->outputs + (size_t)output];
}

static void keep(const run *const r, const iso_plant *const plant, const int tick)
{
    for (int i = 0; i < r->outputs; i++) {
        r->rows[(size_t)tick * (size_t)r->outputs + (size_t)i] = (double)plant->y[i];
    }
}

/* Ten seconds, and whether the guard was content. */
static run run_of(const iso_plant plant)
{
    run r = {NULL, (int)(10.0 / (double)plant.model->step_size + 0.5), plant.model->outputs};
    r.rows = calloc((size_t)(r.ticks + 1) * (size_t)r.outputs, sizeof *r.rows);
    if (r.rows == NULL) {
        abort();
    }
    bool well = true;
    iso_plant_start(&plant);
    plant.model->output(plant.memory);
    keep(&r, &plant, 0);
    for (int tick = 0; tick < r.ticks; tick++) {
        well = iso_plant_tick(&plant, (uint64_t)tick) == plant.model->states && well;
        keep(&r, &plant, tick + 1);
    }
    report_ok(well, "%s runs for ten seconds", plant.model->name);
    return r;
}

#define RUN(name)                                                                                                      \
    static name##_memory name##_of;                                                                                    \
    run r = run_of(name##_plant(&name##_of))

/* The largest |a - wanted| of an output from a tick to another. */
static double off(const run *const r, const int output, const int from, const int to, const double wanted)
{
    double worst = 0.0;
    for (int tick = from; tick <= to; tick++) {
        worst = fmax(worst, fabs(at(r, tick, output) - wanted));
    }
    return worst;
}

/* A motor at rest in speed: V = R i + k w, and k i = damping w + friction + load, where friction slides. Before, it had
 * 28 time constants R J / k^2 = 48 ms; what is left of them, exp(-28), and of the creep, (creep / w)^2 / 2, is below
 * 1e-8. The encoder has counted what the speed adds up to by the rule of the trapezoid, which is off by h^2 / 12 (w'(T)
 * - w'(0)). */
static void test_bench(void)
{
    RUN(dc_motor_bench);
    const double resistance = 2.0, k = 0.05, damping = 20e-6, torque = 5e-3 + 60e-3, volts = 12.0;
    const double speed = (k * volts / resistance - torque) / (k * k / resistance + damping);
    const double current = (volts - k * speed) / resistance;
    const double w = off(&r, DC_MOTOR_BENCH_Y_SPEED, 29900, 30000, speed) / speed;
    const double i = off(&r, DC_MOTOR_BENCH_Y_CURRENT, 29900, 30000, current) / current;
    report_ok(w < 1e-7 && i < 1e-7, "it comes to %.6g rad/s and %.6g A: %.1g and %.1g off", speed, current, w, i);
    double angle = 0.0, worst = 0.0;
    for (int tick = 1; tick <= r.ticks; tick++) {
        angle += 0.5e-4 * (at(&r, tick - 1, DC_MOTOR_BENCH_Y_SPEED) + at(&r, tick, DC_MOTOR_BENCH_Y_SPEED));
        const double exact = angle * 4.0 * 500.0 / (2.0 * PI);
        worst = fmax(worst, fabs(at(&r, tick, DC_MOTOR_BENCH_Y_COUNT) + 0.5 - exact));
    }
    report_ok(worst <= 0.5 + 0.01, "the encoder counts both ways: %.3f counts off its middle", worst);
    free(r.rows);
}

/* From the row of 6 s to that of 6.5 s the reading of the pole sticks. Against the stop the motor stands, with V / R;
 * the pole moves the cart by little there. With its circuit open the motor carries no current (the 5 ms of the scene
 * divide a second), and then friction and stop only take energy: no tick has more than the one before, to rounding. */
static void test_cart(void)
{
    RUN(cart_pole_drive);
    const double stuck = at(&r, 6000, CART_POLE_DRIVE_Y_POLE);
    report_ok(off(&r, CART_POLE_DRIVE_Y_POLE, 6000, 6499, stuck) == 0.0 &&
                  off(&r, CART_POLE_DRIVE_Y_POLE, 6500, 6500, stuck) > 0.1,
              "the reading of the pole sticks for half a second");
    const double stands = at(&r, 2000, CART_POLE_DRIVE_Y_CURRENT);
    report_ok(fabs(stands - 2.5) < 0.025, "at the stop the motor stands: %.4f A", stands);
    report_ok(off(&r, CART_POLE_DRIVE_Y_CURRENT, 9000, r.ticks, 0.0) < 1e-9, "the open circuit carries no current");
    double rise = 0.0;
    for (int tick = 8200; tick < r.ticks; tick++) {
        rise = fmax(rise, at(&r, tick + 1, CART_POLE_DRIVE_Y_ENERGY) - at(&r, tick, CART_POLE_DRIVE_Y_ENERGY));
    }
    report_ok(rise < 1e-14, "without the motor no tick gains energy: %.2g J", rise);
    free(r.rows);
}

/* At rest the tyre bears all. In the air only gravity acts on all of it, whatever springs, damper and stops do: the
 * centre of mass falls along a parabola, to rounding. */
static void test_car(void)
{
    RUN(quarter_car);
    const double weight = 365.0 * g;
    const double rest = off(&r, QUARTER_CAR_Y_LOAD, 0, 999, weight) / weight;
    report_ok(rest < 1e-9, "at rest the tyre bears the weight: %.1g off", rest);
    int first = 1400;
    while (at(&r, first, QUARTER_CAR_Y_LOAD) > 0.0) {
        first++;
    }
    int last = first;
    while (at(&r, last + 1, QUARTER_CAR_Y_LOAD) <= 0.0) {
        last++;
    }
    double centre[3];
    const int half = (last - first) / 2;
    for (int i = 0; i < 3; i++) {
        const int tick = first + i * half;
        centre[i] = (320.0 * at(&r, tick, QUARTER_CAR_Y_BODY) + 45.0 * at(&r, tick, QUARTER_CAR_Y_WHEEL)) / 365.0;
    }
    const double time = half * 1e-3, fall = centre[0] - 2.0 * centre[1] + centre[2];
    report_ok(half > 50 && fabs(fall + g * time * time) < 1e-12, "%g s in the air it falls with g: %.1g m off",
              2.0 * time, fabs(fall + g * time * time));
    free(r.rows);
}

/* The cable bears the load, then it is slack while the floor does, but for what is left of the bounce: its damping goes
 * with its depth. */
static void test_crane(void)
{
    RUN(crane);
    const double weight = 250.0 * g;
    const double hangs = off(&r, CRANE_Y_TENSION, 0, 500, weight) / weight;
    report_ok(hangs < 1e-6, "the cable bears the load: %.1g off", hangs);
    report_ok(off(&r, CRANE_Y_TENSION, 4500, 5500, 0.0) == 0.0, "it is slack while the load stands on the floor");
    const double stands = off(&r, CRANE_Y_FLOOR, 4500, 5500, weight) / weight;
    report_ok(stands < 1e-4, "then the floor bears the load: %.1g off", stands);
    free(r.rows);
}

/* In a curve the moment of the centrifugal force about the ground shifts the load between the wheels. The spin of the
 * wheels adds 2 %, and the tilt by the tyres 1 %. */
static void test_balancer(void)
{
    RUN(balancer);
    const int tick = 3500;
    const double speed = at(&r, tick, BALANCER_Y_SPEED), yaw = at(&r, tick, BALANCER_Y_SPIN);
    const double moment = (1.2 * 0.15 + 0.16 * 0.05) * speed * yaw;
    const double shift = at(&r, tick, BALANCER_Y_NORMAL) - 1.36 * g / 2.0, wanted = moment / 0.2;
    report_ok(fabs(shift / wanted - 1.0) < 0.03, "a curve shifts the load by %.4g N: %.4g N", shift, wanted);
    const double tilt = off(&r, BALANCER_Y_PITCH, 0, r.ticks, 0.0);
    report_ok(tilt < 0.1, "it stays upright: %.3g rad", tilt);
    free(r.rows);
}

/* The centre of mass of the hopper: torso, thigh and shin. */
static void centre_of(const run *const r, const int tick, double c[2])
{
    const double hip = at(r, tick, HOPPER_Y_HIP), leg = at(r, tick, HOPPER_Y_LEG);
    const double far = (0.6 * 0.15 + 0.3 * (0.5 - leg) + 0.1 * (0.7 - leg)) / 9.0;
    c[0] = at(r, tick, HOPPER_Y_PLACE_X) - far * sin(hip);
    c[1] = at(r, tick, HOPPER_Y_PLACE_Z) - far * cos(hip);
}

/* In the air only gravity acts: the centre of mass has a parabola, whatever hip and leg do. */
static void test_hopper(void)
{
    RUN(hopper);
    int flights = 0;
    double worst = 0.0;
    for (int tick = 200; tick + 100 <= r.ticks; tick++) {
        if (off(&r, HOPPER_Y_NORMAL, tick, tick + 100, 0.0) > 0.0) {
            continue;
        }
        double c[3][2];
        for (int i = 0; i < 3; i++) {
            centre_of(&r, tick + 50 * i, c[i]);
        }
        const double x = c[0][0] - 2.0 * c[1][0] + c[2][0], z = c[0][1] - 2.0 * c[1][1] + c[2][1];
        worst = fmax(worst, fmax(fabs(x), fabs(z + g * 0.05 * 0.05)));
        flights++;
        tick += 100;
    }
    report_ok(flights >= 16 && worst < 1e-6, "in %d flights it falls with g: %.2g m off", flights, worst);
    report_ok(off(&r, HOPPER_Y_SPEED, 9000, r.ticks, 0.0) < 0.05 && at(&r, 6000, HOPPER_Y_SPEED) > 0.3,
              "it runs and stops");
    free(r.rows);
}

/* On the ground the unit reads g, on average but for four times 0.045 m/s^2 / sqrt(500) of its noise; it hovers on a
 * lift of its weight, but for the drag of its tilt. */
static void test_quadrotor(void)
{
    RUN(quadrotor_sih);
    double rest = 0.0, lift = 0.0;
    for (int tick = 1; tick <= 500; tick++) {
        rest += at(&r, tick, QUADROTOR_SIH_Y_FORCE) / 500.0;
    }
    for (int tick = 4000; tick < 5000; tick++) {
        lift += 4.0 * 8e-6 * pow(at(&r, tick, QUADROTOR_SIH_Y_SPEED), 2.0) / 1000.0;
    }
    report_ok(fabs(rest - g) < 1e-2, "at rest the unit reads g: %.5f", rest);
    report_ok(fabs(lift / (1.2 * g) - 1.0) < 1e-3, "it hovers on %.5g N", lift);
    free(r.rows);
}

/* After its motor has failed the rotor of the shoulder has the gear's effort alone: 100^2 * 2e-4 kg*m^2 times the
 * second difference of its angle. That leaves out (w h)^2 / 12 of an oscillation with w = 150/s, 0.2 %, and what an
 * impact has besides. In the end the arm lies on its stop. */
static void test_arm(void)
{
    RUN(arm_drive);
    double worst = 0.0, most = 0.0;
    for (int tick = 5010; tick < r.ticks; tick++) {
        double angle[3];
        for (int i = 0; i < 3; i++) {
            angle[i] =
                at(&r, tick - 1 + i, ARM_DRIVE_Y_SHOULDER_ANGLE) + at(&r, tick - 1 + i, ARM_DRIVE_Y_SHOULDER_TWIST);
        }
        const double effort = at(&r, tick, ARM_DRIVE_Y_SHOULDER_TORQUE);
        worst = fmax(worst, fabs(2.0 * (angle[0] - 2.0 * angle[1] + angle[2]) / 1e-6 + effort));
        most = fmax(most, fabs(effort));
    }
    report_ok(most > 100.0 && worst < 0.01 * most, "the rotor has what the gear gives: %.3g of %.4g N*m off", worst,
              most);
    const double lies = at(&r, r.ticks, ARM_DRIVE_Y_SHOULDER_ANGLE);
    report_ok(lies > 0.0 && lies < 0.01, "the arm lies on its stop: %.4f rad", lies);
    free(r.rows);
}

int main(void)
{
    test_bench();
    test_cart();
    test_car();
    test_crane();
    test_balancer();
    test_hopper();
    test_quadrotor();
    test_arm();
    return report_done();
}

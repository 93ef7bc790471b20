"""Laws of the effects on signals: limits, filters, converters, faults, noise, and circuits. Signals are functions of time."""
import math

from law import STABLE_RATE, STEP, clamp, law, noise, rows_of, run

# The signals that the effects see, as inputs: in row k functions of k STEP. A fault begins in row 3.
SIGNALS = {
    "wave": ("V", "2 V * sin(100 Hz) + 0.3 V", lambda t: 2 * math.sin(2 * math.pi * 100 * t) + 0.3),
    "amps": ("A", "4 A * cos(70 Hz)", lambda t: 4 * math.cos(2 * math.pi * 70 * t)),
    "warm": ("W", "20 W * cos(50 Hz) + 30 W", lambda t: 20 * math.cos(2 * math.pi * 50 * t) + 30),
}
SEEDS = (7, 8, 9)
FIRST = 3


def shared():
    """Statements and outputs of the inputs, and whether a fault is on in a row."""
    lines = ["input %s %s = %s" % (name, unit, text) for name, (unit, text, _) in SIGNALS.items()]
    lines += ["input noise_%d = noise(%d)" % (seed, seed) for seed in SEEDS]
    return "\n".join(lines)


def of_inputs(k):
    """What the inputs are in row k."""
    row = {name: function(k * STEP) for name, (_, _, function) in SIGNALS.items()}
    row.update({"noise_%d" % seed: noise(k, seed) for seed in SEEDS})
    return row


def fault(name):
    return "at %g ms set %s.active = 1" % (FIRST * STEP * 1e3, name)


def rest_gain(x):
    """What one number of noise adds in a time x to a lag of 1, whose variance is 1 in the end, and to a second one behind it:
    the root of the first's variance, and over it the covariance of both, by Simpson's rule."""
    n = 200
    covariance = 0.0
    for i in range(n + 1):
        s = x * i / n
        covariance += (1 if i in (0, n) else 4 if i % 2 else 2) * 2 * s * math.exp(-2 * s)
    gain = math.sqrt(1 - math.exp(-2 * x))
    return gain, covariance * x / n / 3 / gain


@law("saturation", "effect saturated saturation { input wave; upper 1.5 V; lower -0.4 V }", "saturated = saturated.value")
@rows_of
def saturation(row, k):
    return {"saturated": clamp(row["wave"], -0.4, 1.5)}


@law("dead_zone", "effect flat dead_zone { input wave; upper 1 V; lower -0.5 V }", "flat = flat.value")
@rows_of
def dead_zone(row, k):
    x = row["wave"]
    return {"flat": x - 1 if x > 1 else x + 0.5 if x < -0.5 else 0}


@law("lag", "effect slow lag { input wave; constant 4 ms }", "slow = slow.value")
def lag(rows):
    return [{"slow": x[0]} for x in run(lambda x, row: [(row["wave"] - x[0]) / 4e-3], [0.0], rows)]


@law("integral", "effect summed integral { input wave }\neffect later integral { input amps; start 2 A*s }",
     "summed = summed.value\nlater = later.value")
def integral(rows):
    return [{"summed": x[0], "later": x[1]} for x in run(lambda x, row: [row["wave"], row["amps"]], [0.0, 2.0], rows)]


@law("derivative", "effect slope derivative { input wave; constant 3 ms }", "slope = slope.value")
def derivative(rows):
    states = run(lambda x, row: [(row["wave"] - x[0]) / 3e-3], [rows[0]["wave"]], rows)
    return [{"slope": (row["wave"] - x[0]) / 3e-3} for x, row in zip(states, rows)]


@law(
    "rate_limit",
    """effect slewed rate_limit { input wave; rise 500 V/s; fall 300 V/s; lag 2 ms }
    effect quick rate_limit { input wave; rise 600 V/s }""",
    "slewed = slewed.value\nquick = quick.value",
)
def rate_limit(rows):
    def rate(x, row):
        return [clamp((row["wave"] - x[0]) / 2e-3, -300, 500), clamp((row["wave"] - x[1]) * STABLE_RATE, -600, 600)]

    return [{"slewed": x[0], "quick": x[1]} for x in run(rate, [0.0, 0.0], rows)]


@law(
    "adc",
    "effect digits adc { input wave; lower -1 V; upper 2 V; offset 10 mV; bits 8 }",
    "digits_code = digits.code\ndigits = digits.value",
)
@rows_of
def adc(row, k):
    size = 3 / 2**8
    code = clamp(math.floor((row["wave"] + 0.01 + 1) / size + 0.5), 0, 255)
    return {"digits_code": code, "digits": -1 + code * size}


@law(
    "current_sense",
    "effect shunt current_sense { current amps; gain 0.11 V/A; nominal 0.1 V/A; offset 5 mV; range 0.4 V; bits 10 }",
    "shunt_code = shunt.code\nshunt = shunt.value",
)
@rows_of
def current_sense(row, k):
    size = 0.8 / 2**10
    code = clamp(math.floor((row["amps"] * 0.11 + 0.005 + 0.4) / size + 0.5), 0, 1023)
    return {"shunt_code": code, "shunt": (code * size - 0.4) / 0.1}


@law(
    "sensor",
    """effect gauge sensor { input wave; gain 1.1; bias 20 mV; density 2 mV/sqrt(Hz); noise noise_7
        walk 0.3 V/sqrt(s); other_noise noise_8 }
    effect quiet sensor { input wave; gain 0.9 }""",
    "gauge = gauge.value\nquiet = quiet.value",
)
def sensor(rows):
    # The walk that a sample has is that of the row before: all memories change together.
    walked, before, shown = 0.0, 0.0, []
    for k, row in enumerate(rows):
        if k:
            before, walked = walked, walked + 0.3 * math.sqrt(STEP) * noise(k, 8)
        white = 2e-3 / math.sqrt(2 * STEP) * noise(k, 7)
        shown.append({"gauge": 1.1 * row["wave"] + 0.02 + before + white, "quiet": 0.9 * row["wave"]})
    return shown


@law("walk", "effect way walk { sigma 0.2 V/sqrt(s); noise noise_9 }", "way = way.value")
def walk(rows):
    return [{"way": 0.2 * math.sqrt(STEP) * sum(noise(i, 9) for i in range(1, k + 1))} for k in range(len(rows))]


@law("stuck", "effect sticks stuck { input wave }\n" + fault("sticks"), "sticks = sticks.value")
def stuck(rows):
    return [{"sticks": rows[min(k, FIRST - 1)]["wave"]} for k in range(len(rows))]


@law("dropped", "effect lost dropped { input wave; rest 50 mV }\n" + fault("lost"), "lost = lost.value")
@rows_of
def dropped(row, k):
    return {"lost": 0.05 if k >= FIRST else row["wave"]}


@law("wiring", "effect bare wiring { input wave; supply 5 V; rest 50 mV }\n" + fault("bare").replace(".active", ".open"),
     "bare = bare.value\nfaulty = bare.faulty")
@rows_of
def wiring(row, k):
    return {"bare": 0.05 if k >= FIRST else row["wave"], "faulty": max(0, k - FIRST + 1)}


@law("offset", "effect shifted offset { input wave; amount 70 mV }\n" + fault("shifted"), "shifted = shifted.value")
@rows_of
def offset(row, k):
    return {"shifted": row["wave"] + (0.07 if k >= FIRST else 0)}


@law("scaled", "effect grown scaled { input wave; factor 1.3 }\n" + fault("grown"), "grown = grown.value")
@rows_of
def scaled(row, k):
    return {"grown": row["wave"] * (1.3 if k >= FIRST else 1)}


@law(
    "noisy",
    "effect hiss noisy { input wave; noise noise_7; density 3 mV/sqrt(Hz) }\n" + fault("hiss"),
    "hiss = hiss.value",
)
@rows_of
def noisy(row, k):
    return {"hiss": row["wave"] + (3e-3 / math.sqrt(2 * STEP) * noise(k, 7) if k >= FIRST else 0)}


@law("delayed", "effect late delayed { input wave }\n" + fault("late"), "late = late.value")
def delayed(rows):
    return [{"late": rows[max(k - 4, 0) if k >= FIRST else k]["wave"]} for k in range(len(rows))]


@law("weak", "effect tired weak { input wave; part 0.3 }\n" + fault("tired"), "tired = tired.value")
@rows_of
def weak(row, k):
    return {"tired": row["wave"] * (0.3 if k >= FIRST else 1)}


@law("dead", "effect off dead { input wave }\n" + fault("off"), "off = off.value")
@rows_of
def dead(row, k):
    return {"off": 0 if k >= FIRST else row["wave"]}


@law(
    "gust",
    "effect breath gust { mean 3 m/s; noise noise_7; sigma 1.5 m/s; length 0.02 m; speed 2 m/s }",
    "breath = breath.value\nbreath_gust = breath.gust",
)
def gust(rows):
    gain, _ = rest_gain(STEP * 2 / 0.02)
    shown, now = [], 0.0
    for k in range(len(rows)):
        if k:
            now = now * math.exp(-STEP * 2 / 0.02) + 1.5 * gain * noise(k, 7)
        shown.append({"breath": 3 + now, "breath_gust": now})
    return shown


@law(
    "gusts",
    "effect storm gusts { wind 8 m/s; heading 1 rad; height 15 m; noise_1 noise_7; noise_2 noise_8; noise_3 noise_9 }",
    "storm_x = storm.wind_x\nstorm_y = storm.wind_y\nstorm_z = storm.wind_z",
)
def gusts(rows):
    feet = 15 / 0.3048
    up = 0.1 * 8
    flat = up / (0.177 + 0.000823 * feet) ** 0.4
    length = 15 / (0.177 + 0.000823 * feet) ** 1.2
    # Along: a lag. Across and up: (1 + sqrt(3) T s) / (1 + T s)^2, in parts sqrt(3) / (1 + T s) + (1 - sqrt(3)) / (1 +
    # T s)^2, of noise that gives a lag the variance 1: over sqrt(2).
    shown, along, side, rise = [], 0.0, [0.0, 0.0], [0.0, 0.0]

    def lags(pair, x, number):
        first, second = rest_gain(x)
        left = math.exp(-x)
        return [left * pair[0] + first * number, left * (pair[1] + x * pair[0]) + second * number]

    def of(pair):
        return (math.sqrt(3) * pair[0] + (1 - math.sqrt(3)) * pair[1]) / math.sqrt(2)

    x, x_up = STEP * 8 / length, STEP * 8 / 15
    for k in range(len(rows)):
        if k:
            along = lags([along, 0], x, noise(k, 7))[0]
            side = lags(side, x, noise(k, 8))
            rise = lags(rise, x_up, noise(k, 9))
        forth, across = 8 + flat * along, flat * of(side)
        c, s = math.cos(1), math.sin(1)
        shown.append({"storm_x": c * forth - s * across, "storm_y": s * forth + c * across, "storm_z": up * of(rise)})
    return shown


@law(
    "battery",
    """effect cells battery { current amps; capacity 0.5 A*s; resistance 50 mOhm; cells 3; start 0.4 }
    effect last battery { current 2 A + amps / 4; capacity 5 A*s; resistance 20 mOhm; start 0.004 }
    effect full battery { current -3 A + amps / 8; capacity 5 A*s; resistance 20 mOhm; start 1 }""",
    """cells = cells.voltage\ncells_charge = cells.charge\ncells_heat = cells.heat\nlast = last.voltage
    last_charge = last.charge\nfull = full.voltage\nfull_charge = full.charge\nfull_heat = full.heat""",
)
def battery(rows):
    # Chen, Rincon-Mora (2006), eq. 2, and below 0.005 in proportion to the charge.
    def cell(charge):
        rest = -1.031 * math.exp(-35 * charge) + 3.685 + 0.2156 * charge - 0.1178 * charge**2 + 0.3201 * charge**3
        return rest * min(charge / 0.005, 1)

    shown, charge, low = [], 0.4, 0.004
    for row in rows:
        i, weak_i, back_i = row["amps"], 2 + row["amps"] / 4, -3 + row["amps"] / 8
        shown.append(
            {
                "cells": 3 * cell(charge) - 0.05 * i,
                "cells_charge": charge,
                "cells_heat": 0.05 * i * i,
                "last": cell(low) - 0.02 * weak_i,
                "last_charge": low,
                "full": cell(1) - 0.02 * back_i,
                "full_charge": 1,
                "full_heat": 0.02 * back_i**2 - cell(1) * back_i,
            }
        )
        charge -= STEP * i / 0.5
        low -= STEP * weak_i / 5
    return shown


@law(
    "thermal",
    "effect copper thermal { heat warm; resistance 2 K/W; capacity 3 mJ/K; ambient 300 K }",
    "copper = copper.temperature\nwarmth = copper.warmth",
)
def thermal(rows):
    states = run(lambda x, row: [(row["warm"] - x[0] / 2) / 3e-3], [0.0], rows)
    # 0.393 %/K from 20 deg C on
    return [{"copper": 300 + x[0], "warmth": 1 + 0.00393 * (300 + x[0] - 293.15)} for x in states]


@law(
    "current_limit",
    """effect fuse current_limit { supply wave; current amps; most 2.5 A; inductance 20 mH; gain 3 Ohm }
    effect steep current_limit { supply wave; current amps; most 3 A; inductance 20 mH }""",
    "fuse = fuse.voltage\nsteep = steep.voltage",
)
@rows_of
def current_limit(row, k):
    i = row["amps"]
    steep = row["wave"] - 20e-3 * STABLE_RATE * (i - clamp(i, -3, 3))
    return {"fuse": row["wave"] - 3 * (i - clamp(i, -2.5, 2.5)), "steep": steep}


@law(
    "pwm_drive",
    """effect bridge pwm_drive { duty wave / 2 V; supply 12 V; current amps; drop 1.2 V; resistance 0.1 Ohm; knee 0.5 A }""",
    "bridge = bridge.voltage\nbridge_drawn = bridge.drawn",
)
@rows_of
def pwm_drive(row, k):
    i, duty = row["amps"], clamp(row["wave"] / 2, -1, 1)
    drop = 1.2 * math.copysign(1 / math.sqrt(1 + (0.5 / i) ** 2), i)
    return {"bridge": 12 * duty - drop - 0.1 * i, "bridge_drawn": duty * i}


@law(
    "chopper",
    """effect steady chopper { duty 0.3 + wave / 10 V; supply 12 V; current 5 A + amps; back 3 V; resistance 2 Ohm
        inductance 20 mH; period 4 ms; drop 0.6 V }
    effect gaps chopper { duty 0.5 + wave / 1000 V; supply 12 V; current 0.35 A + amps / 200; back 3 V; resistance 2 Ohm
        inductance 20 mH; period 4 ms; drop 0.6 V }""",
    "steady = steady.voltage\nsteady_drawn = steady.drawn\ngaps = gaps.voltage\ngaps_drawn = gaps.drawn",
)
@rows_of
def chopper(row, k):
    on, i = clamp(0.3 + row["wave"] / 10, 0, 1), 5 + row["amps"]
    duty, mean = 0.5 + row["wave"] / 1000, 0.35 + row["amps"] / 200
    # The current rises from zero by straight lines: its mean at the edge, and of the transistor in each period.
    peak = (12 - 3) / 20e-3 * duty * 4e-3
    return {
        "steady": on * 12 - (1 - on) * 0.6,
        "steady_drawn": on * i,
        "gaps": 3 + duty * (12 + 0.6) - (3 + 0.6) * mean / (peak / 2),
        "gaps_drawn": duty * peak / 2,
    }

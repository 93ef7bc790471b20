"""What the loop counts under a policy on the simulated port, by other code: a list of times and a few rules."""
import collections
import random
import types

TICKS, PERIOD, BINS, EVENTS = 1000, 1000000, 32, 60
# What a run tells of these, where its scene asks for it.
KEYS = 'ticks late lost overruns margin grace_late grace_overruns skipped degraded'.split()


def script_of(seed):
    """Random events of the simulated port: ticks that come late, last long, or get lost; us by tick."""
    chance = random.Random(seed)
    late, slow, lost = {}, {}, set()
    for _ in range(EVENTS):
        tick, kind = chance.randint(1, TICKS), chance.randrange(3)
        us = chance.randint(1, 9000) if chance.randrange(4) == 0 else chance.randint(1, 1200)
        if kind == 2:
            lost.add(tick)
        else:
            (late, slow)[kind].setdefault(tick, us)
    text = ''.join(f'{word} {tick} {us}us\n' for word, events in (('late', late), ('slow', slow)) for tick, us in events.items())
    return types.SimpleNamespace(late=late, slow=slow, lost=lost, text=text + ''.join(f'lose {tick}\n' for tick in sorted(lost)))


def account(script, policy, most, grace):
    """The values that a summary has of each key, as texts, and the rung of each tick. Of a ladder, which has three rungs,
    `most` good ticks lead up."""
    now = told = absent = first = last = ticks = lost = rung = good = degraded = lowest = 0
    counted, least, bins, rungs = {False: [0, 0], True: [0, 0]}, None, collections.Counter(), []
    stopped = False
    while ticks < TICKS and not stopped:
        k = ticks + 1
        due = (k + absent) * PERIOD
        if told < k + absent:
            wakes = told + 1
            while wakes in script.lost:
                wakes += 1
            now = max(now, wakes * PERIOD + 1000 * script.late.get(wakes, 0))
            told = now // PERIOD
        is_late = now > due + PERIOD // 16
        slow = 1000 * script.slow.get(k, 0)
        now += slow
        left = due + PERIOD - now
        ticks = k
        counted[k <= grace][0] += is_late
        counted[k <= grace][1] += left < 0
        lost += told > k + absent
        least = left if least is None else min(left, least)
        bins[min(slow // (PERIOD // BINS), BINS - 1)] += 1
        if policy == 'catch_up' and told - k - absent > most:
            first = first or k + absent + 1
            absent = told - k - most
            last = k + absent
        if policy == 'degrade':
            rungs.append(rung)
            degraded += rung != 0
            good = 0 if left < 0 and k > grace else good + 1
            if good == 0 and rung < 3:
                rung += 1
            elif rung > 0 and good == most:
                rung, good = rung - 1, 0
            lowest = max(lowest, rung)
        stopped = policy == 'stop' and left < 0 and k > grace
    values = dict(zip(KEYS, ([str(n)] for n in (ticks, counted[False][0], lost, counted[False][1], f'{least} ns', *counted[True]))))
    values['skipped'] = [f'{absent} from {first} to {last}'] if absent else []
    values['degraded'] = [f'{degraded} to rung {lowest}'] if degraded else []
    width = PERIOD // BINS
    values['histogram'] = [f'{f"{i * width} to {(i + 1) * width}" if i + 1 < BINS else f"from {i * width}"} ns: {bins[i]}'
                           for i in sorted(bins)]
    return values, rungs

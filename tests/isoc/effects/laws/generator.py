"""Random effects: a scene of EFFECTS of them, as text for isoc and as formulas for interpreter.py.

Their formulas are plain numbers. What grows is clamped, so that no row is far from one.
"""
import random

EFFECTS = 10
PASTS = ("previous", "delay", "sample")


class Writer:
    """Random formulas of the names of one effect."""

    def __init__(self, r, names):
        self.r, self.names = r, names

    def constant(self):
        return self.r.choice(["0.5", "1.5", "2", "0.3", "1", "0.7", "3"])

    def atom(self):
        r = self.r
        return r.choice(
            self.names * 2
            + [self.constant(), "noise(%d)" % r.randint(1, 9), "time / 1 s * 40", "step(%d ms)" % r.randint(1, 9),
               "square(%d Hz)" % r.choice([100, 125])]
        )

    def past(self, depth, kinds):
        r, kind = self.r, self.r.choice(kinds)
        inner = self.formula(depth - 1, PASTS)
        start = ", %s" % self.constant() if r.random() < 0.3 else ""
        if kind == "previous":
            return "previous(%s%s)" % (inner, start)
        return "%s(%s, %s%d ms%s)" % (kind, inner, "every " if kind == "sample" else "", r.randint(1, 5), start)

    def formula(self, depth, pasts):
        r = self.r
        if depth == 0 or r.random() < 0.1:
            return self.atom()
        f = lambda: self.formula(depth - 1, pasts)
        kind = r.randint(0, 22)
        if kind <= 3:
            return "(%s %s %s)" % (f(), r.choice("+-*"), f())
        if kind == 4:
            return "(%s / (1 + (%s)^2))" % (f(), f())
        if kind == 5:
            return "%s(%s * 1 rad)" % (r.choice(["sin", "cos"]), f())
        if kind == 6:
            return "%s(%s)" % (r.choice(["tanh", "abs", "sign", "floor", "round"]), f())
        if kind == 7:
            return "exp(clamp(%s, -2, 1))" % f()
        if kind == 8:
            return "%s(0.5 + abs(%s))" % (r.choice(["sqrt", "log"]), f())
        if kind == 9:
            return "%s(%s, %s)" % (r.choice(["min", "max"]), f(), f())
        if kind == 10:
            return "clamp(%s, -%s, %s)" % (f(), self.constant(), self.constant())
        if kind == 11:
            return "if(%s %s %s, %s, %s)" % (f(), r.choice(["<", ">", "<=", ">="]), f(), f(), f())
        if kind == 12:
            return "(%s %s %s)" % (f(), r.choice(["<", ">"]), f())
        if kind == 13:
            return "table(%s, -1: 0.5, 0: %s, 1.5: -1)" % (f(), self.constant())
        if kind == 14:
            return "(0.5 + abs(%s))^%s" % (f(), r.choice(["0.7", "-0.3", "-2", "1.5", "-1", "0.5", "c"]))
        if kind == 15:
            return "atan(%s)" % f()
        if kind == 16:
            return r.choice(["hypot(%s, %s)"] * 3 + ["mod(%s, 0.5 + abs(%s))"]) % (f(), f())
        return self.past(depth, pasts) if pasts else f()


def effect(r, number, scene, lines):
    use = "e%d" % number
    formulas = scene["formulas"]
    states = ["x%d" % i for i in range(r.randint(0, 2))]
    memories = ["m%d" % i for i in range(r.randint(1, 2))]
    lines.append("effect kind%d {\n    joint along; signal a; signal b; value c" % number)
    of_joint = ["(position of along / 1 m)", "(speed of along * 1 s / 1 m)"]
    names = states + memories + ["a", "b", "c"]
    full = Writer(r, names + of_joint)
    lines.append("    let p = %s" % (text := full.formula(2, PASTS)))
    formulas[use + ".p"] = (text, use)
    full.names.append("p")
    # A delay within a step follows the stage, so that no delay stands in a rate, nor in what the next effect reads.
    rate = Writer(r, names + of_joint)
    for s in states:
        start = r.choice(["0.5", "c", "a + 1", "position of along / 1 m", "0.25 * b"])
        text = "(clamp(%s, -4, 4) - %s) / %d ms" % (rate.formula(3, ("previous", "sample")), s, r.choice([5, 20, 60]))
        lines.append("    state %s = %s; rate %s = %s" % (s, start, s, text))
        scene["states"].append(use + "." + s)
        formulas[use + "." + s], formulas["rate " + use + "." + s] = (start, use), (text, use)
    for m in memories:
        start = r.choice(["0", "c * b", "floor(a * 3)", "noise(4)", "speed of along * 1 s / 1 m"] + states)
        text = "clamp(%s, -4, 4)" % full.formula(3, PASTS)
        lines.append("    memory %s = %s; next %s = %s" % (m, start, m, text))
        scene["memories"].append(use + "." + m)
        formulas[use + "." + m], formulas["next " + use + "." + m] = (start, use), (text, use)
    effort = "clamp(%s, -3, 3)" % rate.formula(2, ("previous", "sample"))
    lines.append("    effort on along = 1 N * (%s)" % effort)
    formulas[use + ".effort"] = (effort, use)
    for i in range(3):
        text = full.formula(3, PASTS) if i else rate.formula(3, ("previous", "sample"))
        lines.append("    output o%d = %s" % (i, text))
        formulas["%s.o%d" % (use, i)] = (text, use)
    for i, name in enumerate(memories + states):
        lines.append("    output q%d = %s" % (i, name))
        formulas["%s.q%d" % (use, i)] = (name, use)
    shown = ["o0", "o1", "o2"] + ["q%d" % i for i in range(len(memories + states))]
    lines.append("}")
    lines.append("body body%d { mass 2 kg }" % number)
    place, speed = r.choice([0, 0.5, -1]), r.choice([0, 1, -2])
    lines.append("joint joint%d prismatic { parent ground; child body%d; axis x; start %g m; speed %g m/s }"
                 % (number, number, place, speed))
    a = r.choice(["drive", "wave", "drive * wave"] + (["e%d.o0" % (number - 1)] if number else []))
    b = r.choice(["wave", "1.5", "gain", "previous(drive)"])
    lines.append("effect %s kind%d { along joint%d; a %s; b %s; c %s }" % (use, number, number, a, b, c := r.choice(["gain", "0.75"])))
    formulas[use + ".a"], formulas[use + ".b"], formulas[use + ".c"] = (a, ""), (b, ""), (c, "")
    scene["states"] += ["position of joint%d" % number, "speed of joint%d" % number]
    scene["aliases"][use] = "joint%d" % number
    formulas["position of joint%d" % number] = ("%g" % place if place >= 0 else "-%g" % -place, "")
    formulas["speed of joint%d" % number] = ("%g" % speed if speed >= 0 else "-%g" % -speed, "")
    formulas["rate position of joint%d" % number] = ("speed of joint%d" % number, "")
    formulas["rate speed of joint%d" % number] = ("%s.effort / 2" % use, "")
    for o in shown:
        lines.append("output %s_%s = %s.%s" % (use, o, use, o))
        scene["outputs"].append("%s.%s" % (use, o))


def scene_of(seed):
    """The text and the formulas of one scene."""
    r = random.Random(seed)
    method = ("euler", "heun", "rk4")[seed % 3]
    scene = {"step": 1e-3, "method": method, "formulas": {}, "states": [], "memories": [], "outputs": [], "aliases": {},
             "sets": {"gain": (7, 0.5)}}
    drive = "table(time, 0 s: 1, 0.003 s: -1, 0.02 s: 2)"
    wave = "noise(%d) + square(125 Hz)" % r.randint(1, 99)
    lines = ["step 1 ms; method %s" % method, "tunable gain = 1.25", "at 7 ms set gain = 0.5",
             "signal drive = %s" % drive, "signal wave = %s" % wave]
    scene["formulas"].update({"drive": (drive, ""), "wave": (wave, ""), "gain": ("1.25", "")})
    for i in range(EFFECTS):
        effect(r, i, scene, lines)
    for name, (text, use) in scene["formulas"].items():
        if use:
            scene["formulas"][name] = (text.replace("of along", "of " + scene["aliases"][use]), use)
    return "\n".join(lines) + "\n", scene

"""<keyframe> of MJCF: the starts of a run that --key selects; and the joints that start outside of their ranges."""
from equality import close_starts, hold_at_start
from place import Place, norm, of_quaternion

POSITIONS = {"hinge": 1, "slide": 1, "ball": 4, "free": 7}
SPEEDS = {"hinge": 1, "slide": 1, "ball": 3, "free": 6}
NEAR = 1e-5  # rad and m: a start farther outside of its range is reported


def read(reader):
    """Takes the positions of the selected keyframe: before closures, whose gears keep their offsets."""
    wanted, names = reader.options.key, reader.keys
    for group in reader.root.all("keyframe"):
        for key in group.take().all("key"):
            name = key.take().get("name")
            names.extend([name] if name else [])
            if name is None:
                key.leave("a start of a run without a name, by which --key finds it")
            elif name != wanted:
                key.leave(f"a start of a run: --key {name} takes it")
            else:
                positions(reader, key)
    if wanted is not None and wanted not in names:
        there = f"there are {', '.join(names)}" if names else "the file has none with a name"
        reader.root.problem(f"there is no key '{wanted}': {there}")


def positions(reader, key):
    key.leave("inputs and activations start at zero", "time", "act", "ctrl", "mpos", "mquat")
    values = all_of(key, "qpos", [POSITIONS[kind] for _, kind, _ in reader.coordinates])
    for (made, kind, label), own in zip(reader.coordinates, values):
        turn = own[-4:]
        if kind in ("hinge", "slide"):
            made.start = own[0] - reader.joints[label][1]
            continue
        if norm(turn) == 0:
            key.problem(f"the quaternion of {label} has no length", "qpos")
            return
        made.key_place = Place(own[:-4] if kind == "free" else (0.0, 0.0, 0.0), of_quaternion(turn))
    reader.key = key


def all_of(key, name, counts):
    """The numbers of an attribute, by joints; none where the keyframe does not have it."""
    if key.get(name) is None:
        return []
    before = len(key.document.problems)
    numbers = key.numbers(name, sum(counts))
    if len(key.document.problems) > before:
        return []
    ends = [sum(counts[: k + 1]) for k in range(len(counts))]
    return [numbers[end - count : end] for end, count in zip(ends, counts)]


def finish(reader):
    """Speeds, and guesses of starts that closures decide; then the joints that start outside of their ranges."""
    if reader.key is not None:
        text = f"it starts as the keyframe {reader.options.key} says"
        if reader.held:
            text += ", but as near to that as closures hold, which are hard"
            if not close_starts(reader):
                reader.key.problem("no start near that of this keyframe is found where all closures hold", "qpos")
        reader.model.notes.append(text)
        if reader.model.closures:
            reader.key.leave("the closures decide about speeds", "qvel")
        else:
            values = all_of(reader.key, "qvel", [SPEEDS[kind] for _, kind, _ in reader.coordinates])
            for (made, _, _), own in zip(reader.coordinates, values):
                made.speeds = own if made.kind != "fixed" else []
    elif not hold_at_start(reader):
        if not close_starts(reader):
            reader.root.problem("no start near that of the file is found where all closures hold")
        reader.model.notes.append("closures do not hold where the file draws it: it starts as near to that as they hold")
    outside = [
        f"{label} at {made.start + ref:.6g} {made.unit()} ({lower + ref:.6g} to {upper + ref:.6g})"
        for made, label, ref, lower, upper in reader.ranges
        if made.kind != "fixed" and not lower - NEAR <= made.start <= upper + NEAR
    ]
    if outside:
        others = [name for name in reader.keys if name != reader.options.key]
        more = f"; other starts: {', '.join(f'--key {name}' for name in others)}" if others else ""
        reader.model.notes.append(
            f"outside of the range, from where a stop pushes back, starts {', '.join(outside)}{more}"
        )

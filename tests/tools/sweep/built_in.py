# Which tunables isoc builds into a plant: with other defaults of all that it does not, the text of the plant is the
# same but for the tables that the start reads; and each that it does changes more. For all scenes that have tunables.
#
#     built_in.py ISOC FOLDER SCENE...
#
# Prints how many were free, built in, and built in without a change; ends with 1 where a free one changed the plant.
import re
import subprocess
import sys

isoc, folder, scenes = sys.argv[1], sys.argv[2], sys.argv[3:]


def plant(scene, setting):
    """The text of the plant without the defaults, and without the starts, which `begin` sets where they follow from tunables."""
    command = [isoc, scene, "-o", folder + "/plant"] + (["--set", setting] if setting else [])
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        return None
    with open(folder + "/plant/plant.c") as file:
        return re.sub(r"static const real (defaults|start)\[\w+\] = \{.*?\};", "", file.read(), flags=re.S)


def plan(scene, names):
    """Of each tunable its place, -1 where it is built in."""
    varied = "; ".join(f"{name} = {value}" for name, value in names.items())
    command = [isoc, scene, "-o", folder, "--sweep", varied, "--of", "hash"]
    if subprocess.run(command, capture_output=True).returncode:
        return None
    with open(folder + "/plan") as file:
        lines = file.read().split("\n")
    return {line.split("\t")[0]: int(line.split("\t")[3]) for line in lines[5 : 5 + len(names)]}


free = built = idle = 0
for scene in scenes:
    with open(scene) as file:
        found = re.findall(r"^tunable (\w+) = ([\d.]+)([ \w*/^]*?)(?: in .*)?$", file.read(), re.M)
    names = {name: f"{float(value) * 1.03:.4g}{unit}" for name, value, unit in found}
    places, before = (plan(scene, names), plant(scene, "")) if names else (None, None)
    if places is None or before is None:
        continue
    loose = [name for name in names if places[name] >= 0]
    moved = plant(scene, "; ".join(f"{name} = {names[name]}" for name in loose))
    if moved is None:
        continue
    if moved != before:
        sys.exit(f"{scene}: one of {loose} is built in")
    free += len(loose)
    for name in (name for name in names if places[name] < 0):
        after = plant(scene, f"{name} = {names[name]}")
        built += after != before
        idle += after == before
print(free, built, idle)

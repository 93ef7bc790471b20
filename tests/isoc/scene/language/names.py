"""Words of the language as names: names.py ISOC FOLDER RESERVED [WORDS], with a scene on stdin in which NAME stands for the name. Each word
gives the plant that another name gives, but for names and comments; one of those that are reserved is refused. Without
WORDS they are all that may be meant. Prints the words of which that is not so."""
import os
import re
import sys

from isoc import Isoc

WORDS = """x y z ground pi time at about rotate quaternion rest along of in to and set like safe after ticks every jump held
    smooth on against from column body joint frame effect signal value state rate memory next output input energy power
    speed position inertia step method start axis length mass spring force file table sin""".split()


def compiled(isoc, folder, scene, word):
    """Whether the scene with that name is accepted; what isoc says; and what is neither name nor number nor comment in the plant."""
    path = os.path.join(folder, "names.scene")
    with open(path, "w") as file:
        file.write(scene.replace("NAME", word))
    status, told = isoc(path, "-o", os.path.join(folder, "named"))
    if status != 0:
        return False, told, ""
    with open(os.path.join(folder, "named", "plant.c")) as file:
        text = re.sub(r"^(.*?)/\*.*\*/", r"\1", file.read(), flags=re.M)
    return True, told, re.sub(r"[^(){};=*+/-]", "", text)


def main():
    folder, reserved, scene = sys.argv[2], sys.argv[3].split(), sys.stdin.read()
    isoc = Isoc(sys.argv[1], folder)
    accepted, told, neutral = compiled(isoc, folder, scene, "neutral")
    bad = [] if accepted and neutral else ["neutral: " + told]
    for word in sys.argv[4].split() if len(sys.argv) > 4 else WORDS:
        accepted, told, plant = compiled(isoc, folder, scene, word)
        if word in reserved:
            good = not accepted and f"'{word}' is a word of the language" in told
        else:
            good = accepted and plant == neutral
        if not good:
            bad.append(word + ": " + told)
    print(*bad, sep="\n", end="\n" if bad else "")


main()

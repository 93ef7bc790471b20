"""A robot of URDF or MJCF as a scene: import ROBOT.urdf -o ROBOT.scene."""
import argparse
import os
import shutil
import sys

import mjcf
import scene
import urdf
from markup import Document, Stop
from model import Model


def head_of(document, model):
    """The first comment of the scene: its source, its notes, and the parts of the file that were not taken."""
    kind = "MJCF" if document.root.tag == "mujoco" else "URDF"
    own = os.path.basename(document.path)
    moving = sum(joint.kind != "fixed" for joint in model.joints.values())
    lines = [f"{own}, a robot in {kind}: {len(model.bodies)} bodies, {moving} joints, {len(model.inputs)} inputs."]
    lines += [f"- {note}" for note in model.notes]
    if model.renamed:
        lines.append(f"- names: {', '.join(model.renamed)}")
    left = document.not_taken()
    return [*lines, *named(left)] if left else [*lines, "All of the file is taken."]


def named(left):
    """The list of the parts of the file that were not taken."""
    lines = ["Not taken:"]
    for what, why, at in left:
        count = f"{len(at)} times " if len(at) > 1 else ""
        first = f"line {at[0]}" if isinstance(at[0], int) else os.path.basename(str(at[0]).rsplit(":", 1)[0])
        lines.append(f"- {count}{what}, {'first ' if len(at) > 1 else ''}{first}: {why}")
    return lines


def imported(path, options):
    """The text of the scene, and the lines of its head; or None, and the problems."""
    problems = []
    model = Model(options.repair_inertia)
    document = None
    try:
        document = Document(path, problems)
        if document.root.tag == "robot" and options.key is not None:
            document.root.problem(f"there is no key '{options.key}': URDF has no keyframes")
        elif document.root.tag == "robot":
            urdf.Reader(document, model, options).read()
        elif document.root.tag == "mujoco":
            mjcf.Reader(document, model, options).read()
        else:
            document.root.problem(
                f"<{document.root.tag}> is neither <robot> of URDF nor <mujoco> of MJCF; a file of xacro is "
                "to be expanded first"
            )
    except Stop:
        pass
    if not problems and not any(joint.kind != "fixed" for joint in model.joints.values()):
        document.root.problem(f"nothing moves in this file: {why_still(document, model)}")
    if problems:
        left = document.not_taken(has_ended=False) if document is not None else []
        return None, [*(named(left) if left else []), *dict.fromkeys(problems)]  # each once, if it is found again
    urdf.outputs(model)
    head = head_of(document, model)
    return scene.scene_text(model, head), head


def why_still(document, model):
    """Why no joint moves, and what to write."""
    is_urdf = document.root.tag == "robot"
    if any(model.has_mesh_behind(joint) for joint in model.joints.values()):
        return "the masses are those of meshes that are not taken; write an <inertial> into each <body>"
    if is_urdf and model.joints and not any(link.all("inertial") for link in document.root.all("link")):
        return (
            "no link has an <inertial>, so that nothing has a mass. Write one into each link that moves: "
            '<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
        )
    if model.joints:
        return "behind its joints nothing has a mass"
    return f"a scene has a joint{'; --floating lets the root link move' if is_urdf else ''}"


def parser():
    parse = argparse.ArgumentParser(prog="import", description="A robot of URDF or MJCF as a scene.")
    parse.add_argument("file", help="a .urdf, or a .xml of MuJoCo")
    parse.add_argument("-o", dest="out", help="the scene; default: standard output")
    parse.add_argument("--floating", action="store_true", help="of URDF: the root link moves freely")
    parse.add_argument(
        "--drives",
        choices=("file", "none"),
        default="file",
        help="of URDF: those of the file, or of all joints where it has none; or none",
    )
    parse.add_argument(
        "--exact", action="store_true", help="no angle is taken as a quarter turn that is not exactly one"
    )
    parse.add_argument(
        "--repair-inertia",
        action="store_true",
        help="an inertia that no body has becomes the nearest possible one; default: as written, or refused",
    )
    parse.add_argument("--key", metavar="NAME", help="of MJCF: it starts as this keyframe says; default: as drawn")
    return parse


def main():
    options = parser().parse_args()
    text, said = imported(options.file, options)
    if text is None:
        print("\n".join(said), file=sys.stderr)
        return 1
    try:
        if options.out is not None:
            write_file(options.out, text)
        else:
            print("".join(f"{line}\n" for line in said if line.startswith("- warning")), end="", file=sys.stderr)
    except OSError as error:
        print(f"import: error: {options.out} cannot be written: {error.strerror}", file=sys.stderr)
        return 1
    return show(text if options.out is None else "\n".join([*said, ""]), "scene" if options.out is None else "report")


def write_file(path, text):
    """Writes all of a file, or leaves what was there: by another one that takes its name when it is whole."""
    if os.path.exists(path) and not os.path.isfile(path):  # a device, a pipe
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return
    path = os.path.realpath(path)
    part = f"{path}.{os.getpid()}"
    try:
        with open(part, "x", encoding="utf-8") as file:
            file.write(text)
        if os.path.exists(path):
            shutil.copymode(path, part)
        os.replace(part, path)
    except OSError:
        if os.path.exists(part):
            os.remove(part)
        raise


def show(text, what):
    """Prints a text; returns the exit status."""
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        # What is left in the buffer goes nowhere, or the end of the program would try again.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        print(f"import: error: the {what} cannot be printed whole: {error.strerror}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

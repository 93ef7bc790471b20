"""Functions shared by the readers of URDF and MJCF."""
import effects
from model import moves_nothing
from place import quarter_of


class Reader:
    """Reads a document into a model."""

    def __init__(self, document, model, options):
        self.document = document
        self.model = model
        self.options = options
        self.root = document.root
        self.rounded = 0  # angles that were taken as quarter turns

    def angle(self, text):
        """An angle in rad."""
        if self.options.exact:
            return float(text)
        value, rounded = quarter_of(text)
        self.rounded += rounded
        return value

    def note_rounded(self):
        if self.rounded:
            self.model.notes.append(
                f"{self.rounded} angles are quarter turns as far as they are written (1.5708), and are "
                "taken as such; --exact keeps them"
            )

    def hold_idle(self, joint, why=""):
        """A joint that moves no inertia has no acceleration: it is held."""
        if moves_nothing(self.model, joint):
            effects.hold(self.model, joint)
            more = f": {why}" if why else ""
            self.model.notes.append(f"the joint {joint.of} moves no inertia, and is held where it starts{more}")

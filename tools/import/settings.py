"""<compiler> and <option> of MJCF."""
from model import Solid
from inertia import excess, principal, rotated
from place import Place, add, dot, minus, product, scale

OF_FILES = """texturedir discardvisual convexhull usethread fitaabb fusestatic alignfree saveinertial""".split()
OF_THE_SOLVER = """solver iterations tolerance ls_iterations ls_tolerance noslip_iterations noslip_tolerance
mpr_iterations mpr_tolerance ccd_iterations cone jacobian impratio apirate magnetic o_margin o_solref o_solimp
o_friction actuatorgroupdisable""".split()
CONSTRAINTS = {"equality", "frictionloss", "limit"}
SWITCHED_OFF = "<flag> switches it off"
PASSIVE = {"spring", "damper"}
SWITCHES = ("gravity", "passive", *sorted(PASSIVE), "actuation", "clampctrl", "constraint", *sorted(CONSTRAINTS))


class Settings:
    def __init__(self):
        self.degrees = True
        self.eulerseq = "xyz"
        self.autolimits = True
        self.inertiafromgeom = "auto"
        self.groups = (0, 5)
        self.boundmass = self.boundinertia = 0.0
        self.balance = False
        self.total = -1.0
        self.mesh_folder = ""
        self.strips_paths = self.exact_meshes = False
        self.off = set()  # of SWITCHES

    def compiler(self, element):
        word = element.get("angle", "degree" if self.degrees else "radian")
        if word not in ("degree", "radian"):
            element.problem(f"the angle is '{word}': degree or radian", "angle")
        self.degrees = word == "degree"
        self.eulerseq = element.get("eulerseq", self.eulerseq)
        if len(self.eulerseq) != 3 or set(self.eulerseq.lower()) - set("xyz"):
            element.problem(f"the eulerseq is '{self.eulerseq}': three letters of x, y, z, X, Y, Z", "eulerseq")
            self.eulerseq = "xyz"
        self.autolimits = element.get("autolimits", "true" if self.autolimits else "false") == "true"
        self.inertiafromgeom = element.get("inertiafromgeom", self.inertiafromgeom)
        if self.inertiafromgeom not in ("true", "false", "auto"):
            element.problem(f"inertiafromgeom is '{self.inertiafromgeom}': true, false or auto", "inertiafromgeom")
        self.groups = element.numbers("inertiagrouprange", 2, self.groups)
        self.boundmass = element.number("boundmass", self.boundmass)
        self.boundinertia = element.number("boundinertia", self.boundinertia)
        self.balance = element.get("balanceinertia", "true" if self.balance else "false") == "true"
        self.total = element.number("settotalmass", self.total)
        self.mesh_folder = element.get("meshdir", element.get("assetdir", self.mesh_folder))
        self.strips_paths = element.get("strippath", "true" if self.strips_paths else "false") == "true"
        self.exact_meshes = element.get("exactmeshinertia", "true" if self.exact_meshes else "false") == "true"
        if element.get("coordinate", "local") != "local":
            element.problem("global coordinates: save the model with MuJoCo 2, which writes local ones", "coordinate")
        element.leave("of pictures and files", *OF_FILES)
        element.leave_all("of muscles")

    def option(self, element, model):
        model.gravity = tuple(element.numbers("gravity", 3, model.gravity))
        model.step = element.number("timestep", model.step)
        if not 1e-6 <= model.step <= 1:
            element.problem("the timestep is from 1e-6 to 1 s", "timestep")
        self.integrator(element, model)
        for name in ("density", "viscosity", "wind"):
            values = element.numbers(name, (1, 3), [0.0])
            if any(values):
                element.leave("no fluid", name)
        element.leave("of the solver of MuJoCo", *OF_THE_SOLVER)
        for flag in element.all("flag"):
            self.flag(flag.take())

    def flag(self, element):
        """What the file switches off: gravity, springs and dampers, actuators, or constraints."""
        for name in SWITCHES:
            word = element.get(name, "disable" if name in self.off else "enable")
            if word not in ("enable", "disable"):
                element.problem(f"{name} is '{word}': enable or disable", name)
            self.off = self.off | {name} if word == "disable" else self.off - {name}
        for name in element.attributes:
            if name not in SWITCHES:
                element.leave("of the solver of MuJoCo", name)

    def switch_off(self, model):
        """Once all flags are read."""
        if self.off:
            model.notes.append(f"<flag> switches off: {', '.join(sorted(self.off))}")
        if "gravity" in self.off:
            model.gravity = (0.0, 0.0, 0.0)
        if "constraint" in self.off:
            self.off |= CONSTRAINTS
        if "passive" in self.off or PASSIVE <= self.off:
            self.off |= {"passive", *PASSIVE}

    @staticmethod
    def integrator(element, model):
        """The methods of MuJoCo that are implicit become one that is stable for stiff servos at any step."""
        word = element.get("integrator")
        if word in ("implicit", "implicitfast"):
            model.method = "rosenbrock"
            model.notes.append(f"the integrator {word} is method rosenbrock, which is implicit too")
        elif word == "Euler":
            element.leave("method rk4 takes its place", "integrator")
        elif word not in (None, "RK4"):
            element.problem(f"the integrator is '{word}': Euler, RK4, implicit or implicitfast", "integrator")

    def takes_inertial(self, is_given):
        """Whether a body has the inertia of its <inertial>, and not that of its geoms."""
        return self.inertiafromgeom == "false" or (self.inertiafromgeom == "auto" and is_given)

    def bounded(self, solids, name, model, refuse):
        """The parts of a body within the bounds of mass and inertia; one beyond the triangle inequality is balanced where
        the file asks for that."""
        if self.boundmass > 0 or self.boundinertia > 0:
            whole = joined(solids)
            moments, axes = principal(whole.inertia)
            moments = [max(x, self.boundinertia) for x in moments]
            place = Place(whole.place.at, product(whole.place.turn, axes))
            solids = [Solid(max(whole.mass, self.boundmass), place, (*moments, 0.0, 0.0, 0.0), of=name)]
        for solid in solids:
            if self.balance and excess(solid.inertia) > 0:
                mean = max(sum(solid.inertia[:3]) / 3, 0.0)
                solid.inertia = (mean, mean, mean, 0.0, 0.0, 0.0)
                model.unique_note(f"the inertia of {name} is the same in all directions: balanceinertia")
            else:
                model.admit(solid, name, refuse)
        return solids

    def scale_total(self, model):
        if self.total <= 0:
            return
        mass = sum(body.mass() for body in model.bodies.values())
        for body in model.bodies.values():
            for solid in body.solids:
                solid.mass *= self.total / mass
                solid.inertia = tuple(x * self.total / mass for x in solid.inertia)
        model.notes.append(f"all masses are those of the file times {self.total / mass:.6g}: settotalmass")


def joined(solids):
    """Parts as one, about their common centre of mass."""
    mass = sum(solid.mass for solid in solids)
    if mass == 0:
        return Solid(0.0, Place(), (0.0,) * 6)
    centre = (0.0, 0.0, 0.0)
    for solid in solids:
        centre = add(centre, scale(solid.mass / mass, solid.place.at))
    total = [[0.0] * 3 for _ in range(3)]
    for solid in solids:
        own, r = rotated(solid.place.turn, solid.inertia), minus(solid.place.at, centre)
        for i in range(3):
            for j in range(3):
                total[i][j] += own[i][j] + solid.mass * ((i == j) * dot(r, r) - r[i] * r[j])
    values = (total[0][0], total[1][1], total[2][2], total[0][1], total[0][2], total[1][2])
    return Solid(mass, Place(centre), values)

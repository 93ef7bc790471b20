"""A generated plant in which every second tick has a discontinuity, for what counts restarts."""
import re
import shutil

from lab import build

# The cause is between the ticks, in a function of its own that is not counted. Where steps are checked, one is
# `detected`: the usual error is so small that every error is larger; in the ticks between, so large that none is.
CAUSES = {
    'announced': '    memory->p[PLANT_P_FORCED] += (real)(tick % 2);',  # a tunable `forced` changes
    'changed': '    memory->p[0] += (real)(tick % 2);',  # the first tunable
    'input': '    memory->u[0] += (real)(tick % 2);',  # the first input
    'detected': '    memory->progress.usual = tick % 2 == 0 ? ISO_REAL_MAX : R(-1.0);\n'
                '    memory->progress.watched = ISO_USUAL_STEPS;',
}
# It stands in the place of the plant's own `drive`, which it calls.
FUNCTIONS = '''\
__attribute__((noinline)) static void forced_cause(plant_memory *const memory, const uint64_t tick)
{{
{cause}
}}

static void forced(void *const instance, const uint64_t tick)
{{
    plant_memory *const memory = instance;{drive}
    forced_cause(memory, tick);
}}

'''


def forced(plant, cause):
    """The text of plant.c with one of the causes. A tick is 10 ms, within which every step ends; the step is as long as
    it was."""
    drive = '\n    drive(instance, tick);' if re.search(r'^static void drive\(', plant, re.M) else ''
    plant = re.sub(r'^    \.drive = .*\n', '', plant, flags=re.M)
    for place, text in (
            (r'^(?=const iso_model plant_model)', FUNCTIONS.format(cause=CAUSES[cause], drive=drive)),
            (r'^    \.period_ns = .*$', '    .period_ns = UINT32_C(10000000),'),
            (r'^(    \.step = step,.*)$', r'\1\n    .drive = forced,')):
        plant, places = re.subn(place, text, plant, flags=re.M)
        if places != 1:
            raise build.Wrong('this is no plant made by isoc')
    return plant


def with_text(plant, name, text):
    """The plant of a scene with another text of its plant.c, as a plant in C of this name."""
    folder = plant.folder / 'changed'
    folder.mkdir(exist_ok=True)
    shutil.copy(plant.folder / 'plant.h', folder)
    (folder / f'{name}.c').write_text(text)
    return build.plant(folder / f'{name}.c', folder=folder / name, quiet=True, target=plant.target, real=plant.real)

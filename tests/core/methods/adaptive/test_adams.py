"""Whole runs of the adams method."""


def test_runs(program, proves):
    sources = [f'tests/core/methods/adaptive/{name}.c' for name in ('adams', 'problems')]
    proves(program(*sources, 'tests/host/report.c', 'core/numbers/self_check.c', real='double', by='gcc', level='-O2'))

"""The nodes of isoc's graph are made in an order that C defines, so that each compiler's isoc writes the same bytes: of
the arguments of a call, and of an initialiser, at most one makes nodes (tools/isoc/graph/graph.h)."""
import pytest

import arguments
from harness.project import ROOT


def test_of_the_arguments_of_a_call_in_isoc_at_most_one_makes_nodes():
    found, makers = arguments.found(ROOT / 'tools/isoc')
    assert makers > 100 and not found


@pytest.mark.parametrize('line, count', [
    ('return add(g, mul(g, a, b), mul(g, b, b)); /* add( */', 1),
    ('const node both[] = {mul(g, a, b), mul(g, b, b)};', 1),
    ('return add(g, helped(g, a), divide(g, a, larger(g, b, a))); } node helped(graph *g, node a) { return neg(g, a);', 1),
    # Constants beside another argument are none.
    ('return add(g, constant(g, 1.0), mul(g, constant(g, 2.0), b));', 0)])
def test_found_a_call_with_two_that_do(tmp_path, line, count):
    (tmp_path / 'graph.c').write_text((ROOT / 'tools/isoc/graph/graph.c').read_text())
    (tmp_path / 'planted.c').write_text(f'node planted(graph *g, node a, node b)\n{{\n    {line}\n}}\n')
    found, _ = arguments.found(tmp_path)
    assert [text.split(': ')[:2] for text in found] == [[f'{tmp_path}/planted.c:3', 'planted']] * count

"""A closure is stated by `closure` or by `close`."""
import pathlib

import pytest

MODELS = [path for path in sorted(pathlib.Path('models').glob('*.scene')) if '\nclose ' in path.read_text()]


@pytest.mark.parametrize('model', MODELS, ids=lambda path: path.stem)
def test_both_words_make_the_same_plant(isoc, model):
    said = [isoc(model.read_text().replace('\nclose ', f'\n{word} ')) for word in ('close', 'closure')]
    assert said[0].status == said[1].status == 0 and said[0].printed == said[1].printed
    assert said[0].file('plant.c').replace('/* close ', '/* closure ') == said[1].file('plant.c')


def test_another_word_is_refused_with_both(isoc):
    made = isoc(MODELS[0].read_text().replace('\nclose ', '\nclosing ', 1))
    assert made.status == 1 and "closure, close, spring" in made.errors and "found 'closing'" in made.errors

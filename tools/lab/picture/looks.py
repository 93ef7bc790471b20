"""How methods look in all pictures. Colours and marks that are chosen; variants of a method share a colour. The others
have one of the palette: for every colour each of the marks."""
from lab.build import Wrong

CHOSEN = {'euler': ('#8c8c8c', 7), 'semi_implicit': ('#8c8c8c', 6), 'heun': ('#b8860b', 7), 'rk4': ('#0067a5', 7),
          'ab4': ('#d1590a', 7), 'abm4': ('#3c8d2f', 7), 'abm4_pec': ('#3c8d2f', 6), 'abm4_pecece': ('#3c8d2f', 9),
          'bdf4': ('#8e3a8e', 7), 'rosenbrock': ('#c2185b', 5), 'adams': ('#008b8b', 5)}
# Of lines without marks variants have colours of their own.
VARIANTS = {'semi_implicit': '#4d4d4d', 'abm4_pec': '#7cb342', 'abm4_pecece': '#1b5e20'}
DASHES = {'abm4_pecece': 4, 'semi_implicit': 2, 'abm4_pec': 2, 'adams': 2}
PALETTE = '#000000', '#8b4513', '#1a237e', '#7cb342', '#e57373', '#5c9bd5', '#9575cd', '#a1887f'
MARKS = 7, 5, 9, 13, 11, 15


def mark(method, place):
    """Its colour and its mark, by its place in the list of methods."""
    if place >= len(PALETTE) * len(MARKS):
        raise Wrong('plot: two methods would look alike')
    return CHOSEN.get(method) or (PALETTE[place % len(PALETTE)], MARKS[place // len(PALETTE) % len(MARKS)])


def colour(method, place):
    return VARIANTS.get(method) or CHOSEN.get(method, PALETTE[place % len(PALETTE):])[0]


def dashes(method):
    return DASHES.get(method, 1)


def pale(colour_of_mark):
    """A colour #rrggbb, by this part of the way nearer to white."""
    part = 0.65
    values = (int(colour_of_mark[i:i + 2], 16) for i in (1, 3, 5))
    return '#' + ''.join(f'{int(value + part * (255 - value)):02x}' for value in values)

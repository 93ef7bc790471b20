"""`isochron chains`: the costs of chains of rods by their length. First operations of an evaluation of their equations
of motion and the formulation that is kept; on the Cortex-M4F in float the instructions of a step of euler, which has
one evaluation, and its code. Then, of every eighth length, operations of the factors of an implicit method and how they
are found, and their bytes; instructions of a step of bdf4, and all code and tables of the plant."""
from lab import chain, table
from lab.build import Wrong
from lab.counts import Counts

LENGTHS = list(range(1, 17))


def explicit(kind, length):
    of = Counts(f'chains/{kind}_{length}', chain.scene(length, kind), 'euler', name='chain')
    kept = next(words[0] for words in of.lines('formulation') if words[1] == 'kept')
    return [kept, *of.operations, of.step, of.sizes.step_text]


def implicit(length):
    of = Counts(f'chains/implicit_{length}', chain.scene(length, 'planar'), 'bdf4', step='10ms', name='chain')
    (_, add, _, mul, _, div, *_), = of.lines('factor')
    (count, found, *_), = of.lines('factors')
    return [f'planar, {length}', found, add, mul, div, 4 * int(count), of.step, of.plant_text]


def growth(kind, rows, length):
    """From half the greatest length to that."""
    if length % 2 == 0 and length // 2 in rows:
        (half, half_step), (whole, step) = ((sum(map(int, rows[n][1:5])), rows[n][5]) for n in (length // 2, length))
        print(f'- {kind}, {length // 2} to {length} joints: {whole / half:.2f} times the operations, '
              f'{step / half_step:.2f} times the instructions, {(step - half_step) / (length // 2):.0f} for a joint.')


def run(options):
    lengths = options.lengths.split() if options.lengths else LENGTHS
    if not lengths or not all(str(length).isdigit() and int(length) > 0 for length in lengths):
        raise Wrong(f"--lengths '{options.lengths}' are no numbers of joints; it could be '8 16'")
    lengths = list(map(int, lengths))
    measured = {'planar': {}, 'spatial': {}}

    def rows():
        for kind, of_length in measured.items():
            for length in lengths:
                of_length[length] = explicit(kind, length)
                yield [f'{kind}, {length}', *of_length[length]]
    table.show(['chain', 'formulation', 'add', 'mul', 'div', 'sincos', 'instructions', 'text'], rows(), 'llrrrrrr')
    print()
    for kind, of_length in measured.items():
        growth(kind, of_length, lengths[-1])
    print()
    table.show(['chain, bdf4', 'factors', 'add', 'mul', 'div', 'bytes', 'instructions', 'text'],
               (implicit(length) for length in lengths if length % 8 == 0), 'llrrrrrr')

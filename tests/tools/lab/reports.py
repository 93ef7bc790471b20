"""What a report's picture must show, of the rows of its table."""
TITLES = {'float': 'float', 'compensated': 'float, compensated sums', 'cycles_float': 'float',
          'cycles_compensated': 'float, compensated sums', 'double': 'double'}


def points_of(rows):
    """Every error over cost and over the step, and of each kind the Pareto front: the points with a smaller error than
    any that are as cheap."""
    rows = [row for row in rows if 0 < float(row[4]) <= 100]
    fronts = {}
    for row in sorted(rows, key=lambda row: (float(row[7]), float(row[4]))):
        kind = TITLES[row[0]]
        over = f"{kind}|{'cycles' if row[0].startswith('cycles') else 'instructions'} per second, "
        over += 'host' if row[0] == 'double' else 'Cortex-M4F'
        yield over, row[1], row[7], row[4]
        yield f'{kind}|step, ms', row[1], 1000 * float(row[2]), row[4]
        front = fronts.setdefault(kind, [])
        if not front or float(row[4]) < front[-1]:
            front.append(float(row[4]))
            yield over, 'Pareto front', row[7], row[4]

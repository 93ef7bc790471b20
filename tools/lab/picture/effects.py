"""The cost and the influence of each effect of a scene, as bars."""
from lab.draw import Picture, quoted

ROW, ABOVE, BELOW = 44, 84, 28 # in pixels
COLOURS = '#0067a5', '#d1590a'


def effects(scene, target, head, rows):
    """The table of costs of the effects (lab.cost): its columns and rows. Rows of kind `whole` and `base` are the scene
    with all effects and without any; the effects stand above a row without a name."""
    step = {row[1]: float(row[head.index('step')]) for row in rows if row[1] in ('whole', 'base')}
    names = [row[0] for row in rows]
    rows = rows[:names.index('')] if '' in names else rows
    if not rows:
        return None
    p = Picture(900, ROW * len(rows) + ABOVE + BELOW)
    on = target if target == 'host' else 'Cortex-M4F'
    title = (f"{scene} on the {on}: of {step['whole']:.0f} instructions of a step, {step['base']:.0f} are without any "
             'effect')
    p.put('set grid noytics', f'set label 1 {quoted(title)} at screen 0.5, screen {1 - 18 / p.height:.4g} center '
                              'noenhanced',
          'set multiplot')

    def panel(number, text, keys, times, form, left, right):
        """A panel of one column, or of two, each with its name in the legend: "KEY of KEY". The shown number is that
        of the table times `times`, at the end of a bar; the panel reaches from `left` to `right` of the picture."""
        values = {key: [times * float(row[head.index(key)]) for row in rows] for key in keys}
        low, high = (choose([0, *(x for its in values.values() for x in its)]) for choose in (min, max))
        for bar, (key, its) in enumerate(values.items()):
            points = []
            for row, x in enumerate(its, 1):
                top = row - 0.35 + bar * 0.7 / len(keys)
                points.append([f'{x:.9g}', f'{top + 0.35 / len(keys):.4g}', f'{min(0, x):.9g}', f'{max(0, x):.9g}',
                               f'{top:.4g}', f'{top + 0.7 / len(keys):.4g}', f'{max(0, x):.9g}'])
            of = f"of {'a ' if key in ('step', 'tick') else ''}{key}" if len(keys) > 1 else ''
            p.curve(points, f"using 1:2:3:4:5:6 with boxxyerror fill solid noborder linecolor rgb '{COLOURS[bar]}'", of)
            p.curve(points, f"using 7:2:(sprintf(' {form}', $1)) with labels left")
        width = high - low or 1
        p.put_range('x', low, low + 1.2 * width)
        p.put(f'set xrange [{low - 0.1 * width if low < 0 else 0:.9g}:{low + 1.25 * width:.9g}]')
        p.put_place(left, right, 1 - ABOVE / p.height, BELOW / p.height)
        middle = (left + right) / 2
        tics = ', '.join(f"{quoted('' if number else row[0])} {i}" for i, row in enumerate(rows, 1))
        p.put(f"set label 2 '{text}' at screen {middle:.4g}, screen {1 - 46 / p.height:.4g} center",
              f'set key on at screen {middle:.4g}, screen {1 - 58 / p.height:.4g} horizontal center top samplen 1',
              f'set yrange [{len(rows) + 0.5:.1f}:0.5]\nset ytics ({tics}) scale 0 noenhanced')
        p.put_curves()

    panel(0, 'instructions', ('step', 'tick'), 1, '%.0f', 0.17, 0.43)
    p.put('unset label 1')
    panel(1, 'bytes', ('text', 'memory'), 1, '%.0f', 0.46, 0.72)
    panel(2, 'largest change of an output, rms, %', ('part',), 100, '%.3g', 0.75, 0.98)
    p.put('unset multiplot')
    return p

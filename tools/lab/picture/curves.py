"""Pictures of the tables of reports, of drift and of linear models: curves in one panel or a few."""
from lab.draw import Picture, drawable, quoted
from lab.picture import looks


def growth(scene, rows):
    """The error over the time, of the scene's method at its step, in each kind: rows of growth.tsv."""
    curves = {}
    for kind, method, step, time, error in rows:
        if drawable(error):
            curves.setdefault(kind, []).append((time, error))
    if not curves:
        return None
    times, errors = ([float(row[i]) for its in curves.values() for row in its] for i in (0, 1))
    tics, at = [], max(times)
    while at > min(times) / 1.1:
        tics.insert(0, f"'{at:.6g}' {at:.9g}")
        at /= 2
    p = Picture(900, 380)
    p.put('set logscale xy\nset mxtics 1\nset mytics 1',
          f'set xrange [{min(times) / 1.2:.4g}:{max(times) * 1.2:.4g}]', f"set xtics ({', '.join(tics)})")
    p.put_whole_decades(errors)
    p.put("set xlabel 't, s'\nset ylabel 'error of the state'")
    p.put_title(f'{scene}: how the error grows, {method} with a step of {1000 * float(step):.4g} ms')
    for kind, colour in ('float', '#d1590a'), ('compensated', '#3c8d2f'), ('double', '#0067a5'):
        p.curve(curves.get(kind), f"with linespoints linewidth 1.4 pointtype 7 pointsize 0.5 linecolor rgb '{colour}'",
                kind)
    p.put_curves()
    return p


def local_error(scene, rows):
    """The error of a step over the time, and the method's estimate of it: rows of local_error.tsv."""
    curves = [[(row[0], row[c]) for row in rows if drawable(row[c])] for c in (1, 2)]
    if not any(curves):
        return None
    p = Picture(900, 320)
    p.put('set logscale y\nset mytics 1')
    p.put_whole_decades([float(error) for its in curves for _, error in its])
    p.put(f"set xrange [0:{max(float(row[0]) for row in rows):.9g}]\nset xlabel 't, s'\nset ylabel 'error of a step'")
    p.put_title(f'{scene}: the error of a step, {rows[-1][5]} with a step of {1000 * float(rows[-1][4]):.4g} ms')
    for its, look, name in zip(curves, ("6 linecolor rgb '#d1590a'", "7 linecolor rgb '#0067a5'"), ('told', 'true')):
        p.curve(its, 'with linespoints linewidth 1.2 pointsize 0.5 pointtype ' + look, name)
    p.put_curves()
    return p


def singular(scene, rows):
    """How near a run comes to singular positions of its closed loops, and how far these come apart: singular.tsv."""
    p = Picture(900, 560)
    title = quoted(scene + ': nearness to singular positions, and how far loops come apart')
    p.put('set multiplot\nset logscale y\nset mytics 1', f'set xrange [0:{float(rows[-1][0]):.9g}]',
          f"set label 2 {title} noenhanced at screen 0.11, 0.965 left font ',14'")
    for i, (name, colour) in enumerate((('least pivot', '#0067a5'), ('largest change of a pivot in a step', '#c2185b'),
                                        ('violation, m or rad', '#d1590a')), 1):
        points = [(row[0], row[i]) for row in rows if float(row[i]) > 0]
        if not points:
            continue
        values = [float(value) for _, value in points]
        p.put_place(0.11, 0.975, 1.185 - 0.29 * i, 1.185 - 0.29 * i - 0.19)
        p.put_whole_decades([*values, max(values) * 1.0001])
        p.put_head(name)
        p.put_time(i == 3)
        p.curve(points, f"with lines linewidth 1.3 linecolor rgb '{colour}'", name)
        p.put_curves()
        p.put('unset label 2')
    p.put('unset multiplot')
    return p


def regions(scene, own, rows):
    """Regions of stability of all methods, and in them the step times the eigenvalues of the scene: regions.tsv. The
    curve of the scene's own method is the widest."""
    curves, pieces = {}, {}
    for what, real, imaginary, piece in rows:
        curve = curves.setdefault(what, [])
        if what != 'eigenvalue' and pieces.setdefault(what, piece) != piece:
            curve.append(())
            pieces[what] = piece
        curve.append((real, imaginary))
    points = curves.pop('eigenvalue', None)
    if not points:
        return None
    p = Picture(760, 560)
    p.put('set xrange [-4.2:2]\nset yrange [-3.6:3.6]\nset size ratio -1',
          "set xlabel 'real part of the eigenvalue times the step'\nset ylabel 'imaginary part'")
    p.put_title(scene + ': what each method keeps stable, and the eigenvalues at its step')
    p.put('set key samplen 3')
    for i, (method, curve) in enumerate(curves.items(), 1):
        p.curve(curve, f'with lines linewidth {3 if method == own else 1.4} dashtype {looks.dashes(method)} '
                f"linecolor rgb '{looks.colour(method, i)}'", method)
    p.curve(points, "with points pointtype 7 pointsize 0.8 linecolor rgb '#000000'", 'eigenvalue')
    p.put_curves()
    return p


def violation(scene, measured):
    """The largest violation over time for every stabilisation, and its bound as a dashed line: of {stabilisation:
    [(time, violation)], bound}."""
    curves = {name: ([row for row in parts if drawable(row[1])], bound) for name, (parts, bound) in measured.items()}
    curves = {name: its for name, its in curves.items() if its[0]}
    if not curves:
        return None
    end = max(float(time) for parts, _ in curves.values() for time, _ in parts)
    p = Picture(900, 420)
    p.put('set logscale y')
    p.put_whole_decades([float(value) for parts, bound in curves.values()
                         for value in (*(v for _, v in parts), *([bound] if drawable(bound) else ()))])
    p.put(f"set xrange [0:{end:.9g}]\nset xlabel 't, s'\nset ylabel 'largest violation, m or rad'")
    p.put_title(scene + ': how far the loops come apart, in float; dashed: the bound')
    for name, colour in zip(('none', 'baumgarte', 'projection', 'lagrangian'),
                            ('#8c8c8c', '#d1590a', '#0067a5', '#3c8d2f')):
        if name in curves:
            parts, bound = curves[name]
            p.curve(parts, f"with lines linewidth 1.4 linecolor rgb '{colour}'", name)
            if drawable(bound):
                p.curve([(0, float(bound)), (end, float(bound))],
                        f"with lines linewidth 0.7 dashtype 2 linecolor rgb '{colour}'")
    p.put_curves()
    return p


def bode(scene, pair, rows, unit):
    """Gain and phase over the frequency: of the model as lines, and as measured on the plant as points. Rows of `linear
    bode`: model or plant, frequency, gain, phase."""
    frequencies, gains, phases = ([float(row[i]) for row in rows] for i in (1, 2, 3))
    gains = [gain for gain in gains if gain > 0]
    if not gains:
        return None
    p = Picture(760, 520)
    p.put('set multiplot\nset logscale x\nset logscale y')
    p.put_whole_decades([max(min(gains), 1e-12 * max(gains)), max(gains)])
    p.put('set key on top right noenhanced samplen 2', f'set title {quoted(f"{scene}: {pair}")} noenhanced')

    def panel(column, label, top, bottom, with_frequency):
        p.put_place(0.11, 0.97, top, bottom)
        p.put_decades('x', min(frequencies), max(frequencies), with_frequency)
        p.put("set xlabel " + ("'frequency, Hz'" if with_frequency else "''"), f'set ylabel {quoted(label)} noenhanced')
        for kind, style, title in (('model', "lines linewidth 1.6 linecolor rgb '#0067a5'", 'linear model'),
                                   ('plant', "points pointtype 7 pointsize 0.8 linecolor rgb '#d1590a'",
                                    'sines of the plant')):
            p.curve([row[1:] for row in rows if row[0] == kind], f'using 1:{column} with {style}', title)
        p.put_curves()

    panel(2, 'gain, ' + unit, 0.92, 0.52, False)
    p.put('unset title\nset key off\nunset logscale y')
    p.put_range('y', min(phases), max(phases))
    panel(3, 'phase, deg', 0.47, 0.11, True)
    p.put('unset multiplot')
    return p

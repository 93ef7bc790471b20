// The outputs over time, a panel for each, or for the parts of a vector; a cursor at the time of the mechanism.

const PLOT_MARGIN = {left: 40, most: 84, right: 8, top: 6, bottom: 20};

// Names with _x, _y, _z, or _w before these, are one panel.
function panelsOf(run) {
    const panels = [];
    for (let i = 0; i < run.names.length; i++) {
        const stem = run.names[i].slice(0, -2), ends = (letters) => [...letters].every((c, n) => run.names[i + n] === `${stem}_${c}`);
        const letters = stem !== "" && ends("wxyz") ? "wxyz" : stem !== "" && ends("xyz") ? "xyz" : "";
        panels.push({name: letters ? stem : run.names[i], unit: run.units[i], letters,
            columns: letters ? [...letters].map((c, n) => i + n) : [i]});
        i += Math.max(letters.length - 1, 0);
    }
    return panels;
}

// Steps of 1, 2 or 5 times a power of ten, so that about `count` of them fit.
function ticksOf(least, most, count) {
    const raw = (most - least) / count, ten = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((k) => k * ten).find((s) => s >= raw * 0.999);
    const ticks = [];
    for (let n = Math.ceil(least / step - 1e-9); n * step <= most + 1e-9 * step; n++) {
        ticks.push(n * step);
    }
    return {ticks, step};
}

function shortNumber(x, step) {
    const size = Math.abs(x);
    if (x === 0 || size < 1e-9 * step) {
        return "0";
    }
    return size >= 1e5 || size < 1e-3 ? x.toExponential(Math.max(0, Math.min(2, Math.ceil(Math.log10(size / step) - 1e-9))))
        : x.toFixed(Math.max(0, Math.min(8, Math.ceil(-Math.log10(step) - 1e-9))));
}

class Plot {
    constructor(panel, runs, seek) {
        this.panel = panel;
        this.runs = runs;
        this.left = PLOT_MARGIN.left;
        this.figure = document.createElement("figure");
        const caption = document.createElement("figcaption"), name = document.createElement("b");
        const unit = panel.unit && panel.unit !== "1" ? `, ${panel.unit}` : "";
        name.textContent = panel.name.replaceAll("_", " ") + unit;
        this.reading = document.createElement("span");
        caption.append(name, this.reading);
        this.canvas = document.createElement("canvas");
        this.figure.append(caption, this.canvas);
        const move = (e) => seek((e.offsetX - this.left) / this.innerWidth() * this.end());
        this.canvas.addEventListener("pointerdown", (e) => {
            this.canvas.setPointerCapture(e.pointerId);
            move(e);
        });
        this.canvas.addEventListener("pointermove", (e) => e.buttons & 1 && move(e));
        this.several = runs.length > 1 || panel.letters !== "";
        this.scale();
    }

    end() {
        return Math.max(...this.runs.map((run) => run.end), 1e-12);
    }

    innerWidth() {
        return this.canvas.clientWidth - this.left - PLOT_MARGIN.right;
    }

    // The range of all runs.
    scale() {
        let least = Infinity, most = -Infinity;
        for (const run of this.runs) {
            for (const column of this.columnsIn(run)) {
                for (let i = 0; i < run.frames; i++) {
                    const low = run.least[i * run.names.length + column], high = run.most[i * run.names.length + column];
                    least = low < least ? low : least;
                    most = high > most ? high : most;
                }
            }
        }
        if (!(least <= most) || !isFinite(least) || !isFinite(most)) {
            [least, most] = [-1, 1];
        }
        const room = most > least ? 0.06 * (most - least) : Math.abs(most) * 0.1 || 1;
        this.least = least - room;
        this.most = most + room;
    }

    // The columns of the panel in another run, by name.
    columnsIn(run) {
        return this.panel.columns.map((c) => run.names.indexOf(this.runs[0].names[c])).filter((c) => c >= 0);
    }

    draw(time, style) {
        const ratio = window.devicePixelRatio || 1, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
        if (width === 0) {
            return;
        }
        const key = `${width} ${height} ${ratio} ${style.scheme}`;
        if (this.key !== key) {
            this.key = key;
            this.still = this.drawStill(width, height, style);
        }
        const context = contextOf(this.canvas, width, height);
        context.drawImage(this.still, 0, 0, this.still.width / ratio, this.still.height / ratio);
        context.fillStyle = style.cursor;
        context.fillRect(this.x(time, width) - 0.75, PLOT_MARGIN.top, 1.5, height - PLOT_MARGIN.top - PLOT_MARGIN.bottom);
        this.read(time);
    }

    x(time, width) {
        return this.left + time / this.end() * (width - this.left - PLOT_MARGIN.right);
    }

    y(value, height) {
        const inside = height - PLOT_MARGIN.top - PLOT_MARGIN.bottom;
        return PLOT_MARGIN.top + (this.most - value) / (this.most - this.least) * inside;
    }

    // The values at the cursor, in the colours of their curves.
    read(time) {
        const size = Math.max(Math.abs(this.least), Math.abs(this.most)), readings = [];
        this.runs.forEach((run, r) => this.columnsIn(run).forEach((column, n) => {
            const x = run.column(time, column), reading = document.createElement("span");
            const number = Math.abs(x) < 1e-6 * size ? "0" : Number(x.toPrecision(4)).toString();
            reading.textContent = `${this.panel.letters && r === 0 ? this.panel.letters[n] + " " : ""}${number}`;
            reading.style.color = this.several ? `var(--run${(this.runs.length > 1 ? r : n) % 6})` : "";
            readings.push(reading, " ");
        }));
        this.reading.replaceChildren(...readings);
    }

    // Axes and curves, which do not move.
    drawStill(width, height, style) {
        const still = document.createElement("canvas"), context = contextOf(still, width, height);
        context.font = "11px system-ui, sans-serif";
        context.lineWidth = 1;
        this.drawAxes(context, width, height, style);
        this.runs.forEach((run, r) => this.columnsIn(run).forEach((column, n) => {
            context.strokeStyle = this.runs.length > 1 ? style.run[r % style.run.length] : style.run[n % style.run.length];
            context.setLineDash(this.runs.length > 1 && r > 0 ? [6, 3] : []);
            this.drawCurve(context, run, column, width, height);
        }));
        context.setLineDash([]);
        return still;
    }

    drawAxes(context, width, height, style) {
        const floor = height - PLOT_MARGIN.bottom, across = ticksOf(0, this.end(), width > 600 ? 10 : 5);
        const up = ticksOf(this.least, this.most, 4), labels = up.ticks.map((v) => shortNumber(v, up.step));
        const wide = Math.max(...labels.map((label) => context.measureText(label).width)) + 9;
        this.left = Math.max(PLOT_MARGIN.left, Math.min(PLOT_MARGIN.most, wide));
        context.strokeStyle = style.line;
        context.fillStyle = style.faint;
        context.textAlign = "center";
        for (const t of across.ticks) {
            const x = this.x(t, width), last = t === across.ticks[across.ticks.length - 1];
            trace(context, [[x, PLOT_MARGIN.top], [x, floor]], false);
            context.stroke();
            context.fillText(shortNumber(t, across.step) + (last ? " s" : ""), Math.min(x, width - 14), height - 5);
        }
        context.textAlign = "right";
        context.textBaseline = "middle";
        up.ticks.forEach((v, i) => {
            const y = this.y(v, height);
            trace(context, [[this.left, y], [width - PLOT_MARGIN.right, y]], false);
            context.stroke();
            context.fillText(labels[i], this.left - 5, y);
        });
        context.textAlign = "left";
        context.textBaseline = "alphabetic";
    }

    // Through the values at the frames; what was between two frames is a stroke across.
    drawCurve(context, run, column, width, height) {
        const outputs = run.names.length;
        context.lineWidth = 1.4;
        context.beginPath();
        for (let i = 0; i < run.frames; i++) {
            const x = this.x(i * run.interval, width), value = run.value[i * run.columns + column];
            const low = run.least[i * outputs + column], high = run.most[i * outputs + column];
            if (i > 0 && Math.abs(this.y(low, height) - this.y(high, height)) > 1) {
                const before = this.x((i - 0.5) * run.interval, width);
                context.lineTo(before, this.y(low, height));
                context.lineTo(before, this.y(high, height));
            }
            context.lineTo(x, this.y(value, height));
        }
        context.stroke();
    }
}

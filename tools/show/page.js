// The page: time, play and pause, the camera by mouse and touch, runs over one another or side by side.

const data = JSON.parse(document.getElementById("data").textContent);
const runs = data.runs.map((one) => new Run(one));
const cameras = runs.map(() => new Camera(data.view));
const element = (id) => document.getElementById(id);
// Those with a mechanism: a run that was kept has outputs alone.
const moving = runs.map((run, r) => r).filter((r) => runs[r].bodies > 0);
const canvas = element("scene"), end = Math.max(...runs.map((run) => run.end));
const state = {time: 0, playing: false, speed: 1, sideBySide: false, before: 0};

// The colours of the page as it is, light or dark.
function readStyle() {
    const style = getComputedStyle(document.documentElement), of = (name) => style.getPropertyValue(`--${name}`).trim();
    return {line: of("line"), faint: of("faint"), cursor: of("cursor"), scheme: of("ground"),
        run: [0, 1, 2, 3, 4, 5].map((i) => of(`run${i}`))};
}

function colourNumbers(text) {
    return [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
}

function seek(time) {
    state.time = Math.max(0, Math.min(time, end));
    draw();
}

const plots = panelsOf(runs[0]).map((panel) => new Plot(panel, runs, seek));
element("plots").append(...plots.map((plot) => plot.figure));

// One run in a part of the canvas; those over it are tinted.
function drawRun(context, r, left, width, height, style, isOver) {
    const camera = cameras[0];
    context.save();
    context.beginPath();
    context.rect(left, 0, width, height);
    context.clip();
    context.translate(left, 0);
    camera.aim(runs[isOver ? 0 : r], state.time, width, height);
    if (!isOver && data.view.hasFloor) {
        drawFloor(context, data.view, camera, style.line);
    }
    drawWays(context, runs[r], state.time, camera, runs.length > 1 ? style.run[r % style.run.length] : style.cursor);
    const tint = isOver ? colourNumbers(style.run[r % style.run.length]) : null;
    const polygons = polygonsOf(runs[r], state.time, camera, data.inks, tint);
    if (isOver) {
        drawOver(context, polygons, width, height);
    } else {
        drawPolygons(context, polygons);
    }
    context.restore();
}

// A figure as a whole that what is behind shows through: on a canvas of its own first.
const sheet = document.createElement("canvas");
function drawOver(context, polygons, width, height) {
    drawPolygons(contextOf(sheet, width, height), polygons);
    context.globalAlpha = 0.55;
    context.drawImage(sheet, 0, 0, width, height);
    context.globalAlpha = 1;
}

function draw() {
    const style = readStyle(), width = canvas.clientWidth, height = canvas.clientHeight;
    const context = contextOf(canvas, width, height);
    const places = state.sideBySide ? moving.length : 1;
    moving.forEach((r, place) => {
        const left = state.sideBySide ? place * width / places : 0;
        drawRun(context, r, left, width / places, height, style, !state.sideBySide && r > 0);
        if (state.sideBySide) {
            context.fillStyle = style.run[r % style.run.length];
            context.font = "13px system-ui, sans-serif";
            context.fillText(runs[r].label, left + 8, 18);
        }
    });
    plots.forEach((plot) => plot.draw(state.time, style));
    element("scrub").value = state.time / end;
    element("clock").textContent = `${state.time.toFixed(end < 1 ? 4 : 2)} of ${Number(end.toPrecision(4))} s`;
}

// --- time ---

function setPlaying(playing) {
    state.playing = playing;
    state.time = playing && state.time >= end ? 0 : state.time;
    element("play").textContent = playing ? "\u275a\u275a" : "\u25b6\ufe0e";
    element("play").setAttribute("aria-label", playing ? "Pause" : "Play");
    if (playing) {
        state.before = performance.now();
        requestAnimationFrame(advance);
    }
}

function advance(now) {
    if (!state.playing) {
        return;
    }
    const time = state.time + state.speed * Math.max(0, now - state.before) / 1000;
    state.before = now;
    seek(time);
    if (time >= end) {
        setPlaying(false);
    } else {
        requestAnimationFrame(advance);
    }
}

element("play").addEventListener("click", () => setPlaying(!state.playing));
element("scrub").addEventListener("input", (e) => seek(e.target.value * end));
element("speed").addEventListener("change", (e) => {
    state.speed = Number(e.target.value);
});
element("reset").addEventListener("click", () => {
    cameras[0].reset();
    draw();
});
element("layout").addEventListener("click", () => {
    state.sideBySide = !state.sideBySide;
    element("layout").textContent = state.sideBySide ? "over one another" : "side by side";
    draw();
});
document.addEventListener("keydown", (e) => {
    if (e.key === " " && !["BUTTON", "SELECT"].includes(e.target.tagName)) {
        e.preventDefault();
        setPlaying(!state.playing);
    }
    if ((e.key === "ArrowLeft" || e.key === "ArrowRight") && e.target === canvas) {
        seek(state.time + (e.key === "ArrowLeft" ? -1 : 1) * runs[0].interval);
    }
});

// --- the camera: one pointer turns, two come nearer ---

const pointers = new Map();

function apart() {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
}

function zoomBy(factor) {
    cameras[0].zoom = Math.max(0.2, Math.min(20, cameras[0].zoom * factor));
    draw();
}

canvas.addEventListener("pointerdown", (e) => {
    canvas.setPointerCapture(e.pointerId);
    pointers.set(e.pointerId, {x: e.clientX, y: e.clientY});
});
canvas.addEventListener("pointermove", (e) => {
    const last = pointers.get(e.pointerId);
    if (!last) {
        return;
    }
    const before = pointers.size === 2 ? apart() : 0;
    const dx = e.clientX - last.x, dy = e.clientY - last.y;
    pointers.set(e.pointerId, {x: e.clientX, y: e.clientY});
    if (pointers.size === 2) {
        zoomBy(apart() / Math.max(before, 1));
        return;
    }
    cameras[0].yaw -= 0.008 * dx;
    cameras[0].pitch = Math.max(-1.55, Math.min(1.55, cameras[0].pitch + 0.008 * dy));
    draw();
});
for (const name of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(name, (e) => pointers.delete(e.pointerId));
}
canvas.addEventListener("wheel", (e) => {
    e.preventDefault();
    zoomBy(Math.exp(-0.0012 * e.deltaY));
}, {passive: false});

// --- what it is ---

function about(run) {
    const step = run.tick < 1e-3 ? `${Number((run.tick * 1e6).toPrecision(6))} us` : `${Number((run.tick * 1e3).toPrecision(6))} ms`;
    return [run.method, `step ${step}`, run.real, run.bodies > 0 ? "" : "kept: its outputs alone"].filter(Boolean).join(", ") + (run.stopped ? `; ends at ${run.end.toPrecision(4)} s: ${run.stopped}` : "");
}

element("about").textContent = runs.length === 1 ? about(runs[0]) : "";
if (runs.length > 1) {
    element("layout").hidden = moving.length < 2;
    element("legend").append(...runs.map((run, r) => {
        const item = document.createElement("li"), mark = document.createElement("i");
        mark.style.background = `var(--run${r % 6})`;
        item.append(mark, `${run.label} (${about(run)})`);
        return item;
    }));
}
new ResizeObserver(draw).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
setPlaying(false);
draw();

"use strict";
// The mechanism: poses of bodies between frames, and its parts as polygons, drawn from the farthest to the nearest. The camera is
// that of tools/show/view.c.

const PART_OF_BODY = 0, PART_FORCE = 2, INK_STEEL = 8, INK_GROUND = 9, INK_SPRING = 11;
const LIGHT = [-0.35, 0.62, 0.70], DARK = 0.58, BRIGHT = 0.46, MARGIN = 0.9, GRID = 6;

const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (k, a) => [k * a[0], k * a[1], k * a[2]];
const inner = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const outer = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const lengthOf = (a) => Math.sqrt(inner(a, a));
const unit = (a) => {
    const length = lengthOf(a);
    return length > 0 ? times(1 / length, a) : a;
};

// A pose: three rows of a turn, and a move.
const NO_POSE = {row: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], at: [0, 0, 0]};
const turned = (p, a) => [inner(p.row[0], a), inner(p.row[1], a), inner(p.row[2], a)];
const placed = (p, a) => plus(turned(p, a), p.at);

function poseOf([w, x, y, z], at) {
    const norm = w * w + x * x + y * y + z * z, s = norm > 0 ? 2 / norm : 0;
    return {
        row: [[1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)]],
        at,
    };
}

// Its z axis leads from one point to the other, and is as long as they are apart.
function poseBetween(from, to) {
    const way = minus(to, from), z = unit(way);
    const x = unit(outer(Math.abs(z[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0], z)), y = outer(z, x);
    return {row: [0, 1, 2].map((i) => [x[i], y[i], way[i]]), at: from};
}

function floatsOf(text) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return new Float32Array(bytes.buffer);
}

// A run: its numbers at any time.
class Run {
    constructor(data) {
        Object.assign(this, data);
        this.value = floatsOf(data.value);
        this.least = floatsOf(data.least);
        this.most = floatsOf(data.most);
    }

    // The frame before a time, and the part of the way to the next one.
    frameAt(time) {
        const at = Math.max(0, Math.min(time / this.interval, this.frames - 1));
        const frame = Math.min(Math.floor(at), Math.max(this.frames - 2, 0));
        return {frame, part: this.frames > 1 ? at - frame : 0};
    }

    column(time, column) {
        const {frame, part} = this.frameAt(time);
        const a = this.value[frame * this.columns + column];
        return part > 0 ? a + part * (this.value[(frame + 1) * this.columns + column] - a) : a;
    }

    pose(time, body) {
        if (body < 0) {
            return NO_POSE;
        }
        const {frame, part} = this.frameAt(time), first = this.place[body];
        const here = frame * this.columns + first, there = part > 0 ? here + this.columns : here;
        const a = [...this.value.subarray(here, here + 7)], b = this.value.subarray(there, there + 7);
        // A quaternion and its negative are the same turn: the nearer one is the next.
        const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
        const v = a.map((x, i) => x + part * ((i < 3 ? 1 : sign) * b[i] - x));
        return poseOf(v.slice(3), v.slice(0, 3));
    }

    middle(time) {
        let sum = [0, 0, 0];
        for (let i = 0; i < this.bodies; i++) {
            sum = plus(sum, times(1 / this.bodies, this.pose(time, i).at));
        }
        return sum;
    }
}

// What turns, comes nearer and follows.
class Camera {
    constructor(view) {
        this.view = view;
        this.reset();
    }

    reset() {
        this.yaw = this.view.yaw;
        this.pitch = this.view.pitch;
        this.zoom = 1;
    }

    aim(run, time, width, height) {
        const v = this.view, c = Math.cos(this.yaw), s = Math.sin(this.yaw);
        const level = plus(times(c, v.out), times(s, v.right));
        this.right = minus(times(c, v.right), times(s, v.out));
        this.out = plus(times(Math.cos(this.pitch), level), times(Math.sin(this.pitch), v.up));
        this.up = outer(this.out, this.right);
        this.centre = v.follows ? plus(v.centre, run.middle(time)) : v.centre;
        this.scale = this.zoom * MARGIN * Math.min(width / (2 * v.halfWidth), height / (2 * v.halfHeight));
        this.x = width / 2;
        this.y = height / 2;
    }

    // Pixels, and metres towards the viewer.
    sees(p) {
        const d = minus(p, this.centre), near = inner(this.out, d);
        const k = this.scale * this.view.distance / (this.view.distance - Math.min(near, 0.9 * this.view.distance));
        return [this.x + k * inner(this.right, d), this.y - k * inner(this.up, d), near];
    }
}

function partPose(run, part, time, poses) {
    const first = part.body[0] < 0 ? NO_POSE : poses[part.body[0]];
    if (part.kind === PART_OF_BODY) {
        return first;
    }
    const from = placed(first, part.point[0]);
    if (part.kind === PART_FORCE) {
        return poseBetween(from, plus(from, times(part.scale * run.column(time, part.column), turned(first, part.point[1]))));
    }
    return poseBetween(from, placed(part.body[1] < 0 ? NO_POSE : poses[part.body[1]], part.point[1]));
}

function areaOf(p) {
    let sum = 0;
    for (let i = 0; i < p.length; i++) {
        const q = p[(i + 1) % p.length];
        sum += p[i][0] * q[1] - q[0] * p[i][1];
    }
    return sum;
}

function shadeOf(ink, a, b, c, camera) {
    const n = unit(outer(minus(b, a), minus(c, a)));
    const lit = DARK + BRIGHT * Math.max(0, inner([inner(camera.right, n), inner(camera.up, n), inner(camera.out, n)], LIGHT));
    return ink.map((x) => Math.min(255, Math.floor(lit * x + 0.5)));
}

// All polygons of a run that are seen, the farthest first. Inks are colours; `tint`, if any, is mixed into them.
function polygonsOf(run, time, camera, inks, tint) {
    const poses = Array.from({length: run.bodies}, (_, i) => run.pose(time, i)), all = [];
    for (const part of run.parts) {
        if (tint && part.ink === INK_GROUND) {
            continue;
        }
        const at = partPose(run, part, time, poses), corners = [], seen = [];
        for (let i = 0; i < part.v.length; i += 3) {
            const p = placed(at, [part.v[i], part.v[i + 1], part.v[i + 2]]);
            corners.push(p);
            seen.push(camera.sees(p));
        }
        const ink = tint ? inks[part.ink].map((x, i) => 0.25 * x + 0.75 * tint[i]) : inks[part.ink];
        const isLine = part.ink === INK_SPRING;
        for (const face of part.f) {
            const points = face.map((i) => seen[i]);
            if (!isLine && areaOf(points) >= 0) {
                continue;
            }
            const last = face.length - 1;
            all.push({
                points, isLine,
                near: points.reduce((sum, p) => sum + p[2] / points.length, 0),
                colour: isLine ? ink : shadeOf(ink, corners[face[0]], corners[face[1]], corners[face[Math.min(2, last)]], camera),
            });
        }
    }
    return all.sort((a, b) => a.near - b.near);
}

// The context of a canvas that has this size on the page, cleared.
function contextOf(canvas, width, height) {
    const ratio = window.devicePixelRatio || 1, context = canvas.getContext("2d");
    const across = Math.round(width * ratio), up = Math.round(height * ratio);
    if (canvas.width !== across || canvas.height !== up) {
        canvas.width = across;
        canvas.height = up;
    }
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, across, up);
    return context;
}

function trace(context, points, closed) {
    context.beginPath();
    points.forEach((p, i) => (i === 0 ? context.moveTo(p[0], p[1]) : context.lineTo(p[0], p[1])));
    if (closed) {
        context.closePath();
    }
}

function drawPolygons(context, polygons) {
    context.lineJoin = "round";
    for (const one of polygons) {
        const colour = `rgb(${one.colour.join()})`;
        context.strokeStyle = colour;
        context.lineWidth = one.isLine ? 2 : 0.7;
        trace(context, one.points, !one.isLine);
        if (!one.isLine) {
            context.fillStyle = colour;
            context.fill();
        }
        context.stroke();
    }
}

function drawFloor(context, view, camera, colour) {
    const from = minus(camera.centre, view.floor);
    const x = view.cell * Math.floor(inner(from, view.floorX) / view.cell + 0.5);
    const y = view.cell * Math.floor(inner(from, view.floorY) / view.cell + 0.5);
    const at = (a, b) => camera.sees(plus(view.floor, plus(times(x + a, view.floorX), times(y + b, view.floorY))));
    const end = GRID * view.cell;
    context.strokeStyle = colour;
    context.lineWidth = 1;
    for (let i = -GRID; i <= GRID; i++) {
        trace(context, [at(i * view.cell, -end), at(i * view.cell, end)], false);
        context.stroke();
        trace(context, [at(-end, i * view.cell), at(end, i * view.cell)], false);
        context.stroke();
    }
}

// The ways of points: faint the whole run, strong what has just been.
function drawWays(context, run, time, camera, colour) {
    const stride = Math.ceil(run.frames / 1500), {frame} = run.frameAt(time);
    const recent = Math.max(0, frame - Math.ceil(Math.min(1.5, run.end / 4) / run.interval));
    context.strokeStyle = colour;
    for (const column of run.ways) {
        const seen = (i) => {
            const p = i * run.columns + column;
            return camera.sees([run.value[p], run.value[p + 1], run.value[p + 2]]);
        };
        const whole = [], last = [];
        for (let i = 0; i < run.frames; i += stride) {
            whole.push(seen(i));
        }
        for (let i = recent; i <= frame; i++) {
            last.push(seen(i));
        }
        last.push(camera.sees([0, 1, 2].map((i) => run.column(time, column + i))));
        for (const [points, strength, width] of [[whole, 0.45, 1], [last, 1, 1.8]]) {
            context.globalAlpha = strength;
            context.lineWidth = width;
            trace(context, points, false);
            context.stroke();
        }
        context.globalAlpha = 1;
    }
}

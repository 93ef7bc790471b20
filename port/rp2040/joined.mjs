/* Two chips whose pins are joined, each with its own program: node joined.mjs PLANT NANOSECONDS CONTROLLER WIRE...
 *
 * A wire is PIN>PIN or PIN<PIN, the pin of the plant first, from which and to which an edge goes. It takes 1 us to the
 * other end, so that each chip can run by so much before the other one. The console of the plant goes to the standard
 * output, and its end and status are those of the run. */
import fs from 'node:fs';
import { Chip } from './chip.mjs';

const WIRE_NS = 1000, OUTPUT = 1;

const [plantFile, runNs, controllerFile, ...wires] = process.argv.slice(2);
if (!wires.length || !/^\d+$/.test(runNs)) {
  console.error('usage: joined.mjs PLANT NANOSECONDS CONTROLLER PIN>PIN ...');
  process.exit(1);
}
const plant = new Chip(fs.readFileSync(plantFile), { runNs });
const controller = new Chip(fs.readFileSync(controllerFile), { runNs: 0n });
for (const wire of wires) {
  const [, left, way, right] = /^(\d+)([<>])(\d+)$/.exec(wire) ?? [];
  if (!way) {
    console.error(`joined: ${wire} is no wire; it can be 10>6 or 3<14`);
    process.exit(1);
  }
  if (way === '>') join(plant, Number(left), controller, Number(right));
  else join(controller, Number(right), plant, Number(left));
}

/* Each edge of a pin comes to another one later. */
function join(from, fromPin, to, toPin) {
  const edges = [], { clock } = to.mcu;
  const alarm = clock.createAlarm(() => {
    while (edges.length && edges[0].at <= clock.nanos) to.drive(toPin, edges.shift().level);
    if (edges.length) alarm.schedule(edges[0].at - clock.nanos);
  });
  from.mcu.gpio[fromPin].addListener((state) => {
    if (state > 1) return;      // no output
    edges.push({ at: from.nanos + WIRE_NS, level: state });
    if (edges.length === 1) alarm.schedule(edges[0].at - clock.nanos);
  });
}

const bytes = [];
plant.onConsole = (byte) => bytes.push(byte);
while (plant.status === undefined) {
  const until = Math.min(plant.nanos, controller.nanos) + WIRE_NS;
  plant.run(until);
  controller.run(until);
  if (bytes.length > 4096 || plant.status !== undefined) fs.writeSync(OUTPUT, Uint8Array.from(bytes.splice(0)));
}
process.exit(plant.status);

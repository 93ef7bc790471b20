/* Runs a program for the RP2040 in the emulator: node emulator.mjs [--line FILE] PROGRAM NANOSECONDS [SCRIPT]. The bytes
 * of the console go to the standard output, those of UART1 to and from the open file with that number. The exit status
 * is that of the program. */
import fs from 'node:fs';
import { Chip } from './chip.mjs';
import * as wires from './wires.mjs';

const SLICE_NS = 1e6, OUTPUT = 1, LINE_BYTE_NS = 3333, LINE_BYTES = 4096;

function fail(text) {
  console.error(`emulator: ${text}`);
  process.exit(1);
}

/* Writes all bytes, also to a file that is not ready now. */
function write(file, bytes) {
  for (let done = 0; done < bytes.length;) {
    try {
      done += fs.writeSync(file, bytes, done);
    } catch (error) {
      if (error.code !== 'EAGAIN') throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 1);
    }
  }
}

/* UART1 and its peer. A program that sleeps and has no tick to wait for waits for its peer: then time stands still. */
class Line {
  constructor(chip, file) {
    this.uart = chip.mcu.uart[1];
    this.file = file;
    this.out = [];
    this.in = [];
    this.alarm = chip.mcu.clock.createAlarm(() => this.feed());
    this.uart.onByte = (byte) => this.out.push(byte);
  }

  flush() {
    if (this.out.length) write(this.file, Uint8Array.from(this.out.splice(0)));
  }

  /* Waits for bytes; whether some came, or the peer is gone. */
  wait() {
    this.flush();
    const bytes = Buffer.alloc(LINE_BYTES), count = fs.readSync(this.file, bytes, 0, LINE_BYTES);
    this.in.push(...bytes.subarray(0, count));
    if (count) this.feed();
    return count > 0;
  }

  /* The next byte of those that came, when the line has had the time for it. */
  feed() {
    if (this.in.length && !this.uart.rxFIFO.full) this.uart.feedByte(this.in.shift());
    if (this.in.length) this.alarm.schedule(LINE_BYTE_NS);
  }
}

const words = process.argv.slice(2);
let line;
if (words[0] === '--line') line = Number(words.splice(0, 2)[1]);
if (words[0] === '--free') fail('its time is virtual: a controller runs with --mode lockstep there');
const [program, runNs, script] = words;
if (words.length < 2 || words.length > 3 || !/^\d+$/.test(runNs)) fail('usage: emulator.mjs [--line FILE] PROGRAM NANOSECONDS [SCRIPT]');

const chip = new Chip(fs.readFileSync(program), { runNs });
const console_bytes = [];
chip.onConsole = (byte) => console_bytes.push(byte);
let record;
if (script) {
  try {
    const { changes, record: path } = wires.read(script);
    wires.play(chip, changes);
    if (path) record = wires.watch(chip, path);
  } catch (error) {
    fail(error.message);
  }
}
const peer = line === undefined ? undefined : new Line(chip, line);
try {
  while (chip.status === undefined) {
    const isAsleep = chip.run(peer ? Infinity : chip.nanos + SLICE_NS);
    write(OUTPUT, Uint8Array.from(console_bytes.splice(0)));
    if (chip.status === undefined && isAsleep && !(peer && peer.wait())) fail('the program sleeps, and nothing will wake it');
    peer?.flush();
  }
} catch (error) {
  write(OUTPUT, Uint8Array.from(console_bytes.splice(0)));
  fail(error.message);
}
record?.();
process.exit(chip.status);

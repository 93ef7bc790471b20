/* What stands at the pins of an emulated chip, by a script in the words of port/host/script.h:
 *
 *     high PIN TIME      low PIN TIME      volts PIN TIME CODE      record FILE
 *
 * Times begin when SysTick is turned on: with the first tick. An edge is seen by the chip at the next 8 ns, and all are
 * LATCHED_NS late, as long as the firmware takes from a tick to its first counter: so that the script divides an edge
 * from a tick as it does on the host. */
import fs from 'node:fs';
import { CYCLE_NS } from './chip.mjs';

const UNITS = { ns: 1, us: 1e3, ms: 1e6, s: 1e9 }, FIRST_ADC = 26, PINS = 30, ADC_MOST = 4095;
export const LATCHED_NS = 360;

/* The changes of a script and the file of its record. */
export function read(path) {
  const changes = [];
  let record;
  fs.readFileSync(path, 'utf8').split('\n').forEach((text, index) => {
    const fail = (why) => { throw new Error(`${path}:${index + 1}: ${why}`); };
    const [verb, ...words] = text.replace(/#.*/, '').trim().split(/\s+/);
    if (!verb) return;
    if (['late', 'lose', 'slow'].includes(verb)) fail(`${verb} is for the host: here ticks come when they do`);
    if (!['high', 'low', 'volts', 'record'].includes(verb)) fail('expected high, low, volts or record');
    if (words.length !== { record: 1, volts: 3 }[verb] && !(verb in { high: 1, low: 1 } && words.length === 2)) fail('expected as many words as port/host/script.h says');
    if (verb === 'record') {
      record = words[0];
      return;
    }
    const [, number, unit] = /^(\d+)(ns|us|ms|s)$/.exec(words[1]) || fail('expected a time such as 300us');
    const pin = Number(words[0]), at = Number(number) * UNITS[unit], level = verb === 'volts' ? Number(words[2]) : verb === 'high';
    if (!(pin < PINS) || (verb === 'volts' && !(pin >= FIRST_ADC && level <= ADC_MOST))) fail('there is no such pin, or no such voltage');
    if (changes.length && at < changes[changes.length - 1].at) fail('it stands before the line above in time');
    changes.push({ pin, at, level, isVolts: verb === 'volts' });
  });
  return { changes, record };
}

/* Plays changes at the pins of a chip from the first tick on. */
export function play(chip, changes) {
  const { clock } = chip.mcu;
  let next = 0, begin;
  const due = () => begin + Math.ceil((changes[next].at + LATCHED_NS) / CYCLE_NS) * CYCLE_NS;
  const alarm = clock.createAlarm(() => {
    for (; next < changes.length && due() <= clock.nanos; next++) {
      const { pin, level, isVolts } = changes[next];
      if (isVolts) chip.mcu.adc.channelValues[pin - FIRST_ADC] = level;
      else chip.drive(pin, level);
    }
    if (next < changes.length) alarm.schedule(due() - clock.nanos);
  });
  chip.onTicking = (at) => {
    begin ??= at;
    if (next < changes.length) alarm.schedule(due() - clock.nanos);
  };
}

/* Writes down each edge that the chip makes, from the first tick on; the levels before it at that time. */
export function watch(chip, path) {
  const file = fs.openSync(path, 'w'), { clock, gpio } = chip.mcu, ticking = chip.onTicking;
  const lines = [], levels = new Map();
  let begin;
  const write = (pin, level, at) => {
    lines.push(`${level ? 'high' : 'low'} ${pin} ${at}ns\n`);
    if (lines.length > 1000) fs.writeSync(file, lines.splice(0).join(''));
  };
  gpio.forEach((pin, number) => pin.addListener((state) => {
    if (state > 1) return;      // an input
    if (begin === undefined) levels.set(number, state);
    else write(number, state, Math.round(clock.nanos - begin));
  }));
  chip.onTicking = (at) => {
    ticking?.(at);
    if (begin !== undefined) return;
    begin = at;
    for (const [pin, level] of levels) write(pin, level, 0);
  };
  return () => fs.writeSync(file, lines.join(''));
}

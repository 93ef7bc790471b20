/* The RP2040 of rp2040js 1.4.1 with a program in it, and what the package has otherwise than the chip, mended in this
 * file alone. Each instruction takes one cycle of 8 ns. Sections are those of the RP2040 Datasheet.
 *
 *     const chip = new Chip(fs.readFileSync('program.elf'));     // or program.uf2
 *     chip.onConsole = (byte) => ...;
 *     chip.run(1e9);                                              // until 1 s, or the program's end
 *     chip.status                                                 // of the end; undefined before
 */
import { createRequire } from 'node:module';

export const CYCLE_NS = 8;
const VERSION = '1.4.1';
const INSTALL = 'make build/rp2040js, in the folder of Isochron';
const FLASH = 0x10000000, FLASH_BYTES = 2 << 20, RAM = 0x20000000, TOLD_EMULATED = 0x110, TOLD_RUN_NS = 0x108;
const ENDED = 0x49534f;      // in the upper bits of the register that keeps the status: port/rp2040/console.c

const require = createRequire(new URL('../../build/rp2040js/', import.meta.url));
let rp2040js;
try {
  rp2040js = require('rp2040js');
} catch {
  console.error(`emulator: rp2040js ${VERSION} is missing. Install it with: ${INSTALL}`);
  process.exit(1);
}

/* What a file has for flash, by address: the segments of an ELF file of 32 bits, or the blocks of a UF2 file. */
function* segments(file) {
  if (file.readUInt32LE(0) === 0x0a324655) {
    for (let at = 0; at < file.length; at += 512) {
      yield [file.readUInt32LE(at + 12), file.subarray(at + 32, at + 32 + file.readUInt32LE(at + 16))];
    }
    return;
  }
  const first = file.readUInt32LE(28), bytes = file.readUInt16LE(42), count = file.readUInt16LE(44);
  for (let at = first; at < first + bytes * count; at += bytes) {
    const [type, offset, , address, size] = [0, 4, 8, 12, 16].map((field) => file.readUInt32LE(at + field));
    if (type === 1 && size) yield [address, file.subarray(offset, offset + size)];
  }
}

/* 2.8.1.3.1: the checksum of the second stage. */
export function checksum(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte << 24;
    for (let bit = 0; bit < 8; bit++) crc = crc << 1 ^ (crc < 0 ? 0x04c11db7 : 0);
  }
  return crc >>> 0;
}

export class Chip {
  constructor(file, { runNs = 0n } = {}) {
    this.mcu = new rp2040js.RP2040();
    this.mcu.logger = new rp2040js.ConsoleLogger(rp2040js.LogLevel.Warn, true);
    this.instructions = 0;
    this.status = undefined;
    this.machines = [];
    for (const [address, bytes] of segments(file)) this.mcu.flash.set(bytes, address - FLASH);
    this.mcu.flashView.setBigUint64(TOLD_RUN_NS, BigInt(runNs), true);
    this.mcu.flashView.setUint32(TOLD_EMULATED, 1, true);
    mendWaking(this.mcu.core);
    mendSysTick(this.mcu, this);
    mendAlarms(this.mcu);
    mendGates(this.mcu);
    mendMachines(this);
    this.boot();
  }

  set onConsole(take) { this.mcu.uart[0].onByte = take; }
  drive(pin, level) { this.mcu.gpio[pin].setInputValue(Boolean(level)); }
  get nanos() { return this.mcu.clock.nanos; }

  /* 2.8.1: the boot ROM copies the second stage into RAM and runs it, if its checksum is right. */
  boot() {
    const { flash, sram, core } = this.mcu, at = 0x20041f00;
    if (checksum(flash.subarray(0, 252)) !== this.mcu.flashView.getUint32(252, true)) {
      throw new Error('the checksum of the second stage is wrong: the boot ROM would not start this program');
    }
    sram.set(flash.subarray(0, 256), at - RAM);
    core.SP = 0x20041f00;
    core.PC = at;
  }

  /* A processor that sleeps wakes when an enabled interrupt is pending, also if they are held off. */
  get isWoken() {
    const { core } = this.mcu;
    return core.pendingSystick || (core.pendingInterrupts & core.enabledInterrupts) !== 0;
  }

  /* Runs until a time in ns, the end of the program, or until it sleeps and nothing but the outside can wake it. Returns
   * whether that is so. */
  run(until) {
    const { core, clock } = this.mcu;
    while (this.status === undefined && clock.nanosCounter < until) {
      if (!core.waiting) {
        core.executeInstruction();
        this.instructions++;
        this.pass(clock.nanosCounter + CYCLE_NS);
      } else if (this.isWoken) {
        core.waiting = false;
      } else {
        const kept = this.mcu.peripherals[0x40058].scratchData[0];
        if (kept >>> 8 === ENDED) {
          this.status = kept & 0xff;
          break;
        }
        const next = Math.min(until, clock.nextAlarm ? clock.nextAlarm.nanos : Infinity, this.nextMachine());
        if (next === Infinity) return true;
        this.pass(Math.max(next, clock.nanosCounter));
      }
    }
    return false;
  }

  /* Time goes on. */
  pass(nanos) {
    const { clock } = this.mcu;
    clock.nanosCounter = nanos;
    if (clock.nextAlarm && clock.nextAlarm.nanos <= nanos) clock.tick(0);
    if (this.machines.length) this.runMachines(nanos);
  }

  nextMachine() {
    let next = Infinity;
    for (const m of this.machines) if (m.enabled && !(m.isStalled && m.waiting)) next = Math.min(next, m.at);
    return next;
  }

  /* State machines of the PIO, up to now: each takes its divided cycles for an instruction and its delay (3.2). A loop of
   * one instruction that counts down is done at once. One that waits for its FIFO goes on when that moves. */
  runMachines(nanos) {
    for (const m of this.machines) {
      if (!m.enabled) {
        m.at = undefined;
        continue;
      }
      const cycle = CYCLE_NS * ((m.clockDivInt || 65536) + m.clockDivFrac / 256);
      if (m.at === undefined) m.at = nanos;
      if (m.isStalled) {
        if (m.waiting) continue;
        m.at = nanos + cycle;
        m.isStalled = false;
      }
      while (m.at <= nanos) {
        const before = m.cycles, code = m.pio.instructions[m.pc];
        if (!m.waiting && code === (0x40 | m.pc) && m.x > 0) {
          m.at += m.x * cycle;
          m.x = 0;
          continue;
        }
        m.step();
        m.at += cycle * Math.max(1, m.cycles - before);
        m.isStalled = m.waiting && m.waitType > 1;
        if (m.isStalled) break;
      }
    }
    for (const pio of this.mcu.pio) pio.checkChangedPins();
  }
}

/* The package takes an interrupt from sleep although they are held off, and sleeps on if one was pending before. */
function mendWaking(core) {
  core.setInterrupt = (irq, isOn) => {
    core.pendingInterrupts = isOn ? core.pendingInterrupts | 1 << irq : core.pendingInterrupts & ~(1 << irq);
    if (isOn) core.interruptsUpdated = true;
  };
}

/* SysTick of the package has a period one cycle short, rounds, and does not wake a processor that sleeps. Armv6-M
 * Architecture Reference Manual, B3.3: it counts from RVR to 0, and is pending when it gets there. */
function mendSysTick({ ppb, core, clock }, chip) {
  const CSR = 0x10, RVR = 0x14, CVR = 0x18;
  let control = 0, reload = 0, left = 0, zeroAt = 0;
  const cycles = () => Math.round((zeroAt - clock.nanos) / CYCLE_NS) % (reload + 1);
  const alarm = clock.createAlarm(() => {
    if (control & 2) {
      core.pendingSystick = true;
      core.interruptsUpdated = true;
    }
    zeroAt += (reload + 1) * CYCLE_NS;
    alarm.schedule(zeroAt - clock.nanos);
  });
  const run = (count) => {
    zeroAt = clock.nanos + (count || reload + 1) * CYCLE_NS;
    alarm.schedule(zeroAt - clock.nanos);
  };
  const read = ppb.readUint32.bind(ppb), write = ppb.writeUint32.bind(ppb);
  ppb.readUint32 = (offset) => (offset === CSR ? control : offset === RVR ? reload
    : offset === CVR ? (control & 1 ? cycles() : left) : read(offset));
  ppb.writeUint32 = (offset, value) => {
    if (offset === CSR) {
      if (control & 1 & ~value) {
        left = cycles();
        alarm.cancel();
      } else if (value & 1 & ~control) {
        run(left);
        chip.onTicking?.(clock.nanos);
      }
      control = value & 7;
    } else if (offset === RVR) {
      reload = value & 0xffffff;
    } else if (offset === CVR) {
      left = 0;
      if (control & 1) run(0);
    } else {
      write(offset, value);
    }
  };
}

/* 4.6: an alarm of the timer comes when the timer has its microsecond; the package may be one early. */
function mendAlarms({ peripherals, clock }) {
  for (const { clockAlarm } of peripherals[0x40054].alarms) {
    const schedule = clockAlarm.schedule.bind(clockAlarm);
    clockAlarm.schedule = (nanos) => schedule(Math.ceil((clock.nanos + nanos) / 1000) * 1000 - clock.nanos);
  }
}

/* 4.5.2.3: a slice that its pin gates counts clocks while that is high, and its divider keeps what is left of a count.
 * The package takes no input at all (&& for &), and rounds each pulse. */
function mendGates({ pwm, clock }) {
  pwm.gpioOnInput = (pin) => {
    for (const slice of pwm.channels) if (slice.pinB1 === pin || slice.pinB2 === pin) slice.gpioBChanged();
  };
  for (const slice of pwm.channels) {
    const isGated = () => slice.divMode === 1;
    const { updateEnable, readRegister, writeRegister } = Object.getPrototypeOf(slice);
    let high = 0, since;
    const counted = () => Math.floor((high + (since === undefined ? 0 : clock.nanos - since)) / (CYCLE_NS * slice.timer.prescaler));
    slice.updateEnable = () => {
      updateEnable.call(slice);
      const isOpen = isGated() && (slice.csr & 1) !== 0 && slice.gpioBValue;
      if (isOpen && since === undefined) since = clock.nanos;
      if (!isOpen && since !== undefined) {
        high += clock.nanos - since;
        since = undefined;
      }
      if (isGated()) slice.timer.enable = false;
    };
    slice.readRegister = (offset) => (offset === 8 && isGated() ? counted() % (slice.top + 1) : readRegister.call(slice, offset));
    slice.writeRegister = (offset, value) => {
      if (offset === 8) {
        high = value * CYCLE_NS * slice.timer.prescaler;
        since = since === undefined ? undefined : clock.nanos;
      }
      writeRegister.call(slice, offset, value);
    };
  }
}

/* The package runs state machines by themselves, in no time of the chip: `Chip` runs them. */
function mendMachines(chip) {
  for (const pio of chip.mcu.pio) {
    pio.run = () => {
      for (const machine of pio.machines) {
        machine.at = undefined;
        if (!chip.machines.includes(machine)) chip.machines.push(machine);
      }
    };
  }
}

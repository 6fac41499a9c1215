import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Generates signals in each run: a count, the elapsed time, ticks and waves. */
export const clock = defineProcessingModule({
  name: 'clock',
  description: 'Generates ticks, a run count and four waves.',
  tags: ['source', 'generator', 'time', 'number', 'wave', 'sine'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    waveHz: {
      format: 'double',
      default: 1,
      description: 'Frequency of the waves, 0 to 1000 Hz; usable up to half of the run frequency.',
    },
    amplitude: {
      format: 'double',
      default: 1,
      description: 'Height of the waves above and below the offset.',
    },
    offset: { format: 'double', default: 0, description: 'Centre of the waves.' },
    phase: { format: 'double', default: 0, description: 'Phase offset of the waves, in periods.' },
    dutyCycle: {
      format: 'double',
      default: 0.5,
      description: 'Fraction of a period, 0 to 1, in which square is high.',
    },
  },
  outputs: {
    count: { format: 'int32', description: 'Number of earlier runs.' },
    elapsedMs: { format: 'double', description: 'Time since the first run, ms.' },
    tick: { format: 'bool', description: 'True in the first run and at the end of each period.' },
    sine: { format: 'double', description: 'Sine wave, offset ± amplitude.' },
    square: { format: 'double', description: 'Square wave, offset ± amplitude.' },
    triangle: { format: 'double', description: 'Triangle wave, offset ± amplitude.' },
    saw: { format: 'double', description: 'Sawtooth wave, offset ± amplitude.' },
  },
  mode: { frequency: { hertz: 30 } },
  createState: () => ({ runs: 0, elapsedMs: 0, turns: 0 }),
  onProcessing(deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
    };
    const waveHz = read.number(inputs.waveHz, 1, 0, 1000);
    const amplitude = read.number(inputs.amplitude, 1, -1e150, 1e150);
    const offset = read.number(inputs.offset, 0, -1e150, 1e150);
    const phase = read.number(inputs.phase, 0, -1e6, 1e6);
    const dutyCycle = read.number(inputs.dutyCycle, 0.5, 0, 1);

    const isFirst = state.runs === 0;
    state.elapsedMs += deltaTimeMs;
    // Add up the phase instead of computing it from the time, so that the wave does not jump when the
    // frequency changes. Keep only its fraction, so that it stays precise over days.
    const turns = state.turns + (waveHz * deltaTimeMs) / 1000;
    const tick = isFirst || turns >= 1;
    state.turns = turns % 1;
    const count = state.runs;
    state.runs = (state.runs + 1) % 2 ** 31;

    const at = (((state.turns + phase) % 1) + 1) % 1;
    const wave = {
      out(level: number) {
        return { double: offset + amplitude * level };
      },
    };
    return {
      outputs: {
        count: { int32: count },
        elapsedMs: { double: state.elapsedMs },
        tick: tick ? { bool: true } : undefined,
        sine: wave.out(Math.sin(2 * Math.PI * at)),
        square: wave.out(at < dutyCycle ? 1 : -1),
        triangle: wave.out(at < 0.25 ? 4 * at : at < 0.75 ? 2 - 4 * at : 4 * at - 4),
        saw: wave.out(2 * at - 1),
      },
    };
  },
});

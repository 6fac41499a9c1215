import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

interface SpeedState {
  last: { x: number; y: number } | undefined;
  /** Time since the position in `last`, milliseconds. */
  waitedMs: number;
  velocity: { x: number; y: number };
  distance: number;
}

/**
 * Computes the velocity of a position. Runs at a frequency, so that the speed decreases to 0 when no new
 * position arrives.
 */
export const speedVector2 = defineProcessingModule({
  name: 'speed-vector2',
  description: 'Computes the velocity and speed of a position.',
  tags: ['vector', 'number', 'derivative', 'pointer'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    position: { format: 'vector2', description: 'The position, up to 1e100.' },
    smoothingMs: {
      format: 'double',
      default: 60,
      description: 'Smoothing time constant, 0 to 60 000 ms; 0 turns smoothing off.',
    },
  },
  outputs: {
    velocity: { format: 'vector2', description: 'Change of the position per second.' },
    speed: {
      format: 'double',
      description: 'Length of the velocity, in units of the position per second.',
    },
    distance: {
      format: 'double',
      description: 'Travelled distance since the start, in units of the position.',
    },
  },
  mode: { frequency: { hertz: 30 } },
  createState: (): SpeedState => ({
    last: undefined,
    waitedMs: 0,
    velocity: { x: 0, y: 0 },
    distance: 0,
  }),
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
    const smoothingMs = read.number(inputs.smoothingMs, 60, 0, 60_000);
    state.waitedMs += deltaTimeMs;
    const position = inputs.position?.vector2;
    // A run triggered by a parameter has no new position.
    const triggers = state.inputTriggerNames ?? [];
    if (position === undefined || (triggers.length > 0 && !triggers.includes('position')))
      return undefined;
    // Differences of larger numbers could be infinite.
    if (![position.x, position.y].every((part) => Math.abs(part) <= 1e100)) return undefined;

    const { x, y } = position;
    const last = state.last;
    if (last !== undefined && state.waitedMs <= 0) return undefined;
    if (last !== undefined) {
      const seconds = state.waitedMs / 1000;
      const way = { x: x - last.x, y: y - last.y };
      state.distance += Math.hypot(way.x, way.y);
      // First-order low-pass, exact for any interval.
      const share = smoothingMs === 0 ? 1 : -Math.expm1(-state.waitedMs / smoothingMs);
      state.velocity = {
        x: state.velocity.x + share * (way.x / seconds - state.velocity.x),
        y: state.velocity.y + share * (way.y / seconds - state.velocity.y),
      };
    }
    state.last = { x, y };
    state.waitedMs = 0;
    return {
      outputs: {
        velocity: { vector2: state.velocity },
        speed: { double: Math.hypot(state.velocity.x, state.velocity.y) },
        distance: { double: state.distance },
      },
    };
  },
});

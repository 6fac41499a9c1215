import { defineProcessingModule, type ModuleState } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** A record on `value` in any supported format. */
type AnyRecord = { readonly type: string } & { readonly [member: string]: unknown };

interface OneEuroState {
  /** The smoothed value: one number, or the components x, y, z, w that the format has. */
  smoothed: number[] | undefined;
  /** Smoothed change of each component per second. */
  speed: number[];
  /** Time since the last usable sample, milliseconds. */
  waitedMs: number;
}

interface OneEuroInputs {
  value: AnyRecord | undefined;
  minCutoffHz: NumberRecord | undefined;
  beta: NumberRecord | undefined;
  derivativeCutoffHz: NumberRecord | undefined;
}

/**
 * Handles records of all formats. Self-contained, because it is sent as text.
 *
 * Source: G. Casiez, N. Roussel, D. Vogel: "1€ Filter: A Simple Speed-based Low-pass Filter for Noisy
 * Input in Interactive Systems", CHI 2012, algorithm 1. All components share one cut-off, which depends
 * on the length of the velocity, so that the result does not depend on the direction of a movement.
 */
function smooth(deltaTimeMs: number, inputs: OneEuroInputs, state: ModuleState<OneEuroState>) {
  const read = {
    value(record: NumberRecord | undefined) {
      return record?.double ?? record?.float ?? record?.int32;
    },
    // A number that is not finite counts as missing.
    number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
      const value = this.value(record);
      return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
    },
    /** The smoothing factor, alpha in the paper. */
    share(cutoffHz: number, seconds: number) {
      const turns = 2 * Math.PI * cutoffHz * seconds;
      return turns === Infinity ? 1 : turns / (turns + 1);
    },
  };
  const minCutoffHz = read.number(inputs.minCutoffHz, 1, 0, 1000);
  const beta = read.number(inputs.beta, 1, 0, 1e9);
  const derivativeCutoffHz = read.number(inputs.derivativeCutoffHz, 1, 0, 1000);
  state.waitedMs += deltaTimeMs;
  const record = inputs.value;
  const triggers = state.inputTriggerNames ?? [];
  // A run triggered by a parameter has no new sample.
  if (record === undefined || (triggers.length > 0 && !triggers.includes('value')))
    return undefined;

  const value = record[record.type] as number | { readonly [part: string]: number };
  const names =
    typeof value === 'number' ? [] : ['x', 'y', 'z', 'w'].filter((name) => name in value);
  let parts = typeof value === 'number' ? [value] : names.map((name) => value[name]!);
  const isRotation = record.type === 'quaternion';
  if (isRotation) {
    const length = Math.hypot(...parts);
    parts = parts.map((part) => part / length);
  }
  // The time of an unusable sample counts for the next one. A quaternion of length 0 is not a rotation,
  // and differences of larger numbers could be infinite.
  if (!parts.every((part) => Math.abs(part) <= 1e150)) return undefined;

  let smoothed = state.smoothed;
  if (smoothed === undefined || smoothed.length !== parts.length) {
    smoothed = parts;
    state.speed = parts.map(() => 0);
  } else if (state.waitedMs > 0) {
    const before = smoothed;
    const seconds = state.waitedMs / 1000;
    // q and -q are the same rotation: use the closer one.
    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i]!, 0) < 0 ? -1 : 1;
    const derivativeShare = read.share(derivativeCutoffHz, seconds);
    state.speed = state.speed.map(
      (old, i) => old + derivativeShare * ((sign * parts[i]! - before[i]!) / seconds - old),
    );
    // A unit quaternion changes by half of the angle.
    const speed = Math.hypot(...state.speed) * (isRotation ? 2 : 1);
    const share = read.share(minCutoffHz + beta * speed, seconds);
    // Interpolate from the closer end, so that rounding cannot exceed either end.
    smoothed = before.map((b, i) => {
      const p = sign * parts[i]!;
      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);
    });
    if (isRotation) {
      const length = Math.hypot(...smoothed);
      smoothed = smoothed.map((part) => part / length);
    }
  }
  state.smoothed = smoothed;
  state.waitedMs = 0;

  if (typeof value === 'number') return { outputs: { smoothed: { double: smoothed[0] } } };
  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));
  return { outputs: { smoothed: { [record.type]: members } } };
}

/** The supported formats. */
type SmoothFormat = 'double' | 'vector2' | 'vector3' | 'vector4' | 'quaternion';

/** Defines the module for one format. All formats share the code; the formats of input and output differ. */
function defineOneEuro<const F extends SmoothFormat>(name: string, format: F) {
  return defineProcessingModule({
    name,
    description: `Smooths a ${format} with a 1€ filter.`,
    tags: ['filter', 'smoothing', 'one-euro'],
    authors: ['Ubi-Interact'],
    version: '1.0.0',
    inputs: {
      value: { format, description: 'Value to smooth.' },
      minCutoffHz: {
        format: 'double',
        default: 1,
        description: 'Cut-off frequency at rest, 0 to 1000 Hz; lower is smoother.',
      },
      beta: {
        format: 'double',
        default: 1,
        description:
          'Speed coefficient, 0 to 1e9: Hz of cut-off per unit per second of speed; higher reduces delay.',
      },
      derivativeCutoffHz: {
        format: 'double',
        default: 1,
        description: 'Cut-off frequency of the speed, 0 to 1000 Hz.',
      },
    },
    outputs: {
      smoothed: { format, description: 'The smoothed value, in the unit of value.' },
    },
    mode: { triggerOnInput: {} },
    createState: (): OneEuroState => ({ smoothed: undefined, speed: [], waitedMs: 0 }),
    // The callback handles all formats, so it does not have the type of one format.
    onProcessing: smooth as () => undefined,
  });
}

/** 1€ filter of a number. */
export const oneEuroFilter = defineOneEuro('one-euro-filter', 'double');
/** 1€ filter of two numbers. */
export const oneEuroFilterVector2 = defineOneEuro('one-euro-filter-vector2', 'vector2');
/** 1€ filter of three numbers. */
export const oneEuroFilterVector3 = defineOneEuro('one-euro-filter-vector3', 'vector3');
/** 1€ filter of four numbers. */
export const oneEuroFilterVector4 = defineOneEuro('one-euro-filter-vector4', 'vector4');
/** 1€ filter of a rotation along the shorter arc. */
export const oneEuroFilterQuaternion = defineOneEuro('one-euro-filter-quaternion', 'quaternion');

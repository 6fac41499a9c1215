import { defineProcessingModule, type ModuleState } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** What the callback knows of any record on `value`. */
type AnyRecord = { readonly type: string } & { readonly [member: string]: unknown };

interface OneEuroState {
  /** The smoothed value: one number, or the parts x, y, z, w as far as there are. */
  smoothed: number[] | undefined;
  /** Smoothed change of each part, per second. */
  speed: number[];
  /** Time that passed without a usable sample, milliseconds. */
  waitedMs: number;
}

interface OneEuroInputs {
  value: AnyRecord | undefined;
  minCutoffHz: NumberRecord | undefined;
  beta: NumberRecord | undefined;
  derivativeCutoffHz: NumberRecord | undefined;
}

/**
 * The same for every format: it goes by what comes in. Self-contained, for it is sent as text.
 *
 * Source: G. Casiez, N. Roussel, D. Vogel: "1€ Filter: A Simple Speed-based Low-pass Filter for Noisy
 * Input in Interactive Systems", CHI 2012, algorithm 1. All parts share one cut-off, from the length of
 * their speed, so that the direction of a movement makes no difference.
 */
function smooth(deltaTimeMs: number, inputs: OneEuroInputs, state: ModuleState<OneEuroState>) {
  const read = {
    value(record: NumberRecord | undefined) {
      return record?.double ?? record?.float ?? record?.int32;
    },
    // What is no finite number counts as not there.
    number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
      const value = this.value(record);
      return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
    },
    /** How far the smoothed value goes towards a new one: the paper's alpha. */
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
  // A run that only a parameter caused brings no new sample.
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
  // The time of a sample that cannot be used belongs to the next one. No rotation has length 0, and the
  // differences of larger numbers could be infinite.
  if (!parts.every((part) => Math.abs(part) <= 1e150)) return undefined;

  let smoothed = state.smoothed;
  if (smoothed === undefined || smoothed.length !== parts.length) {
    smoothed = parts;
    state.speed = parts.map(() => 0);
  } else if (state.waitedMs > 0) {
    const before = smoothed;
    const seconds = state.waitedMs / 1000;
    // q and -q are the same rotation: towards the one that is closer.
    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i]!, 0) < 0 ? -1 : 1;
    const derivativeShare = read.share(derivativeCutoffHz, seconds);
    state.speed = state.speed.map(
      (old, i) => old + derivativeShare * ((sign * parts[i]! - before[i]!) / seconds - old),
    );
    // A unit quaternion changes by half of the angle.
    const speed = Math.hypot(...state.speed) * (isRotation ? 2 : 1);
    const share = read.share(minCutoffHz + beta * speed, seconds);
    // From the end that is closer, so that rounding leads beyond neither.
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

/** The formats it can smooth. */
type SmoothFormat = 'double' | 'vector2' | 'vector3' | 'vector4' | 'quaternion';

/** One module a format, so that its ends say what they take; the code is the same. */
function defineOneEuro<const F extends SmoothFormat>(name: string, format: F) {
  return defineProcessingModule({
    name,
    description: `Smooths a ${format}: strongly while it is slow, hardly while it is fast (1€ filter).`,
    tags: ['filter', 'smoothing', 'one-euro'],
    authors: ['Ubi-Interact'],
    version: '1.0.0',
    inputs: {
      value: format,
      minCutoffHz: { format: 'double', default: 1 },
      beta: { format: 'double', default: 1 },
      derivativeCutoffHz: { format: 'double', default: 1 },
    },
    outputs: { smoothed: format },
    mode: { triggerOnInput: {} },
    createState: (): OneEuroState => ({ smoothed: undefined, speed: [], waitedMs: 0 }),
    // It goes by what comes in, which no type of one format can say.
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
/** 1€ filter of a rotation, on the shorter way round. */
export const oneEuroFilterQuaternion = defineOneEuro('one-euro-filter-quaternion', 'quaternion');

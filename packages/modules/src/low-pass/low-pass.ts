import { defineProcessingModule, type ModuleState } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** What the callback knows of any record on `value`. */
type AnyRecord = { readonly type: string } & { readonly [member: string]: unknown };

interface LowPassState {
  /** The smoothed value: one number, or the parts x, y, z, w as far as there are. */
  smoothed: number[] | undefined;
  /** Time that passed without a usable sample, milliseconds. */
  waitedMs: number;
}

interface LowPassInputs {
  value: AnyRecord | undefined;
  cutoffHz: NumberRecord | undefined;
}

/** The same for every format: it goes by what comes in. Self-contained, for it is sent as text. */
function smooth(deltaTimeMs: number, inputs: LowPassInputs, state: ModuleState<LowPassState>) {
  const read = {
    value(record: NumberRecord | undefined) {
      return record?.double ?? record?.float ?? record?.int32;
    },
    // What is no finite number counts as not there.
    number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
      const value = this.value(record);
      return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
    },
  };
  const cutoffHz = read.number(inputs.cutoffHz, 1, 0, 1000);
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
  } else {
    const before = smoothed;
    // q and -q are the same rotation: towards the one that is closer.
    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i]!, 0) < 0 ? -1 : 1;
    // The exact answer of a first-order low-pass to a value held for this long, so two short steps are
    // one long one.
    const share = -Math.expm1((-2 * Math.PI * cutoffHz * state.waitedMs) / 1000);
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
function defineLowPass<const F extends SmoothFormat>(name: string, format: F) {
  return defineProcessingModule({
    name,
    description: `Smooths a ${format} with a first-order low-pass; right for any interval between records.`,
    tags: ['filter', 'smoothing', 'low-pass'],
    authors: ['Ubi-Interact'],
    version: '1.0.0',
    inputs: { value: format, cutoffHz: { format: 'double', default: 1 } },
    outputs: { smoothed: format },
    mode: { triggerOnInput: {} },
    createState: (): LowPassState => ({ smoothed: undefined, waitedMs: 0 }),
    // It goes by what comes in, which no type of one format can say.
    onProcessing: smooth as () => undefined,
  });
}

/** Exponential smoothing of a number. */
export const lowPass = defineLowPass('low-pass', 'double');
/** Exponential smoothing of two numbers. */
export const lowPassVector2 = defineLowPass('low-pass-vector2', 'vector2');
/** Exponential smoothing of three numbers. */
export const lowPassVector3 = defineLowPass('low-pass-vector3', 'vector3');
/** Exponential smoothing of four numbers. */
export const lowPassVector4 = defineLowPass('low-pass-vector4', 'vector4');
/** Exponential smoothing of a rotation, on the shorter way round. */
export const lowPassQuaternion = defineLowPass('low-pass-quaternion', 'quaternion');

import { defineProcessingModule, type ModuleState } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** A record on `value` in any supported format. */
type AnyRecord = { readonly type: string } & { readonly [member: string]: unknown };

interface LowPassState {
  /** The smoothed value: one number, or the components x, y, z, w that the format has. */
  smoothed: number[] | undefined;
  /** Time since the last usable sample, milliseconds. */
  waitedMs: number;
}

interface LowPassInputs {
  value: AnyRecord | undefined;
  cutoffHz: NumberRecord | undefined;
}

/** Handles records of all formats. Self-contained, because it is sent as text. */
function smooth(deltaTimeMs: number, inputs: LowPassInputs, state: ModuleState<LowPassState>) {
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
  const cutoffHz = read.number(inputs.cutoffHz, 1, 0, 1000);
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
  } else {
    const before = smoothed;
    // q and -q are the same rotation: use the closer one.
    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i]!, 0) < 0 ? -1 : 1;
    // The exact step response of a first-order low-pass filter, so that two short steps give the same
    // result as one long step.
    const share = -Math.expm1((-2 * Math.PI * cutoffHz * state.waitedMs) / 1000);
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
function defineLowPass<const F extends SmoothFormat>(name: string, format: F) {
  return defineProcessingModule({
    name,
    description: `Smooths a ${format} with a low-pass filter.`,
    tags: ['filter', 'smoothing', 'low-pass'],
    authors: ['Ubi-Interact'],
    version: '1.0.0',
    inputs: {
      value: { format, description: 'Value to smooth.' },
      cutoffHz: {
        format: 'double',
        default: 1,
        description: 'Cut-off frequency, 0 to 1000 Hz; lower is smoother, 0 keeps the first value.',
      },
    },
    outputs: {
      smoothed: { format, description: 'The smoothed value, in the unit of value.' },
    },
    mode: { triggerOnInput: {} },
    createState: (): LowPassState => ({ smoothed: undefined, waitedMs: 0 }),
    // The callback handles all formats, so it does not have the type of one format.
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
/** Exponential smoothing of a rotation along the shorter arc. */
export const lowPassQuaternion = defineLowPass('low-pass-quaternion', 'quaternion');

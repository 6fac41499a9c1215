import type { DataFormat } from '@ubii/proto';
import { sliderBound } from '../../../message-form/slider-range.ts';
import type { ButtonSettings, SliderSettings } from './control-settings.ts';

export const SLIDER_FORMATS: readonly DataFormat[] = ['double', 'float', 'int32'];
export const BUTTON_FORMATS: readonly DataFormat[] = ['bool', 'double', 'float', 'int32', 'string'];
export const PAD_FORMATS: readonly DataFormat[] = ['vector2'];
export const TEXT_FORMATS: readonly DataFormat[] = ['string'];

/** Smallest and largest value of an int32. */
const INT32 = { min: -(2 ** 31), max: 2 ** 31 - 1 };
/** Steps of a slider without a step of its own. */
const STEPS = 100;

export interface SliderRange {
  readonly min: number;
  readonly max: number;
  readonly step: number;
}

/**
 * Returns the range of a slider. Ends that are not set contain all values: 0 to 1, 0 to 10, −100 to 100 …
 * @param lowest smallest and `highest` largest value so far
 */
export function sliderRange(
  settings: SliderSettings,
  format: DataFormat,
  { lowest, highest }: { readonly lowest: number; readonly highest: number },
): SliderRange {
  const isInteger = format === 'int32';
  const bound = sliderBound(Math.max(Math.abs(lowest), Math.abs(highest)), isInteger);
  let min = settings.min ?? (lowest < 0 ? -bound : 0);
  let max = settings.max ?? bound;
  if (isInteger) {
    min = Math.max(INT32.min, Math.ceil(min));
    max = Math.min(INT32.max, Math.floor(max));
  }
  // One end was set beyond the other.
  if (min >= max) {
    if (settings.max === undefined) max = min + bound;
    else min = max - bound;
  }
  const step = settings.step ?? (max - min) / STEPS;
  return { min, max, step: isInteger ? Math.max(1, Math.round(step)) : step };
}

/** Returns a number without the digits that a sum of steps adds, such as 0.30000000000000004. */
export const sliderValue = (value: number): number => Number(value.toPrecision(9));

export type ButtonValue = boolean | number | string;

const DEFAULTS = { on: { number: '1', string: 'on' }, off: { number: '0', string: 'off' } };

/** Returns a value of a button, `undefined` when its text is no number of the format. */
export function buttonValue(
  settings: ButtonSettings,
  format: DataFormat,
  which: 'on' | 'off',
): ButtonValue | undefined {
  if (format === 'bool') return which === 'on';
  const typed = settings[which];
  if (format === 'string') return typed ?? DEFAULTS[which].string;
  return readNumber(typed ?? DEFAULTS[which].number, format);
}

/** Returns a typed number, also with a comma; `undefined` for other texts. */
export function readNumber(text: string, format: DataFormat): number | undefined {
  const plain = text.trim().replace('−', '-').replace(',', '.');
  const number = Number(plain);
  if (plain === '' || !Number.isFinite(number)) return undefined;
  if (format !== 'int32') return number;
  const isInt = Number.isInteger(number) && number >= INT32.min && number <= INT32.max;
  return isInt ? number : undefined;
}

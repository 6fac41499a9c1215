import type { DataFormat, JsonObject } from '@ubii/proto';
import * as v from 'valibot';
import { finite, flag, maybe, textUpTo } from '../../../json/schemas.ts';

/** Longest text that a button sends, characters. */
export const MAX_BUTTON_TEXT = 200;

/** Returns the data format in the settings of a control; without one that it sends, the first that it does. */
export function controlFormat(
  { format }: Readonly<JsonObject>,
  formats: readonly DataFormat[],
): DataFormat {
  return formats.find((one) => one === format) ?? formats[0]!;
}

/** Range of a slider; `undefined` members follow the values. */
export interface SliderSettings {
  readonly min: number | undefined;
  readonly max: number | undefined;
  readonly step: number | undefined;
}

const SLIDER = v.object({ min: maybe(finite), max: maybe(finite), step: maybe(finite) });

/** Reads unvalidated settings; omits invalid members, and a range that is empty. */
export function readSliderSettings(settings: Readonly<JsonObject>): SliderSettings {
  const { min, max, step } = v.parse(SLIDER, settings);
  const isEmpty = min !== undefined && max !== undefined && min >= max;
  return {
    min: isEmpty ? undefined : min,
    max: isEmpty ? undefined : max,
    step: step !== undefined && step > 0 ? step : undefined,
  };
}

/** When a button sends: `hold` at press and release, `toggle` the other value at each press, `once` at each press. */
export type ButtonMode = 'hold' | 'toggle' | 'once';

export interface ButtonSettings {
  readonly mode: ButtonMode;
  /** Values as typed; `undefined` for those of the data format. */
  readonly on?: string | undefined;
  readonly off?: string | undefined;
}

const BUTTON = v.object({
  mode: v.fallback(v.picklist(['hold', 'toggle', 'once']), 'hold'),
  on: maybe(textUpTo(MAX_BUTTON_TEXT)),
  off: maybe(textUpTo(MAX_BUTTON_TEXT)),
});

export const readButtonSettings = (settings: Readonly<JsonObject>): ButtonSettings =>
  v.parse(BUTTON, settings);

const PAD = v.object({ surface: flag });

/** Whether the values of a pad are from 0 to 1 with y down. */
export const readIsSurface = (settings: Readonly<JsonObject>): boolean =>
  v.parse(PAD, settings).surface;

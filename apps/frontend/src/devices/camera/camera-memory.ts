import * as v from 'valibot';
import { readStored } from '../../json/read-stored.ts';
import { textOrNone, validElements } from '../../json/schemas.ts';
import type { PictureSettings } from './encode-picture.ts';
import { ENCODINGS, FIRST_SETTINGS, QUALITIES, RATES, WIDTHS } from './picture-choices.ts';

/** Camera settings stored in this browser. */
export interface CameraMemory {
  /** Id of the camera used last; empty: the browser's choice. */
  readonly chosen: string;
  /** By camera id, newest last. */
  readonly settings: ReadonlyMap<string, Readonly<PictureSettings>>;
}

/** Most cameras remembered. Ids change when a browser clears its site data, so old ones are dropped. */
const MAX_CAMERAS = 8;

export const NO_MEMORY: CameraMemory = { chosen: '', settings: new Map() };

/** Returns the last settings of a camera, or the defaults. */
export function settingsOf({ settings }: CameraMemory, camera: string): Readonly<PictureSettings> {
  return settings.get(camera) ?? FIRST_SETTINGS;
}

/** Stores the settings of a camera, and marks it as used last. */
export function remember(
  memory: CameraMemory,
  camera: string,
  settings: Readonly<PictureSettings>,
): CameraMemory {
  if (camera === '') return memory;
  const others = [...memory.settings].filter(([id]) => id !== camera).slice(1 - MAX_CAMERAS);
  return { chosen: camera, settings: new Map([...others, [camera, { ...settings }]]) };
}

export function writeMemory({ chosen, settings }: CameraMemory): string {
  return JSON.stringify({ chosen, settings: [...settings] });
}

/** Each member is validated separately: invalid ones get their default. */
const SETTINGS: v.GenericSchema<unknown, PictureSettings> = v.object({
  width: v.fallback(v.picklist(WIDTHS), FIRST_SETTINGS.width),
  rateHz: v.fallback(v.picklist(RATES), FIRST_SETTINGS.rateHz),
  encoding: v.fallback(v.picklist(ENCODINGS.map(({ value }) => value)), FIRST_SETTINGS.encoding),
  quality: v.fallback(
    v.pipe(v.number(), v.minValue(QUALITIES.min), v.maxValue(QUALITIES.max)),
    FIRST_SETTINGS.quality,
  ),
});

const MEMORY = v.object({
  chosen: textOrNone,
  settings: v.pipe(
    validElements(
      v.tuple([v.pipe(v.string(), v.minLength(1)), v.fallback(SETTINGS, FIRST_SETTINGS)]),
    ),
    v.transform((entries) => new Map(entries.slice(-MAX_CAMERAS))),
  ),
});

/** Returns the valid part of the stored settings, which another program or version may have written. */
export const readMemory = (text: string): CameraMemory => readStored(MEMORY, text) ?? NO_MEMORY;

import type { PictureSettings } from './encode-picture.ts';
import { ENCODINGS, FIRST_SETTINGS, QUALITIES, RATES, WIDTHS } from './picture-choices.ts';

/** What this browser remembers of its cameras. */
export interface CameraMemory {
  /** Id of the one that was used last; empty for the browser's choice. */
  readonly chosen: string;
  /** By id of the camera, the newest last. */
  readonly settings: ReadonlyMap<string, Readonly<PictureSettings>>;
}

/** Ids change when a browser forgets a page: those of long ago are let go of. */
const MOST_CAMERAS = 8;

export const NO_MEMORY: CameraMemory = { chosen: '', settings: new Map() };

/** How the pictures of a camera were sent last, or how they are sent at first. */
export function settingsOf({ settings }: CameraMemory, camera: string): Readonly<PictureSettings> {
  return settings.get(camera) ?? FIRST_SETTINGS;
}

/** The memory with this camera as the one that was used last. */
export function remember(
  memory: CameraMemory,
  camera: string,
  settings: Readonly<PictureSettings>,
): CameraMemory {
  if (camera === '') return memory;
  const others = [...memory.settings].filter(([id]) => id !== camera).slice(1 - MOST_CAMERAS);
  return { chosen: camera, settings: new Map([...others, [camera, { ...settings }]]) };
}

export function writeMemory({ chosen, settings }: CameraMemory): string {
  return JSON.stringify({ chosen, settings: [...settings] });
}

/** Returns the valid part of the stored settings, which another program or version may have written. */
export function readMemory(text: string): CameraMemory {
  try {
    const kept = JSON.parse(text) as { chosen?: unknown; settings?: unknown } | null;
    if (!Array.isArray(kept?.settings)) return NO_MEMORY;
    const settings = (kept.settings as unknown[]).slice(-MOST_CAMERAS).flatMap((entry) => {
      const [id, value] = Array.isArray(entry) ? (entry as unknown[]) : [];
      return typeof id === 'string' && id !== '' ? [[id, readSettings(value)] as const] : [];
    });
    const chosen = typeof kept.chosen === 'string' ? kept.chosen : '';
    return { chosen, settings: new Map(settings) };
  } catch {
    return NO_MEMORY;
  }
}

/** Each member by itself: one that is no choice of today is what it is at first. */
function readSettings(value: unknown): PictureSettings {
  const { width, rateHz, encoding, quality } = (value ?? {}) as {
    [M in keyof PictureSettings]?: unknown;
  };
  const isQuality =
    typeof quality === 'number' && quality >= QUALITIES.min && quality <= QUALITIES.max;
  return {
    width: WIDTHS.find((one) => one === width) ?? FIRST_SETTINGS.width,
    rateHz: RATES.find((one) => one === rateHz) ?? FIRST_SETTINGS.rateHz,
    encoding: ENCODINGS.find((one) => one.value === encoding)?.value ?? FIRST_SETTINGS.encoding,
    quality: isQuality ? quality : FIRST_SETTINGS.quality,
  };
}

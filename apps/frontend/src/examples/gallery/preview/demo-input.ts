import { ButtonEventType, type RecordInit } from '@ubii/proto';
import type { GalleryEntry } from '../gallery.ts';

/** Interval between samples of a demonstration input, milliseconds. */
export const DEMO_INTERVAL_MS = 25;
const CLICK_EVERY_MS = 650;
const CLICK_MS = 160;
const RESET_AFTER_CLICKS = 12;
const KEYS = ['c', 'e', 'g'];
const KEY_EVERY_MS = 450;
/** Amplitude of the jitter that a filter smooths, as a fraction of the surface. */
const TREMBLE = 0.02;

/**
 * Returns the position of a moving pointer.
 * @param tremble amplitude of its jitter
 */
export function demoPointer(atMs: number, tremble = 0): { x: number; y: number } {
  const t = atMs / 1000;
  const shake = (speed: number): number =>
    tremble * Math.sin(t * speed) * Math.sin(t * 2.7 * speed);
  return {
    x: 0.5 + 0.36 * Math.sin(t * 0.9) + shake(23),
    y: 0.5 + 0.32 * Math.sin(t * 1.7) + shake(31),
  };
}

/**
 * Returns the inputs of a preview without user input, for an interval of time. The modules of the
 * preview are the real ones.
 */
export function demoInputs(
  { inputs, view }: Pick<GalleryEntry, 'inputs' | 'view'>,
  fromMs: number,
  toMs: number,
): RecordInit[] {
  const tremble = view.kind === 'surface' && view.trails.length > 0 ? TREMBLE : 0;
  return inputs.flatMap(({ topic, input }): RecordInit[] => {
    switch (input) {
      case 'pointer':
        return [{ topic, format: 'vector2', value: demoPointer(toMs, tremble) }];
      case 'pressed': {
        const isPressed = (ms: number): boolean => ms % CLICK_EVERY_MS < CLICK_MS;
        const now = isPressed(toMs);
        const isNew = isPressed(fromMs) !== now || crosses(fromMs, toMs, CLICK_EVERY_MS);
        return isNew ? [{ topic, format: 'bool', value: now }] : [];
      }
      case 'escape':
        return crosses(fromMs, toMs, CLICK_EVERY_MS * RESET_AFTER_CLICKS)
          ? [
              { topic, format: 'bool', value: true },
              { topic, format: 'bool', value: false },
            ]
          : [];
      case 'key': {
        if (!crosses(fromMs, toMs, KEY_EVERY_MS)) return [];
        // Press one key after the other, then release one after the other.
        const step = Math.floor(toMs / KEY_EVERY_MS) % (KEYS.length * 2);
        const key = KEYS[step % KEYS.length] ?? '';
        const type = step < KEYS.length ? ButtonEventType.DOWN : ButtonEventType.UP;
        return [{ topic, format: 'keyEvent', value: { type, key } }];
      }
    }
  });
}

const crosses = (fromMs: number, toMs: number, everyMs: number): boolean =>
  Math.floor(fromMs / everyMs) !== Math.floor(toMs / everyMs);

import { ButtonEventType, TouchEventType } from '@ubii/proto';
import type { DataFormat } from '@ubii/proto';

/** What a button does, as Home Assistant lists it. */
export const BUTTON_EVENTS = ['press', 'release'] as const;

/** Formats of events that `eventOf` reads. */
export const BUTTON_FORMATS: readonly DataFormat[] = ['keyEvent', 'mouseEvent', 'touchEvent'];

/**
 * Returns what a button, a key or a finger did.
 *
 * @throws Error for other values, and for a finger that moves
 */
export function eventOf(record: {
  readonly format: DataFormat;
  readonly value: unknown;
}): (typeof BUTTON_EVENTS)[number] {
  const { type } = record.value as { readonly type: number };
  switch (record.format) {
    case 'keyEvent':
    case 'mouseEvent':
      return type === ButtonEventType.DOWN ? 'press' : 'release';
    case 'touchEvent':
      if (type === TouchEventType.TOUCH_START) return 'press';
      if (type === TouchEventType.TOUCH_END) return 'release';
      throw new Error('A finger that moves is no event of a button.');
    default:
      throw new Error(`A value of ${record.format} is no event of a button.`);
  }
}

import type { UbiiClient } from '@ubii/client-web';
import type { Mark } from '@ubii/proto';
import { shallowRef } from 'vue';
import type { OwnMark } from './connection.ts';

const MARK_KEY = 'ubii.mark';

/** The mark that this browser kept; `undefined` without one, or when it cannot be read. */
export function keptMark(storage: Pick<Storage, 'getItem'>): Mark | undefined {
  try {
    const { shape, colour, chosen } = JSON.parse(storage.getItem(MARK_KEY) ?? 'null') as Mark;
    if (!Number.isInteger(shape) || !Number.isInteger(colour)) return undefined;
    return { shape, colour, chosen: chosen === true };
  } catch {
    return undefined;
  }
}

/** Follows the mark that the master gives, and keeps the one that a person takes. [EX-100] */
export function createOwnMark(
  client: Pick<UbiiClient, 'mark' | 'onState' | 'updateProfile'>,
  storage: Pick<Storage, 'getItem' | 'setItem'>,
): OwnMark {
  const kept = shallowRef(keptMark(storage));
  const told = (): Mark | undefined => client.mark as Mark | undefined;
  const current = shallowRef(told());
  client.onState(() => (current.value = told()));
  return {
    current,
    kept,
    set(mark) {
      kept.value = mark;
      storage.setItem(MARK_KEY, JSON.stringify(mark));
      const telling = client.updateProfile({ mark });
      current.value = told();
      // What the master refuses it says in the connection's state; it may have given another mark.
      void telling.catch(() => undefined).then(() => (current.value = told()));
    },
  };
}

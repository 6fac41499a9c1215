import { describe, expect, it } from 'vitest';
import { shallowRef } from 'vue';
import { EMPTY_ROOM, nextRoom, RoomRefusal, type RoomEvent } from '../sim/index.ts';
import { useRefusal } from './useRefusal.ts';

const proceed: RoomEvent = { type: 'proceed', by: 'host' };

/** A room that changes as the host and phones ask. */
function party() {
  const room = shallowRef(EMPTY_ROOM);
  const change = (event: RoomEvent): void => void (room.value = nextRoom(room.value, event, 1000));
  const link = {
    nowMs: () => 1000,
    apply(event: RoomEvent): string | undefined {
      try {
        change(event);
        return undefined;
      } catch (cause) {
        if (cause instanceof RoomRefusal) return cause.message;
        throw cause;
      }
    },
  };
  return { change, ...useRefusal(link, () => room.value) };
}

describe('refusal on the big screen', () => {
  it('is shown until its reason no longer holds', () => {
    const { apply, change, refusal } = party();
    apply(proceed);
    expect(refusal.value).toMatchObject({ event: proceed });
    change({ type: 'join', key: 'ada', name: 'Ada' });
    expect(refusal.value?.sentence).toContain('2 players');
    change({ type: 'join', key: 'bob', name: 'Bob' });
    expect(refusal.value).toBeUndefined();
  });

  it('goes with the next event that is not refused, and when the host dismisses it', () => {
    const { apply, dismiss, refusal } = party();
    apply(proceed);
    apply({ type: 'fill', by: 'host', players: 2 });
    expect(refusal.value).toBeUndefined();
    apply({ type: 'set-games', by: 'host', games: [] });
    expect(refusal.value).toBeDefined();
    dismiss();
    expect(refusal.value).toBeUndefined();
  });
});

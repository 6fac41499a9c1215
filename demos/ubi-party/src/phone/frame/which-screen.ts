import { shallowRef, watch } from 'vue';

import type { PhoneFacts } from '../../net/phone/phone-link.ts';
import type { Player, Room, Spectator } from '../../sim/index.ts';
import type { PhoneContext } from './phone-context.ts';

export type ScreenName =
  | 'join'
  | 'removed'
  | 'watch'
  | 'lobby'
  | 'explanation'
  | 'play'
  | 'waiting'
  | 'result';

/** Why a phone has no seat any more, or watches no longer. */
export type Removal = 'taken-over' | 'timed-out' | 'removed' | 'dismissed';

/**
 * @param lost why the phone lost a seat that it had and did not give back; undefined: it had none
 */
export function screenOf(
  facts: Pick<PhoneFacts, 'view' | 'me'> & Partial<Pick<PhoneFacts, 'spectator'>>,
  lost?: Removal,
): ScreenName {
  const { view, me, spectator } = facts;
  if (view && !me && spectator) return 'watch';
  if (!view || !me) return lost ? 'removed' : 'join';
  const { phase } = view.room;
  if (phase === 'lobby') return 'lobby';
  if (phase === 'end') return 'result';
  if (me.isWaiting) return 'waiting';
  if (phase === 'podium') return 'result';
  // The pads are there during the countdown, so that thumbs find their place.
  return phase === 'explanation' ? 'explanation' : 'play';
}

/**
 * @param last what the phone knew of itself while it had the seat
 * @param wasLost the connection was lost before the seat was
 */
export function removalOf(room: Room, last: Player, wasLost: boolean): Removal {
  const now = room.players.find(({ seat }) => seat === last.seat);
  if (now && now.key !== undefined && now.key !== last.key && now.name === last.name)
    return 'taken-over';
  return wasLost ? 'timed-out' : 'removed';
}

/** Detects why this phone loses its seat, or its place to watch: the player left, or a reason that the page shows. */
export function useSeat({ facts, me, spectator, room }: PhoneContext) {
  const removal = shallowRef<Removal>();
  let isLeaving = false;
  let last: Player | undefined;
  let lastWatching: Spectator | undefined;
  /** As it was when the connection was lost; the same one is no news after it. */
  let roomAtLoss: Room | undefined;

  watch(
    [me, () => facts.value.link, room, spectator] as const,
    ([player, link, now, watching]) => {
      if (link === 'lost') roomAtLoss = now;
      if (player ?? watching) {
        last = player;
        lastWatching = watching;
        if (link === 'connected' && now !== roomAtLoss) roomAtLoss = undefined;
        removal.value = undefined;
        isLeaving = false;
        return;
      }
      if (!(last ?? lastWatching) || !now || link === 'lost') return;
      // The host removes players that were away for long, also behind another page
      const wasLost = roomAtLoss !== undefined || (last ?? lastWatching)?.awaySinceMs !== undefined;
      // A spectator who was away too long joins again at the start page
      const dismissal = wasLost ? undefined : 'dismissed';
      const reason = last ? removalOf(now, last, wasLost) : dismissal;
      removal.value = isLeaving ? undefined : reason;
      last = undefined;
      lastWatching = undefined;
    },
    { immediate: true, flush: 'sync' },
  );

  return {
    removal,
    /** Before the player gives the seat back. */
    leave: () => void (isLeaving = true),
    /** The player has read it. */
    forget: () => void (removal.value = undefined),
  };
}

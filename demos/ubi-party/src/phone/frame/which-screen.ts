import type { Player, Room } from '../../sim/index.ts';
import type { PhoneFacts } from '../../net/phone/phone-link.ts';

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

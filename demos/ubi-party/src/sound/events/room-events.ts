import type { RoomView } from '../../net/index.ts';
import type { Room } from '../../sim/index.ts';
import { leaderOf } from '../music/mood.ts';
import type { SoundEvent } from './sound-event.ts';

/** Sound events of a change of the room. */
export function roomEvents(before: RoomView | undefined, after: RoomView): SoundEvent[] {
  if (!before) return [];
  const [was, is] = [before.room, after.room];
  const events: SoundEvent[] = [];
  for (const { seat, key, isReady } of is.players) {
    const old = was.players.find((player) => player.seat === seat);
    if (!old) events.push({ kind: 'join', seat });
    // Bots are always ready
    else if (isReady && !old.isReady && key !== undefined) events.push({ kind: 'ready', seat });
  }
  for (const { seat } of was.players)
    if (!is.players.some((player) => player.seat === seat)) events.push({ kind: 'leave', seat });
  return is.phase === was.phase ? events : [...events, ...phaseEvents(is)];
}

function phaseEvents(room: Room): SoundEvent[] {
  switch (room.phase) {
    case 'play':
      return [{ kind: 'go' }];
    case 'podium':
      return (room.results.at(-1)?.places[0] ?? [])
        .slice(0, 3)
        .map((seat) => ({ kind: 'flourish', seat }));
    case 'end':
      return [{ kind: 'flourish', seat: leaderOf(room) }];
    default:
      return [];
  }
}

/** The wooden block of 3, 2, 1. @param left whole seconds of a countdown; undefined: there is none */
export function countEvents(before: number | undefined, left: number | undefined): SoundEvent[] {
  return left !== undefined && left !== before && left >= 1 && left <= 3
    ? [{ kind: 'count', left }]
    : [];
}

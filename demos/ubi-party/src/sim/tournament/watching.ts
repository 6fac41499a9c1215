import type { Seat } from '../game.ts';
import { MAX_SEATS } from '../seats/identity.ts';
import { distinctName, toName } from './names.ts';
import type { Room, Spectator } from './room.ts';
import { RoomRefusal } from './room-event.ts';

/** With those who play, fewer than the host remembers phones. */
export const MAX_SPECTATORS = 64;
const NAMELESS = 'Guest';

/** Reactions that a phone can send; the big screen shows them beside the piece or the name. */
export const CHEERS = ['nice', 'love', 'great', 'hooray'] as const;
export type CheerKind = (typeof CHEERS)[number];

export interface Cheer {
  readonly kind: CheerKind;
  /** The client that cheers. */
  readonly key: string;
  readonly name: string;
  /** Undefined: a spectator. */
  readonly seat?: Seat;
}

/** Watches without a seat, also when the game is locked or full. */
export function watch(room: Room, key: string, name: string): Room {
  if (room.players.some((player) => player.key === key))
    throw new RoomRefusal('This phone already has a seat. Leave it first.');
  const others = room.spectators.filter((one) => one.key !== key);
  if (others.length >= MAX_SPECTATORS)
    throw new RoomRefusal(`The limit of ${MAX_SPECTATORS} spectators is reached.`);
  const taken = [...room.players, ...others].map((one) => one.name);
  const spectator = { key, name: distinctName(taken, toName(name) || NAMELESS) };
  return { ...room, spectators: [...others, spectator] };
}

export function withoutSpectators(room: Room, isGone: (one: Spectator) => boolean): Room {
  return room.spectators.some(isGone)
    ? { ...room, spectators: room.spectators.filter((one) => !isGone(one)) }
    : room;
}

/** Whether all seats, or all places to watch, are taken by people; false for the seats of a locked game. */
export function isFull({ isLocked, players, spectators }: Room, as: 'join' | 'watch'): boolean {
  if (as === 'watch') return spectators.length >= MAX_SPECTATORS;
  return !isLocked && players.filter(({ key }) => key !== undefined).length >= MAX_SEATS;
}

/** Why nobody can get a seat now, one sentence; undefined: somebody can. Bots leave when people come. */
export function whyNoSeat(room: Room): string | undefined {
  if (room.isLocked) return 'The game is locked. Ask the host to let you in.';
  return isFull(room, 'join') ? `All ${MAX_SEATS} seats are taken.` : undefined;
}

/** A reaction of somebody who plays or watches; undefined: of nobody here, at no time for it, or of no known kind. */
export function cheerOf(room: Room, key: string, kind: string): Cheer | undefined {
  const isTime = room.phase === 'play' || room.phase === 'podium';
  if (!isTime || !isCheer(kind)) return undefined;
  const player = room.players.find((one) => one.key === key);
  if (player) return { kind, key, name: player.name, seat: player.seat };
  const spectator = room.spectators.find((one) => one.key === key);
  return spectator && { kind, key, name: spectator.name };
}

const isCheer = (kind: string): kind is CheerKind => (CHEERS as readonly string[]).includes(kind);

import type { Seat } from '../game.ts';
import { MAX_SEATS, identityOf } from '../seats/identity.ts';
import { RoomRefusal, type Room, type Spectator, type Player } from './room.ts';

const MAX_NAME = 16;

/** Without control characters and space around it, short enough for a sign under a piece. */
function toName(text: string): string {
  return [...text.replace(/[\p{C}\s]+/gu, ' ').trim()].slice(0, MAX_NAME).join('');
}

function distinctName(taken: readonly string[], name: string): string {
  let distinct = name;
  for (let number = 2; taken.includes(distinct); number += 1) distinct = `${name} ${number}`;
  return distinct;
}

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

/** Why no seat is available, one sentence; undefined: a seat is available. A person replaces a bot. */
export function whyNoSeat(room: Room): string | undefined {
  if (room.isLocked) return 'The game is locked. Ask the host to let you in.';
  return isFull(room, 'join') ? `All ${MAX_SEATS} seats are taken.` : undefined;
}

/** A reaction of a player or spectator; undefined for other clients, in other phases, and for unknown kinds. */
export function cheerOf(room: Room, key: string, kind: string): Cheer | undefined {
  const isTime = room.phase === 'play' || room.phase === 'podium';
  if (!isTime || !isCheer(kind)) return undefined;
  const player = room.players.find((one) => one.key === key);
  if (player) return { kind, key, name: player.name, seat: player.seat };
  const spectator = room.spectators.find((one) => one.key === key);
  return spectator && { kind, key, name: spectator.name };
}

const isCheer = (kind: string): kind is CheerKind => (CHEERS as readonly string[]).includes(kind);

/** The seat of an absent player is kept this long, milliseconds. */
export const KEPT_FOR_MS = 2 * 60_000;

/** Assigns a seat: a known player keeps theirs; a new player gets the first free one, or that of a bot. */
export function join(room: Room, key: string, name: string): Room {
  if (room.players.some((player) => player.key === key)) {
    return setAway(changed(room, key, { name: toName(name) }), key, undefined);
  }
  const refusal = whyNoSeat(room);
  if (refusal !== undefined) throw new RoomRefusal(refusal);
  const seat = freeSeat(room) ?? room.players.find((player) => player.key === undefined)!.seat;
  const taken = room.players.map((player) => player.name);
  const player: Player = {
    seat,
    key,
    name: distinctName(taken, toName(name) || identityOf(seat).letter),
    isReady: false,
    isWaiting: room.phase !== 'lobby' && room.phase !== 'end',
    points: 0,
  };
  const others = withoutSpectators(room, (one) => one.key === key);
  return seated({ ...others, leader: room.leader ?? seat }, player);
}

/** The lead passes to the next present person. */
export function remove(room: Room, isGone: (player: Player) => boolean): Room {
  const players = room.players.filter((player) => !isGone(player));
  const { leader, ...rest } = room;
  if (players.some(({ seat }) => seat === leader)) return { ...room, players };
  const next =
    players.find(({ key, awaySinceMs }) => key !== undefined && awaySinceMs === undefined) ??
    players.find(({ key }) => key !== undefined);
  return { ...rest, players, ...(next && { leader: next.seat }) };
}

export function removeLongAway(room: Room, nowMs: number): Room {
  const isGone = ({ awaySinceMs }: Pick<Player, 'awaySinceMs'>): boolean =>
    awaySinceMs !== undefined && nowMs - awaySinceMs >= KEPT_FOR_MS;
  const left = room.players.some(isGone) ? remove(room, isGone) : room;
  return withoutSpectators(left, isGone);
}

export function setAway(room: Room, key: string, sinceMs: number | undefined): Room {
  const change = <One extends Pick<Player, 'key' | 'awaySinceMs'>>(one: One): One => {
    if (one.key !== key) return one;
    const { awaySinceMs, ...rest } = one;
    const away = sinceMs === undefined ? {} : { awaySinceMs: awaySinceMs ?? sinceMs };
    return { ...rest, ...away } as One;
  };
  return { ...room, players: room.players.map(change), spectators: room.spectators.map(change) };
}

export function setReady(room: Room, key: string, isReady: boolean): Room {
  return changed(room, key, { isReady });
}

export function handOver(room: Room, key: string, to: string): Room {
  if (!room.players.some((player) => player.key === key))
    throw new RoomRefusal('Another phone has this seat.');
  if (room.players.some((player) => player.key === to))
    throw new RoomRefusal('This phone already has a seat. Leave it first.');
  const others = withoutSpectators(room, (one) => one.key === to);
  return setAway(changed(others, key, { key: to }), to, undefined);
}

/** @param players how many shall play in all; more than there are is filled with bots, fewer removes bots */
export function fill(room: Room, players: number): Room {
  const people = room.players.filter(({ key }) => key !== undefined);
  let filled: Room = { ...room, players: people };
  for (let count = people.length; count < Math.min(players, MAX_SEATS); count += 1) {
    const seat = freeSeat(filled)!;
    const bot = { seat, name: `Bot ${identityOf(seat).letter}`, isReady: true, isWaiting: false };
    filled = seated(filled, { ...bot, points: 0 });
  }
  return filled;
}

function freeSeat({ players }: Room): Seat | undefined {
  const taken = new Set(players.map(({ seat }) => seat));
  return Array.from({ length: MAX_SEATS }, (_, seat) => seat).find((seat) => !taken.has(seat));
}

function seated(room: Room, player: Player): Room {
  const others = room.players.filter(({ seat }) => seat !== player.seat);
  return { ...room, players: [...others, player].sort((a, b) => a.seat - b.seat) };
}

function changed(room: Room, key: string, change: Partial<Player>): Room {
  const players = room.players.map((player) =>
    player.key === key ? { ...player, ...change } : player,
  );
  return { ...room, players };
}

type Person = Pick<Player, 'key' | 'awaySinceMs'>;

/**
 * Returns the client whose place a new client gets when all places are taken: one of the address with the most places, if it has
 * at least two more than the address of the new client. An absent client gives its place first, else the last one. Places are
 * divided between addresses, and joining again has no advantage.
 *
 * @param people who have a place, in their order
 * @param asker key of the client that asks
 * @param addresses what clients of one address share, by key; clients without one neither give nor get a place
 * @returns the key of the client that gives its place; undefined: none
 */
export function crowderOf(
  people: readonly Person[],
  asker: string,
  addresses: ReadonlyMap<string, string>,
): string | undefined {
  const own = addresses.get(asker);
  if (own === undefined) return undefined;
  const byAddress = new Map<string, Person[]>();
  for (const person of people) {
    const address = person.key === undefined ? undefined : addresses.get(person.key);
    if (address === undefined) continue;
    byAddress.set(address, [...(byAddress.get(address) ?? []), person]);
  }
  const share = byAddress.get(own)?.length ?? 0;
  const [largest] = [...byAddress.values()].sort((a, b) => b.length - a.length);
  if (largest === undefined || largest.length < share + 2) return undefined;
  const one = largest.find(({ awaySinceMs }) => awaySinceMs !== undefined) ?? largest.at(-1);
  return one?.key;
}

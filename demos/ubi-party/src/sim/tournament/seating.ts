import type { Seat } from '../game.ts';
import { identityOf, MAX_SEATS } from '../seats/identity.ts';
import { distinctName, toName } from './names.ts';
import type { Player, Room } from './room.ts';
import { RoomRefusal } from './room-event.ts';
import { whyNoSeat, withoutSpectators } from './watching.ts';

/** A seat is kept so long for who is away, milliseconds. */
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

/** The lead passes on to the next person who is there. */
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

import type { Seat } from '../game.ts';
import { identityOf, MAX_SEATS } from '../seats/identity.ts';
import type { Player, Room } from './room.ts';
import { RoomRefusal } from './room-event.ts';

/** A seat is kept so long for who is away, milliseconds. */
export const KEPT_FOR_MS = 2 * 60_000;
const MAX_NAME = 16;

/** Who has a seat already gets that one; a new player gets the first free one, or that of a bot. */
export function join(room: Room, key: string, name: string): Room {
  if (room.players.some((player) => player.key === key)) {
    return setAway(changed(room, key, { name: toName(name) }), key, undefined);
  }
  if (room.isLocked) throw new RoomRefusal('The game is locked. Ask the host to let you in.');
  const seat = freeSeat(room) ?? room.players.find((player) => player.key === undefined)?.seat;
  if (seat === undefined) throw new RoomRefusal(`All ${MAX_SEATS} seats are taken.`);
  const player: Player = {
    seat,
    key,
    name: distinctName(room, toName(name) || identityOf(seat).letter),
    isReady: false,
    isWaiting: room.phase !== 'lobby' && room.phase !== 'end',
    points: 0,
  };
  return seated({ ...room, leader: room.leader ?? seat }, player);
}

/** Who leads hands on to the next person who is there. */
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
  const isGone = ({ awaySinceMs }: Player): boolean =>
    awaySinceMs !== undefined && nowMs - awaySinceMs >= KEPT_FOR_MS;
  return room.players.some(isGone) ? remove(room, isGone) : room;
}

export function setAway(room: Room, key: string, sinceMs: number | undefined): Room {
  const players = room.players.map((player) => {
    if (player.key !== key) return player;
    const { awaySinceMs, ...rest } = player;
    return sinceMs === undefined ? rest : { ...rest, awaySinceMs: awaySinceMs ?? sinceMs };
  });
  return { ...room, players };
}

export function setReady(room: Room, key: string, isReady: boolean): Room {
  return changed(room, key, { isReady });
}

export function handOver(room: Room, key: string, to: string): Room {
  if (!room.players.some((player) => player.key === key))
    throw new RoomRefusal('Another phone has this seat.');
  if (room.players.some((player) => player.key === to))
    throw new RoomRefusal('This phone has a seat already. Leave it first.');
  return setAway(changed(room, key, { key: to }), to, undefined);
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

/** Without control characters and space around it, short enough for a sign under a piece. */
function toName(text: string): string {
  return [...text.replace(/[\p{C}\s]+/gu, ' ').trim()].slice(0, MAX_NAME).join('');
}

function distinctName({ players }: Room, name: string): string {
  const names = new Set(players.map((player) => player.name));
  let distinct = name;
  for (let number = 2; names.has(distinct); number += 1) distinct = `${name} ${number}`;
  return distinct;
}

import type { Places, Seat, GameSettings } from '../game.ts';
import { GAMES, type GameId } from '../games.ts';
import {
  watch,
  withoutSpectators,
  fill,
  handOver,
  join,
  remove,
  removeLongAway,
  setAway,
  setReady,
} from './members.ts';
import {
  RoomRefusal,
  COUNTDOWN_MS,
  isPace,
  readingMs,
  gameOf,
  playersOf,
  type Room,
  type Pace,
  type Phase,
  type Asker,
  type RoomEvent,
} from './room.ts';

/** By place; players who share a place all get its points. */
const BY_PLACE = [10, 8, 6, 5, 4, 3, 2, 1];

/** The points of a round, by seat. Everybody who played gets one at least. */
function pointsOf(places: Places): Record<Seat, number> {
  const points: Record<Seat, number> = {};
  let place = 0;
  for (const seats of places) {
    for (const seat of seats) points[seat] = BY_PLACE[place] ?? 1;
    place += seats.length;
  }
  return points;
}

/** The greatest setting that modules accept. */
const MAX_SETTING = 5;

/** Changes a setting of a game. Default values are not kept. */
function setSetting(room: Room, game: string, setting: string, value: number): Room {
  const defaults = Object.hasOwn(GAMES, game)
    ? (GAMES[game as keyof typeof GAMES].settings as GameSettings)
    : {};
  if (!Object.hasOwn(defaults, setting) || !Number.isFinite(value))
    throw new RoomRefusal('This game does not have this setting.');
  const { [game]: before = {}, ...others } = room.settings;
  const { [setting]: _, ...rest } = before;
  const kept = Math.min(MAX_SETTING, Math.max(0, value));
  const changed = kept === defaults[setting] ? rest : { ...rest, [setting]: kept };
  const hasDefaults = Object.keys(changed).length === 0;
  return { ...room, settings: hasDefaults ? others : { ...others, [game]: changed } };
}

export const MIN_PLAYERS = 2;
const MAX_TEAMS = 4;

/**
 * The room after an event. Pure: what is stored of a room is enough to go on.
 *
 * @param nowMs milliseconds since the Unix epoch, master's clock
 * @throws RoomRefusal with the sentence for who asked; the room stays as it was
 */
export function nextRoom(room: Room, event: RoomEvent, nowMs: number): Room {
  switch (event.type) {
    case 'join':
      return join(room, event.key, event.name);
    case 'watch':
      return watch(room, event.key, event.name);
    case 'leave':
      return withoutSpectators(
        remove(room, (player) => player.key === event.key),
        ({ key }) => key === event.key,
      );
    case 'away':
      return setAway(room, event.key, nowMs);
    case 'back':
      return setAway(room, event.key, undefined);
    case 'hand-over':
      return handOver(room, event.key, event.to);
    case 'ready':
      return whenAllReady(setReady(room, event.key, event.isReady), nowMs);
    case 'round-over':
      return endRound(room, event.places, nowMs);
    case 'time':
      return passTime(room, nowMs);
    default:
      checkLeads(room, event.by);
      return lead(room, event, nowMs);
  }
}

function lead(room: Room, event: Extract<RoomEvent, { by: Asker }>, nowMs: number): Room {
  switch (event.type) {
    case 'kick':
      return remove(room, ({ seat }) => seat === event.seat);
    case 'dismiss':
      return withoutSpectators(room, ({ key }) => key === event.key);
    case 'lead':
      if (!room.players.some(({ seat, key }) => seat === event.seat && key !== undefined))
        throw new RoomRefusal('No player has this seat.');
      return { ...room, leader: event.seat };
    case 'lock':
      return { ...room, isLocked: event.on };
    case 'hide-code':
      return { ...room, isCodeHidden: event.on };
    case 'set-teams':
      checkInLobby(room, 'Teams');
      if (
        !Number.isInteger(event.teams) ||
        event.teams < 0 ||
        event.teams > MAX_TEAMS ||
        event.teams === 1
      )
        throw new RoomRefusal(`Choose no teams, or 2 to ${MAX_TEAMS}.`);
      return { ...room, teams: event.teams };
    case 'set-games':
      checkInLobby(room, 'Games');
      if (event.games.length === 0) throw new RoomRefusal('Choose at least one game.');
      return { ...room, games: event.games };
    case 'set-pace':
      return setPace(room, event.pace);
    case 'set-setting':
      return setSetting(room, event.game, event.setting, event.value);
    case 'fill':
      checkInLobby(room, 'Bots');
      return fill(room, event.players);
    case 'proceed':
      return proceed(room, nowMs);
  }
}

function checkLeads(room: Room, by: Asker): void {
  if (by === 'host') return;
  const leader = room.players.find(({ seat }) => seat === room.leader);
  if (leader?.key !== by.key)
    throw new RoomRefusal(`${leader?.name ?? 'The host'} leads the game.`);
}

function checkInLobby({ phase }: Room, what: string): void {
  if (phase !== 'lobby') throw new RoomRefusal(`${what} can be changed in the lobby only.`);
}

/** Enters the next phase, by timer or on the leader's request. */
function proceed(room: Room, nowMs: number): Room {
  switch (room.phase) {
    case 'lobby':
      if (room.players.length < MIN_PLAYERS)
        throw new RoomRefusal(`A game needs ${MIN_PLAYERS} players. Bots can fill the seats.`);
      return read(everybodyPlays(room), 'explanation', nowMs);
    case 'explanation':
      return enter(room, 'countdown', nowMs + COUNTDOWN_MS);
    case 'countdown':
      return enter(room, 'play');
    case 'play':
      throw new RoomRefusal('The round is being played.');
    case 'podium':
      return room.results.length < room.games.length
        ? read(everybodyPlays(room), 'explanation', nowMs)
        : enter(room, 'end');
    case 'end':
      return enter(newTable(everybodyPlays(room)), 'lobby');
  }
}

function enter(room: Room, phase: Phase, endsAtMs?: number): Room {
  const { endsAtMs: _, ...rest } = room;
  const players = rest.players.map((player) => ({ ...player, isReady: player.key === undefined }));
  return { ...rest, players, phase, ...(endsAtMs !== undefined && { endsAtMs }) };
}

/** A phase that ends when its reading time is over. */
function read(room: Room, phase: 'explanation' | 'podium', nowMs: number): Room {
  const next = enter(room, phase);
  return { ...next, endsAtMs: nowMs + readingMs(phase, room.pace, rulesOf(next))! };
}

/** Changes the pace; the end of a current reading phase moves with it. */
function setPace(room: Room, pace: Pace): Room {
  if (!isPace(pace)) throw new RoomRefusal('The pace is normal, relaxed or long.');
  if (room.phase === 'countdown' || room.phase === 'play')
    throw new RoomRefusal('The pace can be changed between rounds only.');
  const { phase, endsAtMs } = room;
  const game = rulesOf(room);
  const before = readingMs(phase, room.pace, game);
  if (before === undefined || endsAtMs === undefined) return { ...room, pace };
  return { ...room, pace, endsAtMs: endsAtMs - before + readingMs(phase, pace, game)! };
}

/** Undefined in the lobby. */
function rulesOf(room: Room): (typeof GAMES)[GameId] | undefined {
  const id = gameOf(room);
  return id === undefined ? undefined : GAMES[id as GameId];
}

function everybodyPlays(room: Room): Room {
  return { ...room, players: room.players.map((player) => ({ ...player, isWaiting: false })) };
}

function newTable(room: Room): Room {
  return {
    ...room,
    results: [],
    players: room.players.map((player) => ({ ...player, points: 0 })),
  };
}

/**
 * An explanation or a podium ends when all players who are present are ready: absent players do not block it, and bots
 * alone do not end it.
 */
function whenAllReady(room: Room, nowMs: number): Room {
  const isAsked = room.phase === 'explanation' || room.phase === 'podium';
  const present = playersOf(room).filter(({ awaySinceMs }) => awaySinceMs === undefined);
  const isAnybodyHere = present.some(({ key }) => key !== undefined);
  return isAsked && isAnybodyHere && present.every(({ isReady }) => isReady)
    ? proceed(room, nowMs)
    : room;
}

function endRound(room: Room, places: Places, nowMs: number): Room {
  const game = gameOf(room);
  if (room.phase !== 'play' || game === undefined)
    throw new RoomRefusal('No round is being played.');
  const points = pointsOf(places);
  const players = room.players.map((player) => ({
    ...player,
    points: player.points + (points[player.seat] ?? 0),
  }));
  const results = [...room.results, { game, places, points }];
  return read({ ...room, players, results }, 'podium', nowMs);
}

function passTime(room: Room, nowMs: number): Room {
  const left = removeLongAway(room, nowMs);
  if (left.endsAtMs !== undefined && nowMs >= left.endsAtMs) return proceed(left, nowMs);
  // The last player who was not ready may be gone. Here and not when one goes: several may go at once
  return whenAllReady(left, nowMs);
}

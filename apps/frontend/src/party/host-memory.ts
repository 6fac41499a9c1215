import type { HostMemory, HostStorage } from '@ubii/party/net';
import { PACES, PHASES, toRoom, type Pace } from '@ubii/party/sim';
import * as v from 'valibot';
import { readStored } from '../json/read-stored.ts';
import { finite } from '../json/schemas.ts';

const MEMORY_KEY = 'ubii.party';

const seat = v.pipe(v.number(), v.integer());
const places = v.array(v.array(seat));
const numbers = v.record(v.string(), finite);
const person = { name: v.string(), awaySinceMs: v.optional(finite) };

const PLAYER = v.object({
  ...person,
  seat,
  key: v.optional(v.string()),
  isReady: v.boolean(),
  isWaiting: v.boolean(),
  points: finite,
});

/** Rooms of earlier versions lack members, which get the values of an empty room. */
const ROOM = v.object({
  phase: v.optional(v.picklist(PHASES)),
  endsAtMs: v.optional(finite),
  players: v.optional(v.array(PLAYER)),
  spectators: v.optional(v.array(v.object({ ...person, key: v.string() }))),
  leader: v.optional(seat),
  isLocked: v.optional(v.boolean()),
  isCodeHidden: v.optional(v.boolean()),
  teams: v.optional(finite),
  games: v.optional(v.array(v.string())),
  results: v.optional(v.array(v.object({ game: v.string(), places, points: numbers }))),
  settings: v.optional(v.record(v.string(), numbers)),
  pace: v.optional(v.picklist(Object.keys(PACES) as Pace[])),
});

const MEMORY = v.object({
  room: v.pipe(
    ROOM,
    v.transform((room) => toRoom(room)),
  ),
  round: v.optional(
    v.object({
      id: v.string(),
      game: v.string(),
      seed: finite,
      startsAtMs: finite,
      seats: v.array(seat),
      pace: v.optional(finite),
      sessionId: v.optional(v.string()),
    }),
  ),
  sinceMs: v.optional(finite),
  arePhotosHidden: v.optional(v.boolean()),
  state: v.optional(
    v.object({ id: v.string(), step: finite, state: v.unknown(), places, isOver: v.boolean() }),
  ),
});

/** Storage of the party in this browser; an invalid one starts a new party. */
export const hostStorage: HostStorage = {
  load(): HostMemory | undefined {
    try {
      return readStored(MEMORY, localStorage.getItem(MEMORY_KEY));
    } catch {
      return undefined; // Storage is blocked.
    }
  },
  save(memory) {
    try {
      localStorage.setItem(MEMORY_KEY, JSON.stringify(memory));
    } catch {
      // The party continues; a reload would start a new one.
    }
  },
};

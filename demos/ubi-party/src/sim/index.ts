export { NEWS_STEPS, type Hud } from './hud.ts';
export type { Controller, Feedback, Question } from './feedback.ts';
export * from './game.ts';
export { GAMES, type GameId } from './games.ts';
export { isSignalled, type DuelState } from './duel/duel-game.ts';
export * from './hill/hill-state.ts';
export { nextRing, RINGS, SUDDEN_DEATH_AT } from './hill/rings.ts';
export { gainsOf, ordinal } from './hunt/hunt-points.ts';
export {
  nowMsOf,
  THINGS_A_ROUND,
  type Hunt,
  type HuntPhoto,
  type HuntState,
} from './hunt/hunt-state.ts';
export { THINGS, thingOf, type Thing } from './hunt/things.ts';
export { lapOf, trackOf, type Cart, type RaceState } from './race/race-state.ts';
export { placeAt, type Track, type TrackPoint } from './race/track.ts';
export { TRACKS } from './race/tracks.ts';
export { identityOf, MAX_SEATS, type Identity, type Shape } from './seats/identity.ts';
export { stateHash } from './state-hash.ts';
export { crowderOf } from './tournament/crowding.ts';
export * from './tournament/pace.ts';
export { MIN_PLAYERS, nextRoom } from './tournament/next-room.ts';
export * from './tournament/room.ts';
export {
  cheerOf,
  CHEERS,
  isFull,
  MAX_SPECTATORS,
  whyNoSeat,
  type Cheer,
  type CheerKind,
} from './tournament/watching.ts';
export { RoomRefusal, type Asker, type RoomEvent } from './tournament/room-event.ts';

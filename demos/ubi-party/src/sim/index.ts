export * from './game.ts';
export { GAMES, type GameId } from './games.ts';
export { isSignalled, type DuelState } from './duel/duel-game.ts';
export * from './hill/hill-state.ts';
export {
  gainsOf,
  ordinal,
  nowMsOf,
  THINGS_A_ROUND,
  THINGS,
  thingOf,
  type Hunt,
  type HuntPhoto,
  type HuntState,
  type Thing,
} from './hunt/hunt-state.ts';
export { lapOf, trackOf, type Cart, type RaceState } from './race/race-state.ts';
export { placeAt, TRACKS, type Track, type TrackPoint } from './race/track.ts';
export { identityOf, MAX_SEATS, type Identity, type Shape } from './seats/identity.ts';
export { stateHash } from './state-hash.ts';
export {
  crowderOf,
  cheerOf,
  CHEERS,
  isFull,
  MAX_SPECTATORS,
  whyNoSeat,
  type Cheer,
  type CheerKind,
} from './tournament/members.ts';
export { MIN_PLAYERS, nextRoom } from './tournament/next-room.ts';
export * from './tournament/room.ts';

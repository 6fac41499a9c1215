export * from './game.ts';
export { GAMES, type GameId } from './games.ts';
export { PlayedRound } from './rounds/played-round.ts';
export { identityOf, MAX_SEATS, type Identity, type Shape } from './seats/identity.ts';
export { stateHash } from './state-hash.ts';
export { nextRoom } from './tournament/next-room.ts';
export * from './tournament/room.ts';
export { RoomRefusal, type Asker, type RoomEvent } from './tournament/room-event.ts';

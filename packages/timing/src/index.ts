export type { Cancel, Clock, PreciseClock } from './clock.ts';
export { EndOfTurn, type TurnTask } from './end-of-turn.ts';
export { TokenBucket } from './token-bucket.ts';
export { within } from './within.ts';

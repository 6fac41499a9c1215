export {
  within,
  EndOfTurn,
  type Cancel,
  type Clock,
  type PreciseClock,
  type TurnTask,
} from './clock.ts';
export { TokenBucket } from './token-bucket.ts';

import type { Pace, Seat } from '../sim/index.ts';

/** A request of a phone to the host. Requests that lead the game are for the leader's phone only. */
export type PhoneWish =
  | { readonly type: 'join' | 'watch'; readonly name: string }
  | { readonly type: 'leave' | 'away' | 'back' }
  | { readonly type: 'ready'; readonly isReady: boolean }
  /** A code with which another phone takes over the seat. */
  | { readonly type: 'offer' }
  | { readonly type: 'take'; readonly code: string }
  | { readonly type: 'proceed' }
  | { readonly type: 'kick' | 'lead'; readonly seat: Seat }
  | { readonly type: 'dismiss'; readonly key: string }
  | { readonly type: 'lock' | 'hide-code'; readonly on: boolean }
  | { readonly type: 'set-teams'; readonly teams: number }
  | { readonly type: 'set-pace'; readonly pace: Pace }
  | { readonly type: 'set-games'; readonly games: readonly string[] }
  | { readonly type: 'fill'; readonly players: number };

/** A wish on its way; `number` grows, so that the answer finds it. */
export interface PhoneRequest {
  readonly number: number;
  readonly wish: PhoneWish;
}

/** The answer of the host. */
export interface HostReply {
  readonly number: number;
  /** Why nothing changed, one sentence. */
  readonly refusal?: string;
  /** Of `offer`. */
  readonly code?: string;
}

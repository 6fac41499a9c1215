import type { Seat } from '../../sim/index.ts';

/** Something that is heard once. Those of a seat are in the pitch of its player. */
export type SoundEvent =
  | {
      readonly kind:
        | 'join'
        | 'leave'
        | 'ready'
        | 'fall'
        | 'hit'
        | 'boost'
        | 'land'
        | 'crown'
        | 'press'
        | 'news';
      readonly seat: Seat;
    }
  /** A winner. */
  | { readonly kind: 'flourish'; readonly seat: Seat }
  /** A number that counts down, and the start of a round. */
  | { readonly kind: 'count' | 'tick'; readonly left: number }
  | { readonly kind: 'go' | 'ring' | 'flag' | 'question' };

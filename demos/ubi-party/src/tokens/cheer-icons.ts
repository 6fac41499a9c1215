import { Heart, PartyPopper, Star, ThumbsUp } from '@lucide/vue';
import type { Component } from 'vue';
import type { CheerKind } from '../sim/index.ts';

/** Icon and word of each cheer. */
export const CHEER_LOOKS: Readonly<
  Record<CheerKind, { readonly icon: Component; readonly word: string }>
> = {
  nice: { icon: ThumbsUp, word: 'Nice' },
  love: { icon: Heart, word: 'Love it' },
  great: { icon: Star, word: 'Great' },
  hooray: { icon: PartyPopper, word: 'Hooray' },
};

import { shallowRef, watch } from 'vue';
import type { Player, Room } from '../../sim/index.ts';
import type { PhoneContext } from './phone-context.ts';
import { removalOf, type Removal } from './which-screen.ts';

/** Notices how this phone loses its seat: given back by the player, or for a reason to tell. */
export function useSeat({ facts, me, room }: PhoneContext) {
  const removal = shallowRef<Removal>();
  let isLeaving = false;
  let last: Player | undefined;
  /** As it was when the connection was lost; the same one is no news after it. */
  let roomAtLoss: Room | undefined;

  watch(
    [me, () => facts.value.link, room] as const,
    ([player, link, now]) => {
      if (link === 'lost') roomAtLoss = now;
      if (player) {
        last = player;
        if (link === 'connected' && now !== roomAtLoss) roomAtLoss = undefined;
        removal.value = undefined;
        isLeaving = false;
        return;
      }
      if (!last || !now || link === 'lost') return;
      removal.value = isLeaving ? undefined : removalOf(now, last, roomAtLoss !== undefined);
      last = undefined;
    },
    { immediate: true, flush: 'sync' },
  );

  return {
    removal,
    /** Before the player gives the seat back. */
    leave: () => void (isLeaving = true),
    /** The player has read it. */
    forget: () => void (removal.value = undefined),
  };
}

import { shallowRef, watch } from 'vue';
import type { Player, Room, Spectator } from '../../sim/index.ts';
import type { PhoneContext } from './phone-context.ts';
import { removalOf, type Removal } from './which-screen.ts';

/** Notices how this phone loses its seat, or its place to watch: given back by the player, or for a reason to tell. */
export function useSeat({ facts, me, spectator, room }: PhoneContext) {
  const removal = shallowRef<Removal>();
  let isLeaving = false;
  let last: Player | undefined;
  let lastWatching: Spectator | undefined;
  /** As it was when the connection was lost; the same one is no news after it. */
  let roomAtLoss: Room | undefined;

  watch(
    [me, () => facts.value.link, room, spectator] as const,
    ([player, link, now, watching]) => {
      if (link === 'lost') roomAtLoss = now;
      if (player ?? watching) {
        last = player;
        lastWatching = watching;
        if (link === 'connected' && now !== roomAtLoss) roomAtLoss = undefined;
        removal.value = undefined;
        isLeaving = false;
        return;
      }
      if (!(last ?? lastWatching) || !now || link === 'lost') return;
      // The host takes out who was away for long, also behind another page
      const wasLost = roomAtLoss !== undefined || (last ?? lastWatching)?.awaySinceMs !== undefined;
      // A spectator who was away too long joins again at the start page
      const dismissal = wasLost ? undefined : 'dismissed';
      const reason = last ? removalOf(now, last, wasLost) : dismissal;
      removal.value = isLeaving ? undefined : reason;
      last = undefined;
      lastWatching = undefined;
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

import { computed, shallowRef, type ComputedRef } from 'vue';
import { nextRoom, RoomRefusal, type Room, type RoomEvent } from '../sim/index.ts';
import type { ScreenLink } from './screen-link.ts';

/** A request of the host that the room refused. */
export interface Refusal {
  readonly event: RoomEvent;
  /** Why, one sentence. */
  readonly sentence: string;
}

/** Applies events of the host, and has the last refusal for as long as its reason holds. */
export function useRefusal(
  link: Pick<ScreenLink, 'apply' | 'nowMs'>,
  room: () => Room | undefined,
): {
  readonly refusal: ComputedRef<Refusal | undefined>;
  apply(event: RoomEvent): void;
  dismiss(): void;
} {
  const refused = shallowRef<Refusal>();
  const refusal = computed(() => {
    const now = room();
    if (refused.value === undefined || now === undefined) return undefined;
    return isRefused(now, refused.value.event, link.nowMs()) ? refused.value : undefined;
  });
  return {
    refusal,
    apply(event) {
      const sentence = link.apply(event);
      refused.value = sentence === undefined ? undefined : { event, sentence };
    },
    dismiss: () => (refused.value = undefined),
  };
}

function isRefused(room: Room, event: RoomEvent, nowMs: number): boolean {
  try {
    nextRoom(room, event, nowMs);
    return false;
  } catch (cause) {
    if (cause instanceof RoomRefusal) return true;
    throw cause;
  }
}

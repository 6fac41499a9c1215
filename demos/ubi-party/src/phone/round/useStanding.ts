import { computed, type ComputedRef } from 'vue';
import { usePhone } from '../frame/phone-context.ts';
import type { GameTexts } from './game-of.ts';
import { ordinal } from './place-table.ts';
import { useNow } from './useNow.ts';

/** Words of a round: 3, 2, 1 until its first step, then what the game says of this player. */
export function useStanding(game: ComputedRef<GameTexts>) {
  const { facts, room, round } = usePhone();
  const nowMs = useNow();
  const startsAtMs = computed(() => round.value?.startsAtMs ?? room.value?.endsAtMs ?? 0);
  const leftS = computed(() => Math.ceil((startsAtMs.value - nowMs.value) / 1000));
  const isStarted = computed(() => leftS.value <= 0);

  const standing = computed(() => {
    const { title, controller } = game.value;
    const { feedback } = facts.value;
    if (!isStarted.value)
      return {
        kicker: title,
        headline: String(leftS.value),
        sentence: GET_READY[controller.steering],
      };
    if (!feedback) return { kicker: title, headline: 'Go!', sentence: 'Look at the big screen.' };
    const { place, of, headline, sentence } = feedback;
    return { kicker: `${ordinal(place)} of ${of}`, headline, sentence };
  });
  return { standing, isStarted };
}

const GET_READY = {
  wheel: 'Hold the phone level.',
  stick: 'Put both thumbs on the pads.',
  none: 'Hold a thumb over the button.',
  camera: 'Get your camera ready.',
} as const;

import { computed, onScopeDispose, shallowRef, watch, type Ref } from 'vue';
import { usePhone } from '../frame/phone-context.ts';
import { PRESS_MS, vibrate } from '../frame/haptics.ts';
import { bestFor } from './detector/sightings.ts';
import type { Sighting } from './detector/detector.ts';
import { photoOf, pixelsOf, takeStill, type PictureSource, type Still } from './picture.ts';
import { useEyes } from './useEyes.ts';

/** Between two looks of the live picture: the phone has other things to do, milliseconds. */
const REST_MS = 120;

/** A photo that was taken for the thing that is hunted. */
interface Taken {
  readonly still: Still;
  readonly atMs: number;
}

/**
 * Looks at the live picture, and hands photos in.
 *
 * @param live the picture of the camera now; undefined while there is none
 * @param isShown the player shows photos on the big screen
 */
export function useHunt(live: () => PictureSource | undefined, isShown: Ref<boolean>) {
  const { link, facts } = usePhone();
  const { detector } = useEyes();
  const question = computed(() => facts.value.feedback?.question);
  /** Changes with the thing, not with each word about it. */
  const thing = computed(() => question.value && `${question.value.beganAtMs}`);
  const seen = shallowRef<Sighting>();
  const taken = shallowRef<Taken>();
  const isLooking = shallowRef(false);
  const trouble = shallowRef('');
  let isGone = false;

  async function find(still: Still): Promise<Sighting | undefined> {
    if (detector.value.status !== 'ready' || !question.value) return undefined;
    const wanted = question.value;
    return bestFor(wanted, await detector.value.detector.detect(pixelsOf(still)));
  }

  async function lookOn(): Promise<void> {
    while (!isGone) {
      const source = isLooking.value || !question.value ? undefined : live();
      if (source) {
        const found = await find(takeStill(source)).catch(() => undefined);
        if (!isLooking.value) seen.value = found;
      }
      await new Promise((resolve) => setTimeout(resolve, REST_MS));
    }
  }

  async function shoot(source: PictureSource): Promise<void> {
    const wanted = question.value;
    if (!wanted || isLooking.value || detector.value.status !== 'ready') return;
    vibrate(PRESS_MS);
    isLooking.value = true;
    trouble.value = '';
    const atMs = Math.round(facts.value.nowMs());
    const still = takeStill(source);
    taken.value = { still, atMs };
    link.answer({ text: '', score: 0, atMs });
    try {
      if (isShown.value) await show();
      const found = await find(still);
      seen.value = found;
      const area = isShown.value ? found?.area : undefined;
      const result = { text: found?.label ?? 'nothing', score: found?.score ?? 0, atMs };
      link.answer({ ...result, ...(area && { area }) });
    } catch (cause) {
      trouble.value = (cause as Error).message;
      link.answer({ text: 'nothing', score: 0, atMs });
    } finally {
      isLooking.value = false;
    }
  }

  async function show(): Promise<void> {
    const { still, atMs } = taken.value ?? {};
    if (!still || atMs === undefined) return;
    const photo = await photoOf(still, atMs);
    // The player may have changed their mind meanwhile
    if (isShown.value && taken.value?.atMs === atMs && !isGone) link.showPhoto(photo);
  }

  watch(isShown, (is) => (is ? void show() : link.showPhoto(undefined)));
  watch(thing, (now) => {
    if (now === undefined) return;
    taken.value = undefined;
    seen.value = undefined;
    link.showPhoto(undefined);
  });
  onScopeDispose(() => {
    isGone = true;
    link.showPhoto(undefined);
  });
  void lookOn();

  return { question, seen, taken, isLooking, trouble, shoot };
}

import { MAX_CHOSEN_PIXELS, readPictureFile } from '@ubii/pictures';
import { useLocalStorage } from '@vueuse/core';
import { computed, onScopeDispose, shallowRef, watch, type Ref } from 'vue';

import { thingOf, type Question } from '../../sim/index.ts';
import { PRESS_MS, vibrate } from '../frame/haptics.ts';
import { usePhone } from '../frame/phone-context.ts';
import { bestFor, type Sighting } from './detector/detector.ts';
import { photoOf, pixelsOf, takeStill, type PictureSource, type Still } from './picture.ts';
import { useEyes } from './useEyes.ts';

/** Whether this player shows photos on the big screen: off by default, then the last choice. */
export function useShownSetting(): Ref<boolean> {
  return useLocalStorage('ubii.party.shows-photos', false);
}

/** Sentence for the current detection, shown before the player presses. */
export function liveSentence(question: Question, seen: Sighting | undefined): string {
  const { text, name } = question;
  if (seen === undefined) return `Looking for ${name}`;
  if (seen.label === text)
    return text === 'scissors' ? 'Scissors. Take it!' : `That’s ${name}. Take it!`;
  return `That’s ${thingOf(seen.label).name}, not ${name}`;
}

/** Pause between two detections in the live picture, milliseconds. */
const REST_MS = 120;

/** A photo that was taken for the thing that is hunted. */
interface Taken {
  readonly still: Still;
  readonly atMs: number;
}

/**
 * Detects things in the live picture, and submits photos.
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

  /** Uses a picture file in place of the camera. */
  async function shootFile(chosen: File): Promise<void> {
    try {
      const file = readPictureFile(new Uint8Array(await chosen.arrayBuffer()), MAX_CHOSEN_PIXELS);
      const bitmap = await createImageBitmap(new Blob([file.data.slice()]));
      await shoot({ element: bitmap, width: bitmap.width, height: bitmap.height });
      bitmap.close();
    } catch (error) {
      trouble.value =
        error instanceof RangeError
          ? error.message
          : `“${chosen.name}” is not a picture that this browser can read.`;
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

  return { question, seen, taken, isLooking, trouble, shoot, shootFile };
}

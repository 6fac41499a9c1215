import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import type { Ref } from 'vue';
import { storedAs } from '../../json/read-stored.ts';
import { flag } from '../../json/schemas.ts';

const HABITS = v.object({
  /** Quality, size and rate follow what link and modules take. */
  isAdaptive: v.fallback(v.boolean(), true),
  /** The newest picture stays on the master when no more are sent, until this client leaves. [TD-49] */
  keepsNewest: flag,
});

/** How this browser sends pictures, whatever they are of. */
export type PictureHabits = v.InferOutput<typeof HABITS>;

export const storedHabits = storedAs(HABITS, {});

const LEAST_EXPIRY_MS = 1000;
/** Pictures may be late by two of them. */
const INTERVALS = 3;

/** How long a picture stands on the master without a newer one, milliseconds. [TD-49] */
export function pictureExpiryMs(rateHz: number): number {
  return Math.round(Math.max(LEAST_EXPIRY_MS, (INTERVALS * 1000) / rateHz));
}

/** The habits of this browser, remembered. */
export function usePictureHabits(): Ref<PictureHabits> {
  return useLocalStorage('ubii.pictures', v.parse(HABITS, {}), {
    serializer: storedHabits,
    writeDefaults: false,
  });
}

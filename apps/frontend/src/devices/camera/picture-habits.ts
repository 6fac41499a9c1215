import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import type { Ref } from 'vue';
import { storedAs } from '../../json/read-stored.ts';
import { flag } from '../../json/schemas.ts';

const HABITS = v.object({
  /** Adapts quality, size and rate to network and modules. */
  isAdaptive: v.fallback(v.boolean(), true),
  /** Keeps the newest picture on the master after sending stops, until this client leaves. [TD-49] */
  keepsNewest: flag,
});

/** Preferences of this browser for sending pictures of any source. */
export type PictureHabits = v.InferOutput<typeof HABITS>;

export const storedHabits = storedAs(HABITS, {});

const MIN_EXPIRY_MS = 1000;
/** Expiry of a picture as a multiple of the interval. */
const INTERVALS = 3;

/** Returns the expiry of a picture without a newer one, milliseconds. [TD-49] */
export function pictureExpiryMs(rateHz: number): number {
  return Math.round(Math.max(MIN_EXPIRY_MS, (INTERVALS * 1000) / rateHz));
}

/** Preferences stored in this browser. */
export function usePictureHabits(): Ref<PictureHabits> {
  return useLocalStorage('ubii.pictures', v.parse(HABITS, {}), {
    serializer: storedHabits,
    writeDefaults: false,
  });
}

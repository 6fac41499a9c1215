import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';

/** How this browser sends pictures, whatever they are of. */
export interface PictureHabits {
  /** Quality, size and rate follow what link and modules take. */
  isAdaptive: boolean;
  /** The newest picture stays on the master when no more are sent, until this client leaves. [TD-49] */
  keepsNewest: boolean;
}

const FIRST_HABITS: PictureHabits = { isAdaptive: true, keepsNewest: false };
const LEAST_EXPIRY_MS = 1000;
/** Pictures may be late by two of them. */
const INTERVALS = 3;

/** How long a picture stands on the master without a newer one, milliseconds. [TD-49] */
export function pictureExpiryMs(rateHz: number): number {
  return Math.round(Math.max(LEAST_EXPIRY_MS, (INTERVALS * 1000) / rateHz));
}

/** Returns the valid part of what was stored, which another version may have written. */
export function readHabits(text: string): PictureHabits {
  try {
    const kept = JSON.parse(text) as Partial<Record<keyof PictureHabits, unknown>> | null;
    return {
      isAdaptive: kept?.isAdaptive !== false,
      keepsNewest: kept?.keepsNewest === true,
    };
  } catch {
    return FIRST_HABITS;
  }
}

/** The habits of this browser, remembered. */
export function usePictureHabits(): Ref<PictureHabits> {
  return useLocalStorage('ubii.pictures', FIRST_HABITS, {
    serializer: { read: readHabits, write: (habits) => JSON.stringify(habits) },
    writeDefaults: false,
  });
}

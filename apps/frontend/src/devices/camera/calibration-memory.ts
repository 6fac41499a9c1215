import { parseCalibration } from '@ubii/vision/markers';
import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import { readStored } from '../../json/read-stored.ts';
import { validElements } from '../../json/schemas.ts';

/** Calibrations as JSON text, by id of the camera, the newest last. */
export type Calibrations = ReadonlyMap<string, string>;

/** Ids change when a browser forgets a page: those of long ago are let go of. */
const MOST_CAMERAS = 8;

/** The memory with another calibration of a camera. */
export function withCalibration(kept: Calibrations, camera: string, json: string): Calibrations {
  if (camera === '') return kept;
  const others = [...kept].filter(([id]) => id !== camera).slice(1 - MOST_CAMERAS);
  return new Map([...others, [camera, json]]);
}

const ENTRIES = validElements(
  v.tuple([v.pipe(v.string(), v.minLength(1)), v.pipe(v.string(), v.check(isCalibration))]),
);

/** Returns the valid part of what is stored, which another program or version may have written. */
export const readCalibrations = (text: string): Calibrations => new Map(readStored(ENTRIES, text));

function isCalibration(json: string): boolean {
  try {
    parseCalibration(json);
    return true;
  } catch {
    return false;
  }
}

/** The calibrations of this browser's cameras. They change in all of its tabs. */
export function useCalibrations() {
  const kept = useLocalStorage<Calibrations>('ubii.camera-calibrations', new Map(), {
    serializer: { read: readCalibrations, write: (value) => JSON.stringify([...value]) },
    shallow: true,
    writeDefaults: false,
  });
  return {
    /** JSON text; undefined for a camera that was not calibrated. */
    of: (camera: string): string | undefined => kept.value.get(camera),
    keep(camera: string, json: string): void {
      kept.value = withCalibration(kept.value, camera, json);
    },
  };
}

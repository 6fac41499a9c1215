import { parseCalibration } from '@ubii/vision/markers';
import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import { readStored } from '../../json/read-stored.ts';
import { validElements } from '../../json/schemas.ts';

/** Calibrations as JSON text, by camera id, newest last. */
export type Calibrations = ReadonlyMap<string, string>;

/** Most cameras remembered. Ids change when a browser clears its site data, so old ones are dropped. */
const MAX_CAMERAS = 8;

/** Adds or replaces the calibration of a camera. */
export function withCalibration(kept: Calibrations, camera: string, json: string): Calibrations {
  if (camera === '') return kept;
  const others = [...kept].filter(([id]) => id !== camera).slice(1 - MAX_CAMERAS);
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

/** Calibrations of this browser's cameras, shared by all its tabs. */
export function useCalibrations() {
  const kept = useLocalStorage<Calibrations>('ubii.camera-calibrations', new Map(), {
    serializer: { read: readCalibrations, write: (value) => JSON.stringify([...value]) },
    shallow: true,
    writeDefaults: false,
  });
  return {
    /** JSON text; undefined for a camera without calibration. */
    of: (camera: string): string | undefined => kept.value.get(camera),
    keep(camera: string, json: string): void {
      kept.value = withCalibration(kept.value, camera, json);
    },
  };
}

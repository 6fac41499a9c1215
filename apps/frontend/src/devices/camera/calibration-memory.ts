import { parseCalibration } from '@ubii/vision/markers';
import { useLocalStorage } from '@vueuse/core';

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

/** Returns the valid part of what is stored, which another program or version may have written. */
export function readCalibrations(text: string): Calibrations {
  try {
    const entries = JSON.parse(text) as unknown;
    if (!Array.isArray(entries)) return new Map();
    return new Map(
      entries.filter((entry): entry is [string, string] => {
        const [id, json] = Array.isArray(entry) ? (entry as unknown[]) : [];
        return typeof id === 'string' && id !== '' && typeof json === 'string' && isValid(json);
      }),
    );
  } catch {
    return new Map();
  }
}

function isValid(json: string): boolean {
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

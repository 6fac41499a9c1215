import type { RouteLocationRaw } from 'vue-router';

/** Where a recording of the master is shown. */
export function recordingLocation(id: string): RouteLocationRaw {
  return { path: `/recordings/${encodeURIComponent(id)}` };
}

/** Where the master serves its file. */
export const recordingFileUrl = (id: string): string =>
  `/recordings/${encodeURIComponent(id)}.mcap`;

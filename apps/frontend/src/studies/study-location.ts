import type { RouteLocationRaw } from 'vue-router';

/** Part of the page of a study. */
export type StudyPart = 'design' | 'run' | 'participants';

/** Where a study is shown. @param part which part of it; the page chooses without it */
export function studyLocation(id: string, part?: StudyPart): RouteLocationRaw {
  const path = `/studies/${encodeURIComponent(id)}`;
  return { path: part === undefined ? path : `${path}/${part}` };
}

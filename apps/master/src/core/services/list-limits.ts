import type { Core } from '../parts/core.ts';

/** The profiles of a request, unless there are too many to compare everything with. */
export function requireProfiles<T>(core: Core, profiles: readonly T[]): readonly T[] {
  return requireAtMost(core, 'listProfiles', profiles, 'profiles');
}

/** The elements of a list in a request, unless there are too many. */
export function requireElements<T>(core: Core, elements: readonly T[]): readonly T[] {
  return requireAtMost(core, 'listElements', elements, 'elements of a list');
}

function requireAtMost<T>(
  { limitWatch, limits }: Core,
  limit: 'listProfiles' | 'listElements',
  list: readonly T[],
  what: string,
): readonly T[] {
  if (list.length <= limits[limit]) return list;
  throw limitWatch.refusal(limit, `more than ${limits[limit]} ${what} in one request`);
}

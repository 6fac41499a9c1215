import type { LimitWatch } from '../counters/limit-watch.ts';

interface Parts {
  readonly limitWatch: LimitWatch;
}

/** The profiles of a request, unless there are too many to compare everything with. */
export function requireProfiles<T>(parts: Parts, profiles: readonly T[]): readonly T[] {
  return requireAtMost(parts, 'listProfiles', profiles, 'profiles');
}

/** The elements of a list in a request, unless there are too many. */
export function requireElements<T>(parts: Parts, elements: readonly T[]): readonly T[] {
  return requireAtMost(parts, 'listElements', elements, 'elements of a list');
}

function requireAtMost<T>(
  { limitWatch }: Parts,
  limit: 'listProfiles' | 'listElements',
  list: readonly T[],
  what: string,
): readonly T[] {
  const max = limitWatch.limits[limit];
  if (list.length <= max) return list;
  throw limitWatch.refusal(limit, `more than ${max} ${what} in one request`);
}

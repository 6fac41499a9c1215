import type { LimitWatch } from '../counters/limit-watch.ts';

interface Context {
  readonly limitWatch: LimitWatch;
}

/** The profiles of a request, unless there are too many to compare everything with. */
export function requireProfiles<T>(context: Context, profiles: readonly T[]): readonly T[] {
  return requireAtMost(context, 'listProfiles', profiles, 'profiles');
}

/** The elements of a list in a request, unless there are too many. */
export function requireElements<T>(context: Context, elements: readonly T[]): readonly T[] {
  return requireAtMost(context, 'listElements', elements, 'elements of a list');
}

function requireAtMost<T>(
  { limitWatch }: Context,
  limit: 'listProfiles' | 'listElements',
  list: readonly T[],
  what: string,
): readonly T[] {
  const max = limitWatch.limits[limit];
  if (list.length <= max) return list;
  throw limitWatch.refusal(limit, `more than ${max} ${what} in one request`);
}

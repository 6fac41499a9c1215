import type { Session } from '@ubii/proto';

/** Marks the sessions of tests, together with the id of the client each belongs to. */
export const TEST_SESSION_TAG = 'performance-test';

/** True for a session of a test whose page was closed, so that no page can stop it. */
export function isAbandoned(
  { tags }: Pick<Session, 'tags'>,
  isThere: (clientId: string) => boolean,
): boolean {
  if (!tags.includes(TEST_SESSION_TAG)) return false;
  const owner = tags.find((tag) => tag !== TEST_SESSION_TAG);
  return owner === undefined || !isThere(owner);
}

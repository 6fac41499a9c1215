import type { Session } from '@ubii/proto';

/** Tag of sessions of tests. A second tag is the id of the client. */
export const TEST_SESSION_TAG = 'performance-test';

/** True for a session of a test whose page was closed: no page will stop it. */
export function isAbandoned(
  { tags }: Pick<Session, 'tags'>,
  isThere: (clientId: string) => boolean,
): boolean {
  if (!tags.includes(TEST_SESSION_TAG)) return false;
  const owner = tags.find((tag) => tag !== TEST_SESSION_TAG);
  return owner === undefined || !isThere(owner);
}

import type { RouteLocationRaw } from 'vue-router';

/**
 * Location of a topic; the URL can be shared. Topics may contain any character. Dots are encoded as `%2E`; otherwise
 * the master would look for a file when a topic ends like a filename.
 */
export function topicLocation(topic: string): RouteLocationRaw {
  return { path: pathOf(topic) };
}

const pathOf = (topic: string): string =>
  `/topics/${encodeURIComponent(topic).replaceAll('.', '%2E')}`;

/** Location of a topic with the form that publishes on it. */
export function topicPublishLocation(topic: string): RouteLocationRaw {
  return { path: pathOf(topic), query: { publish: '1' } };
}

/** Location of the Panels page with the layout that is saved with a session. */
export function sessionPanelsLocation(sessionId: string): RouteLocationRaw {
  return { path: '/panels', query: { session: sessionId } };
}

/** Location of the Panels page; with a topic, adds a panel for it. */
export function panelsLocation(topic?: string): RouteLocationRaw {
  return { path: '/panels', query: topic === undefined ? {} : { topic } };
}

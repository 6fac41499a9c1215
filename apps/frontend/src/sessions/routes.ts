import type { RouteLocationRaw, RouteRecordRaw } from 'vue-router';

/** A new session as text. */
export const NEW_TEXT_PATH = '/sessions/new/text';

const PARENT = { title: 'Sessions', to: '/sessions' };

/** Where a session is shown. */
export function sessionLocation(id: string): RouteLocationRaw {
  return { path: `/sessions/${encodeURIComponent(id)}` };
}

/** Where the text of a session is edited; at a line, to be shown there. */
export function sessionTextLocation(id: string, line?: number): RouteLocationRaw {
  const hash = line === undefined ? '' : `#L${line}`;
  return { path: `/sessions/${encodeURIComponent(id)}/text`, hash };
}

/**
 * Where a new session is written as text.
 * @param id of the new session on the graph page, if it was there before
 */
export function newTextLocation(id?: string): RouteLocationRaw {
  return { path: NEW_TEXT_PATH, query: id === undefined ? {} : { id } };
}

export const sessionsRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/sessions',
    component: () => import('./SessionsPage.vue'),
    meta: { title: 'Sessions' },
  },
  {
    path: NEW_TEXT_PATH,
    component: () => import('./NewSessionPage.vue'),
    meta: { title: 'New session', parent: PARENT },
  },
  {
    path: '/sessions/:id',
    component: () => import('./SessionPage.vue'),
    meta: { title: 'Session', parent: PARENT },
  },
  {
    path: '/sessions/:id/text',
    component: () => import('./EditSessionPage.vue'),
    meta: { title: 'Edit as JSON', parent: PARENT },
  },
];

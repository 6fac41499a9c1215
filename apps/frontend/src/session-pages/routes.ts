import type { RouteRecordRaw } from 'vue-router';
import { NEW_TEXT_PATH } from '../locations/session-location.ts';

const PARENT = { title: 'Sessions', to: '/sessions' };

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

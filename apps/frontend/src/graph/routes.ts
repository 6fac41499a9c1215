import type { RouteRecordRaw } from 'vue-router';
import { randomUuid } from '../connection/random-uuid.ts';
import {
  NEW_TEXT_PATH,
  newTextLocation,
  SESSION_DRAWERS,
  sessionLocation,
} from '../locations/session-location.ts';
import { CANVAS_LETTERS } from './canvas/canvas-letters.ts';
import { GRAPH_CANVAS_ID } from './canvas/graph-canvas-id.ts';

export const graphRoutes: readonly RouteRecordRaw[] = [
  // A new session has its id and URL from the start; it is stored on the first save.
  { path: '/sessions/new', redirect: () => sessionLocation(randomUuid(), true) },
  { path: NEW_TEXT_PATH, redirect: () => newTextLocation() },
  // The address of the graph in earlier versions.
  {
    path: '/sessions/:id/graph',
    redirect: ({ params, query, hash }) => ({
      path: `/sessions/${encodeURIComponent(String(params['id']))}`,
      query,
      hash,
    }),
  },
  {
    path: `/sessions/:id/:drawer(${SESSION_DRAWERS.join('|')})?`,
    component: () => import('./editor/GraphPage.vue'),
    meta: {
      title: 'Session',
      isFullBleed: true,
      parent: { title: 'Sessions', to: '/sessions' },
      ownKeys: CANVAS_LETTERS,
      skip: { title: 'Skip to the graph', id: GRAPH_CANVAS_ID },
    },
  },
];

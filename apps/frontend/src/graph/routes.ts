import type { RouteRecordRaw } from 'vue-router';
import { randomUuid } from '../connection/random-uuid.ts';
import { graphLocation } from '../locations/graph-location.ts';
import { CANVAS_LETTERS } from './canvas/canvas-letters.ts';
import { GRAPH_CANVAS_ID } from './canvas/graph-canvas-id.ts';

export const graphRoutes: readonly RouteRecordRaw[] = [
  // A new session has its id and URL from the start; it is stored on the first save.
  { path: '/sessions/new', redirect: () => graphLocation(randomUuid(), true) },
  {
    path: '/sessions/:id/graph',
    component: () => import('./editor/GraphPage.vue'),
    meta: {
      title: 'Graph',
      parent: { title: 'Sessions', to: '/sessions' },
      ownKeys: CANVAS_LETTERS,
      skip: { title: 'Skip to the graph', id: GRAPH_CANVAS_ID },
    },
  },
];

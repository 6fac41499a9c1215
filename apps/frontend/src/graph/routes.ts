import type { RouteLocationRaw, RouteRecordRaw } from 'vue-router';
import { GRAPH_CANVAS_ID } from './graph-canvas-id.ts';

/** Where the graph of a session is edited. */
export function graphLocation(id: string): RouteLocationRaw {
  return { path: `/sessions/${encodeURIComponent(id)}/graph` };
}

export const graphRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/sessions/:id/graph',
    component: () => import('./editor/GraphPage.vue'),
    meta: {
      title: 'Graph',
      parent: { title: 'Sessions', to: '/sessions' },
      skip: { title: 'Skip to the graph', id: GRAPH_CANVAS_ID },
    },
  },
];

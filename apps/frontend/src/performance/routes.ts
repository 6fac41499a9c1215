import type { RouteRecordRaw } from 'vue-router';

const TITLE = 'Performance';
const PARENT = { title: TITLE, to: '/performance' };

export const performanceRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/performance',
    component: () => import('./PerformancePage.vue'),
    meta: { title: TITLE },
    redirect: '/performance/round-trip',
    children: [
      {
        path: 'round-trip',
        component: () => import('./round-trip/RoundTripTest.vue'),
        meta: { title: TITLE },
      },
      {
        path: 'load',
        component: () => import('./load/LoadTest.vue'),
        meta: { title: 'Message load', parent: PARENT },
      },
      {
        path: 'session-speed',
        component: () => import('./session-speed/SpeedTest.vue'),
        meta: { title: 'Session speed', parent: PARENT },
      },
      {
        path: 'screen',
        component: () => import('./screen/ScreenTest.vue'),
        meta: { title: 'Topic to screen', parent: PARENT },
      },
      {
        path: 'results',
        component: () => import('./result-views/ResultsPanel.vue'),
        meta: { title: 'Results', parent: PARENT },
      },
      {
        path: 'results/:id',
        component: () => import('./result-views/ResultPanel.vue'),
        meta: { title: 'Result', parent: { title: 'Results', to: '/performance/results' } },
      },
      {
        path: 'compare',
        component: () => import('./compare/ComparePanel.vue'),
        meta: { title: 'Compare', parent: { title: 'Results', to: '/performance/results' } },
      },
    ],
  },
];

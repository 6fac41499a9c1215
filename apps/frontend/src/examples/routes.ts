import type { RouteRecordRaw } from 'vue-router';
import { EXAMPLES } from './catalogue.ts';

export const examplesRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/examples',
    component: () => import('./ExamplesPage.vue'),
    meta: { title: 'Examples' },
  },
  ...EXAMPLES.flatMap(({ path, title, page }) =>
    page
      ? [
          {
            path,
            component: page,
            meta: { title, parent: { title: 'Examples', to: '/examples' }, isFullBleed: true },
          },
        ]
      : [],
  ),
];

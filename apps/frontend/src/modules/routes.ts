import type { RouteLocationRaw, RouteRecordRaw } from 'vue-router';

/** Where a module is shown, by its name. */
export function moduleLocation(name: string): RouteLocationRaw {
  return { path: `/modules/${encodeURIComponent(name).replaceAll('.', '%2E')}` };
}

export const modulesRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/modules/:name?',
    component: () => import('./ModulesPage.vue'),
    meta: { title: 'Modules' },
  },
];

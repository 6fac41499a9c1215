import type { RouteRecordRaw } from 'vue-router';

export const modulesRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/modules/:name?',
    component: () => import('./ModulesPage.vue'),
    meta: { title: 'Modules' },
  },
  {
    path: '/modules/:name/edit',
    component: () => import('./editor/ModuleEditorPage.vue'),
    meta: { title: 'Edit', parent: { title: 'Modules', to: '/modules' }, isFullBleed: true },
  },
];

import type { RouteRecordRaw } from 'vue-router';

const parent = { title: 'Settings', to: '/settings' };

/** Settings of this browser and the master, and status of the master. */
export const settingsRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/settings',
    component: () => import('./browser/BrowserPage.vue'),
    meta: { title: 'Settings' },
  },
  {
    path: '/settings/master',
    component: () => import('./master/MasterPage.vue'),
    meta: { title: 'Master', parent },
  },
  {
    path: '/settings/masters',
    component: () => import('./masters/MastersPage.vue'),
    meta: { title: 'Masters', parent },
  },
  {
    path: '/settings/limits',
    component: () => import('./limits/LimitsPage.vue'),
    meta: { title: 'Limits', parent },
  },
  {
    path: '/settings/log',
    component: () => import('./log/LogPage.vue'),
    meta: { title: 'Log', parent },
  },
  {
    path: '/settings/audit',
    component: () => import('./audit/AuditPage.vue'),
    meta: { title: 'Audit log', parent },
  },
  {
    path: '/settings/licences',
    component: () => import('./licences/LicencesPage.vue'),
    meta: { title: 'Licences', parent },
  },
];

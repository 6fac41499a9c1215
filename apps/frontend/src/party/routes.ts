import type { RouteRecordRaw } from 'vue-router';

export const PARTY_PATH = '/party';
export const PARTY_PHONE_PATH = '/party/play';

export const partyRoutes: readonly RouteRecordRaw[] = [
  {
    path: PARTY_PATH,
    component: () => import('./PartyPage.vue'),
    meta: { title: 'Ubi-Party', isWhole: true },
  },
  {
    path: PARTY_PHONE_PATH,
    component: () => import('./PartyPhonePage.vue'),
    meta: { title: 'Ubi-Party', isWhole: true },
  },
];

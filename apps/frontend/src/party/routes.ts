import type { RouteRecordRaw } from 'vue-router';
import { PARTY_PATH, PARTY_PHONE_PATH } from '../locations/party-location.ts';

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

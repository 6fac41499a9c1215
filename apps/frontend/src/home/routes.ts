import type { RouteRecordRaw } from 'vue-router';
import { isNewcomer, useRecent } from '../page/recent.ts';
import { loadBack, loadPhone, PHONE } from './load-home.ts';

const loadPage = () => import('./HomePage.vue');

/** Loads Home with the part of it that will be shown, so that it is there at once. */
async function loadHome(): ReturnType<typeof loadPage> {
  const page = loadPage();
  if (matchMedia(PHONE).matches) await loadPhone();
  else if (!isNewcomer(useRecent().things.value)) await loadBack();
  return page;
}

export const homeRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/',
    component: loadHome,
    meta: { title: 'Home' },
  },
  {
    // What Home shows to a new user, for all others.
    path: '/learn/first-session',
    component: loadHome,
    props: { isFirst: true },
    meta: { title: 'First session', parent: { title: 'Learn', to: '/learn' } },
  },
];

import type { RouteRecordRaw } from 'vue-router';

const component = () => import('./LearnPage.vue');
const parent = { title: 'Learn', to: '/learn' };

export const learnRoutes: readonly RouteRecordRaw[] = [
  { path: '/learn', component, meta: { title: 'Learn' } },
  { path: '/learn/how-to/:howTo', component, meta: { title: 'How to', parent } },
  { path: '/learn/reference/:page', component, meta: { title: 'Reference', parent } },
  { path: '/learn/:lesson', component, meta: { title: 'Lesson', parent } },
];

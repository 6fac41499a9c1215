import type { RouteRecordRaw } from 'vue-router';
import { CANVAS_LETTERS } from '../graph/canvas/canvas-letters.ts';

const component = () => import('./LearnPage.vue');
const parent = { title: 'Learn', to: '/learn' };

export const learnRoutes: readonly RouteRecordRaw[] = [
  { path: '/learn', component, meta: { title: 'Learn' } },
  { path: '/learn/how-to/:howTo', component, meta: { title: 'How to', parent } },
  { path: '/learn/reference/:page', component, meta: { title: 'Reference', parent } },
  // Lessons have a graph beside the text.
  { path: '/learn/:lesson', component, meta: { title: 'Lesson', parent, ownKeys: CANVAS_LETTERS } },
];

import type { RouteRecordRaw } from 'vue-router';
import { CANVAS_LETTERS } from '../graph/canvas/canvas-letters.ts';

const component = () => import('./LearnPage.vue');
// The contents stand at the edge, and beside them a lesson and its editor.
const isFullBleed = true;
const parent = { title: 'Learn', to: '/learn' };

export const learnRoutes: readonly RouteRecordRaw[] = [
  { path: '/learn', component, meta: { title: 'Learn', isFullBleed } },
  { path: '/learn/how-to/:howTo', component, meta: { title: 'How to', parent, isFullBleed } },
  { path: '/learn/reference/:page', component, meta: { title: 'Reference', parent, isFullBleed } },
  // Lessons have a graph beside the text.
  {
    path: '/learn/:lesson',
    component,
    meta: { title: 'Lesson', parent, isFullBleed, ownKeys: CANVAS_LETTERS },
  },
];

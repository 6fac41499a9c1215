import type { RouteRecordRaw } from 'vue-router';
import { startPath } from './start-path.ts';

/** Start URL of the installed app, as in `public/manifest.webmanifest`. */
export const START_PATH = '/start';

export const installRoutes: readonly RouteRecordRaw[] = [
  { path: START_PATH, redirect: () => startPath() },
];

import type { RouteRecordRaw } from 'vue-router';
import { startPath } from './start-path.ts';

/** Where the installed app opens, as `public/manifest.webmanifest` says. */
export const START_PATH = '/start';

export const installRoutes: readonly RouteRecordRaw[] = [
  { path: START_PATH, redirect: () => startPath() },
];

import type { RouteRecordRaw } from 'vue-router';
import { bridgesRoutes } from './bridges/routes.ts';
import { callsRoutes } from './calls/routes.ts';
import { clientsRoutes } from './clients/routes.ts';
import { devicesRoutes } from './devices/routes.ts';
import { certificateRoutes } from './joining/certificate/routes.ts';
import { connectPhoneRoutes } from './joining/connect-phone/routes.ts';
import { connectProgramRoutes } from './joining/connect-program/routes.ts';
import { examplesRoutes } from './examples/routes.ts';
import { graphRoutes } from './graph/routes.ts';
import { homeRoutes } from './home/routes.ts';
import { installRoutes } from './install/routes.ts';
import { joinRoutes } from './joining/join/routes.ts';
import { learnRoutes } from './learn/routes.ts';
import { markersRoutes } from './markers/routes.ts';
import { partyRoutes } from './party/routes.ts';
import { modulesRoutes } from './modules/routes.ts';
import { performanceRoutes } from './performance/routes.ts';
import { publishRoutes } from './publish/routes.ts';
import { recordingsRoutes } from './recordings/routes.ts';
import { sessionsRoutes } from './session-pages/routes.ts';
import { settingsRoutes } from './settings/routes.ts';
import { studiesRoutes } from './studies/routes.ts';
import { topicsRoutes } from './topics/routes.ts';

declare module 'vue-router' {
  interface RouteMeta {
    /** The page's name in the document title and at the end of the path in the top bar. */
    title: string;
    /** The parent page in the path. */
    parent?: { readonly title: string; readonly to: string };
    /** A second skip link: to what the page is about. */
    skip?: { readonly title: string; readonly id: string };
    /** Letters that have their own meaning on the page, in upper case: shortcuts of the program leave them. */
    ownKeys?: string;
    /** On phones it says itself who this is and how it stands with the master: no top bar. */
    hasOwnHeader?: boolean;
    /** Goes from edge to edge, with panels of its own: no `PageFrame`, and a rail without labels. */
    isFullBleed?: boolean;
    /** Stands alone, without rail and top bar, and also for those who have not joined. */
    isBare?: boolean;
    /** Fills the window: no rail, no top bar, no column. */
    isWhole?: boolean;
  }
}

/** Every page. A feature's pages stand in its own folder and are loaded when they are opened. */
export const routes: readonly RouteRecordRaw[] = [
  ...homeRoutes,
  ...sessionsRoutes,
  ...graphRoutes,
  ...modulesRoutes,
  ...topicsRoutes(
    () => import('./publish/TopicPublisher.vue'),
    () => import('./session-pages/panels/SessionPanels.vue'),
  ),
  ...publishRoutes,
  ...callsRoutes,
  ...clientsRoutes,
  ...bridgesRoutes,
  ...performanceRoutes,
  ...recordingsRoutes,
  ...studiesRoutes,
  ...devicesRoutes,
  ...markersRoutes,
  ...examplesRoutes,
  ...learnRoutes,
  ...partyRoutes,
  ...settingsRoutes,
  ...installRoutes,
  ...joinRoutes,
  ...connectPhoneRoutes,
  ...connectProgramRoutes,
  ...certificateRoutes,
  {
    path: '/:path(.*)*',
    component: () => import('./shell/NotFoundPage.vue'),
    meta: { title: 'No such page' },
  },
];

import { defineAsyncComponent, type AsyncComponentLoader } from 'vue';
import type { RouteRecordRaw } from 'vue-router';

/**
 * @param publisher component that publishes on a topic: properties `topic` and `record`
 * @param sessionPanels component that saves layouts of panels with sessions: see `PanelsPage`
 */
export const topicsRoutes = (
  publisher: AsyncComponentLoader,
  sessionPanels: AsyncComponentLoader,
): readonly RouteRecordRaw[] => [
  {
    // Also `/topics?topic=/a/b` and `/topics?client=<client id>`, for links written by hand.
    path: '/topics/:topic?',
    component: () => import('./TopicsPage.vue'),
    props: { publisher: defineAsyncComponent(publisher) },
    meta: { title: 'Topics' },
  },
  {
    // The layout of the panels is in `#layout=`, which browsers do not send to servers; `?session=<id>` opens that of a session.
    path: '/panels',
    component: () => import('./panels/PanelsPage.vue'),
    props: { sessionPanels: defineAsyncComponent(sessionPanels) },
    meta: { title: 'Panels', ownKeys: 'F' },
  },
];

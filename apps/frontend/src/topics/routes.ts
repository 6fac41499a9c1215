import { defineAsyncComponent, type AsyncComponentLoader } from 'vue';
import type { RouteRecordRaw } from 'vue-router';

/** @param publisher component that publishes on a topic: properties `topic` and `record` */
export const topicsRoutes = (publisher: AsyncComponentLoader): readonly RouteRecordRaw[] => [
  {
    // Also `/topics?topic=/a/b` and `/topics?client=<client id>`, for links written by hand.
    path: '/topics/:topic?',
    component: () => import('./TopicsPage.vue'),
    props: { publisher: defineAsyncComponent(publisher) },
    meta: { title: 'Topics' },
  },
  {
    // The layout of the panels is in `#layout=`, which browsers do not send to servers.
    path: '/panels',
    component: () => import('./panels/PanelsPage.vue'),
    meta: { title: 'Panels' },
  },
];

import type { Component } from 'vue';

/** An example: a page people use and a folder people read. */
export interface Example {
  readonly id: string;
  readonly title: string;
  /** What it needs or does, a few words. */
  readonly sentence: string;
  readonly path: string;
  readonly page: () => Promise<{ default: Component }>;
  /** A picture of 96 × 54 px, drawn with the tokens. */
  readonly thumbnail: () => Promise<{ default: Component }>;
}

/** Every example, in the order in which they are shown. */
export const EXAMPLES: readonly Example[] = [
  {
    id: 'mouse-pointer',
    title: 'Mouse pointer',
    sentence: 'No phone needed',
    path: '/examples/mouse-pointer',
    page: () => import('./mouse-pointer/MousePointerPage.vue'),
    thumbnail: () => import('./mouse-pointer/MousePointerThumbnail.vue'),
  },
  {
    id: 'smart-device-gatherer',
    title: 'Smart-device gatherer',
    sentence: 'Phones that feel each other',
    path: '/examples/smart-device-gatherer',
    page: () => import('./smart-device-gatherer/SmartDeviceGathererPage.vue'),
    thumbnail: () => import('./smart-device-gatherer/SmartDeviceGathererThumbnail.vue'),
  },
  {
    id: 'model-viewer',
    title: 'Model viewer',
    sentence: 'Turned by a phone',
    path: '/examples/model-viewer',
    page: () => import('./model-viewer/ModelViewerPage.vue'),
    thumbnail: () => import('./model-viewer/ModelViewerThumbnail.vue'),
  },
];

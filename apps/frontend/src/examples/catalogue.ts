import type { Component } from 'vue';

/** An example with its own page. */
export interface Example {
  readonly id: string;
  readonly title: string;
  /** Describes the example in a few words. */
  readonly sentence: string;
  readonly path: string;
  /** Undefined for examples whose page belongs to another feature. */
  readonly page?: () => Promise<{ default: Component }>;
  /** Thumbnail of 96 × 54 px in the colours of the theme. */
  readonly thumbnail: () => Promise<{ default: Component }>;
}

/** All examples in display order. */
export const EXAMPLES: readonly Example[] = [
  {
    id: 'party',
    title: 'Ubi-Party',
    sentence: 'Party games on a big screen, with phones as controllers',
    path: '/party',
    thumbnail: () => import('./party/PartyThumbnail.vue'),
  },
  {
    id: 'mouse-pointer',
    title: 'Mouse pointer',
    sentence: 'Mirrors your pointer',
    path: '/examples/mouse-pointer',
    page: () => import('./mouse-pointer/MousePointerPage.vue'),
    thumbnail: () => import('./mouse-pointer/MousePointerThumbnail.vue'),
  },
  {
    id: 'smart-device-gatherer',
    title: 'Smart-device gatherer',
    sentence: 'Vibrates phones that are touched in nearly the same place',
    path: '/examples/smart-device-gatherer',
    page: () => import('./smart-device-gatherer/SmartDeviceGathererPage.vue'),
    thumbnail: () => import('./smart-device-gatherer/SmartDeviceGathererThumbnail.vue'),
  },
  {
    id: 'model-viewer',
    title: 'Model viewer',
    sentence: 'Rotates a model with a phone',
    path: '/examples/model-viewer',
    page: () => import('./model-viewer/ModelViewerPage.vue'),
    thumbnail: () => import('./model-viewer/ModelViewerThumbnail.vue'),
  },
  {
    id: 'object-detection',
    title: 'Object detection',
    sentence: 'Finds objects, bodies and hands',
    path: '/examples/object-detection',
    page: () => import('./object-detection/ObjectDetectionPage.vue'),
    thumbnail: () => import('./object-detection/ObjectDetectionThumbnail.vue'),
  },
  {
    id: 'marker-tracking',
    title: 'Marker tracking',
    sentence: 'Finds printed markers in space',
    path: '/examples/marker-tracking',
    page: () => import('./marker-tracking/MarkerTrackingPage.vue'),
    thumbnail: () => import('./marker-tracking/MarkerTrackingThumbnail.vue'),
  },
  {
    id: 'image-processing',
    title: 'Image processing',
    sentence: 'Sends pictures through modules',
    path: '/examples/image-processing',
    page: () => import('./image-processing/ImageProcessingPage.vue'),
    thumbnail: () => import('./image-processing/ImageProcessingThumbnail.vue'),
  },
];

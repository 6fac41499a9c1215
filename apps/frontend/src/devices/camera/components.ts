import type { ComponentInit } from '@ubii/client-web';

/** Name that existing programs look for. */
export const CAMERA_DEVICE = 'CameraWebInterface';

/** Components of a camera; topics are `/<client id>/CameraWebInterface/<name>`. */
export const CAMERA_COMPONENTS = [
  {
    name: 'camera_image',
    format: 'image2D',
    tags: ['camera', 'image'],
    description: 'The newest picture, raw pixels or a JPEG file in its data.',
  },
  {
    name: 'objects',
    format: 'object2DList',
    ioType: 'subscriber',
    tags: ['camera', 'objects'],
    description: 'Objects found in the picture, drawn over it; 0 to 1 from the top left.',
  },
  // Added at the end, because existing programs may rely on the order.
  {
    name: 'calibration',
    format: 'string',
    tags: ['camera'],
    description:
      'Calibration of the camera, as JSON for marker-tracking; empty until it is calibrated.',
  },
] as const satisfies readonly ComponentInit[];

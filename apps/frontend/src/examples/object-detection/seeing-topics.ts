import type { ComponentInit } from '@ubii/client-web';

/** Name of the page's device; topics are `/<client id>/web-example-object-detection/<name>`. */
export const SEEING_DEVICE = 'web-example-object-detection';

export const SEEING_COMPONENTS = [
  {
    name: 'image',
    format: 'image2D',
    tags: ['camera', 'image'],
    description: 'The newest picture of the source, a JPEG file in its data.',
  },
  {
    name: 'threshold',
    format: 'double',
    tags: ['detection'],
    description: 'Lowest score of an object, 0 to 1.',
  },
  {
    name: 'detector',
    format: 'string',
    tags: ['detection'],
    description: 'Detector: centernet or coco-ssd.',
  },
  {
    name: 'objects',
    format: 'object2DList',
    ioType: 'subscriber',
    tags: ['objects'],
    description: 'Objects found in the picture; 0 to 1 from the top left.',
  },
  {
    name: 'belowThreshold',
    format: 'object2DList',
    ioType: 'subscriber',
    tags: ['objects'],
    description: 'Objects with a score below the threshold.',
  },
  {
    name: 'bodies',
    format: 'object2DList',
    ioType: 'subscriber',
    tags: ['pose'],
    description: 'Keypoints of the most visible body.',
  },
  {
    name: 'hands',
    format: 'object2DList',
    ioType: 'subscriber',
    tags: ['pose'],
    description: 'Keypoints of the hands.',
  },
  {
    name: 'decode',
    format: 'double',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Decoding time, milliseconds.',
  },
  {
    name: 'duration',
    format: 'double',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Decoding and detection time, milliseconds.',
  },
  {
    name: 'backend',
    format: 'string',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Backend of the detector: webgpu, webgl, wasm or cpu.',
  },
  {
    name: 'error',
    format: 'string',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Problem with picture, detector or backend; empty when there is none.',
  },
  {
    name: 'backendFault',
    format: 'string',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Failed backends and their replacements.',
  },
] as const satisfies readonly ComponentInit[];

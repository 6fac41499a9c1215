import type { ComponentInit } from '@ubii/client-web';

/** The page as a device; topics are `/<client id>/web-example-object-detection/<name>`. */
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
    description: 'Which detector is used: centernet or coco-ssd.',
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
    description: 'What was found with a score below the threshold.',
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
    description: 'Time of decoding alone, milliseconds.',
  },
  {
    name: 'duration',
    format: 'double',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Time of decoding and detection, milliseconds.',
  },
  {
    name: 'backend',
    format: 'string',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'What computes the detections: webgpu, webgl, wasm or cpu.',
  },
  {
    name: 'error',
    format: 'string',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'What is wrong with image, detector or backend; empty when all is well.',
  },
  {
    name: 'backendFault',
    format: 'string',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Which backends failed, and what replaces them.',
  },
] as const satisfies readonly ComponentInit[];

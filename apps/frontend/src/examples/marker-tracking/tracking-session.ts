import type { ComponentInit } from '@ubii/client-web';
import type { Init, Session } from '@ubii/proto';

/** Name of the page's device; topics are `/<client id>/web-example-marker-tracking/<name>`. */
export const TRACKING_DEVICE = 'web-example-marker-tracking';
export const TRACKING_MODULE = 'marker-tracking';

export const TRACKING_COMPONENTS = [
  {
    name: 'image',
    format: 'image2D',
    tags: ['camera', 'image'],
    description: 'The newest picture of the source, a JPEG file in its data.',
  },
  {
    name: 'markers',
    format: 'object3DList',
    ioType: 'subscriber',
    tags: ['pose'],
    description: 'Poses of the markers: metres, right-handed, y up, seen from the camera.',
  },
  {
    name: 'outlines',
    format: 'object2DList',
    ioType: 'subscriber',
    tags: ['objects'],
    description: 'The markers in the picture: boxes, corners and axes; 0 to 1 from the top left.',
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
    name: 'error',
    format: 'string',
    ioType: 'subscriber',
    tags: ['detection'],
    description: 'Problem with the picture or a setting; empty when there is none.',
  },
] as const satisfies readonly ComponentInit[];

type Output = 'markers' | 'outlines' | 'decodeMs' | 'durationMs' | 'error';

/** Specification of a tracking session. */
export interface TrackingSpec {
  readonly owner: string;
  /** Topic of the pictures. */
  readonly image: string;
  readonly outputs: { readonly [O in Output]: string };
  readonly dictionary: string;
  readonly sizeMetres: number;
  readonly smoothingMs: number;
  /** JSON text; empty for none. */
  readonly calibration: string;
}

/** Above the rate of any source, so that the rate is that of the pictures. */
const MAX_MODULE_HZ = 120;

/**
 * Creates a session with one module that reads pictures and writes topics of this page. Changed constants apply while
 * it runs.
 */
export function trackingSession(spec: TrackingSpec): Init<Session> {
  const constants = {
    dictionary: { string: spec.dictionary },
    markerSize: { double: spec.sizeMetres },
    smoothingMs: { double: spec.smoothingMs },
    maxRate: { double: MAX_MODULE_HZ },
    ...(spec.calibration !== '' && { calibration: { string: spec.calibration } }),
  };
  return {
    name: `Marker tracking of ${spec.owner}`,
    description:
      'Finds markers in the pictures of the Marker tracking example. Ends when the page is closed.',
    tags: ['example', 'camera'],
    processingModules: [{ name: TRACKING_MODULE }],
    ioMappings: [
      {
        processingModuleName: TRACKING_MODULE,
        inputMappings: [
          { inputName: 'image', topic: spec.image },
          ...Object.entries(constants).map(([inputName, value]) => ({
            inputName,
            constantJson: JSON.stringify(value),
          })),
        ],
        outputMappings: Object.entries(spec.outputs).map(([outputName, topic]) => ({
          outputName,
          topic,
        })),
      },
    ],
  };
}

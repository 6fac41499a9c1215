import type { ComponentInit } from '@ubii/client-web';
import type { Init, Session } from '@ubii/proto';

/** Name of the page's device; topics are `/<client id>/web-camera-calibration/<name>`. */
export const CALIBRATION_DEVICE = 'web-camera-calibration';

export const CALIBRATION_COMPONENTS = [
  {
    name: 'image',
    format: 'image2D',
    tags: ['camera', 'image'],
    description: 'The newest picture of the camera, a JPEG file in its data.',
  },
  {
    name: 'start_over',
    format: 'bool',
    tags: ['camera'],
    description: 'True discards all views.',
  },
  {
    name: 'calibration',
    format: 'string',
    ioType: 'subscriber',
    tags: ['camera'],
    description: 'The calibration as JSON, once it is computed.',
  },
  {
    name: 'views',
    format: 'double',
    ioType: 'subscriber',
    tags: ['camera'],
    description: 'Number of views of the board; 12 are enough.',
  },
  {
    name: 'hint',
    format: 'string',
    ioType: 'subscriber',
    tags: ['camera'],
    description: 'Next step for the user.',
  },
  {
    name: 'corners',
    format: 'object2DList',
    ioType: 'subscriber',
    tags: ['camera'],
    description: 'Corners of the board in the picture; 0 to 1 from the top left.',
  },
  {
    name: 'error',
    format: 'string',
    ioType: 'subscriber',
    tags: ['camera'],
    description: 'Problem with the picture or the board; empty when there is none.',
  },
] as const satisfies readonly ComponentInit[];

const OUTPUTS = ['calibration', 'views', 'hint', 'corners', 'error'] as const;
export type CalibrationComponent = (typeof CALIBRATION_COMPONENTS)[number]['name'];

/** Measures of the printed board. */
export interface PrintedBoard {
  readonly columns: number;
  readonly rows: number;
  readonly squareMetres: number;
  readonly markerMetres: number;
}

/** Creates a session with the module `camera-calibration` that reads and writes topics of this page. */
export function calibrationSession(
  owner: string,
  board: PrintedBoard,
  topicOf: (component: CalibrationComponent) => string,
): Init<Session> {
  const module = 'camera-calibration';
  const constants = {
    columns: board.columns,
    rows: board.rows,
    squareSize: board.squareMetres,
    markerSize: board.markerMetres,
    maxRate: 10,
  };
  return {
    name: `Camera calibration of ${owner}`,
    description: 'Calibrates a camera with a printed board. Ends when the page is closed.',
    tags: ['camera'],
    processingModules: [{ name: module }],
    ioMappings: [
      {
        processingModuleName: module,
        inputMappings: [
          { inputName: 'image', topic: topicOf('image') },
          { inputName: 'startOver', topic: topicOf('start_over') },
          ...Object.entries(constants).map(([inputName, value]) => ({
            inputName,
            constantJson: JSON.stringify({ double: value }),
          })),
        ],
        outputMappings: OUTPUTS.map((name) => ({ outputName: name, topic: topicOf(name) })),
      },
    ],
  };
}

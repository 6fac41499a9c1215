import {
  componentTopic,
  parseDataFormat,
  type Init,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';

/** Name of the page's device. */
export const PROCESSING_DEVICE = 'web-example-image-processing';

/** True for modules with an input for pictures. */
export function takesPictures({ inputs }: Pick<ProcessingModule, 'inputs'>): boolean {
  return pictureInput({ inputs }) !== undefined;
}

/** Returns the input for pictures. */
function pictureInput({ inputs }: Pick<ProcessingModule, 'inputs'>) {
  return inputs.find(
    ({ messageFormat, isRecordList }) =>
      parseDataFormat(messageFormat) === 'image2D' && !isRecordList,
  );
}

/** Returns the other inputs, which the user sets as constants. */
export function parametersOf(module: Pick<ProcessingModule, 'inputs'>) {
  const picture = pictureInput(module);
  return module.inputs.filter((input) => input !== picture && !input.isRecordList);
}

/** Topic of an output. */
export const outputTopic = (clientId: string, output: string): string =>
  componentTopic(clientId, PROCESSING_DEVICE, output);

export interface ProcessingSpec {
  readonly owner: string;
  readonly clientId: string;
  readonly module: Pick<ProcessingModule, 'name' | 'inputs' | 'outputs'>;
  /** Topic of the pictures. */
  readonly image: string;
  /** Values of parameters that the user set, as JSON text such as `{"double":1}`. */
  readonly parameters: ReadonlyMap<string, string>;
}

/** Creates a session with one module that reads pictures and writes topics of this page. */
export function processingSession(spec: ProcessingSpec): Init<Session> {
  const { owner, clientId, module, image, parameters } = spec;
  const picture = pictureInput(module)?.internalName ?? '';
  return {
    name: `Image processing of ${owner}`,
    description:
      'Processes the pictures of the Image processing example. Ends when the page is closed.',
    tags: ['example', 'camera'],
    processingModules: [{ name: module.name }],
    ioMappings: [
      {
        processingModuleName: module.name,
        inputMappings: [
          { inputName: picture, topic: image },
          ...parametersOf(module).flatMap(({ internalName }) => {
            const constantJson = parameters.get(internalName);
            return constantJson === undefined ? [] : [{ inputName: internalName, constantJson }];
          }),
        ],
        outputMappings: module.outputs.map(({ internalName }) => ({
          outputName: internalName,
          topic: outputTopic(clientId, internalName),
        })),
      },
    ],
  };
}

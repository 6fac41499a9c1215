import {
  componentTopic,
  parseDataFormat,
  type Init,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';

/** The page as a device. */
export const PROCESSING_DEVICE = 'web-example-image-processing';

/** True for modules that process pictures: one of their inputs takes them. */
export function takesPictures({ inputs }: Pick<ProcessingModule, 'inputs'>): boolean {
  return pictureInput({ inputs }) !== undefined;
}

/** The input for the pictures. */
function pictureInput({ inputs }: Pick<ProcessingModule, 'inputs'>) {
  return inputs.find(
    ({ messageFormat, isRecordList }) =>
      parseDataFormat(messageFormat) === 'image2D' && !isRecordList,
  );
}

/** The other inputs: constants that people set. */
export function parametersOf(module: Pick<ProcessingModule, 'inputs'>) {
  const picture = pictureInput(module);
  return module.inputs.filter((input) => input !== picture && !input.isRecordList);
}

/** Where an output goes. */
export const outputTopic = (clientId: string, output: string): string =>
  componentTopic(clientId, PROCESSING_DEVICE, output);

export interface ProcessingSpec {
  readonly owner: string;
  readonly clientId: string;
  readonly module: Pick<ProcessingModule, 'name' | 'inputs' | 'outputs'>;
  /** Topic of the pictures. */
  readonly image: string;
  /** What was set of the parameters, as JSON such as `{"double":1}`. */
  readonly parameters: ReadonlyMap<string, string>;
}

/** One module between a topic of pictures and topics of this page. */
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

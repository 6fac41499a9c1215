import type { ModuleIO } from '@ubii/proto';
import { expect, it } from 'vitest';
import { parametersOf, processingSession, takesPictures } from './processing-session.ts';

const io = (internalName: string, messageFormat: string, isRecordList = false): ModuleIO => ({
  internalName,
  messageFormat,
  isRecordList,
  defaultJson: '',
  description: '',
  choices: [],
});
const module = {
  name: 'tools',
  inputs: [
    io('maxSide', 'double'),
    io('image', 'ubii.dataStructure.Image2D'),
    io('format', 'string'),
  ],
  outputs: [io('image', 'image2D'), io('motion', 'double')],
};

it('fits modules with an input for pictures', () => {
  expect(takesPictures(module)).toBe(true);
  expect(takesPictures({ inputs: [io('value', 'double')] })).toBe(false);
  expect(takesPictures({ inputs: [io('images', 'image2D', true)] })).toBe(false);
  expect(parametersOf(module).map(({ internalName }) => internalName)).toEqual([
    'maxSide',
    'format',
  ]);
});

it('wires pictures in, parameters that were set, and every output to a topic of the page', () => {
  const parameters = new Map([
    ['maxSide', '{"double":160}'],
    ['gone', '{"double":1}'],
  ]);
  const spec = { owner: 'Ada', clientId: 'c1', module, image: '/cam', parameters };
  expect(processingSession(spec)).toMatchObject({
    name: 'Image processing of Ada',
    processingModules: [{ name: 'tools' }],
    ioMappings: [
      {
        processingModuleName: 'tools',
        inputMappings: [
          { inputName: 'image', topic: '/cam' },
          { inputName: 'maxSide', constantJson: '{"double":160}' },
        ],
        outputMappings: [
          { outputName: 'image', topic: '/c1/web-example-image-processing/image' },
          { outputName: 'motion', topic: '/c1/web-example-image-processing/motion' },
        ],
      },
    ],
  });
});

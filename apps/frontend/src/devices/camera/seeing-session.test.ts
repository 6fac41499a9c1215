import { expect, it } from 'vitest';
import { seeingSession } from './seeing-session.ts';

const spec = { name: 'Seeing', description: '', tags: ['camera'], image: '/cam/image' };

it('has a module for each thing that is looked for, and wires pictures to all of them', () => {
  const session = seeingSession({
    ...spec,
    found: { objects: '/objects', bodies: undefined, hands: '/hands' },
    inputs: { threshold: '/threshold' },
    outputs: { durationMs: '/duration', backend: undefined },
    constants: { maxRate: { double: 60 } },
  });
  expect(session.processingModules).toEqual([{ name: 'object-detection' }, { name: 'hand-pose' }]);
  expect(session.ioMappings).toEqual([
    {
      processingModuleName: 'object-detection',
      inputMappings: [
        { inputName: 'image', topic: '/cam/image' },
        { inputName: 'threshold', topic: '/threshold' },
        { inputName: 'maxRate', constantJson: '{"double":60}' },
      ],
      outputMappings: [
        { outputName: 'predictions', topic: '/objects' },
        { outputName: 'durationMs', topic: '/duration' },
      ],
    },
    {
      processingModuleName: 'hand-pose',
      inputMappings: [
        { inputName: 'image', topic: '/cam/image' },
        { inputName: 'maxRate', constantJson: '{"double":60}' },
      ],
      outputMappings: [{ outputName: 'keypoints', topic: '/hands' }],
    },
  ]);
});

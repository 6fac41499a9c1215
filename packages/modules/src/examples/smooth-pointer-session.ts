import type { Init, Session } from '@ubii/proto';

/**
 * The smallest session with a visible result: smooths a position. To use it, replace the first topic with
 * the topic of a pointer.
 */
export const smoothPointerSession = {
  name: 'Smooth a pointer',
  description:
    'Smooths the position of one topic with a 1€ filter and publishes it on another topic.',
  tags: ['example'],
  // At a frequency, as it also moves while the pointer rests: until it is there
  processingModules: [
    { name: 'one-euro-filter-vector2', processingMode: { frequency: { hertz: 60 } } },
  ],
  ioMappings: [
    {
      processingModuleName: 'one-euro-filter-vector2',
      inputMappings: [
        { inputName: 'value', topic: '/examples/smooth-pointer/pointer' },
        { inputName: 'minCutoffHz', constantJson: '{"double":0.5}' },
        { inputName: 'beta', constantJson: '{"double":0.5}' },
      ],
      outputMappings: [{ outputName: 'smoothed', topic: '/examples/smooth-pointer/smoothed' }],
    },
  ],
} satisfies Init<Session>;

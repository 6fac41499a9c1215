import type { Init, Session } from '@ubii/proto';

/** Computes the mean of noise over the last second: a source, a mixer, and statistics with a time window. */
export const movingAverageSession = {
  name: 'Moving average',
  description: 'Computes the mean of a noisy random walk over the last second.',
  tags: ['example'],
  processingModules: [
    { name: 'noise', processingMode: { frequency: { hertz: 30 } } },
    { name: 'mix' },
    { name: 'statistics' },
  ],
  ioMappings: [
    {
      processingModuleName: 'noise',
      inputMappings: [{ inputName: 'walkSpeed', constantJson: '{"double":0.6}' }],
      outputMappings: [
        { outputName: 'walk', topic: '/examples/moving-average/walk' },
        { outputName: 'uniform', topic: '/examples/moving-average/noise' },
      ],
    },
    {
      processingModuleName: 'mix',
      inputMappings: [
        { inputName: 'a', topic: '/examples/moving-average/walk' },
        { inputName: 'b', topic: '/examples/moving-average/noise' },
        { inputName: 'gainB', constantJson: '{"double":0.4}' },
      ],
      outputMappings: [{ outputName: 'mixed', topic: '/examples/moving-average/noisy' }],
    },
    {
      processingModuleName: 'statistics',
      inputMappings: [
        { inputName: 'value', topic: '/examples/moving-average/noisy' },
        { inputName: 'windowMs', constantJson: '{"double":1000}' },
      ],
      outputMappings: [
        { outputName: 'mean', topic: '/examples/moving-average/mean' },
        { outputName: 'standardDeviation', topic: '/examples/moving-average/deviation' },
      ],
    },
  ],
} satisfies Init<Session>;

import type { Init, Session } from '@ubii/proto';

/**
 * Four modules in a row: a clock generates a square wave, which is mapped to another range and smoothed;
 * the last module computes its statistics. It has no inputs, so that it runs everywhere.
 */
export const smoothingChainSession = {
  name: 'Smoothing chain',
  description:
    'Maps a square wave to 0 to 100, smooths it with a 1€ filter, and computes statistics.',
  tags: ['example'],
  processingModules: [
    { name: 'clock', processingMode: { frequency: { hertz: 60 } } },
    { name: 'map-range' },
    { name: 'one-euro-filter' },
    { name: 'statistics' },
  ],
  ioMappings: [
    {
      processingModuleName: 'clock',
      inputMappings: [{ inputName: 'waveHz', constantJson: '{"double":0.5}' }],
      outputMappings: [{ outputName: 'square', topic: '/examples/smoothing-chain/wave' }],
    },
    {
      processingModuleName: 'map-range',
      inputMappings: [
        { inputName: 'value', topic: '/examples/smoothing-chain/wave' },
        { inputName: 'inMin', constantJson: '{"double":-1}' },
        { inputName: 'outMax', constantJson: '{"double":100}' },
      ],
      outputMappings: [{ outputName: 'mapped', topic: '/examples/smoothing-chain/mapped' }],
    },
    {
      processingModuleName: 'one-euro-filter',
      inputMappings: [
        { inputName: 'value', topic: '/examples/smoothing-chain/mapped' },
        { inputName: 'minCutoffHz', constantJson: '{"double":1}' },
        { inputName: 'beta', constantJson: '{"double":0.001}' },
      ],
      outputMappings: [{ outputName: 'smoothed', topic: '/examples/smoothing-chain/smoothed' }],
    },
    {
      processingModuleName: 'statistics',
      inputMappings: [
        { inputName: 'value', topic: '/examples/smoothing-chain/smoothed' },
        { inputName: 'windowMs', constantJson: '{"double":2000}' },
      ],
      outputMappings: [
        { outputName: 'mean', topic: '/examples/smoothing-chain/mean' },
        { outputName: 'min', topic: '/examples/smoothing-chain/min' },
        { outputName: 'max', topic: '/examples/smoothing-chain/max' },
        { outputName: 'standardDeviation', topic: '/examples/smoothing-chain/deviation' },
      ],
    },
  ],
} satisfies Init<Session>;

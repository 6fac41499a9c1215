import type { Init, Session } from '@ubii/proto';

/** Two instances of one module with different constants, and a module that adds their waves. */
export const mixedWavesSession = {
  name: 'Two waves, mixed',
  description: 'Adds two waves of different frequencies.',
  tags: ['example'],
  processingModules: [
    { name: 'clock', processingMode: { frequency: { hertz: 60 } } },
    { name: 'clock', processingMode: { frequency: { hertz: 60 } } },
    { name: 'mix' },
  ],
  ioMappings: [
    {
      processingModuleName: 'clock',
      inputMappings: [{ inputName: 'waveHz', constantJson: '{"double":0.4}' }],
      outputMappings: [{ outputName: 'sine', topic: '/examples/mixed-waves/slow' }],
    },
    {
      processingModuleName: 'clock',
      inputMappings: [
        { inputName: 'waveHz', constantJson: '{"double":2.2}' },
        { inputName: 'amplitude', constantJson: '{"double":0.4}' },
      ],
      outputMappings: [{ outputName: 'triangle', topic: '/examples/mixed-waves/fast' }],
    },
    {
      processingModuleName: 'mix',
      inputMappings: [
        { inputName: 'a', topic: '/examples/mixed-waves/slow' },
        { inputName: 'b', topic: '/examples/mixed-waves/fast' },
      ],
      outputMappings: [{ outputName: 'mixed', topic: '/examples/mixed-waves/mixed' }],
    },
  ],
} satisfies Init<Session>;

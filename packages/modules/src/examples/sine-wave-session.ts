import type { Init, Session } from '@ubii/proto';

/** The smallest session without inputs: one module that runs at a frequency and generates a wave. */
export const sineWaveSession = {
  name: 'Sine wave',
  description: 'Generates a sine wave of 0.5 Hz with 60 values per second.',
  tags: ['example'],
  processingModules: [{ name: 'clock', processingMode: { frequency: { hertz: 60 } } }],
  ioMappings: [
    {
      processingModuleName: 'clock',
      inputMappings: [{ inputName: 'waveHz', constantJson: '{"double":0.5}' }],
      outputMappings: [{ outputName: 'sine', topic: '/examples/sine-wave/wave' }],
    },
  ],
} satisfies Init<Session>;

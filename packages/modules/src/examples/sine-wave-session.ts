import type { Init, Session } from '@ubii/proto';

/** The smallest session that needs nothing: one module that runs at a frequency and makes a wave. */
export const sineWaveSession = {
  name: 'sine-wave',
  description: 'One module makes a sine wave, 60 times a second.',
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

import type { Init, Session } from '@ubii/proto';

/** A noisy wave crosses a threshold. With hysteresis, each crossing causes only one event. */
export const hysteresisSession = {
  name: 'Threshold with hysteresis',
  description:
    'Converts a noisy wave to events: when it rises to 0.2, and when it falls below −0.2.',
  tags: ['example'],
  processingModules: [
    { name: 'clock', processingMode: { frequency: { hertz: 30 } } },
    { name: 'noise', processingMode: { frequency: { hertz: 30 } } },
    { name: 'mix' },
    { name: 'threshold' },
  ],
  ioMappings: [
    {
      processingModuleName: 'clock',
      inputMappings: [{ inputName: 'waveHz', constantJson: '{"double":0.5}' }],
      outputMappings: [{ outputName: 'sine', topic: '/examples/hysteresis/wave' }],
    },
    {
      processingModuleName: 'noise',
      inputMappings: [{ inputName: 'amplitude', constantJson: '{"double":0.25}' }],
      outputMappings: [{ outputName: 'uniform', topic: '/examples/hysteresis/noise' }],
    },
    {
      processingModuleName: 'mix',
      inputMappings: [
        { inputName: 'a', topic: '/examples/hysteresis/wave' },
        { inputName: 'b', topic: '/examples/hysteresis/noise' },
      ],
      outputMappings: [{ outputName: 'mixed', topic: '/examples/hysteresis/noisy' }],
    },
    {
      processingModuleName: 'threshold',
      inputMappings: [
        { inputName: 'value', topic: '/examples/hysteresis/noisy' },
        { inputName: 'threshold', constantJson: '{"double":0.2}' },
        { inputName: 'hysteresis', constantJson: '{"double":0.4}' },
      ],
      outputMappings: [
        { outputName: 'isAbove', topic: '/examples/hysteresis/is_above' },
        { outputName: 'rose', topic: '/examples/hysteresis/rose' },
        { outputName: 'fell', topic: '/examples/hysteresis/fell' },
        { outputName: 'riseCount', topic: '/examples/hysteresis/rise_count' },
      ],
    },
  ],
} satisfies Init<Session>;

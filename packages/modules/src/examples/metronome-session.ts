import type { Init, Session } from '@ubii/proto';

/**
 * The same module in two processing modes: one instance runs at a frequency with a timer of its own, the
 * other one runs in the lockstep passes of the session. The difference of their times is the drift.
 */
export const metronomeSession = {
  name: 'Metronome and drift',
  description:
    'Ticks at 2 Hz, and compares the time of a frequency module with that of a lockstep module.',
  tags: ['example'],
  processingModules: [
    { name: 'clock', processingMode: { frequency: { hertz: 25 } } },
    { name: 'clock', processingMode: { lockstep: {} } },
    { name: 'mix' },
    { name: 'counter' },
  ],
  ioMappings: [
    {
      processingModuleName: 'clock',
      inputMappings: [{ inputName: 'waveHz', constantJson: '{"double":2}' }],
      outputMappings: [
        { outputName: 'tick', topic: '/examples/metronome/tick' },
        { outputName: 'elapsedMs', topic: '/examples/metronome/frequency_ms' },
      ],
    },
    {
      processingModuleName: 'clock',
      outputMappings: [{ outputName: 'elapsedMs', topic: '/examples/metronome/lockstep_ms' }],
    },
    {
      processingModuleName: 'mix',
      inputMappings: [
        { inputName: 'a', topic: '/examples/metronome/frequency_ms' },
        { inputName: 'b', topic: '/examples/metronome/lockstep_ms' },
        { inputName: 'gainB', constantJson: '{"double":-1}' },
      ],
      outputMappings: [{ outputName: 'mixed', topic: '/examples/metronome/drift_ms' }],
    },
    {
      processingModuleName: 'counter',
      inputMappings: [{ inputName: 'event', topic: '/examples/metronome/tick' }],
      outputMappings: [{ outputName: 'count', topic: '/examples/metronome/beats' }],
    },
  ],
} satisfies Init<Session>;

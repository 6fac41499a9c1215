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

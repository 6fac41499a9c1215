import type { Init, Session } from '@ubii/proto';

/**
 * The mouse-pointer example of the paper on Ubi-Interact (section 7.1): mirrors a position, depending on
 * two switches.
 */
export const mirrorPointerSession = {
  name: 'Mirror a pointer',
  description: 'Mirrors the position of one topic and publishes it on another topic.',
  tags: ['example'],
  processingModules: [{ name: 'mirror-pointer' }],
  ioMappings: [
    {
      processingModuleName: 'mirror-pointer',
      inputMappings: [
        { inputName: 'pointer', topic: '/examples/mirror-pointer/pointer' },
        { inputName: 'mirrorX', topic: '/examples/mirror-pointer/mirror_x' },
        { inputName: 'mirrorY', topic: '/examples/mirror-pointer/mirror_y' },
      ],
      outputMappings: [{ outputName: 'mirrored', topic: '/examples/mirror-pointer/mirrored' }],
    },
  ],
} satisfies Init<Session>;

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

/** Computes the speed of a position. Runs at a frequency, so that the speed of a resting pointer is 0. */
export const pointerSpeedSession = {
  name: 'Pointer speed',
  description: 'Computes the velocity and the speed of a position.',
  tags: ['example'],
  processingModules: [{ name: 'speed-vector2', processingMode: { frequency: { hertz: 30 } } }],
  ioMappings: [
    {
      processingModuleName: 'speed-vector2',
      inputMappings: [
        { inputName: 'position', topic: '/examples/pointer-speed/pointer' },
        { inputName: 'smoothingMs', constantJson: '{"double":150}' },
      ],
      outputMappings: [
        { outputName: 'speed', topic: '/examples/pointer-speed/speed' },
        { outputName: 'velocity', topic: '/examples/pointer-speed/velocity' },
      ],
    },
  ],
} satisfies Init<Session>;

/** Converts between data formats: a vector to a colour, each time it changes. */
export const pointerColorSession = {
  name: 'Pointer to colour',
  description: 'Converts a position to a colour: hue from x, lightness from y.',
  tags: ['example'],
  processingModules: [{ name: 'position-color' }],
  ioMappings: [
    {
      processingModuleName: 'position-color',
      inputMappings: [{ inputName: 'position', topic: '/examples/pointer-color/pointer' }],
      outputMappings: [
        { outputName: 'color', topic: '/examples/pointer-color/color' },
        { outputName: 'hex', topic: '/examples/pointer-color/hex' },
      ],
    },
  ],
} satisfies Init<Session>;

/** Shows events instead of a stream: the module runs only when an event arrives, and keeps its count as state. */
export const clickCounterSession = {
  name: 'Click counter',
  description: 'Counts pointer presses; the Escape key sets the count to 0.',
  tags: ['example'],
  processingModules: [{ name: 'counter' }],
  ioMappings: [
    {
      processingModuleName: 'counter',
      inputMappings: [
        { inputName: 'event', topic: '/examples/click-counter/pressed' },
        { inputName: 'reset', topic: '/examples/click-counter/reset' },
      ],
      outputMappings: [{ outputName: 'count', topic: '/examples/click-counter/count' }],
    },
  ],
} satisfies Init<Session>;

/** Converts key events to a text, with a module that stores the keys that are held. */
export const keyChordSession = {
  name: 'Keys to text',
  description: 'Joins the keys that are held down into one text.',
  tags: ['example'],
  processingModules: [{ name: 'key-chord' }],
  ioMappings: [
    {
      processingModuleName: 'key-chord',
      inputMappings: [{ inputName: 'key', topic: '/examples/key-chord/key' }],
      outputMappings: [
        { outputName: 'chord', topic: '/examples/key-chord/chord' },
        { outputName: 'count', topic: '/examples/key-chord/count' },
      ],
    },
  ],
} satisfies Init<Session>;

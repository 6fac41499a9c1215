import type { Init, Session } from '@ubii/proto';

/** A value of one format becomes a value of another one: a vector a colour, each time it changes. */
export const pointerColorSession = {
  name: 'pointer-color',
  description: 'Turns the position on one topic into a colour: hue by x, lightness by y.',
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

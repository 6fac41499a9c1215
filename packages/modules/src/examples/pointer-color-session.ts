import type { Init, Session } from '@ubii/proto';

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

import type { Init, Session } from '@ubii/proto';

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

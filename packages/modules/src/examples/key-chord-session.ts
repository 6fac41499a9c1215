import type { Init, Session } from '@ubii/proto';

/** Key events become a text: a module with a memory of what is held. */
export const keyChordSession = {
  name: 'key-chord',
  description: 'The keys that are held together, as text.',
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

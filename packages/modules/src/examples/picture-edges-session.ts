import type { Init, Session } from '@ubii/proto';

/** Images are records like any other: a module makes pictures, another one finds their edges. */
export const pictureEdgesSession = {
  name: 'picture-edges',
  description: 'A generated picture, the same in grey, and its edges.',
  tags: ['example'],
  processingModules: [{ name: 'test-picture' }, { name: 'picture-edges' }],
  ioMappings: [
    {
      processingModuleName: 'test-picture',
      outputMappings: [{ outputName: 'picture', topic: '/examples/picture-edges/picture' }],
    },
    {
      processingModuleName: 'picture-edges',
      inputMappings: [{ inputName: 'picture', topic: '/examples/picture-edges/picture' }],
      outputMappings: [
        { outputName: 'grey', topic: '/examples/picture-edges/grey' },
        { outputName: 'edges', topic: '/examples/picture-edges/edges' },
      ],
    },
  ],
} satisfies Init<Session>;

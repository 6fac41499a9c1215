import type { Init, Session } from '@ubii/proto';

/** Images are records as all values: one module generates images, another one detects their edges. */
export const pictureEdgesSession = {
  name: 'Edges of a picture',
  description: 'Generates a picture, converts it to greyscale, and detects its edges.',
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

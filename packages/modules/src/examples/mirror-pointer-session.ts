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

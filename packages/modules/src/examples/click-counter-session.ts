import type { Init, Session } from '@ubii/proto';

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

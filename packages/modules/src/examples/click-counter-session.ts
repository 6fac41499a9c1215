import type { Init, Session } from '@ubii/proto';

/** Events instead of a stream: the module runs only when something happens, and keeps its count in between. */
export const clickCounterSession = {
  name: 'click-counter',
  description: 'Counts presses of the pointer. The Escape key sets the counter to zero.',
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

import type { Init, Session } from '@ubii/proto';

/**
 * The smallest session that does something to see: a position goes in, and comes out calmer. Whoever
 * uses it puts a pointer of theirs in the place of the first topic.
 */
export const smoothPointerSession = {
  name: 'smooth-pointer',
  description: 'Smooths the position on one topic with a 1€ filter, and puts it on another one.',
  tags: ['example'],
  processingModules: [{ name: 'one-euro-filter-vector2' }],
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

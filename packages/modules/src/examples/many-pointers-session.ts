import { UUID_PATTERN, type Init, type Session } from '@ubii/proto';

/** Two pointers that the session moves, so that there are several pointers from the start. */
const MOVING = [
  { id: 'circle', hertz: 0.25, phase: 0, y: 'triangle' },
  { id: 'wave', hertz: 0.4, phase: 0.25, y: 'sine' },
] as const;

/**
 * A muxer collects the pointers of all pages and phones and two moving points in one module. A demuxer
 * publishes a result for each of them.
 */
export const manyPointersSession = {
  name: 'Mean of many pointers',
  description:
    'Computes the mean of all pointers, and publishes the offset of each on its own topic.',
  tags: ['example'],
  processingModules: [
    ...MOVING.flatMap(() => [
      { name: 'clock', processingMode: { frequency: { hertz: 30 } } },
      { name: 'clock', processingMode: { frequency: { hertz: 30 } } },
      { name: 'merge-vector2', processingMode: { frequency: { hertz: 30 } } },
    ]),
    { name: 'average-positions' },
  ],
  ioMappings: [
    ...MOVING.flatMap(({ id, hertz, phase, y }) => {
      const topic = `/examples/many-pointers/${id}`;
      const wave = (phase: number, amplitude: number) => [
        { inputName: 'waveHz', constantJson: `{"double":${hertz}}` },
        { inputName: 'phase', constantJson: `{"double":${phase}}` },
        { inputName: 'amplitude', constantJson: `{"double":${amplitude}}` },
        { inputName: 'offset', constantJson: '{"double":0.5}' },
      ];
      return [
        {
          processingModuleName: 'clock',
          inputMappings: wave(phase, 0.4),
          outputMappings: [{ outputName: 'sine', topic: `${topic}/x` }],
        },
        {
          processingModuleName: 'clock',
          inputMappings: wave(phase + 0.25, 0.3),
          outputMappings: [{ outputName: y, topic: `${topic}/y` }],
        },
        {
          processingModuleName: 'merge-vector2',
          inputMappings: [
            { inputName: 'x', topic: `${topic}/x` },
            { inputName: 'y', topic: `${topic}/y` },
          ],
          outputMappings: [{ outputName: 'vector', topic: `${topic}/position` }],
        },
      ];
    }),
    {
      processingModuleName: 'average-positions',
      inputMappings: [
        {
          inputName: 'positions',
          topicMux: {
            name: 'all pointers',
            dataType: 'vector2',
            topicSelector:
              '^/(?:examples/many-pointers/[a-z]+/position|[^/]+/web-example-mouse-pointer/mouse_client_position|[^/]+/web-interface-smart-device/touch_position)$',
            identityMatchPattern: `${UUID_PATTERN}|circle|wave`,
          },
        },
      ],
      outputMappings: [
        { outputName: 'middle', topic: '/examples/many-pointers/middle' },
        { outputName: 'count', topic: '/examples/many-pointers/count' },
        {
          outputName: 'offsets',
          topicDemux: {
            name: 'offset of each pointer',
            dataType: 'vector2',
            outputTopicFormat: '/examples/many-pointers/offset/{{#0}}',
          },
        },
      ],
    },
  ],
} satisfies Init<Session>;

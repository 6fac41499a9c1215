import { UUID_PATTERN, type Init, type Session } from '@ubii/proto';

/** Waves of two clocks. */
const WAVES = [
  { hertz: 0.25, phase: 0, outputs: { sine: 'loop/x', triangle: 'wave/y' } },
  { hertz: 0.4, phase: 0.25, outputs: { sine: 'wave/x', triangle: 'loop/y' } },
] as const;
/** Two pointers that the clocks move, so that there are several pointers from the start. */
const MOVING = ['loop', 'wave'] as const;
const TOPIC = '/examples/many-pointers';
const MODE = { frequency: { hertz: 30 } };

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
    ...WAVES.map(() => ({ name: 'clock', processingMode: MODE })),
    ...MOVING.map(() => ({ name: 'merge-vector2', processingMode: MODE })),
    { name: 'average-positions' },
  ],
  ioMappings: [
    ...WAVES.map(({ hertz, phase, outputs }) => ({
      processingModuleName: 'clock',
      inputMappings: [
        { inputName: 'waveHz', constantJson: `{"double":${hertz}}` },
        { inputName: 'phase', constantJson: `{"double":${phase}}` },
        { inputName: 'amplitude', constantJson: '{"double":0.35}' },
        { inputName: 'offset', constantJson: '{"double":0.5}' },
      ],
      outputMappings: Object.entries(outputs).map(([outputName, topic]) => ({
        outputName,
        topic: `${TOPIC}/${topic}`,
      })),
    })),
    ...MOVING.map((id) => ({
      processingModuleName: 'merge-vector2',
      inputMappings: [
        { inputName: 'x', topic: `${TOPIC}/${id}/x` },
        { inputName: 'y', topic: `${TOPIC}/${id}/y` },
      ],
      outputMappings: [{ outputName: 'vector', topic: `${TOPIC}/${id}/position` }],
    })),
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
            identityMatchPattern: `${UUID_PATTERN}|loop|wave`,
          },
        },
      ],
      outputMappings: [
        { outputName: 'middle', topic: `${TOPIC}/middle` },
        { outputName: 'count', topic: `${TOPIC}/count` },
        {
          outputName: 'offsets',
          topicDemux: {
            name: 'offset of each pointer',
            dataType: 'vector2',
            outputTopicFormat: `${TOPIC}/offset/{{#0}}`,
          },
        },
      ],
    },
  ],
} satisfies Init<Session>;

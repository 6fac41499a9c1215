import { UUID_PATTERN, type Init, type Session } from '@ubii/proto';

/**
 * A muxer collects the pointers of all clients, of mice and fingers, and a module counts those that are
 * near one another. The muxer includes clients that join later.
 */
export const gatherPointersSession = {
  name: 'Gather pointers',
  description: 'Collects the pointers of all clients, and counts those that are near one another.',
  tags: ['example'],
  processingModules: [{ name: 'touch-proximity' }],
  ioMappings: [
    {
      processingModuleName: 'touch-proximity',
      inputMappings: [
        {
          inputName: 'touches',
          topicMux: {
            name: 'pointers of all clients',
            dataType: 'vector2',
            topicSelector:
              '^/[^/]+/(?:web-example-mouse-pointer/mouse_client_position|web-interface-smart-device/touch_position)$',
            identityMatchPattern: UUID_PATTERN,
          },
        },
        { inputName: 'distance', constantJson: '{"double":0.2}' },
      ],
      outputMappings: [{ outputName: 'nearCount', topic: '/examples/gather-pointers/near_count' }],
    },
  ],
} satisfies Init<Session>;

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

/**
 * The muxer example of the paper on Ubi-Interact (section 5.6): each phone with an open touch page takes
 * part, and phones that are touched near one another vibrate.
 */
export const touchProximitySession = {
  name: 'Touch proximity',
  description: 'Makes phones vibrate that are touched at nearly the same position.',
  tags: ['example'],
  processingModules: [{ name: 'touch-proximity' }],
  ioMappings: [
    {
      processingModuleName: 'touch-proximity',
      inputMappings: [
        {
          inputName: 'touches',
          topicMux: {
            name: 'touches of all phones',
            dataType: 'vector2',
            topicSelector: '^/[^/]+/web-interface-smart-device/touch_position$',
            identityMatchPattern: UUID_PATTERN,
          },
        },
        {
          inputName: 'touching',
          topicMux: {
            name: 'touch states of all phones',
            dataType: 'bool',
            topicSelector: '^/[^/]+/web-interface-smart-device/is_touched$',
            identityMatchPattern: UUID_PATTERN,
          },
        },
        { inputName: 'distance', topic: '/examples/touch-proximity/distance' },
      ],
      outputMappings: [
        {
          outputName: 'vibration',
          topicDemux: {
            name: 'vibration of each phone',
            dataType: 'double',
            outputTopicFormat: '/{{#0}}/vibration_pattern',
          },
        },
        {
          outputName: 'isNear',
          topicDemux: {
            name: 'proximity of each phone',
            dataType: 'bool',
            outputTopicFormat: '/{{#0}}/web-interface-smart-device/is_near',
          },
        },
        { outputName: 'nearCount', topic: '/examples/touch-proximity/near_count' },
      ],
    },
  ],
} satisfies Init<Session>;

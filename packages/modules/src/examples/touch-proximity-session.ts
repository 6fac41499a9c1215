import { UUID_PATTERN, type Init, type Session } from '@ubii/proto';

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

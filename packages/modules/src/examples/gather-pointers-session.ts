import { UUID_PATTERN, type Init, type Session } from '@ubii/proto';

/**
 * One muxer gathers the pointers of all clients, mice and fingers alike, and a module counts those that
 * are near one another. Who comes later is in it at once.
 */
export const gatherPointersSession = {
  name: 'gather-pointers',
  description: 'Gathers the pointers of all clients, and counts those that are near one another.',
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

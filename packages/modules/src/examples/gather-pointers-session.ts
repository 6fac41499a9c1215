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

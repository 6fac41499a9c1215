import { defineProcessingModule } from '@ubii/pm-sandbox';

/**
 * Computes the mean of many positions and the offset of each position from the mean. A muxer collects
 * the positions; a demuxer publishes the offset of each client on a topic of that client.
 */
export const averagePositions = defineProcessingModule({
  name: 'average-positions',
  description: 'Computes the mean of positions, and all offsets.',
  tags: ['vector', 'muxer', 'demuxer', 'pointer'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    positions: { format: 'vector2', list: true, description: 'Positions to average, up to 1e100.' },
  },
  outputs: {
    middle: { format: 'vector2', description: 'Mean of the positions, in their unit.' },
    count: { format: 'int32', description: 'Number of positions.' },
    offsets: {
      format: 'vector2',
      list: true,
      description: 'Position minus mean, one for each identity.',
    },
  },
  mode: { frequency: { hertz: 30 } },
  onProcessing(_deltaTimeMs, inputs) {
    // Larger numbers are dropped, because their sum could be infinite. An unmapped input has no list.
    const usable = (inputs.positions?.elements ?? []).filter(
      ({ vector2 }) => Math.abs(vector2.x) <= 1e100 && Math.abs(vector2.y) <= 1e100,
    );
    const count = usable.length;
    if (count === 0) return { outputs: { count: { int32: 0 } } };
    const middle = { x: 0, y: 0 };
    for (const { vector2 } of usable) {
      middle.x += vector2.x / count;
      middle.y += vector2.y / count;
    }
    const offsets = usable.flatMap(({ identity, vector2 }) =>
      identity
        ? [
            {
              vector2: { x: vector2.x - middle.x, y: vector2.y - middle.y },
              outputTopicParams: [identity],
            },
          ]
        : [],
    );
    return {
      outputs: {
        middle: { vector2: middle },
        count: { int32: count },
        offsets: { elements: offsets },
      },
    };
  },
});

import { defineProcessingModule } from '@ubii/pm-sandbox';

/**
 * The middle of many positions, and for each of them how far it is from the middle. A muxer brings the
 * positions; a demuxer takes the offsets back to where they came from.
 */
export const averagePositions = defineProcessingModule({
  name: 'average-positions',
  description:
    'Gives the middle of many positions, and the offset of each of them from the middle.',
  tags: ['vector', 'muxer', 'demuxer', 'pointer'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: { positions: { format: 'vector2', list: true } },
  outputs: {
    middle: 'vector2',
    count: 'int32',
    offsets: { format: 'vector2', list: true },
  },
  mode: { frequency: { hertz: 30 } },
  onProcessing(_deltaTimeMs, inputs) {
    // Sums of larger numbers could be infinite. The list is missing while the input is not mapped.
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

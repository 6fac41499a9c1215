import { defineProcessingModule } from '@ubii/pm-sandbox';

/**
 * Mirrors a position at the centre of a surface, in x, in y, in both or not at all: the module of the
 * mouse-pointer example. Positions are from 0 to 1 of width and height; positions outside are mirrored
 * to the outside of the opposite edge.
 */
export const mirrorPointer = defineProcessingModule({
  name: 'mirror-pointer',
  description: 'Mirrors a position from 0 to 1 in x, y or both.',
  tags: ['pointer', 'vector', 'example'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    pointer: {
      format: 'vector2',
      description: 'Position, 0 to 1 of width and height, origin top left.',
    },
    mirrorX: { format: 'bool', default: false, description: 'True swaps left and right.' },
    mirrorY: { format: 'bool', default: false, description: 'True swaps top and bottom.' },
  },
  outputs: {
    mirrored: {
      format: 'vector2',
      description: 'The mirrored position, 0 to 1 of width and height.',
    },
  },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs, state) {
    const pointer = inputs.pointer;
    if (pointer === undefined) return undefined;
    const { x, y } = pointer.vector2;
    if (!Number.isFinite(x) || !Number.isFinite(y)) return undefined;
    const vector2 = {
      x: inputs.mirrorX?.bool ? 1 - x : x,
      y: inputs.mirrorY?.bool ? 1 - y : y,
    };
    // The mirrored position keeps the timestamp of the original one, so that a client can measure the
    // round trip. When only a switch has changed, the node sets the timestamp.
    const triggers = state.inputTriggerNames ?? [];
    const isNew = triggers.length === 0 || triggers.includes('pointer');
    return {
      outputs: {
        mirrored:
          isNew && pointer.timestamp ? { vector2, timestamp: pointer.timestamp } : { vector2 },
      },
    };
  },
});

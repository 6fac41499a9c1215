import { describe, expect, it } from 'vitest';
import { DATA_FORMATS } from './data-formats.ts';
import type { DataFormat } from './data-format-values.ts';

const PNG = new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d]);

describe('validate', () => {
  it.each<[DataFormat, unknown]>([
    ['double', -0.5],
    ['double', NaN],
    ['int32', -(2 ** 31)],
    ['bool', false],
    ['string', ''],
    ['vector2', { x: 1, y: 2 }],
    ['vector2', { x: 1 }],
    ['vector2', {}],
    ['vector2', { x: 1, y: 2, z: 3, isVector: true }],
    ['vector2', { x: null, y: 1 }],
    ['vector2List', { elements: [{ x: 1 }] }],
    ['doubleList', { elements: [1, 2] }],
    ['doubleList', { elements: new Float64Array(2) }],
    ['touchEvent', { type: 2, position: { x: 0.5, y: 0.5 }, id: '1' }],
    ['object3D', { id: 'a', pose: { position: {}, euler: { x: 1 } } }],
    ['image2D', { width: 2, height: 2, dataFormat: 1, data: new Uint8Array(12) }],
    ['image2D', { width: 1, height: 1, dataFormat: 2, data: new Uint8ClampedArray(4) }],
    ['image2D', { width: 640, height: 480, dataFormat: 1, data: PNG }],
    ['image2D', {}],
  ])('%s takes %j', (format, value) => {
    expect(DATA_FORMATS[format].validate(value)).toBeUndefined();
  });

  it.each<[DataFormat, unknown, string]>([
    ['double', '1', 'double must be a number, got "1".'],
    ['int32', 1.5, 'int32 must be an integer of 32 bits, got 1.5.'],
    ['int32', 2 ** 31, 'int32 must be an integer of 32 bits, got 2147483648.'],
    ['bool', 1, 'bool must be true or false, got 1.'],
    ['string', undefined, 'string must be text, got undefined.'],
    ['vector2', 5, 'vector2 must be an object with x, y, got 5.'],
    ['vector2', null, 'vector2 must be an object with x, y, got null.'],
    ['vector2', [1, 2], 'vector2 must be an object with x, y, got an array of 2.'],
    ['vector2', { X: 1, Y: 2 }, 'vector2 must be an object with x, y, got an object with X, Y.'],
    ['vector2', { x: '1' }, 'vector2.x must be a number, got "1".'],
    [
      'object3D',
      { pose: { position: { x: true } } },
      'object3D.pose.position.x must be a number, got true.',
    ],
    [
      'vector2List',
      { elements: [{ x: 1 }, { y: 'b' }] },
      'vector2List.elements[1].y must be a number, got "b".',
    ],
    [
      'vector2List',
      { elements: {} },
      'vector2List.elements must be an array, got an empty object.',
    ],
    ['stringList', { elements: [null] }, 'stringList.elements[0] must be text, got null.'],
    [
      'stringList',
      { elements: new Uint8Array(1) },
      'stringList.elements must be an array, got an object with 0.',
    ],
    ['keyEvent', { type: 'DOWN' }, 'keyEvent.type must be one of 0 (UP), 1 (DOWN), got "DOWN".'],
    ['pose2D', { angle: 1, direction: { x: 1 } }, 'pose2D has both direction and angle; give one.'],
    ['image2D', { data: [1] }, 'image2D.data must be a Uint8Array, got an array of 1.'],
    ['image2D', { width: -1 }, 'image2D must not be smaller than 0 by 0, got -1 by 0.'],
    [
      'image2D',
      { width: 2, height: 2, dataFormat: 2, data: new Uint8Array(15) },
      'image2D.data must be 16 bytes for 2 by 2 pixels of 4 bytes, got 15.',
    ],
    [
      'image2DList',
      { elements: [{}, { width: 1, height: 1 }] },
      'image2DList.elements[1].data must be 1 bytes for 1 by 1 pixels of 1 bytes, got 0.',
    ],
  ])('%s refuses %j and says why', (format, value, sentence) => {
    expect(DATA_FORMATS[format].validate(value)).toBe(sentence);
  });
});

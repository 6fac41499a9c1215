import { describe, expect, it } from 'vitest';
import { messageDescriptor } from '../descriptor.ts';
import { DATA_FORMATS } from './data-formats.ts';
import { parseDataFormat } from './parse-data-format.ts';

describe('parseDataFormat', () => {
  it.each(Object.values(DATA_FORMATS))('finds $format by its names', (info) => {
    const { fieldByNumber } = messageDescriptor('ubii.topicData.TopicDataRecord');
    expect(parseDataFormat(info.format)).toBe(info.format);
    expect(parseDataFormat(fieldByNumber.get(info.fieldNumber)!.protoName)).toBe(info.format);
    if (info.format !== 'quaternionList') {
      expect(parseDataFormat(info.messageType)).toBe(info.format);
    }
  });

  it.each([
    ['boolean', 'bool'],
    ['ubii.dataStructure.Image', 'image2D'],
    ['ubii.dataStructure.ImageList', 'image2DList'],
    ['Vector3', 'vector3'],
    ['VECTOR3', 'vector3'],
    ['ubii.dataStructure.Float', 'float'],
    ['ubii.proto.v1.dataStructure.Vector2', 'vector2'],
    ['ubii.dataStructure.QuaternionList', 'quaternionList'],
    [' vector2 ', 'vector2'],
    ['number', 'double'],
    ['int', 'int32'],
    ['object2D_list', 'object2DList'],
    ['object_2d_list', 'object2DList'],
  ])('reads %j as %s, as found in deployed applications', (text, format) => {
    expect(parseDataFormat(text)).toBe(format);
  });

  it.each([
    '',
    'vector',
    'vector9',
    'ubii.',
    'com.example.Vector2',
    'ubii.dataStructure.Vector8',
    '__proto__',
    'constructor',
  ])('finds nothing for %j', (text) => {
    expect(parseDataFormat(text)).toBeUndefined();
  });
});

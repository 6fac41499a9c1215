import { describe, expect, expectTypeOf, it } from 'vitest';
import { messageDescriptor } from '../descriptor.ts';
import type { TopicDataRecord, Vector2 } from '../generated/messages.ts';
import { decodeRecord, encodeRecord } from '../records.ts';
import type { DataFormat, DataFormatValues } from './data-format-values.ts';
import { DATA_FORMATS, dataFormatOfField, isDataFormat } from './data-formats.ts';

const INFOS = Object.values(DATA_FORMATS);

describe('the data formats', () => {
  it('are the value members of a record', () => {
    const members = messageDescriptor('ubii.topicData.TopicDataRecord').fields.filter(
      ({ oneof }) => oneof !== undefined,
    );
    expect(INFOS.map(({ format, fieldNumber }) => [format, fieldNumber])).toEqual(
      members.map(({ jsonName, number }) => [jsonName, number]),
    );
    type Members = Omit<TopicDataRecord, 'topic' | 'timestamp' | 'clientId' | 'extension'>;
    expectTypeOf<DataFormatValues>().toEqualTypeOf<{
      [M in keyof Members]-?: NonNullable<Members[M]>;
    }>();
  });

  it('know their message, family, and whether they are lists and events', () => {
    expect(DATA_FORMATS.vector2).toMatchObject({
      format: 'vector2',
      fieldNumber: 6,
      messageType: 'ubii.dataStructure.Vector2',
      family: 'vector',
      isList: false,
      isEvent: false,
    });
    expect(DATA_FORMATS.double).toMatchObject({ messageType: 'double', family: 'number' });
    expect(DATA_FORMATS.quaternionList).toMatchObject({
      messageType: 'ubii.dataStructure.Quaternion',
      isList: false,
    });
    expect(
      INFOS.filter(({ isList }) => isList)
        .map(({ format }) => format)
        .sort(),
    ).toEqual(
      INFOS.map(({ format }) => format)
        .filter((format) => format.endsWith('List') && format !== 'quaternionList')
        .sort(),
    );
    expect(INFOS.every(({ family }) => family.length > 0)).toBe(true);
  });

  it('[TD-31] [EX-23] count touch, key, mouse, Myo and module events one by one', () => {
    expect(
      INFOS.filter(({ isEvent }) => isEvent)
        .map(({ format }) => format)
        .sort(),
    ).toEqual([
      'keyEvent',
      'moduleEvent',
      'mouseEvent',
      'myoEvent',
      'touchEvent',
      'touchEventList',
    ]);
  });

  it.each(INFOS)(
    '$format: the default is valid, crosses the wire, and is new each time',
    (info) => {
      const value = info.createDefault();
      expect(info.validate(value)).toBeUndefined();
      const record = { topic: '/t', format: info.format, value } as Parameters<
        typeof encodeRecord
      >[0];
      expect(decodeRecord(encodeRecord(record)).value).toEqual(value);
      if (typeof value === 'object') expect(info.createDefault()).not.toBe(value);
    },
  );

  it('have neutral defaults: identity rotations, opaque black, poses at the origin', () => {
    expect(DATA_FORMATS.quaternion.createDefault()).toEqual({ x: 0, y: 0, z: 0, w: 1 });
    expect(DATA_FORMATS.color.createDefault()).toEqual({ r: 0, g: 0, b: 0, a: 1 });
    expect(DATA_FORMATS.matrix3x2.createDefault()).toMatchObject({ m00: 1, m11: 1, m21: 0 });
    expect(DATA_FORMATS.matrix4x4.createDefault()).toMatchObject({ m00: 1, m33: 1, m01: 0 });
    expect(DATA_FORMATS.pose2D.createDefault()).toEqual({ position: { x: 0, y: 0 }, angle: 0 });
    expect(DATA_FORMATS.pose3D.createDefault()).toEqual({
      position: { x: 0, y: 0, z: 0 },
      quaternion: { x: 0, y: 0, z: 0, w: 1 },
    });
    expect(DATA_FORMATS.client.createDefault().extension).toBeUndefined();
  });

  it('are found by field number and by exact name', () => {
    expect(dataFormatOfField(6)).toBe('vector2');
    expect(dataFormatOfField(1000)).toBe('client');
    expect(dataFormatOfField(1)).toBeUndefined();
    expect(dataFormatOfField(0)).toBeUndefined();
    expect(isDataFormat('vector2')).toBe(true);
    expect(isDataFormat('Vector2')).toBe(false);
    expect(isDataFormat('__proto__')).toBe(false);
  });

  it('are typed one by one', () => {
    expectTypeOf(DATA_FORMATS.vector2.createDefault()).toEqualTypeOf<Vector2>();
    expectTypeOf(DATA_FORMATS.bool.format).toEqualTypeOf<'bool'>();
    expectTypeOf<DataFormat>().toEqualTypeOf<keyof typeof DATA_FORMATS>();
  });
});

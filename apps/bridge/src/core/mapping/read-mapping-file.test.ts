import { describe, expect, it } from 'vitest';
import { BRIDGE_LIMITS } from '../limits.ts';
import { readMappingFile } from './read-mapping-file.ts';
import type { Protocol } from './mapping.ts';

const temperature = {
  direction: 'in',
  foreign: 'sensors/+/temp',
  topic: '/mqtt/{1}/temp',
  format: 'double',
};

const read = (file: object, protocol: Protocol = 'mqtt') =>
  readMappingFile(JSON.stringify({ version: 1, ...file }), protocol);
const readOne = (mapping: object, protocol: Protocol = 'mqtt') =>
  read({ mappings: [mapping] }, protocol).mappings[0];

describe('a mapping file [BR-1]', () => {
  it('has defaults', () => {
    expect(readOne(temperature)).toMatchObject({
      name: 'sensors/+/temp in /mqtt/{1}/temp',
      direction: 'in',
      format: 'double',
      payload: 'json',
      field: [],
      qos: 0,
      retained: false,
      maxRateHz: 0,
      maxTopics: BRIDGE_LIMITS.topicsPerMapping,
      maxBytes: BRIDGE_LIMITS.messageBytes,
    });
    expect(read({ mappings: [], homeAssistant: {} })).toMatchObject({
      homeAssistant: { prefix: 'homeassistant', topics: 'ubii' },
      system: undefined,
    });
  });

  it('takes what a mapping says', () => {
    expect(
      readOne({
        ...temperature,
        name: 'temperatures',
        field: 'values[0].celsius',
        qos: 1,
        retained: true,
        maxRateHz: 5,
        maxTopics: 3,
        maxBytes: 100,
      }),
    ).toMatchObject({
      name: 'temperatures',
      field: ['values', 0, 'celsius'],
      qos: 1,
      retained: true,
      maxRateHz: 5,
      maxTopics: 3,
      maxBytes: 100,
    });
    const speed = { direction: 'in', foreign: '/speed', topic: '/speed', format: 'vector3' };
    expect(readOne({ ...speed, type: 'geometry_msgs/msg/Vector3' }, 'rosbridge')).toMatchObject({
      rosType: 'geometry_msgs/Vector3',
      compression: 'none',
      queueLength: 1,
    });
    expect(() => readOne({ ...temperature, type: 'std_msgs/Float64' }, 'rosbridge')).toThrow(
      'rosbridge subscribes to single topics',
    );
    expect(readOne({ ...speed, timeTag: true }, 'osc')).toMatchObject({ timeTag: true });
  });

  it.each([
    ['{', 'The mapping is not JSON'],
    ['3', 'The mapping must be an object'],
    ['{"version":2,"mappings":[]}', 'version must be 1, but is 2.'],
    ['{"version":1}', 'mappings is missing.'],
    ['{"version":1,"mappings":[],"mapings":[]}', 'mapings is unknown. Check how it is written'],
    ['{"version":1,"mappings":[],"availability":"a/#"}', 'has a wildcard. Write one topic.'],
  ])('refuses %s: %s', (text, reason) => {
    expect(() => readMappingFile(text, 'mqtt')).toThrow(reason);
  });

  it.each([
    [{ direction: 'into' }, 'mappings[0].direction must be "in", "out" or "both", but is "into".'],
    [{ direction: undefined }, 'mappings[0].direction is missing.'],
    [{ format: 'number' }, 'mappings[0].format must be a data format'],
    [{ format: undefined }, 'mappings[0].format is missing. Set the data format'],
    [{ qos: 3 }, 'mappings[0].qos must be 0, 1 or 2, but is 3.'],
    [{ payload: 'xml' }, 'mappings[0].payload must be "json", "text"'],
    [{ payload: 'text', format: 'vector3' }, 'the payload "text" carries double, float'],
    [{ payload: 'bytes' }, 'the payload "bytes" carries image2D, int32List'],
    [{ payload: 'text', field: 'a' }, 'mappings[0].field is for the payload "json" only'],
    [{ field: 'a..b' }, 'mappings[0].field: must be members and indices'],
    [{ topic: '/ubii/{1}' }, 'mappings[0].topic: topics below /info/ and /ubii/'],
    [{ topic: '/x/{2}' }, 'mappings[0]: `topic` has the placeholder {2}'],
    [{ topik: '/x' }, 'mappings[0].topik is unknown.'],
    [{ type: 'std_msgs/Float64' }, 'mappings[0].type is unknown.'],
    [{ maxTopics: 0 }, 'mappings[0].maxTopics must be a whole number from 1'],
    [{ foreign: 'a\nb' }, 'mappings[0].foreign must be a text of 1 to 200 characters'],
  ])('says where and what is wrong: %j', (change, reason) => {
    expect(() => readOne({ ...temperature, ...change })).toThrow(reason);
  });

  it('refuses two mappings of one name, and more than it can have', () => {
    expect(() => read({ mappings: [temperature, temperature] })).toThrow(
      'mappings[1].name: "sensors/+/temp in /mqtt/{1}/temp" is the name of another mapping.',
    );
    const many = Array.from({ length: BRIDGE_LIMITS.mappings + 1 }, () => temperature);
    expect(() => read({ mappings: many })).toThrow('must be a list of at most 200 mappings');
    const long = ' '.repeat(BRIDGE_LIMITS.mappingFileChars + 1);
    expect(() => readMappingFile(long, 'mqtt')).toThrow('Divide it between several bridges');
  });
});
